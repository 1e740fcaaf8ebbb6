"""Policies written in Python, in this process or in one of their own.

One that never answers cannot be stopped from inside its own process (a thread cannot be killed); a process can. So with a
limit the policy is pickled into a new process, and that is ended when an answer takes too long.
"""

from __future__ import annotations

import multiprocessing
import pickle
import time
import traceback
from typing import Any

from .errors import Error

FIRST_WORD_S = 120.0  # a new process imports what the policy needs


class PolicyFailed(Exception):
    """The policy raised, hung or died; its episode ends with it."""

    def __init__(self, code: str, message: str):
        super().__init__(message)
        self.code, self.message = code, message


def ready(policy: Any) -> Any:
    """The object that is asked: a class is called, an object with act() is taken, a function is what acts."""
    return policy() if isinstance(policy, type) else policy


def asked(policy: Any, method: str, *arguments: Any) -> Any:
    if method == "act" and not hasattr(policy, "act"):
        return policy(*arguments)
    call = getattr(policy, method, None)
    return None if call is None else call(*arguments)


def _said(fault: BaseException) -> str:
    last = traceback.extract_tb(fault.__traceback__)[-1:]
    place = f" ({last[0].filename}:{last[0].lineno})" if last else ""
    return f"{type(fault).__name__}: {fault}{place}"


class PolicyHere:
    """A policy in this process; without a limit."""

    def __init__(self, policy: Any):
        self._policy = ready(policy)

    def ask(self, method: str, *arguments: Any) -> Any:
        try:
            return asked(self._policy, method, *arguments)
        except Exception as fault:
            raise PolicyFailed("episode.policy_failed", _said(fault)) from fault

    def close(self) -> None:
        pass


def _serve(connection: Any, pickled: bytes) -> None:
    """The inside of the process: ("ok", answer) or ("error", text) for each call."""
    try:
        policy = ready(pickle.loads(pickled))
    except Exception as fault:
        connection.send(("error", _said(fault)))
        return
    connection.send(("ok", None))
    while True:
        try:
            method, arguments = connection.recv()
        except EOFError:
            return
        try:
            connection.send(("ok", asked(policy, method, *arguments)))
        except Exception as fault:
            connection.send(("error", _said(fault)))


class PolicyProcess:
    """A policy in a process of its own, started at the first question and anew after it was ended."""

    def __init__(self, policy: Any, limit_s: float):
        try:
            self._pickled = pickle.dumps(policy)
        except Exception as fault:
            raise Error(
                "usage.bad_flag",
                "policy",
                f"it cannot be sent to a process of its own ({fault}): define it in a module that can be imported, "
                "or give act_limit_s=0, which runs it in this one",
            ) from fault
        self._limit_s = limit_s
        self._process: Any = None
        self._connection: Any = None

    def ask(self, method: str, *arguments: Any) -> Any:
        if self._process is None:
            self._start()
        try:
            self._connection.send((method, arguments))
        except OSError:
            self._died()
        return self._answer(self._limit_s)

    def _start(self) -> None:
        context = multiprocessing.get_context("spawn")
        self._connection, theirs = context.Pipe()
        self._process = context.Process(target=_serve, args=(theirs, self._pickled), daemon=True)
        self._process.start()
        theirs.close()
        try:
            self._answer(FIRST_WORD_S)
        except PolicyFailed as fault:
            self.close()
            raise Error(
                "episode.policy_failed",
                "policy",
                f"it does not start in a process of its own: {fault.message}; a script's own code belongs under "
                'if __name__ == "__main__"',
            ) from fault

    def _answer(self, limit_s: float) -> Any:
        until = time.monotonic() + limit_s
        try:
            if not self._connection.poll(max(0.0, until - time.monotonic())):
                self.close()
                raise PolicyFailed(
                    "episode.policy_hung", f"took longer than {limit_s:g} s over one answer (act_limit_s)"
                )
            word, value = self._connection.recv()
        except (EOFError, OSError):
            self._died()
        if word == "error":
            raise PolicyFailed("episode.policy_failed", value)
        return value

    def _died(self) -> None:
        self._process.join(1)
        status = self._process.exitcode
        self.close()
        raise PolicyFailed("episode.policy_crashed", f"its process ended with status {status}")

    def close(self) -> None:
        if self._process is not None:
            self._process.kill()
            self._process.join()
            self._connection.close()
        self._process = None
