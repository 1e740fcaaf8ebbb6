"""The protocol of GR00T's policy servers since N1.6 (gr00t/policy/server_client.py of Isaac-GR00T).

ZeroMQ, a request and its reply, msgpack both: {"endpoint": ..., "data": {...}}; an array is a map with "__ndarray_class__" and "as_npy",
the bytes of an .npy file. Endpoints: ping, reset, get_action, which replies [actions by name, (1, steps, numbers)] and something
about them. A reply {"error": ...} is what went wrong in the server. Observations have two axes more in front: batch and time, both
one long.
"""

from __future__ import annotations

import io
from typing import Any

import numpy as np

from ..errors import Error
from ..policy_process import PolicyFailed
from .adaptation import BAD_ANSWER
from .waiting import Deadline
from .websocket import MAX_BYTES


def packed(value: Any) -> bytes:
    import msgpack

    return msgpack.packb(value, default=_map_of_array)


def _map_of_array(value: Any) -> Any:
    if not isinstance(value, np.ndarray):
        raise TypeError(f"{type(value).__name__} does not travel")
    written = io.BytesIO()
    np.save(written, value, allow_pickle=False)
    return {"__ndarray_class__": True, "as_npy": written.getvalue()}


def unpacked(message: bytes) -> Any:
    """Raises ValueError for what is no such message."""
    import msgpack

    try:
        return msgpack.unpackb(message, object_hook=_array_of_map)
    except Exception as fault:  # whatever bytes they are
        raise ValueError(f"it is no msgpack of this protocol ({fault})") from fault


def _array_of_map(value: dict[Any, Any]) -> Any:
    return np.load(io.BytesIO(value["as_npy"]), allow_pickle=False) if "__ndarray_class__" in value else value


def batched(told: Any) -> Any:
    """With axes for batch and time."""
    if isinstance(told, dict):
        return {name: batched(part) for name, part in told.items()}
    return told[None, None] if isinstance(told, np.ndarray) else [[told]]


class Groot:
    """A Model (acting.py). `address`: host:port."""

    def __init__(self, address: str, start_limit_s: float, hang_limit_s: float):
        self.address, self._start_limit_s, self._hang_limit_s = address, start_limit_s, hang_limit_s
        self._socket: Any = None
        self._ended: Any = None  # says when the connection is lost

    def begin(self) -> None:
        try:
            if self._socket is None:
                self._connect()
                self._asked("ping", self._start_limit_s)
            self._asked("reset", self._hang_limit_s, {"options": None})
        except PolicyFailed as fault:
            self.close()
            message = f"no server of GR00T, N1.6 or later, answers there within {self._start_limit_s:g} s ({fault.message}): start it"
            raise Error("episode.no_policy", self.address, message) from fault

    def _connect(self) -> None:
        import zmq
        import zmq.utils.monitor

        self._socket = zmq.Context.instance().socket(zmq.REQ)
        self._socket.setsockopt(zmq.LINGER, 0)
        self._socket.setsockopt(zmq.MAXMSGSIZE, MAX_BYTES)
        self._ended = self._socket.get_monitor_socket(zmq.EVENT_DISCONNECTED)
        self._socket.connect(f"tcp://{self.address}")

    def infer(self, told: dict[str, Any]) -> Any:
        if self._socket is None:
            raise PolicyFailed("episode.server_lost", f"there is no connection to {self.address}")
        answer = self._asked("get_action", self._hang_limit_s, {"observation": batched(told), "options": None})
        if not isinstance(answer, list) or not answer:
            raise PolicyFailed(BAD_ANSWER, f"{type(answer).__name__} in place of a list of actions and what there is about them")
        return answer[0]

    def _asked(self, endpoint: str, limit_s: float, data: dict[str, Any] | None = None) -> Any:
        self._socket.send(packed({"endpoint": endpoint} if data is None else {"endpoint": endpoint, "data": data}))
        try:
            answer = unpacked(self._reply(endpoint, limit_s))
        except ValueError as fault:
            self.close()
            raise PolicyFailed(BAD_ANSWER, str(fault)) from fault
        if isinstance(answer, dict) and "error" in answer:
            raise PolicyFailed("episode.policy_failed", f"its server says: {answer['error']}")
        return answer

    def _reply(self, endpoint: str, limit_s: float) -> bytes:
        import zmq

        poller, deadline = zmq.Poller(), Deadline(limit_s)
        for one in (self._socket, self._ended):
            poller.register(one, zmq.POLLIN)
        while not deadline.is_over():
            ready = dict(poller.poll(1000 * deadline.slice_s()))
            if self._socket in ready:
                return self._socket.recv()
            if self._ended in ready:
                self._ended.recv_multipart()
                if endpoint != "ping":  # which waits for a server that is not there yet
                    self.close()
                    raise PolicyFailed("episode.server_lost", f"{self.address} closed the connection")
        self.close()
        raise PolicyFailed("episode.policy_hung", f"{self.address} gave no answer within {limit_s:g} s of wall time (hang_limit_s)")

    def close(self) -> None:
        if self._socket is not None:
            self._socket.disable_monitor()
            self._socket.close(0)
        self._socket = self._ended = None
