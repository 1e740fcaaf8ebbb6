"""Draws what ppo_pick.py has measured: share of episodes that succeed over steps learned, beside chance and the oracle.

    pip install matplotlib
    python examples/plot_curve.py [CURVE.json [PICTURE.png]]
"""

import importlib.util
import json
import pathlib
import sys

source = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "out/examples/ppo_pick/curve.json")
picture = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else source.with_suffix(".png")


def draw(curve):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(7, 4), dpi=110)
    points = curve["ppo"]
    axes.plot([p["learned_steps"] for p in points], [p["success"] for p in points], "o-", label="PPO", color="tab:blue")
    for name, style in (("oracle", "--"), ("chance", ":")):
        axes.axhline(curve[name]["success"], linestyle=style, color="black", label=name)
    axes.set(xlabel="steps learned", ylabel=f"episodes that succeed, of {curve['trials']}", ylim=(-0.03, 1.03), title=curve["task"])
    axes.grid(alpha=0.3)
    axes.legend(loc="center right")
    figure.tight_layout()
    figure.savefig(picture)


if not source.exists():
    print(f"there is no {source}: examples/ppo_pick.py measures one")
elif importlib.util.find_spec("matplotlib") is None:
    print("drawing needs matplotlib: pip install matplotlib")
else:
    draw(json.loads(source.read_text()))
    print(f"picture: {picture}")
