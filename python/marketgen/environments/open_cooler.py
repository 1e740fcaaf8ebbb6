"""A stage of In-Aisle Item Collection: the door before what is asked for is opened."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np

from .pick_from_shelf import witness_arm
from .stage_env import StageEnv

NEAR_M = 0.05  # of the tanh by which the distance of the hand counts
REACH_SHARE, HELD_SHARE, OPEN_SHARE = 0.25, 0.2, 0.45
MOVE_SHARE, TURN_SHARE = 0.3, 0.2  # of the whole task's: 6 mm and 0.02 rad in a control step
REACH_M, TOOL_M, BEHIND_RAD, OPENING_M, FAST_RAD_S = 0.1, 1.0, math.radians(45), 0.0896, 1.0  # what 1 stands for


class OpenCooler(StageEnv):
    """The robot of In-Aisle Item Collection stands before a shut glass door of a cooler, an open hand 10 cm before its bar: it is to
    pull the door open.

    An action moves that arm's tool (x ahead, y to the hinge's side, z up: 1 = 6 mm, 20 times a second; turn as the leaf turns when it
    opens: 1 = 0.02 rad) and opens (above 0) or closes its gripper, 10 times a second. What lies to the hinge's side is told so, too: doors
    that are hung on the other side look alike. Base, lift and the other arm stand still. It has 10 s. Done: the door stands open by 50
    degrees. Lost: something happened that no clean episode has.

    Progress: 0.25 (1 - tanh(hand to bar / 5 cm)) + 0.2 when both fingers are on the door + 0.45 (open / 50 degrees, 0 to 1); done: 1.
    """

    track, stage = "aisle", "open"
    control = "pd_ee_delta_pose"
    limit_s, hold = 10.0, 2
    moves = ("tool_x", "tool_y", "tool_z", "tool_turn_z", "tool_opening")
    sees = (
        "to_bar_x", "to_bar_y", "to_bar_z", "tool_x", "tool_y", "tool_z", "behind", "open", "open_speed", "opening", "held",
        "last_x", "last_y", "last_z", "last_turn", "last_opening", "stopped",
    )  # fmt: skip

    def __init__(self, *args: Any, **options: Any):
        self._left = True
        super().__init__(*args, **options)
        self._door: dict[str, Any] = {}

    def _told_names(self) -> tuple[str, ...]:
        side = "left" if self._left else "right"
        return tuple(f"{side}_{name}" for name in self.moves)

    def _begin(self, text: str) -> None:
        self._left = witness_arm(json.loads(text)) == "left_arm"
        super()._begin(text)

    def _prepare(self) -> None:
        self._door = self.environment.door()

    def _told(self, numbers: np.ndarray) -> np.ndarray:
        side = self._door["side"]
        x, y, z, turn = numbers[:4] * (MOVE_SHARE, side * MOVE_SHARE, MOVE_SHARE, -side * TURN_SHARE)
        return np.array([x, y, z, turn, 1 if numbers[4] > 0 else -1])

    def _act(self, numbers: np.ndarray) -> bool:
        ended = super()._act(numbers)
        self._door = self.environment.door()
        return ended

    def _numbers(self) -> list[float]:
        door, mirror = self._door, np.array([1, self._door["side"], 1])
        opening = self.parts()["agent"]["qpos"][-2 if self._left else -1]
        return [
            *mirror * door["to_bar"] / REACH_M, *mirror * door["tool"] / TOOL_M, door["behind_rad"] / BEHIND_RAD,
            2 * door["position_rad"] / door["asked_rad"] - 1, door["speed_rad_s"] / FAST_RAD_S, 2 * opening / OPENING_M - 1,
            float(door["held"]), *self._last, float(self.environment.robot_stopped()),
        ]  # fmt: skip

    def _progress(self) -> float:
        door = self._door
        reached = REACH_SHARE * (1 - math.tanh(float(np.linalg.norm(door["to_bar"])) / NEAR_M))
        opened = OPEN_SHARE * float(np.clip(door["position_rad"] / door["asked_rad"], 0, 1))
        return reached + HELD_SHARE * door["held"] + opened

    def _done(self) -> bool:
        return self._door["clean"] and self._door["position_rad"] >= self._door["asked_rad"]

    def _lost(self) -> bool:
        return not self._door["clean"]

    def _take_own_state(self, state: dict[str, Any]) -> None:
        super()._take_own_state(state)
        self._door = self.environment.door()
