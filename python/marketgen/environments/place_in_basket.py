"""A stage at the counter: what is taken goes into the basket."""

from __future__ import annotations

from typing import Any

import numpy as np

from .. import _core
from .stage_env import StageEnv

TOOL_STEP_M = 0.02  # what 1 of an action is
AT_M, MAX_STEPS, CLOSING_STEPS, TRIES = 0.008, 40, 8, 2  # of the hand that takes the box beforehand
LET_GO_SHARE = 0.9
MAX_DRAWS = 20  # of episodes, until it has hold of one's box
ABOVE_M = 0.10  # its middle, before the hand goes down
OVER_RIM_M = 0.05  # the box's bottom when it has it
REACH_M, SIZE_M, OPENING_M, FAST_M_S = 0.5, 0.3, 0.08, 0.5  # what 1 stands for


class PlaceInBasket(StageEnv):
    """The Panda of Checkout Unloading has taken a light box from the counter, and is to put it into the basket beside.

    An action moves the tool (x over the counter, y to the robot's left, z up: 1 = 20 mm, 20 times a second) and opens (1) or
    closes (-1) the gripper, 10 times a second. It begins with the box in the hand, 5 cm above the rim's height: the hand took it by
    the same actions before the episode. It has 6 s. Done: the box lies in the basket, let go and at rest for a second, by the rules
    of the judge; from too high it would count as thrown. Lost: it rests on the unloading area. The observation is the truth.

    Progress is that of reward_mode="shaped" with the basket as the goal's place: hand at the box 0.2, held 0.1, along the counter
    nearer to the basket 0.4, in it or over its opening 0.75, let go 0.9; done: 1. One that was thrown stays at 0.9.
    """

    track, stage, station = "checkout", "place", "one-item-basket"
    control, reward = "pd_ee_delta_pos", "shaped"
    limit_s, hold = 6.0, 2
    moves = ("tool_x", "tool_y", "tool_z", "tool_opening")
    sees = (
        "tool_x", "tool_y", "tool_z", "to_box_x", "to_box_y", "to_box_z", "box_to_basket_x", "box_to_basket_y", "box_to_basket_z",
        "size_x", "size_y", "size_z", "velocity_x", "velocity_y", "velocity_z", "opening", "held", "last_x", "last_y", "last_z",
        "last_opening", "stopped",
    )  # fmt: skip

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None):
        """Raises Error episode.impossible when the hand does not get hold of the box of an episode that was asked for; of those
        that are drawn the next one is taken."""
        begun = super().reset(seed=seed, options=options)
        for _ in range(0 if (options or {}).get("episode") is not None else MAX_DRAWS):
            if self._held():
                break
            begun = super().reset()
        if self._held():
            return begun
        self._over = True
        raise _core.Error("episode.impossible", self.episode["id"], "the hand did not get hold of its box; take another episode")

    def _held(self) -> bool:
        return bool(self.parts()["privileged"]["item_held"][0] > 0)

    def _prepare(self) -> None:
        for _ in range(TRIES):
            self._take(self._box())
            if self._held():
                break

    def _take(self, box: np.ndarray) -> None:
        self._bring(box + (0, 0, ABOVE_M), 1.0)
        self._bring(box, 1.0)
        for _ in range(CLOSING_STEPS):
            self._move(np.zeros(3), -1.0)
        self._bring(box + (0, 0, self._rim_m() + OVER_RIM_M), -1.0)

    def _rim_m(self) -> float:
        return float(self.parts()["privileged"]["goal_size"][2])

    def _box(self) -> np.ndarray:
        """The box's middle."""
        truth = self.parts()["privileged"]
        return truth["item_pose"][0, :3].astype(float) + (0, 0, truth["item_size"][0, 2] / 2)

    def _tool(self) -> np.ndarray:
        return self.parts()["extra"]["tcp_pose"][:3].astype(float)

    def _move(self, by_m: np.ndarray, opening: float) -> None:
        self._advance(np.append(np.clip(by_m / TOOL_STEP_M, -1, 1), opening))

    def _bring(self, to: np.ndarray, opening: float) -> None:
        for _ in range(MAX_STEPS):
            way = to - self._tool()
            if np.abs(way).max() < AT_M:
                return
            self._move(way, opening)

    def _numbers(self) -> list[float]:
        parts = self.parts()
        truth = parts["privileged"]
        return [
            *self._tool() - (0.5, 0, 0), *truth["tcp_to_item"][0] / REACH_M, *(truth["goal_position"] - self._box()) / REACH_M,
            *truth["item_size"][0] / SIZE_M, *truth["item_velocity"][0] / FAST_M_S, 2 * parts["agent"]["qpos"][-1] / OPENING_M - 1,
            float(self._held()), *self._last, float(self.environment.robot_stopped()),
        ]  # fmt: skip

    def _progress(self) -> float:
        return min(self.environment.progress(), LET_GO_SHARE)

    def _done(self) -> bool:
        return bool(self.parts()["privileged"]["item_in_place"][0] > 0)
