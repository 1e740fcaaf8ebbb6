"""Policies written in Python, in this process or in one of their own.

One that never answers cannot be stopped from inside its own process (a thread cannot be killed); a process can. So with a
limit the policy is pickled into a new process, and that is ended when it computes too long over an answer or never gives one,
with whatever the policy has started. It ends with this process, too, however this one ends. What a notebook's cell or a script
defines travels as code (cloudpickle), so that the new process imports neither.

This process simulates, so it knows the truth; the policy's is told a task and observations, over a pipe, and answers with
numbers (answers.py). Where the kernel can it opens nothing else either (confinement.py).
"""

from __future__ import annotations

import dataclasses
import importlib
import importlib.util
import math
import multiprocessing.connection
import multiprocessing.spawn
import os
import pathlib
import pickle
import socket
import struct
import sys
import tempfile
import time
import traceback
from collections.abc import Sequence
from typing import Any, ClassVar

from . import _core, answers, arguments, confinement
from .errors import Error

LOOK_UP_S = 0.2  # how often an interrupt is looked for
GRACE_S = 1.0  # that a process which has closed its end may take to end

# The inside of the process; its standard input is the connection.
PROGRAM = "import sys; sys.path.insert(0, sys.argv[1]); from marketgen.policy_process import serve; serve()"


class PolicyFailed(Exception):
    """The policy raised, was too slow, hung or died; its episode ends with it."""

    def __init__(self, code: str, message: str):
        super().__init__(message)
        self.code, self.message = code, message


class PolicySource:
    """A policy that only the process in which it acts makes or loads: load(). `name` stands in results."""

    name: str

    def load(self) -> Any:
        raise NotImplementedError

    def folders(self) -> list[str]:
        """That its process reads beside what a policy's process reads anyway."""
        return []


@dataclasses.dataclass(frozen=True)
class PolicyFile(PolicySource):
    """`name` in the Python file `path`."""

    path: str
    name: str

    @classmethod
    def of_text(cls, text: str) -> PolicyFile:
        """ "FILE.py:NAME". Raises Error usage.bad_flag, input.not_found."""
        file, _, name = text.rpartition(":")
        if not file.endswith(".py") or not name.isidentifier():
            raise Error("usage.bad_flag", "policy", f"{text!r} is neither a policy's name nor FILE.py:NAME")
        return cls(arguments.existing("policy", file), name)

    def load(self) -> Any:
        sys.path.insert(0, os.path.dirname(self.path))  # as a script finds what lies beside it
        spec = importlib.util.spec_from_file_location(pathlib.Path(self.path).stem, self.path)
        assert spec is not None and spec.loader is not None  # its name ends with .py
        module = sys.modules[spec.name] = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        return getattr(module, self.name)

    def folders(self) -> list[str]:
        return [os.path.dirname(self.path)]


@dataclasses.dataclass(frozen=True)
class PolicyModule(PolicySource):
    """`name` in a module that Python finds by its name: "python:mypackage.policies:Mine"."""

    module: str
    name: str

    PREFIX: ClassVar[str] = "python:"

    @classmethod
    def of_text(cls, text: str) -> PolicyModule:
        """Raises Error usage.bad_flag, input.not_found."""
        module, _, name = text.removeprefix(cls.PREFIX).rpartition(":")
        if not name.isidentifier() or not all(part.isidentifier() for part in module.split(".")):
            raise Error("usage.bad_flag", "policy", f"{text!r}: expected {cls.PREFIX}MODULE:NAME")
        top = module.partition(".")[0]
        if importlib.util.find_spec(top) is None:  # looks for it without running it
            raise Error("input.not_found", top, "policy names it, and Python finds no such module: install it, or set PYTHONPATH")
        return cls(module, name)

    def load(self) -> Any:
        return getattr(importlib.import_module(self.module), self.name)


def policy_of_text(text: str) -> PolicySource:
    """FILE.py:NAME or python:MODULE:NAME. Raises Error usage.bad_flag, input.not_found."""
    return (PolicyModule if text.startswith(PolicyModule.PREFIX) else PolicyFile).of_text(text)


def ready(policy: Any) -> Any:
    """The object that is asked: a class is called, an object with act() is taken, a function is what acts."""
    if isinstance(policy, PolicySource):
        policy = policy.load()
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


def serve() -> None:
    """The inside of the process: "ok" and the answer, or "error" and a text, for each call."""
    connection = multiprocessing.connection.Connection(os.dup(0))

    def say(word: str, value: Any) -> None:
        connection.send_bytes(answers.packed(word, value))

    null = os.open(os.devnull, os.O_RDONLY)
    os.dup2(null, 0)
    os.close(null)
    say("ok", None)
    try:
        path, pickled = connection.recv()
        sys.path[:] = path
        policy = ready(pickle.loads(pickled))
    except Exception as fault:
        say("error", _said(fault))
        return
    say("ok", None)
    while True:
        try:
            method, arguments = connection.recv()
        except EOFError:
            return
        try:
            answer = asked(policy, method, *arguments)
        except Exception as fault:
            say("error", _said(fault))
        else:
            say("ok", None if method == "begin" else answer)


def _pickled(policy: Any) -> bytes:
    import cloudpickle

    try:
        return cloudpickle.dumps(policy)
    except Exception as fault:
        raise Error(
            "usage.bad_flag",
            "policy",
            f"it cannot be sent to a process of its own ({_said(fault)}): give a class, which is made there, "
            "or act_limit_s=0, which runs it in this one",
        ) from fault


class PolicyProcess:
    """A policy in a process of its own, started at the first question and anew after it was ended.

    act_limit_s    of processor time of that process, over one answer: a busy machine does not change it
    hang_limit_s   of wall time, against one that waits for what never comes and so uses no processor time; 0: none
    start_limit_s  of processor time, until it is ready; hang_limit_s holds for that, too. 0: none
    sight          what it may open (policy_sight.py); None: what we may
    """

    def __init__(
        self,
        policy: Any,
        act_limit_s: float,
        hang_limit_s: float = 1200.0,
        start_limit_s: float = 120.0,
        sight: Sequence[confinement.Rule] | None = None,
    ):
        self._pickled = _pickled(policy)
        self._act_limit_s, self._hang_limit_s, self._start_limit_s = act_limit_s, hang_limit_s, start_limit_s
        self._sight = sight
        self._group: Any = None
        self._connection: Any = None
        self._scratch: tempfile.TemporaryDirectory[str] | None = None

    def ask(self, method: str, *arguments: Any) -> Any:
        if self._group is None:
            self._start()
        computed_s = self._group.cpu_s()
        answer = self._asked((method, arguments), self._hang_limit_s, computed_s + self._act_limit_s)
        # What counts is how much it took, not when that was looked at.
        if self._group.cpu_s() - computed_s >= self._act_limit_s:
            self._slow()
        return answer

    def _start(self) -> None:
        ours, theirs = socket.socketpair()
        # One that stops reading or writing in the middle of a message must not hold us, either.
        longest = struct.pack("ll", int(self._hang_limit_s) + 1 if self._hang_limit_s else 0, 0)
        for way in (socket.SO_SNDTIMEO, socket.SO_RCVTIMEO):
            ours.setsockopt(socket.SOL_SOCKET, way, longest)
        python = os.fsdecode(multiprocessing.spawn.get_executable())
        command = [python, "-c", PROGRAM, str(pathlib.Path(__file__).parents[1])]
        if self._sight is not None:
            command = confinement.confined_command(command)
        with theirs:
            self._group = _core.start_process_group(command, [theirs.fileno(), -1, -1])
        self._connection = multiprocessing.connection.Connection(ours.detach())
        try:
            self._confine()
            limits_s = self._hang_limit_s, self._start_limit_s or math.inf
            self._answer(*limits_s)  # it listens: what follows may be larger than any buffer
            self._asked((sys.path, self._pickled), *limits_s)
        except PolicyFailed as fault:
            self.close()
            spent = {
                "episode.policy_slow": f"{self._start_limit_s:g} s of processor time (start_limit_s)",
                "episode.policy_hung": f"{self._hang_limit_s:g} s of wall time (hang_limit_s)",
            }
            if fault.code in spent:
                why = f"it was not ready after {spent[fault.code]}: what it imports or loads takes too long"
            else:
                why = f"{fault.message}; act_limit_s=0 runs it in this one"
            raise Error("episode.no_policy", "policy", f"it does not start in a process of its own: {why}") from fault

    def _confine(self) -> None:
        if self._sight is None:
            return
        self._scratch = tempfile.TemporaryDirectory(prefix="marketgen-policy-", ignore_cleanup_errors=True)
        rules = [*self._sight, confinement.Rule(self._scratch.name, "write")]
        self._send(confinement.told(rules, {"TMPDIR": self._scratch.name}), self._hang_limit_s)

    def _asked(self, message: Any, limit_s: float, max_cpu_s: float = math.inf) -> Any:
        self._send(pickle.dumps(message, pickle.HIGHEST_PROTOCOL), limit_s)
        return self._answer(limit_s, max_cpu_s)

    def _send(self, message: bytes, limit_s: float) -> None:
        try:
            self._connection.send_bytes(message)
        except BlockingIOError:
            self._hung(limit_s)
        except OSError:
            self._died()

    def _answer(self, limit_s: float, max_cpu_s: float = math.inf) -> Any:
        """`limit_s` of wall time, 0: none; until the process has used `max_cpu_s` since it began."""
        until = time.monotonic() + (limit_s or math.inf)
        try:
            while not self._connection.poll(min(LOOK_UP_S, max(0.0, until - time.monotonic()))):
                _core.check_interrupt()
                if self._group.cpu_s() >= max_cpu_s:
                    self._slow()
                if time.monotonic() >= until:
                    self._hung(limit_s)
            word, value = answers.unpacked(self._connection.recv_bytes(answers.MAX_BYTES))
        except BlockingIOError:
            self._hung(limit_s)
        except (EOFError, OSError):
            self._died()
        except ValueError:
            self._babbled()
        if word == "error":
            raise PolicyFailed("episode.policy_failed", self._explained(str(value)))
        return value

    def _explained(self, said: str) -> str:
        """A file that is not there for it is the policy's commonest fault, and the hardest to guess."""
        if self._sight is None or not said.startswith(("PermissionError", "ModuleNotFoundError")):
            return said
        return f"{said}; a policy's process opens Python's files, its code's folders and those named in policy_files"

    def _babbled(self) -> None:
        self.close()
        raise PolicyFailed("episode.policy_crashed", "its process wrote what is no answer onto its connection")

    def _slow(self) -> None:
        self.close()
        why = f"computed for more than {self._act_limit_s:g} s over one answer (act_limit_s)"
        raise PolicyFailed("episode.policy_slow", why)

    def _hung(self, limit_s: float) -> None:
        self.close()
        raise PolicyFailed("episode.policy_hung", f"gave no answer within {limit_s:g} s of wall time (hang_limit_s)")

    def _died(self) -> None:
        ended = self._group.wait(GRACE_S)
        self.close()
        raise PolicyFailed("episode.policy_crashed", f"its process ended with {ended}")

    def close(self) -> None:
        if self._group is not None:
            self._group.end()
            self._connection.close()
        if self._scratch is not None:
            self._scratch.cleanup()
        self._group = self._scratch = None
