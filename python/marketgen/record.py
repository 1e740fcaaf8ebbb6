"""Demonstrations as a LeRobot dataset, from the command line: marketgen.record().

    python -m marketgen.record tasks.jsonl -o unloading --policy oracle --success-only
    python -m marketgen.record pool/checkout -o numbers --cameras none --count 20
    python -m marketgen.record tasks.jsonl --check unloading
    python -m marketgen.record --teleop drives/*.drive.jsonl.gz -o driven

Ends as the program's commands do; 1: a dataset that does not replay.
"""

from __future__ import annotations

import argparse
import sys

from . import arguments
from .command_line import Told, callable_module, ended
from .errors import Error
from .recording import Recording, record, record_drives, replay_check
from .recording.video import CODECS


def main(words: list[str] | None = None) -> int:
    given = _parser().parse_args(words)
    command = _check if given.check else _record
    kept = "" if given.check else "; what is finished is kept: go on with --resume"
    return ended(lambda: command(given), kept, unlike="episode.not_repeated")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m marketgen.record",
        description="Acts episodes out and writes what happened as a LeRobot dataset v3.0 (docs/demonstrations.md).",
        epilog="example: python -m marketgen.record tasks.jsonl -o unloading --policy oracle --success-only",
    )
    add = parser.add_argument
    add("episodes", metavar="EPISODES", nargs="?", help="a file of `marketgen episodes`, or a set that comes with the program: pool/checkout")
    out = parser.add_mutually_exclusive_group(required=True)
    out.add_argument("-o", "--output", metavar="DATASET", help="the folder to make; until it is done DATASET.unfinished")
    out.add_argument("--check", metavar="DATASET", help="instead: execute the actions of a dataset and compare the states")
    add("--teleop", metavar="LOG", nargs="+", help="instead of EPISODES: logs of what was driven in `marketgen view`")
    add("--policy", help="oracle, classical, ... FILE.py:NAME or python:MODULE:NAME (default: oracle)")
    add("--cameras", metavar="NAMES", help="scene_camera,wrist_camera; none: numbers alone (default: both at the counter, the head's in the aisles)")
    add("--size", default="256x256", help="of the pictures (default: %(default)s)")
    add("--quality", default="fast", choices=("fast", "balanced", "best"), help="of the pictures (default: %(default)s)")
    add("--control-mode", metavar="MODE", help="what an action is (default: pd_joint_pos)")
    add("--realism", help="ideal, standard, hard, crowded, randomized or a file (default: ideal)")
    add("--codec", default="h264", choices=tuple(CODECS), help="of the videos (default: %(default)s)")
    add("--success-only", action="store_true", help="leave out episodes that did not reach all their goals")
    add("--count", type=int, default=0, metavar="N", help="stop when so many are in the dataset (default: all)")
    add("--shard", default="", metavar="I/N", help="the I-th of N parts of the file, a dataset of its own")
    add("--resume", action="store_true", help="go on with a recording that was broken off")
    add("--quiet", action="store_true", help="no progress")
    return parser


def _record(given: argparse.Namespace) -> int:
    options = {
        "cameras": None if given.cameras is None else arguments.camera_names(given.cameras),
        "size": _size(given.size),
        "quality": given.quality,
        "codec": given.codec,
        "success_only": given.success_only,
        "count": given.count,
        "shard": given.shard,
        "resume": given.resume,
        "progress": None if given.quiet else Told(),
    }
    acted = {name: getattr(given, name) for name in ("policy", "control_mode", "realism") if getattr(given, name) is not None}
    if given.teleop is None:
        made = record(_episodes(given), given.output, **acted, **options)
    elif acted or given.episodes is not None:
        told = "EPISODES" if given.episodes is not None else f"--{next(iter(acted)).replace('_', '-')}"
        raise Error("usage.bad_flag", told, "logs of --teleop have that in them: leave it out")
    else:
        made = record_drives(given.teleop, given.output, **options)
    print(summary_of(made))
    return 0


def _episodes(given: argparse.Namespace) -> str:
    if given.episodes is None:
        raise Error("usage.bad_flag", "EPISODES", "name a file of episodes, or a set that comes with the program: pool/checkout")
    return given.episodes


def _check(given: argparse.Namespace) -> int:
    realism = given.realism if given.realism and given.realism.endswith(".json") else None
    frames = replay_check(given.check, _episodes(given), realism=realism, progress=None if given.quiet else Told())
    print(f"{given.check}: the actions of {frames:,} frames lead to the same states, bit for bit")
    return 0


def summary_of(made: Recording) -> str:
    """For people: what there is, how fast it went, and what recording cost beyond acting."""
    lines = [f"{made.folder}: {made.episodes} episodes, {made.succeeded} of them successful, {made.frames:,} frames"]
    if made.acted_now:
        spent = ", ".join(f"{name} {seconds:.0f} s" for name, seconds in made.seconds.items() if name != "all")
        lines.append(
            f"{made.acted_now} acted out in {made.seconds['all']:.0f} s: {made.episodes_an_hour:.0f} an hour, "
            f"{made.times_as_long:.2f} times as long as without recording ({spent})"
        )
    return "\n".join(lines)


def _size(text: str) -> tuple[int, int]:
    width, _, height = text.partition("x")
    if not (width.isdecimal() and height.isdecimal()):
        raise Error("usage.bad_flag", "--size", f"{text!r}: expected WIDTHxHEIGHT, as 256x256")
    return int(width), int(height)


if __name__ == "__main__":
    sys.exit(main())
sys.modules[__name__].__class__ = callable_module(record)
