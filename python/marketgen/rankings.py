"""Results of policies side by side, and the shards of one run as a whole."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from typing import Any

from . import _core, arguments
from .arguments import PathLike
from .evaluation import Evaluation, evaluation_in


def merge(results: Sequence[PathLike], folder: PathLike) -> Evaluation:
    """The shards of one run (evaluate(shard="1/4") …) as a whole; `marketgen merge` from Python.

    results  folders of evaluate(), in any order; `folder` gets what evaluate() of all episodes would have left there

    Raises Error results.not_comparable (other episodes, policy, version or commit), results.overlap, results.incomplete,
    store.exists, and what is wrong with one of them: results.*, json.*.
    """
    into = os.path.abspath(arguments.a_path("folder", folder))
    _core.merge(arguments.paths("results", results), into, "")
    return evaluation_in(into)


def leaderboard(results: Sequence[PathLike], *, html: PathLike | None = None) -> dict[str, Any]:
    """Policies on the same episodes, best first, with 95 % intervals, paired tests against the best, and how many episodes
    would be needed; `marketgen leaderboard` from Python.

    results  folders of evaluate() or merge(); complete ones only
    html     page of the same that is written, too

    Returns a market-leaderboard/1 (docs/fields/market-leaderboard-1.md). Raises Error results.*, io.*, json.*.
    """
    page = "" if html is None else arguments.a_path("html", html)
    return json.loads(_core.leaderboard(arguments.paths("results", results), page))


def tables(kind: str, folders: Sequence[PathLike]) -> dict[str, Any]:
    """Results, and what stores give to ask for, in the form that papers print; `marketgen tables` from Python, which also
    writes LaTeX, Markdown and CSV.

    kind     "tracks": policies on all tracks beside published scores; "shapes": goals by shape (bottles, cans, boxes, bags) beside
             published grasps; "swap": one policy with the truth in the place of
             modules (evaluate("classical+target")) beside itself; "realism": one policy at several levels beside itself at ideal;
             "goals": how much of what stores offer tasks may ask for, and why not the rest; "generator": what stores are worth
             (collisions, floor, wishes met, time) beside published generators
    folders  of evaluate() or merge(), complete ones only; for "goals" and "generator" stores

    Returns a market-tracks/1, market-shapes/1, market-differences/1, market-goals/1 or market-generator/1. Raises Error results.*, store.*, io.*, json.*.
    """
    chosen = arguments.a_name("kind", kind, ("tracks", "shapes", "swap", "realism", "goals", "generator"))
    named = arguments.paths("folders", folders)
    if chosen == "tracks":
        return json.loads(_core.tracks_table(named))
    if chosen == "shapes":
        return json.loads(_core.shapes_table(named))
    if chosen == "generator":
        return json.loads(_core.generator_table(named))
    if chosen == "goals":
        return json.loads(_core.goals_table(named))
    return json.loads(_core.differences_table(named, "truth" if chosen == "swap" else "realism"))
