"""Policies for evaluation_test.py: a module of its own, so that another process finds them."""

import ctypes
import json
import os
import pathlib
import subprocess
import sys
import time

import numpy as np

NUMBERS = 9  # of an action of pd_joint_delta_pos at the counter


def still(observation):
    action = np.zeros(NUMBERS, np.float32)
    action[-1] = -1
    return action


class StopsAtOnce:
    """Says at the second step that it has done, and why it failed."""

    name = "stops"

    def begin(self, task, observation):
        assert task["track"] == "checkout" and task["goals"] and task["action_names"][-1] == "stop"
        assert observation["agent"]["qpos"].shape == (8,)
        self.steps = 0

    def act(self, observation):
        self.steps += 1
        action = still(observation)
        action[-1] = 1 if self.steps == 2 else -1
        return action

    def failure(self):
        return "NoGrasp"


class FailsOnce:
    """Does `what` in the first episode, and stops at once in those that follow. In a new process every episode is the first,
    so `mark` is a file that says that it was."""

    def __init__(self, what, mark):
        self.what, self.mark, self.name = what, mark, what

    def act(self, observation):
        action = still(observation)
        if os.path.exists(self.mark):
            action[-1] = 1
            return action
        open(self.mark, "w").close()
        if self.what == "raises":
            raise KeyError("where is it?")
        if self.what == "hangs":
            time.sleep(1000)
        if self.what == "computes":
            while True:
                pass
        if self.what == "crashes":
            os._exit(3)
        if self.what == "nan":
            action[0] = np.nan
        return action[:3] if self.what == "short" else None if self.what == "nothing" else action


class Stuck:
    """Starts a child that sleeps, notes both numbers in a file, and never answers."""

    def __init__(self, file):
        self.file = file

    def act(self, observation):
        child = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(1000)"])
        with open(self.file + ".part", "w") as out:
            out.write(f"{os.getpid()} {child.pid}")
        os.rename(self.file + ".part", self.file)
        while True:
            pass


class HangsAtImport:
    """As a policy whose module never gets to its end."""

    def __init__(self, payload):
        self.payload = payload

    def __reduce__(self):
        return _sleep, (1000, bytes(self.payload))

    def act(self, observation):
        return None


def _sleep(seconds, _payload):
    time.sleep(seconds)


class ComputesAtImport(HangsAtImport):
    def __init__(self):
        super().__init__(0)

    def __reduce__(self):
        return _count, ()


def _count():
    return sum(iter(int, 1))  # for ever


class BreaksAtImport(HangsAtImport):
    def __init__(self):
        super().__init__(0)

    def __reduce__(self):
        return _divide, (0,)


def _divide(number):
    return 1 / number


class Spy:
    """Tries to read what it must not know, and notes in `folder` how far it got. `paths`: where it would look."""

    name = "spy"

    def __init__(self, folder, paths):
        self.folder, self.paths = pathlib.Path(folder), paths

    def begin(self, task, observation):
        parent = f"/proc/{os.getppid()}"
        looks = [*self.paths, *(f"{parent}{path}" for path in ("/environ", "/maps", "/mem", "/auxv"))]
        looks += [f"{parent}/root{path}" for path in self.paths] + [f"{parent}/fd/{number}" for number in range(64)]
        self.note("told", {"task": repr(task), "observation": repr(observation), "names": sorted(task)})
        self.note("opened", [path for path in looks if opens(path)])
        self.note("written", [path for path in self.paths if opens(path, os.O_WRONLY)])
        self.note("traced", [look(os.getppid()) for look in (attached, read_from)])
        self.note("signalled", signalled(os.getppid()))
        self.note("episodes", [file for place in (os.getcwd(), *map(os.path.dirname, self.paths)) for file in episodes_in(place)])
        self.note("held", {number: os.readlink(f"/proc/self/fd/{number}") for number in open_files()})
        self.note("environment", dict(os.environ))
        self.note("command", pathlib.Path("/proc/self/cmdline").read_text().split("\0"))

    def note(self, what, found):
        (self.folder / f"{what}.json").write_text(json.dumps(found))

    def act(self, observation):
        action = still(observation)
        action[-1] = 1
        return action


def opens(path, flags=os.O_RDONLY):
    try:
        os.close(os.open(path, flags))
    except OSError:
        return False
    return True


def open_files():
    return [number for number in os.listdir("/proc/self/fd") if os.path.lexists(f"/proc/self/fd/{number}")]


def episodes_in(place):
    """Files there, however deep and whatever they are called, that can be read and hold an episode."""
    for folder, _, names in os.walk(place):
        for path in (os.path.join(folder, name) for name in names):
            if opens(path) and b'"market-episode' in pathlib.Path(path).read_bytes():
                yield path


def signalled(pid):
    try:
        os.kill(pid, 0)
    except PermissionError:
        return False
    return True


def attached(pid):
    """By PTRACE_ATTACH."""
    return ctypes.CDLL(None).ptrace(16, pid, None, None) == 0


def read_from(pid):
    """Of its memory, where ours has something, by process_vm_readv."""
    there, here = ctypes.create_string_buffer(8), ctypes.create_string_buffer(8)
    part = ctypes.c_size_t * 2
    to, at = part(ctypes.addressof(here), 8), part(ctypes.addressof(there), 8)
    return ctypes.CDLL(None, use_errno=True).process_vm_readv(pid, to, 1, at, 1, 0) > 0 or ctypes.get_errno() == 14  # EFAULT


class Bomb:
    """Answers with what runs, where it is unpickled, `open(mark, "w")`."""

    def __init__(self, mark):
        self.mark = mark

    def __reduce__(self):
        return open, (self.mark, "w")


class Answers:
    """With one and the same thing."""

    def __init__(self, answer):
        self.answer = answer

    def act(self, observation):
        return self.answer() if callable(self.answer) else self.answer


class Babbles:
    """Writes onto its connection by itself."""

    def act(self, observation):
        for number in open_files():
            if os.readlink(f"/proc/self/fd/{number}").startswith("socket:"):
                os.write(int(number), b"\0\0\0\4what")
        time.sleep(1000)


class ReadsAtStart:
    """Its process reads a file before it is ready."""

    def __init__(self, file):
        self.file = file

    def __reduce__(self):
        return _read, (self.file,)

    def act(self, observation):
        return None


def _read(file):
    return open(file).read()


class Echo:
    """Answers how much it was given, in all."""

    def __init__(self, payload):
        self.payload = payload

    def act(self, observation):
        return len(self.payload) + len(observation)


class Waits:
    """As one whose process gets no turn on a busy machine: it answers late and computes next to nothing."""

    def act(self, seconds):
        time.sleep(seconds)
        return seconds


class Computes:
    """Answers by itself, after so much processor time."""

    def act(self, seconds):
        end = time.process_time() + seconds
        while time.process_time() < end:
            pass
        return seconds
