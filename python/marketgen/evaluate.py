"""Scores of policies on episodes, from the command line: marketgen.evaluate().

    python -m marketgen.evaluate --episodes tasks.jsonl --policy openpi://localhost:8000 --adapter openpi-libero -o results
    python -m marketgen.evaluate --episodes tasks.jsonl --policy python:mine.policies:Mine -o results --resume

`marketgen eval` for policies that are not the program's own: flags of the same names mean the same. Ends as the program's commands
do.
"""

from __future__ import annotations

import argparse
import json
import sys
from typing import Any

from .command_line import Told, callable_module, ended
from .errors import Error
from .evaluation import Evaluation, evaluate
from .rankings import leaderboard

KEPT = "; what is finished is kept: go on with --resume"
SHARES = {"strict": "SR strict", "clean": "SR clean", "goals": "goals", "violations": "violations"}


def main(words: list[str] | None = None) -> int:
    given = _parser().parse_args(words)
    return ended(lambda: _evaluate(given), KEPT)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m marketgen.evaluate",
        description="Runs episodes with a policy, in physics: one of your own, or a model of others (docs/remote.md).",
        epilog="example: python -m marketgen.evaluate --episodes tasks.jsonl --policy openpi://localhost:8000 -o results",
    )
    add = parser.add_argument
    add("--episodes", required=True, metavar="FILE", help="a file of `marketgen episodes`, or a set that comes with the program: pool/checkout")
    add("--policy", required=True, help="openpi://HOST:PORT, groot://HOST:PORT, lerobot:FOLDER, python:MODULE:NAME, FILE.py:NAME, or one of the program's own")
    add("--adapter", metavar="ROW", help="what a model of others sees and says: a row of the program's own, or FILE.yaml:ROW")
    add("--name", default="", help="under which the results have it")
    add("-o", "--output", required=True, metavar="FOLDER", help="folder for the results")
    add("--jobs", type=int, default=0, metavar="N", help="episodes at a time; 0: as many as there are cores (default: %(default)s)")
    add("--shard", default="", metavar="I/N", help="run a part of the file; `marketgen merge` joins them")
    add("--repetition", type=int, default=1, metavar="N", help="which run of the episodes this is: from 2 on all that is drawn is drawn anew")
    add("--realism", default="ideal", help="ideal, standard, hard, crowded, randomized or a file (default: %(default)s)")
    add("--obs-mode", metavar="MODE", help="of a policy of your own: state_robot, rgbd or pointcloud")
    add("--control-mode", metavar="MODE", help="of a policy of your own: pd_joint_pos, ...")
    add("--policy-files", action="append", default=[], metavar="PATH", help="that a policy of your own reads and writes")
    add("--act-limit-s", type=float, default=120.0, metavar="S", help="processor time of a policy's process for one answer (default: %(default)g)")
    add("--hang-limit-s", type=float, default=1200.0, metavar="S", help="wall time for one answer; 0: no limit (default: %(default)g)")
    add("--start-limit-s", type=float, default=120.0, metavar="S", help="processor time until a policy's process is ready, wall time until a server answers (default: %(default)g)")
    add("--against", nargs="+", default=[], metavar="FOLDER", help="results of other policies on the same episodes, to be compared with")
    add("--resume", action="store_true", help="go on with a run that was broken off")
    add("--json", action="store_true", help="the summary as JSON")
    add("--quiet", action="store_true", help="no progress")
    return parser


def _evaluate(given: argparse.Namespace) -> int:
    chosen = {"obs_mode": given.obs_mode, "control_mode": given.control_mode}
    scores = evaluate(
        given.episodes,
        given.policy,
        given.output,
        jobs=given.jobs,
        resume=given.resume,
        act_limit_s=given.act_limit_s,
        hang_limit_s=given.hang_limit_s,
        start_limit_s=given.start_limit_s,
        shard=given.shard,
        repetition=given.repetition,
        realism=given.realism,
        policy_files=given.policy_files,
        adapter=given.adapter,
        name=given.name,
        progress=None if given.quiet else Told(),
        **{option: value for option, value in chosen.items() if value is not None},
    )
    print(json.dumps(scores.summary, indent=2) if given.json else summary_of(scores))
    if given.against:
        print(comparison_of(leaderboard([given.output, *given.against])))
    return _all_run(scores)


def _all_run(scores: Evaluation) -> int:
    """0. Raises Error of the first episode that could not be run; the summary stands."""
    failed = [result for result in scores.results if result.get("error")]
    if failed:
        first = failed[0]
        count = f"{len(failed)} of {len(scores.results)} episodes could not be run; of this one: {first['detail']}"
        raise Error(first["error"], first["episode"], count)
    return 0


def summary_of(scores: Evaluation) -> str:
    """For people."""
    lines = [f"{name:<12}{_share(scores.summary[key])}" for key, name in SHARES.items()]
    lines += [f"{failure['failure']:<12}{failure['episodes']}" for failure in scores.summary["failures"]]
    return "\n".join(lines)


def _share(share: dict[str, Any]) -> str:
    return f"{share['share'] * 100:5.1f} %  ({share['low'] * 100:.1f} to {share['high'] * 100:.1f}), {share['number']} of {share['of']}"


def comparison_of(board: dict[str, Any]) -> str:
    """Each policy beside the best of its track, by the paired test of docs/episodes.md."""
    lines = []
    for track in board["tracks"]:
        for entry in track["entries"]:
            to_best = entry.get("to_best")
            beside = f"; strict beside the best: p = {to_best['p_strict']:.2g}" if to_best else ""
            lines.append(f"{track['track']:<10}{entry['policy']:<24}SR strict {entry['strict']['share'] * 100:5.1f} %{beside}")
    return "\n".join(lines)


if __name__ == "__main__":
    sys.exit(main())
sys.modules[__name__].__class__ = callable_module(evaluate)
