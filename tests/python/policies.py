"""Policies for evaluation_test.py: a module of its own, so that another process finds them."""

import os
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


class BreaksAtImport(HangsAtImport):
    def __init__(self):
        super().__init__(0)

    def __reduce__(self):
        return _divide, (0,)


def _divide(number):
    return 1 / number


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
