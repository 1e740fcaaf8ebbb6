"""What public functions say of arguments that they cannot take, before anything is done."""

from __future__ import annotations

import difflib
import json
import math
import operator
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from . import _core
from .errors import Error

PathLike = str | os.PathLike[str]
Progress = Callable[[int, int, str], Any]  # done, total, what is being done
MAX_SEED = 2**64 - 1
MAX_SIDE_PX = 16384
MAX_TOKENS, MAX_SECONDS = 200_000, 300.0  # of a language model, unless more or less is allowed


def bad(name: str, value: Any, expected: str) -> Error:
    shown = repr(value)
    return Error("usage.bad_flag", name, f"{shown if len(shown) <= 80 else shown[:77] + '...'}: expected {expected}")


def a_text(name: str, value: Any) -> str:
    if not isinstance(value, str):
        raise bad(name, value, "a text")
    return value


def a_path(name: str, value: Any) -> str:
    """As a text; what may be a file or folder: str or os.PathLike."""
    try:
        return os.fsdecode(value)
    except TypeError:
        raise bad(name, value, "a path: str or os.PathLike") from None


def texts(name: str, values: Any, expected: str = "a list of texts") -> list[str]:
    if isinstance(values, str) or not isinstance(values, Sequence):
        raise bad(name, values, expected)
    return [a_text(name, value) for value in values]


def existing(name: str, file: str) -> str:
    """A whole path to what is there."""
    if not os.path.exists(file):
        raise Error("input.not_found", file, f"{name} names it, and it is not there")
    return os.path.abspath(file)


def episodes_path(name: str, value: Any) -> str:
    """A whole path: of the file, or of a set that comes with the program, by its name ("pool/aisle")."""
    return os.path.abspath(_core.find_episode_file(a_path(name, value)))


def paths(name: str, values: Any) -> list[str]:
    if isinstance(values, (str, bytes, os.PathLike)) or not isinstance(values, Iterable):
        raise bad(name, values, "a list of paths")
    return [a_path(name, value) for value in values]


def path_or_paths(name: str, values: Any) -> list[str]:
    """One path, or a list of them."""
    if isinstance(values, (str, bytes, os.PathLike)):
        return [a_path(name, values)]
    if not isinstance(values, Iterable):
        raise bad(name, values, "a path, or a list of paths")
    return [a_path(name, value) for value in values]


def documents(name: str, values: Any) -> list[dict[str, Any]]:
    """Objects as JSON has them."""
    if isinstance(values, (str, bytes, Mapping)) or not isinstance(values, Iterable):
        raise bad(name, values, "a list of objects")
    rows = list(values)
    if not all(isinstance(row, Mapping) for row in rows):
        raise bad(name, values, "a list of objects")
    try:
        return json.loads(json.dumps(rows, default=dict, allow_nan=False))
    except (TypeError, ValueError) as fault:
        raise bad(name, values, f"objects that JSON can hold ({fault})") from None


def a_whole(name: str, value: Any, low: int, high: int) -> int:
    try:
        number = operator.index(value) if not isinstance(value, bool) else None
    except TypeError:
        number = None
    if number is None or not low <= number <= high:
        raise bad(name, value, f"a whole number from {low} to {high}")
    return number


def seeds(name: str, values: Any, high: int) -> dict[str, int]:
    """A seed for each name."""
    if not isinstance(values, Mapping) or not all(isinstance(key, str) for key in values):
        raise bad(name, values, 'seeds by name, as in {"fill": 3}')
    return {key: a_whole(name, seed, 0, high) for key, seed in values.items()}


def a_number(name: str, value: Any, low: float, high: float) -> float:
    try:
        number = float(value) if not isinstance(value, (bool, str, bytes)) else math.nan
    except (TypeError, ValueError, OverflowError):
        number = math.nan
    if not low <= number <= high:
        raise bad(name, value, f"a number from {low:g} to {high:g}")
    return number


def numbers(name: str, values: Any, count: int) -> tuple[float, ...]:
    """So many finite ones."""
    try:
        made = tuple(float(value) for value in values)
    except (TypeError, ValueError):
        made = ()
    if len(made) != count or not all(map(math.isfinite, made)):
        raise bad(name, values, f"{count} finite numbers")
    return made


def a_truth(name: str, value: Any) -> bool:
    if value not in (True, False) or isinstance(value, (int, float)) and not isinstance(value, bool):
        raise bad(name, value, "True or False")
    return bool(value)


def a_name(name: str, value: Any, known: Sequence[Any]) -> Any:
    if value in known:
        return value
    words = [word for word in known if isinstance(word, str)]
    near = difflib.get_close_matches(value, words, 1) if isinstance(value, str) else []
    meant = f"; did you mean {near[0]!r}?" if near else ""
    raise bad(name, value, f"one of {', '.join(map(repr, known))}{meant}")


def a_size(name: str, value: Any) -> tuple[int, int]:
    """Width and height in pixels."""
    try:
        width, height = value
    except (TypeError, ValueError):
        raise bad(name, value, "(width, height) in pixels") from None
    return a_whole(name, width, 1, MAX_SIDE_PX), a_whole(name, height, 1, MAX_SIDE_PX)


def planner_access(
    planner_url: Any, record: Any, max_tokens: Any, max_seconds: Any, max_usd: Any, usd_per_million: Any
) -> _core.PlannerAccess:
    """How a language model is reached, and what it may cost: arguments of generate() and Store.shop()."""
    return _core.planner_access(
        "" if planner_url is None else a_text("planner_url", planner_url),
        "" if record is None else a_path("record", record),
        a_whole("max_tokens", max_tokens, 0, 10**12),
        a_number("max_seconds", max_seconds, 0, 1e9),
        None if max_usd is None else a_number("max_usd", max_usd, 0, 1e9),
        None if usd_per_million is None else numbers("usd_per_million", usd_per_million, 2),
    )


def camera_names(text: str) -> tuple[str, ...]:
    """Of "scene_camera,wrist_camera"; "none": none."""
    return () if text == "none" else tuple(text.split(","))


def a_progress(value: Any) -> Progress | None:
    if value is not None and not callable(value):
        raise bad("progress", value, "a function of (done, total, text), or None")
    return value
