"""Policies for evaluation_test.py: a module of its own, so that another process finds them."""

import os
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
        if self.what == "crashes":
            os._exit(3)
        if self.what == "nan":
            action[0] = np.nan
        return action[:3] if self.what == "short" else None if self.what == "nothing" else action
