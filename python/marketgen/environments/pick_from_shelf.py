"""The second stage of In-Aisle Item Collection."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np

from .stage_env import StageEnv

OUT_M, LOST_M = 0.15, 0.15  # out of the shelf when it is taken; below its board when it has fallen
NEAR_M = 0.1  # of the tanh by which the distance of the hand counts
REACH_SHARE, HELD_SHARE, OUT_SHARE = 0.25, 0.15, 0.4
REACH_M, SIZE_M, OPENING_M, FAST_M_S = 0.2, 0.3, 0.08, 0.5  # what 1 stands for


def witness_arm(episode: dict[str, Any]) -> str | None:
    """Which arm takes its product; None when nobody knows, which reset() then says."""
    witness = episode["certificate"].get("witness")
    return witness[0]["arm"] if witness else None


class PickFromShelf(StageEnv):
    """The robot of In-Aisle Item Collection stands before a shelf, an open hand 12 cm before a product: it is to take it off.

    An action moves that arm's tool (x into the shelf, y to the left, z up: 1 = 20 mm, 20 times a second) and opens (1) or closes (-1)
    its gripper, 10 times a second; base, lift and the other arm stand still. The product, the arm, the hand's turn and the lift are
    those by which the episode's certificate shows that it can be taken; the robot stands up to 2 cm and 2 degrees off. It has 6 s.
    Done: the hand holds it 15 cm out of where it stood. Lost: it lies 15 cm deeper. The observation is the truth.

    Progress: 0.25 (1 - tanh(hand to product / 0.1 m)) + when it is held, 0.15 + 0.4 (out / 15 cm, 0 to 1); done: 1.
    """

    track, stage = "aisle", "pick"
    control = "pd_ee_delta_pos"
    limit_s, hold = 6.0, 2
    moves = ("tool_x", "tool_y", "tool_z", "tool_opening")
    sees = (
        "to_product_x", "to_product_y", "to_product_z", "moved_x", "moved_y", "moved_z", "size_x", "size_y", "size_z",
        "velocity_x", "velocity_y", "velocity_z", "opening", "held", "left", "last_x", "last_y", "last_z", "last_opening", "stopped",
    )  # fmt: skip

    def __init__(self, *args: Any, **options: Any):
        self._left = True
        super().__init__(*args, **options)
        self._stood = np.zeros(3)  # where the product stood, in the frame of the base

    def _told_names(self) -> tuple[str, ...]:
        side = "left" if self._left else "right"
        return tuple(f"{side}_{name}" for name in self.moves)

    def _begin(self, text: str) -> None:
        self._left = witness_arm(json.loads(text)) == "left_arm"
        super()._begin(text)

    def _prepare(self) -> None:
        self._stood = self.parts()["privileged"]["item_pose"][0, :3].astype(float)

    def _to_product(self, parts: dict[str, dict[str, np.ndarray]]) -> np.ndarray:
        return parts["privileged"]["tcp_to_item"][0 if self._left else 1, 0]

    def _moved(self, parts: dict[str, dict[str, np.ndarray]]) -> np.ndarray:
        return parts["privileged"]["item_pose"][0, :3] - self._stood

    def _held(self, parts: dict[str, dict[str, np.ndarray]]) -> bool:
        return bool(parts["privileged"]["item_held"][0] > 0)

    def _numbers(self) -> list[float]:
        parts = self.parts()
        truth = parts["privileged"]
        opening = parts["agent"]["qpos"][-2 if self._left else -1]
        return [
            *self._to_product(parts) / REACH_M, *self._moved(parts) / REACH_M, *truth["item_size"][0] / SIZE_M,
            *truth["item_velocity"][0] / FAST_M_S, 2 * opening / OPENING_M - 1, float(self._held(parts)), 1.0 if self._left else -1.0,
            *self._last, float(self.environment.robot_stopped()),
        ]  # fmt: skip

    def _progress(self) -> float:
        parts = self.parts()
        reached = REACH_SHARE * (1 - math.tanh(float(np.linalg.norm(self._to_product(parts))) / NEAR_M))
        if not self._held(parts):
            return reached
        return reached + HELD_SHARE + OUT_SHARE * float(np.clip(-self._moved(parts)[0] / OUT_M, 0, 1))

    def _done(self) -> bool:
        parts = self.parts()
        return self._held(parts) and -self._moved(parts)[0] >= OUT_M

    def _lost(self) -> bool:
        return bool(self._moved(self.parts())[2] < -LOST_M)

    def _own_state(self) -> dict[str, Any]:
        return {**super()._own_state(), "stood": self._stood.tolist()}

    def _take_own_state(self, state: dict[str, Any]) -> None:
        super()._take_own_state(state)
        self._stood = np.array(state["stood"])
