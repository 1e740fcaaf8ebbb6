"""A hand that a stage leads: level, by even speeds, in its own frame."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

STEP_M, STEP_RAD = 0.02, 0.1  # what 1 of the whole task's actions is
MAX_LEAD_M = 0.008  # before the tool: nothing is pressed against on and on, and a wrist near its stretch has time to turn
MAX_CHANGE_M = 0.001  # of the speed, from one control step to the next: what is reversed at once shakes the arm


def _turn_between(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The small rotation vector, along the axes of their parent, that brings quaternion a (w, x, y, z) to b."""
    part = b[0] * a[0] + b[1:] @ a[1:]
    turn = a[0] * b[1:] - b[0] * a[1:] - np.cross(b[1:], a[1:])
    return 2 * math.copysign(1, part) * turn


class LedHand:
    """Where a tool is to be, from control step to control step. What is told by steps from where the tool is drifts, since an arm is
    always a little behind; this keeps the place that was meant, and the turn that the tool had at first.

    tool  its pose then: x, y, z, qw, qx, qy, qz in the frame of the robot's base, metres; it points along its z axis, level
    """

    def __init__(self, tool: np.ndarray):
        self.place, self.turned = tool[:3].astype(float), tool[3:].astype(float)
        self.height_m = float(tool[2])  # at first
        self.speed = np.zeros(3)  # along `axes`, metres in a control step
        w, x, y, z = self.turned
        ahead = np.array([x * z + w * y, y * z - w * x])
        ahead = ahead / np.linalg.norm(ahead)
        self.axes = np.array([[*ahead, 0], [-ahead[1], ahead[0], 0], [0, 0, 1]])  # rows: ahead, to the left, up

    def told(self, tool: np.ndarray, asked_m: np.ndarray, *, stopped: bool) -> np.ndarray:
        """The next step as pd_ee_delta_pose has it: x, y, z and a turn about them.

        tool     where it is, as at first
        asked_m  ahead, to the left, up in this control step, which the speed comes near to
        stopped  the robot takes no commands: it goes on from where it is
        """
        at = tool[:3].astype(float)
        self.speed = self.speed + np.clip(asked_m - self.speed, -MAX_CHANGE_M, MAX_CHANGE_M)
        wanted = (at if stopped else self.place) + self.speed @ self.axes
        lead = np.clip(wanted - at, -MAX_LEAD_M, MAX_LEAD_M)
        self.place = at + lead
        return np.array([*lead / STEP_M, *_turn_between(tool[3:].astype(float), self.turned) / STEP_RAD])

    def state(self) -> dict[str, Any]:
        return {"first": [*self.place[:2], self.height_m, *self.turned], "place": self.place.tolist(), "speed": self.speed.tolist()}

    @classmethod
    def of_state(cls, state: dict[str, Any]) -> LedHand:
        hand = cls(np.array(state["first"]))
        hand.place, hand.speed = np.array(state["place"]), np.array(state["speed"])
        return hand
