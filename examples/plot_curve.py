"""Draws what ppo_pick.py has measured: share of episodes that succeed over steps learned, beside chance and the oracle.

    pip install matplotlib
    python examples/plot_curve.py [CURVE.json ...] [PICTURE.png]

A panel a curve, of which a file may have a list; bars are Wilson intervals, 95 %.
"""

import importlib.util
import json
import pathlib
import sys

given = [pathlib.Path(name) for name in sys.argv[1:]]
sources = [path for path in given if path.suffix == ".json"] or [pathlib.Path("out/examples/ppo_pick/curve.json")]
picture = next((path for path in given if path.suffix == ".png"), sources[0].with_suffix(".png"))


def draw(axes, curve):
    points = curve["learned"]
    steps, shares = [p["learned_steps"] for p in points], [p["success"] for p in points]
    axes.plot(steps, shares, "o-", label=curve["algorithm"], color="tab:blue")
    for p in points:
        if "within" in p:
            axes.plot([p["learned_steps"]] * 2, p["within"], color="tab:blue", alpha=0.4)
    for name, style in (("oracle", "--"), ("chance", ":")):
        if name in curve:
            axes.axhline(curve[name]["success"], linestyle=style, color="black", label=name)
    title = curve["task"].removeprefix("MarketGen/")
    axes.set(xlabel="steps learned", ylabel="episodes that succeed", ylim=(-0.03, 1.03), title=title)
    axes.grid(alpha=0.3)
    axes.legend(loc="best")


def draw_all(curves):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, panels = pyplot.subplots(1, len(curves), figsize=(7 if len(curves) == 1 else 5.5 * len(curves), 4), dpi=110, squeeze=False)
    for axes, curve in zip(panels[0], curves, strict=True):
        draw(axes, curve)
    figure.tight_layout()
    figure.savefig(picture)


missing = [str(path) for path in sources if not path.exists()]
if missing:
    print(f"there is no {', '.join(missing)}: examples/ppo_pick.py measures one")
elif importlib.util.find_spec("matplotlib") is None:
    print("drawing needs matplotlib: pip install matplotlib")
else:
    read = [json.loads(path.read_text()) for path in sources]
    draw_all([curve for part in read for curve in (part if isinstance(part, list) else [part])])
    print(f"picture: {picture}")
