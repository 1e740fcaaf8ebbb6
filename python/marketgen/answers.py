"""What a policy answers, as bytes that can be read without running anything in them.

A pickle can run whatever it likes in the process that reads it, and that process knows the truth. So nothing that comes from a
policy's process is unpickled: it is a line of JSON, and behind it the numbers of an array.
"""

from __future__ import annotations

import json
from typing import Any, NamedTuple

import numpy as np

WORDS = ("ok", "error")
NUMBERS = "biuf"  # kinds of arrays that travel: truths, whole numbers, floats
MAX_BYTES = 1 << 26


class Unsendable(NamedTuple):
    """In place of a value that does not travel: no action, whatever asks."""

    kind: str


def packed(word: str, value: Any) -> bytes:
    if value is None or isinstance(value, (bool, int, float, str)):
        return json.dumps([word, value]).encode()
    try:
        numbers = np.ascontiguousarray(value) if np.ndim(value) else np.asarray(value)
    except Exception:  # an object's __array__ may raise anything
        numbers = np.empty(0, object)
    if numbers.dtype.kind not in NUMBERS:
        return json.dumps([word, {"unsendable": type(value).__name__}]).encode()
    array = {"dtype": numbers.dtype.str, "shape": numbers.shape}
    return json.dumps([word, array]).encode() + b"\n" + numbers.tobytes()


def unpacked(message: bytes) -> tuple[str, Any]:
    """The word and the value. Raises ValueError when it is no such message."""
    try:
        return _unpacked(message)
    except Exception as fault:  # whatever bytes they are
        raise ValueError("it is no answer") from fault


def _unpacked(message: bytes) -> tuple[str, Any]:
    head, _, numbers = message.partition(b"\n")
    word, value = json.loads(head)
    if word not in WORDS:
        raise ValueError(word)
    if not isinstance(value, dict):
        return word, value
    if "unsendable" in value:
        return word, Unsendable(str(value["unsendable"]))
    dtype = np.dtype(value["dtype"])
    if dtype.kind not in NUMBERS:
        raise ValueError(dtype)
    return word, np.frombuffer(numbers, dtype).reshape(value["shape"]).copy()
