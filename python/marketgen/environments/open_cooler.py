"""A stage of In-Aisle Item Collection: the door before what is asked for is opened."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np

from .led_hand import STEP_M, STEP_RAD
from .pick_from_shelf import witness_arm
from .stage_env import StageEnv, opened_above

WITHIN_M = 0.004  # of the fingertips, when they hold the bar: shut 4 mm before it they slip
REACH_SHARE, NEAR_M, AT_SHARE, FINE_M = 0.15, 0.05, 0.25, 0.005  # of the hand's distance to there, two tanhs
HELD_SHARE, OPEN_SHARE = 0.05, 0.45
PULL_M, ASIDE_M = 0.004, 0.001  # in a control step, of a hand that holds the bar; at 6 mm it slips
SLOWEST_M, FASTEST_M, NEARER, AT_BAR_M = 0.0004, 0.004, 0.12, 0.005  # of one that does not, as it nears the bar
TOUCHED_N = 10.0  # from which on it goes back only
LEVEL, LEVEL_STEP_M = 0.3, 0.002  # of what it is too high or low, in a control step
AHEAD_RAD, TURNED, TURN_GAIN, TURN_RAD = math.radians(25), 0.69, 5.0, 0.02  # how the hand is turned to the leaf; in a control step
WIDE = 0.7  # of the hand: open
REACH_M, SMALL_M, TOOL_M, BEHIND_RAD = 0.1, 0.01, 1.0, math.radians(45)  # what 1 stands for
OPENING_M, FAST_RAD_S, HARD_N = 0.0896, 1.0, 50.0  # the same


class OpenCooler(StageEnv):
    """The robot of In-Aisle Item Collection stands before a shut glass door of a cooler, an open hand 6 cm before its bar: it is to
    pull the door open.

    An action moves that arm's tool as the leaf stands, 2.5 times a second: out of the leaf's plane and along it to the hinge, and opens
    (above 0) or closes its gripper. What lies to the hinge's side is told so: doors that are hung on either side look alike. The arm
    itself keeps the tool level with the middle of the bar, and turns it by 0.69 of the leaf's turn. A hand that has both fingers on the
    door moves by 4 mm (1, 20 times a second), 1 mm along, and does not push; another the slower the nearer it is to the bar, 4 to 0.4
    mm, and where it feels more than 10 N it goes back only: an open hand that is told to press on presses by less than 50 N. Base, lift
    and the other arm stand still. It has 16 s. Done: the door stands open by 50 degrees. Lost: something happened that no clean episode
    has.

    Progress: 0.15 (1 - tanh(d / 5 cm)) + 0.25 (1 - tanh(d / 5 mm)) with d from the hand to where the bar lies 4 mm within its tips, the
    second of an open hand; of one that has both fingers on the door 0.15, 0.25 (...) as it took it, 0.05 + 0.45 (open / 50 degrees, 0 to
    1); done: 1, lost: 0.
    """

    track, stage = "aisle", "open"
    control = "pd_ee_delta_pose"
    limit_s, hold = 16.0, 8
    moves = ("tool_out", "tool_along", "tool_opening")
    sees = (
        "to_bar_out", "to_bar_along", "out_fine", "along_fine", "to_bar_z", "tool_x", "tool_y", "leaf", "behind", "open",
        "open_speed", "opening", "held", "depth", "pressed", "last_out", "last_along", "last_opening", "stopped",
    )  # fmt: skip

    def __init__(self, *args: Any, **options: Any):
        self._left = True
        super().__init__(*args, **options)
        self._door: dict[str, Any] = {}
        self._depth = 0.0

    def _told_names(self) -> tuple[str, ...]:
        side = "left" if self._left else "right"
        return tuple(f"{side}_{name}" for name in ("tool_x", "tool_y", "tool_z", "tool_turn_z", "tool_opening"))

    def _begin(self, text: str) -> None:
        self._left = witness_arm(json.loads(text)) == "left_arm"
        super()._begin(text)

    def _prepare(self) -> None:
        self._door = {}
        self._look()

    # ---- The door's frame: out of the leaf's plane to who pulls, along it to the hinge. ----

    def _axes(self) -> np.ndarray:
        into, side = self._door["into_rad"], self._door["side"]
        return np.array([[-math.cos(into), -math.sin(into)], [-side * math.sin(into), side * math.cos(into)]])

    def _to_bar(self) -> np.ndarray:
        return self._axes() @ self._door["to_bar"][:2]

    def _share(self) -> float:
        return float(np.clip(self._door["position_rad"] / self._door["asked_rad"], 0, 1))

    def _pressed_n(self) -> float:
        return float(self.parts()["agent"]["external_force"][0 if self._left else -1])

    def _opening_m(self) -> float:
        return float(self.parts()["agent"]["qpos"][-2 if self._left else -1])

    def _is_open(self) -> bool:
        return self._opening_m() > WIDE * OPENING_M

    def _move_m(self, numbers: np.ndarray) -> np.ndarray:
        """Of an action, in a control step: out and along."""
        touched = self._pressed_n() > TOUCHED_N
        if self._door["held"]:
            return np.array([PULL_M * max(numbers[0], 0), 0 if touched else ASIDE_M * numbers[1]])
        before_bar = -self._to_bar()[0] - AT_BAR_M
        most = float(np.clip(SLOWEST_M + NEARER * before_bar, SLOWEST_M, FASTEST_M))
        out, along = most * numbers / max(1.0, float(np.linalg.norm(numbers)))
        return np.array([max(out, 0), 0]) if touched else np.array([out, along])

    def _told(self, numbers: np.ndarray) -> np.ndarray:
        door = self._door
        x, y = self._move_m(numbers[:2]) @ self._axes() / STEP_M
        level = np.clip(LEVEL * door["to_bar"][2], -LEVEL_STEP_M, LEVEL_STEP_M) / STEP_M
        behind = door["behind_rad"] + AHEAD_RAD - TURNED * door["asked_rad"] * self._share()
        turn = TURN_RAD * float(np.clip(TURN_GAIN * behind, -1, 1)) / STEP_RAD
        return np.array([x, y, level, -door["side"] * turn, opened_above(numbers[2], 0)])

    def _look(self) -> None:
        held = self._door.get("held", False)
        self._door = self.environment.door()
        if held and self._door["held"]:
            return  # what counts is how the bar was taken: it slides outwards as the leaf turns
        may_hold = self._is_open() or self._door["held"]
        self._depth = 1 - math.tanh(self._off_m() / FINE_M) if may_hold else 0.0

    def _off_m(self) -> float:
        """From the hand to where it holds the bar best."""
        return float(np.linalg.norm([*self._to_bar() - (WITHIN_M, 0), self._door["to_bar"][2]]))

    def _numbers(self) -> list[float]:
        door, side = self._door, self._door["side"]
        return [
            *self._to_bar() / REACH_M, *self._to_bar() / SMALL_M, door["to_bar"][2] / REACH_M,
            door["tool"][0] / TOOL_M, side * door["tool"][1] / TOOL_M, side * door["into_rad"],
            door["behind_rad"] / BEHIND_RAD, 2 * door["position_rad"] / door["asked_rad"] - 1,
            door["speed_rad_s"] / FAST_RAD_S, 2 * self._opening_m() / OPENING_M - 1, float(door["held"]), self._depth,
            self._pressed_n() / HARD_N, *self._last, float(self.environment.robot_stopped()),
        ]  # fmt: skip

    def _progress(self) -> float:
        door = self._door
        if self._lost():
            return 0.0
        reached = 1 - (0 if door["held"] else math.tanh(self._off_m() / NEAR_M))
        return REACH_SHARE * reached + AT_SHARE * self._depth + HELD_SHARE * door["held"] + OPEN_SHARE * self._share()

    def _done(self) -> bool:
        return self._door["clean"] and self._door["position_rad"] >= self._door["asked_rad"]

    def _lost(self) -> bool:
        return not self._door["clean"]

    def _own_state(self) -> dict[str, Any]:
        return {**super()._own_state(), "depth": self._depth}

    def _take_own_state(self, state: dict[str, Any]) -> None:
        super()._take_own_state(state)
        self._look()
        self._depth = state["depth"]
