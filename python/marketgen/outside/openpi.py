"""The protocol of openpi's policy servers (websocket_policy_server.py of openpi, websocket_client_policy.py of openpi-client).

A websocket without a path. The server speaks first: its metadata, a map. Then an observation is sent, and the answer is a map with
"actions", an array (steps, numbers of a step). All are msgpack; an array is a map with the keys b"__ndarray__", b"data", b"dtype"
and b"shape". A text in place of a map is the traceback of what went wrong in the server.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from ..errors import Error
from ..policy_process import PolicyFailed
from .adaptation import BAD_ANSWER
from .websocket import Websocket

NUMBERS = "biuf"  # kinds of arrays that travel


def packed(value: Any) -> bytes:
    import msgpack

    return msgpack.packb(value, default=_map_of_array)


def _map_of_array(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return {b"__ndarray__": True, b"data": value.tobytes(), b"dtype": value.dtype.str, b"shape": value.shape}
    if isinstance(value, np.generic):
        return {b"__npgeneric__": True, b"data": value.item(), b"dtype": value.dtype.str}
    raise TypeError(f"{type(value).__name__} does not travel")


def unpacked(message: bytes) -> Any:
    """Raises ValueError for what is no such message."""
    import msgpack

    try:
        return msgpack.unpackb(message, object_hook=_array_of_map)
    except Exception as fault:  # whatever bytes they are
        raise ValueError(f"it is no msgpack of this protocol ({fault})") from fault


def _array_of_map(value: dict[Any, Any]) -> Any:
    if b"__ndarray__" in value:
        dtype = np.dtype(value[b"dtype"])
        if dtype.kind not in NUMBERS:
            raise ValueError(f"an array of {dtype}")
        return np.frombuffer(value[b"data"], dtype).reshape(value[b"shape"])
    if b"__npgeneric__" in value:
        return np.dtype(value[b"dtype"]).type(value[b"data"])
    return value


class OpenPi:
    """A Model (acting.py). `address`: host:port."""

    def __init__(self, address: str, start_limit_s: float, hang_limit_s: float):
        self._start_limit_s = start_limit_s
        self._connection = Websocket(address, hang_limit_s)

    def begin(self) -> None:
        if self._connection.is_connected:
            return
        self._connection.connect(self._start_limit_s)
        try:
            metadata = self._received(self._start_limit_s)
        except PolicyFailed as fault:
            raise self._other_protocol(fault.message) from fault
        if not isinstance(metadata, dict):
            self.close()
            raise self._other_protocol(f"it begins with {type(metadata).__name__}")

    def _other_protocol(self, why: str) -> Error:
        message = f"it does not speak as a server of openpi, which begins with its metadata: {why}"
        return Error("episode.no_policy", self._connection.address, message)

    def infer(self, told: dict[str, Any]) -> Any:
        self._connection.send(packed(told))
        return self._received()

    def _received(self, limit_s: float | None = None) -> Any:
        message = self._connection.receive(limit_s)
        if isinstance(message, str):
            self.close()
            last = message.strip().splitlines()[-1:] or ["nothing"]
            raise PolicyFailed("episode.policy_failed", f"its server says: {last[0]}")
        try:
            return unpacked(message)
        except ValueError as fault:
            self.close()
            raise PolicyFailed(BAD_ANSWER, str(fault)) from fault

    def close(self) -> None:
        self._connection.close()
