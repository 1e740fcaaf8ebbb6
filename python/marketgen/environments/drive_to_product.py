"""The first stage of In-Aisle Item Collection."""

from __future__ import annotations

import math
from typing import Any

from .stage_env import StageEnv

NEAR_M, TURNED_RAD = 0.10, math.radians(10)  # of the place, when it is reached
STILL_M_S, STILL_RAD_S = 0.1, 0.2
FAR_M, FAST = 4.0, 1.5  # what 1 stands for: the longest way, the robot's most speed and turn rate
BESIDE_M = 0.5  # of the same at the place, where centimetres count
WAY_SHARE, THERE_SHARE, THERE_M = 0.4, 0.2, 0.25
FACING_SHARE, FACING_M = 0.2, 0.12  # counts at the place only: a base that faces it from beside has to turn away to come there


class DriveToProduct(StageEnv):
    """The robot of In-Aisle Item Collection drives to where it can take a product, and stands still there, facing it.

    An action is speed and turn rate as shares of the most (1.5 m/s, 1.5 rad/s; 1 m/s^2), 5 times a second. It begins where the
    shortest way among the fixtures is 1 to 4 m, heading anywhere, and has 20 s. Done: 10 cm and 10 degrees off at most, slower than
    0.1 m/s and 0.2 rad/s. The observation is the truth: where that way turns next, how long it is, where the place is.

    Progress: 0.4 (1 - way / way at the start) + 0.2 (1 - tanh(way / 25 cm))
    + 0.2 (1 - tanh(way / 12 cm)) (1 - |turn that is missing| / pi); done: 1.
    """

    track, stage = "aisle", "drive"
    control = "pd_joint_delta_pos"
    limit_s, hold = 20.0, 4
    moves = ("drive", "turn")
    sees = (
        "corner_x", "corner_y", "corner_cos", "corner_sin", "way", "stand_x", "stand_y", "beside_x", "beside_y",
        "stand_cos", "stand_sin", "speed", "turn_rate", "last_drive", "last_turn", "stopped",
    )  # fmt: skip

    def __init__(self, *args: Any, **options: Any):
        super().__init__(*args, **options)
        self._way_at_start_m = math.inf

    def _prepare(self) -> None:
        self._way_at_start_m = max(self.environment.way_to_stand()["way_m"], NEAR_M)

    def _numbers(self) -> list[float]:
        way = self.environment.way_to_stand()
        x, y = way["corner"]
        bearing = math.atan2(y, x)
        stand_x, stand_y, heading = way["stand"]
        return [
            x / FAR_M, y / FAR_M, math.cos(bearing), math.sin(bearing), way["way_m"] / FAR_M,
            stand_x / FAR_M, stand_y / FAR_M, stand_x / BESIDE_M, stand_y / BESIDE_M, math.cos(heading), math.sin(heading),
            way["speed_m_s"] / FAST, way["turn_rad_s"] / FAST, *self._last, float(self.environment.robot_stopped()),
        ]  # fmt: skip

    def _progress(self) -> float:
        way = self.environment.way_to_stand()
        come = 1 - min(way["way_m"] / self._way_at_start_m, 1)
        facing = 1 - abs(way["stand"][2]) / math.pi
        there = 1 - math.tanh(way["way_m"] / THERE_M)
        return WAY_SHARE * come + THERE_SHARE * there + FACING_SHARE * (1 - math.tanh(way["way_m"] / FACING_M)) * facing

    def _done(self) -> bool:
        way = self.environment.way_to_stand()
        there = way["way_m"] <= NEAR_M and abs(way["stand"][2]) <= TURNED_RAD
        return there and abs(way["speed_m_s"]) <= STILL_M_S and abs(way["turn_rad_s"]) <= STILL_RAD_S

    def _own_state(self) -> dict[str, Any]:
        return {**super()._own_state(), "way_at_start_m": self._way_at_start_m}

    def _take_own_state(self, state: dict[str, Any]) -> None:
        super()._take_own_state(state)
        self._way_at_start_m = state["way_at_start_m"]
