"""An environment's whole state as bytes: what another instance or process goes on from, bit for bit."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from .. import _core

_TAG = b"marketgen-state/1\n"
_LENGTH = 8  # bytes of a length


def packed(head: dict[str, Any], body: bytes) -> bytes:
    text = json.dumps(head, default=_plain).encode()
    return _TAG + len(text).to_bytes(_LENGTH, "little") + text + body


def unpacked(state: bytes) -> tuple[dict[str, Any], bytes]:
    """Raises Error physics.bad_command when they are no such bytes."""
    begin = len(_TAG) + _LENGTH
    try:
        if bytes(state[: len(_TAG)]) != _TAG:
            raise ValueError("they begin otherwise")
        end = begin + int.from_bytes(state[len(_TAG) : begin], "little")
        return json.loads(bytes(state[begin:end])), bytes(state[end:])
    except (TypeError, ValueError) as fault:
        raise _core.Error(
            "physics.bad_command", "state", f"expected what get_state() gave, of this version of marketgen: {fault}"
        ) from None


def random_state(generator: np.random.Generator) -> dict[str, Any]:
    return generator.bit_generator.state


def generator_of(state: dict[str, Any]) -> np.random.Generator:
    bits = getattr(np.random, state["bit_generator"])()
    bits.state = state
    return np.random.Generator(bits)


def _plain(value: Any) -> Any:
    return value.tolist() if isinstance(value, (np.ndarray, np.generic)) else value
