"""Fields of a YAML document, read one by one, with errors that say where they are.

    fields = Fields(document, "mine.yaml:/row")
    size = fields.take("size", a_pair)
    fields.done()                               # raises when something is left over
"""

from __future__ import annotations

import difflib
import math
from collections.abc import Callable, Mapping
from typing import Any

from ..errors import Error

_MISSING = object()


def wrong_type(where: str, value: Any, expected: str) -> Error:
    shown = repr(value)
    return Error("json.wrong_type", where, f"{shown if len(shown) <= 80 else shown[:77] + '...'}: expected {expected}")


class Fields:
    """Of one mapping. `where`: "file.yaml:/row/action"."""

    def __init__(self, document: Any, where: str):
        if not isinstance(document, Mapping):
            raise wrong_type(where, document, "fields with names")
        self.where = where
        self._left = dict(document)
        self._known: list[str] = []

    def __contains__(self, name: str) -> bool:
        return name in self._left

    def take(self, name: str, read: Callable[[Any, str], Any], default: Any = _MISSING) -> Any:
        """What `read` makes of it. Raises Error json.missing_field and what `read` raises."""
        self._known.append(name)
        if name not in self._left:
            if default is _MISSING:
                raise Error("json.missing_field", self.where, f'"{name}" is missing')
            return default
        return read(self._left.pop(name), f"{self.where}/{name}")

    def done(self) -> None:
        """Raises Error json.unknown_field for one that nobody took."""
        for name in self._left:
            near = difflib.get_close_matches(str(name), self._known, 1)
            meant = f'; did you mean "{near[0]}"?' if near else f"; there are: {', '.join(self._known)}"
            raise Error("json.unknown_field", f"{self.where}/{name}", f"no such field{meant}")


def a_text(value: Any, where: str) -> str:
    if not isinstance(value, str) or not value:
        raise wrong_type(where, value, "a text")
    return value


def a_number(value: Any, where: str) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise wrong_type(where, value, "a finite number")
    return float(value)


def above_zero(value: Any, where: str) -> float:
    number = a_number(value, where)
    if number <= 0:
        raise Error("json.out_of_range", where, f"{number:g}: expected a number above 0")
    return number


def a_count(most: int) -> Callable[[Any, str], int]:
    """A whole number from 1 on."""

    def read(value: Any, where: str) -> int:
        if isinstance(value, bool) or not isinstance(value, int):
            raise wrong_type(where, value, "a whole number")
        if not 1 <= value <= most:
            raise Error("json.out_of_range", where, f"{value}: expected 1 to {most}")
        return value

    return read


def one_of(names: tuple[str, ...]) -> Callable[[Any, str], str]:
    def read(value: Any, where: str) -> str:
        if value not in names:
            near = difflib.get_close_matches(str(value), names, 1)
            meant = f"; did you mean {near[0]!r}?" if near else ""
            raise Error("json.unknown_name", where, f"{value!r}: expected one of {', '.join(names)}{meant}")
        return value

    return read


def texts(value: Any, where: str) -> tuple[str, ...]:
    """One at least."""
    if not isinstance(value, list) or not value:
        raise wrong_type(where, value, "a list of texts")
    return tuple(a_text(one, f"{where}/{number}") for number, one in enumerate(value))
