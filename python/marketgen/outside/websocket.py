"""A websocket to a policy's server: whole binary messages there and back, in a given time.

What goes wrong is a PolicyFailed with the code of what it is, and the connection is closed then: an answer that comes late would
else be taken for that to the next question.
"""

from __future__ import annotations

import contextlib
import logging
import socket
import time
from typing import Any

from ..errors import Error
from ..policy_process import PolicyFailed
from .waiting import LOOK_UP_S, Deadline

MAX_BYTES = 1 << 26  # of an answer


class Websocket:
    """Connected by connect(). `hang_limit_s`: of waiting for one answer; 0: none."""

    def __init__(self, address: str, hang_limit_s: float):
        self.address, self._hang_limit_s = address, hang_limit_s
        self._socket: Any = None
        self._open = contextlib.ExitStack()

    @property
    def is_connected(self) -> bool:
        return self._socket is not None

    def connect(self, start_limit_s: float) -> None:
        """Tries again until `start_limit_s` of wall time is over; 0: for ever. Raises Error episode.no_policy."""
        deadline, why = Deadline(start_limit_s), "it was not tried"
        while True:
            try:
                self._connect(max(deadline.slice_s(), LOOK_UP_S))
                return
            except (OSError, EOFError, _websockets().exceptions.WebSocketException) as fault:
                why = str(fault) or type(fault).__name__
            if deadline.is_over():
                raise Error(
                    "episode.no_policy", self.address, f"no policy's server answers there within {start_limit_s:g} s ({why}): start it"
                )
            time.sleep(deadline.slice_s())

    def _connect(self, limit_s: float) -> None:
        connect = _websockets().sync.client.connect
        # No pings: a server that computes in the thread that would answer them is slow, not gone.
        opened = connect(
            f"ws://{self.address}",
            compression=None,
            max_size=MAX_BYTES,
            open_timeout=max(limit_s, 10 * LOOK_UP_S),
            ping_interval=None,
            logger=_silent(),
        )
        self._socket = self._open.enter_context(opened)
        self._socket.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    def send(self, message: bytes) -> None:
        try:
            self._socket.send(message)
        except _websockets().exceptions.ConnectionClosed as fault:
            self._lost(fault)

    def receive(self, limit_s: float | None = None) -> bytes | str:
        """The next message, within `limit_s` (that of answers, without it)."""
        limit_s = self._hang_limit_s if limit_s is None else limit_s
        deadline = Deadline(limit_s)
        while True:
            try:
                return self._socket.recv(timeout=deadline.slice_s())
            except TimeoutError:
                if deadline.is_over():
                    self.close()
                    raise PolicyFailed(
                        "episode.policy_hung", f"{self.address} gave no answer within {limit_s:g} s of wall time (hang_limit_s)"
                    ) from None
            except _websockets().exceptions.ConnectionClosed as fault:
                self._lost(fault)

    def _lost(self, fault: Exception) -> None:
        self.close()
        raise PolicyFailed("episode.server_lost", f"{self.address} closed the connection ({fault})") from fault

    def close(self) -> None:
        if self._socket is not None:
            self._socket.close_timeout = LOOK_UP_S  # one that hangs does not answer that, either
            self._open.close()
        self._socket = None


def _websockets() -> Any:
    import websockets.exceptions
    import websockets.sync.client

    return websockets


def _silent() -> logging.Logger:
    logger = logging.getLogger("marketgen.outside.websocket")
    logger.setLevel(logging.CRITICAL)
    return logger
