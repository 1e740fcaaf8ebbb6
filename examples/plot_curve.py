"""Draws what ppo_pick.py has measured: share of episodes that succeed over steps learned, beside chance and the oracle.

    pip install matplotlib
    python examples/plot_curve.py [CURVE.json ...] [PICTURE.png]

A panel a task, of which a file may have a list, with a curve a seed; bars are Wilson intervals, 95 %. A star is the policy that was
kept, on its last trials.
"""

import importlib.util
import json
import pathlib
import sys

given = [pathlib.Path(name) for name in sys.argv[1:]]
sources = [path for path in given if path.suffix == ".json"] or [pathlib.Path("out/examples/ppo_pick/curve.json")]
picture = next((path for path in given if path.suffix == ".png"), sources[0].with_suffix(".png"))


COLORS = ("tab:blue", "tab:orange", "tab:green", "tab:purple")  # of seeds


def draw(axes, curves):
    for curve, color in zip(curves, COLORS, strict=False):
        points = curve["learned"]
        steps, shares = [p["learned_steps"] for p in points], [p["success"] for p in points]
        label = curve["algorithm"] if len(curves) == 1 else f"{curve['algorithm']}, seed {curve['seed']}"
        axes.plot(steps, shares, "o-", label=label, color=color)
        for p in points:
            if "within" in p:
                axes.plot([p["learned_steps"]] * 2, p["within"], color=color, alpha=0.25)
        if kept := curve.get("kept"):
            axes.plot(kept["learned_steps"], kept["success"], "*", markersize=15, color=color, markeredgecolor="black", label="kept")
            axes.plot([kept["learned_steps"]] * 2, kept["within"], color="black", linewidth=1.5)
    for name, style in (("oracle", "--"), ("chance", ":")):
        if name in curves[0]:
            axes.axhline(curves[0][name]["success"], linestyle=style, color="black", label=name)
    title = curves[0]["task"].removeprefix("MarketGen/")
    axes.set(xlabel="steps learned", ylabel="episodes that succeed", xlim=(0, None), ylim=(-0.03, 1.07), title=title)
    axes.grid(alpha=0.3)
    axes.legend(loc="lower right", fontsize=8)


def draw_all(curves):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    tasks = {}
    for curve in curves:
        tasks.setdefault(curve["task"], []).append(curve)
    figure, panels = pyplot.subplots(1, len(tasks), figsize=(7 if len(tasks) == 1 else 4.5 * len(tasks), 4), dpi=110, squeeze=False)
    for axes, of_task in zip(panels[0], tasks.values(), strict=True):
        draw(axes, of_task)
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
