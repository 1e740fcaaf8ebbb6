"""README.md of a dataset: what is in it, for people; and a strip of what its cameras saw."""

from __future__ import annotations

import fractions
import json
import pathlib
from typing import TYPE_CHECKING, Any

import numpy as np

from ..policies import SUBTASKS
from .features import PICTURES, SUBTASK
from .outputs import write

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .dataset import About
    from .parts import Part

STRIP, STRIP_PICTURES, GAP_PX = "strip.png", 6, 2
FRONT = """---
task_categories:
- robotics
tags:
- LeRobot
- MarketGen
configs:
- config_name: default
  data_files: data/*/*.parquet
---
"""


def write_card(
    root: pathlib.Path, name: str, kept: Sequence[Part], tried: Sequence[Part], about: About, settings: dict[str, Any]
) -> None:
    """Of the dataset in `root`, which is to be called `name`. `tried`: all that were acted out, kept or not."""
    info = json.loads((root / "meta/info.json").read_text(encoding="utf-8"))
    stats = json.loads((root / "meta/stats.json").read_text(encoding="utf-8"))
    parts = [FRONT, f"# {name}", "", *_said(kept, tried, info, settings), "", *_tasks(kept), ""]
    if about.cameras:
        write(root / STRIP, png_of(_strip(kept, about)))
        shown = f"The first episode, evenly over its time: {', '.join(about.cameras)}, top to bottom."
        parts += [f"![{shown}]({STRIP})", "", shown, ""]
    parts += [*_features(info, stats), "", "Made by MarketGen (`python -m marketgen.record`); in LeRobot's format v3.0:", "", *_example(name, info), ""]
    write(root / "README.md", "\n".join(parts).encode())


def _said(kept: Sequence[Part], tried: Sequence[Part], info: dict[str, Any], settings: dict[str, Any]) -> list[str]:
    succeeded = sum(part.told["success"] for part in kept)
    ran = [part for part in tried if "error" not in part.told]
    minutes = info["total_frames"] / info["fps"] / 60
    rows = {
        "episodes": f"{len(kept)}, {succeeded} of them successful",
        "frames": f"{info['total_frames']:,} at {info['fps']} a second ({minutes:.1f} min)",
        "tasks": f"{info['total_tasks']:,}",
        "robot": info["robot_type"],
        "policy": f"{settings['policy']}, which reached all goals in {sum(part.told['success'] for part in ran)} of {len(ran)}",
        "actions": settings["control_mode"],
        "pictures": f"{', '.join(settings['cameras'])}: {settings['size'][0]}x{settings['size'][1]}, {settings['codec']}"
        if settings["cameras"]
        else "none",
        "realism": settings["realism"],
        "sub-tasks": _subtasks(kept),
    }
    if len(ran) < len(tried):
        rows["left out"] = f"{len(tried) - len(ran)} that could not be simulated to the end"
    return ["| | |", "|---|---|", *(f"| {name} | {value} |" for name, value in rows.items())]


def _subtasks(kept: Sequence[Part]) -> str:
    """Those that there are, with their shares of the frames."""
    frames = np.bincount(np.concatenate([part.values(SUBTASK) for part in kept]), minlength=len(SUBTASKS))
    return ", ".join(f"{name} {share:.0%}" for name, share in zip(SUBTASKS, frames / frames.sum(), strict=True) if share)


def _tasks(kept: Sequence[Part]) -> list[str]:
    said = list(dict.fromkeys(part.told["task"] for part in kept))
    more = [f"- and {len(said) - 5:,} more"] if len(said) > 5 else []
    return ["Tasks:", "", *(f"- {task}" for task in said[:5]), *more]


def _features(info: dict[str, Any], stats: dict[str, Any]) -> list[str]:
    """A row for each number that has a name, and for each feature without."""
    lines = ["| feature | number | least | mean | most | deviation |", "|---|---|---|---|---|---|"]
    for feature, told in info["features"].items():
        values = {key: np.ravel(stats[feature][key]) for key in ("min", "mean", "max", "std")}
        names = ("red", "green", "blue") if feature.startswith(PICTURES) else told["names"] or [""]
        for i, name in enumerate(names):
            numbers = " | ".join(f"{values[key][i]:.4g}" for key in values)
            lines.append(f"| {f'`{feature}`' if i == 0 else ''} | {name} | {numbers} |")
    return lines


def _example(name: str, info: dict[str, Any]) -> list[str]:
    return [
        "```python",
        "from lerobot.datasets.lerobot_dataset import LeRobotDataset",
        "",
        f'dataset = LeRobotDataset("{name}", root="{name}")    # {info["total_frames"]} frames',
        "```",
    ]


def _strip(kept: Sequence[Part], about: About) -> np.ndarray:
    """A row of pictures a camera, with white between them."""
    width, height = about.size
    step_x, step_y = width + GAP_PX, height + GAP_PX
    strip = np.full((step_y * len(about.cameras) - GAP_PX, step_x * STRIP_PICTURES - GAP_PX, 3), 255, np.uint8)
    for row, camera in enumerate(about.cameras):
        for column, picture in enumerate(_pictures(kept[0], camera)):
            strip[row * step_y :, column * step_x :][:height, :width] = picture
    return strip


def _pictures(part: Part, camera: str) -> list[np.ndarray]:
    import av

    wanted = np.linspace(0, part.told["frames"] - 1, STRIP_PICTURES).round().astype(int).tolist()
    with av.open(str(part.video(camera))) as video:
        found = {i: frame.to_ndarray(format="rgb24") for i, frame in enumerate(video.decode(video=0)) if i in wanted}
    return [found[i] for i in wanted]


def png_of(rgb: np.ndarray) -> bytes:
    import av

    height, width, _ = rgb.shape
    encoder = av.CodecContext.create("png", "w")
    encoder.width, encoder.height, encoder.pix_fmt, encoder.time_base = width, height, "rgb24", fractions.Fraction(1, 1)
    packets = [*encoder.encode(av.VideoFrame.from_ndarray(rgb, format="rgb24")), *encoder.encode(None)]
    return b"".join(bytes(packet) for packet in packets)
