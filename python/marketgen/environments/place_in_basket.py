"""A stage at the counter: what is taken goes into the basket."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from .. import _core
from .led_hand import STEP_M
from .stage_env import StageEnv, opened_above

AT_M, MAX_STEPS, CLOSING_STEPS, TRIES = 0.008, 40, 8, 2  # of the hand that takes the box beforehand
MAX_DRAWS = 20  # of episodes, until it has hold of one's box
ABOVE_M = 0.10  # its middle, before the hand goes down
OVER_RIM_M = 0.05  # the box's bottom when it has it
SLOW = 0.6  # of the most of the whole task: 1 = 12 mm in a control step
LETS_GO = 0.5  # from which on the hand opens: what moves at random holds its box for some steps
CARRY_SHARE, LOWER_SHARE, LAID_SHARE = 0.35, 0.35, 0.15
CARRY_M, RIM_M = 0.15, 0.05  # of the tanh by which the way along the counter counts; so far outside lowering counts nothing
LOW_M, TOO_HIGH_M = 0.03, 0.05  # over the basket's floor: from 5 cm a fall ends with the 1 m/s that counts as thrown
REACH_M, HEIGHT_M, SIZE_M, OPENING_M, FAST_M_S = 0.4, 0.3, 0.2, 0.08, 0.5  # what 1 stands for


class PlaceInBasket(StageEnv):
    """The Panda of Checkout Unloading has taken a light box from the counter, and is to put it into the basket beside.

    An action moves the tool (x over the counter, y to the robot's left, z up: 1 = 12 mm, 20 times a second) and opens (above 0.5)
    or closes the gripper, 5 times a second. It begins with the box in the hand, 5 cm above the rim's height: the hand took it by
    the same actions before the episode. It has 8 s. Done: the box lies in the basket, let go and at rest for a second, by the rules
    of the judge; from too high it would count as thrown. Lost: the hand has no hold of it, and it is not over the basket's floor by
    5 cm at most. The observation is the truth.

    Progress: 0.35 (1 - tanh(box to the basket's middle along the counter / 15 cm)) + 0.35 (lowered, 0 to 1) where it fits between
    the walls, less from 5 cm outside on + 0.15 when it is let go low; done: 1, lost: 0.
    """

    track, stage, station = "checkout", "place", "one-item-basket"
    control = "pd_ee_delta_pos"
    limit_s, hold = 8.0, 4
    moves = ("tool_x", "tool_y", "tool_z", "tool_opening")
    sees = (
        "box_to_basket_x", "box_to_basket_y", "height", "outside", "low", "in_hand_x", "in_hand_y", "in_hand_z",
        "size_x", "size_y", "size_z", "fall", "opening", "held", "last_opening", "stopped",
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
        return self.environment.running() and bool(self.parts()["privileged"]["item_held"][0] > 0)

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
        if self.environment.running():  # a box that slips out of the hand may end it
            self._advance(np.append(np.clip(by_m / STEP_M, -1, 1), opening))

    def _bring(self, to: np.ndarray, opening: float) -> None:
        for _ in range(MAX_STEPS):
            way = to - self._tool()
            if np.abs(way).max() < AT_M:
                return
            self._move(way, opening)

    def _told(self, numbers: np.ndarray) -> np.ndarray:
        return np.append(SLOW * numbers[:3], opened_above(numbers[3], LETS_GO))

    # ---- How the box stands to the basket. ----

    def _off(self) -> np.ndarray:
        """To the basket's middle, along the counter."""
        return (self.parts()["privileged"]["goal_position"] - self._box())[:2]

    def _outside_m(self) -> float:
        """By how much it does not fit between the walls."""
        truth = self.parts()["privileged"]
        room = (truth["goal_size"][:2] - truth["item_size"][0, :2].max()) / 2
        return float(np.linalg.norm(np.maximum(np.abs(self._off()) - room, 0)))

    def _height_m(self) -> float:
        """Of its bottom over the basket's floor."""
        truth = self.parts()["privileged"]
        return float(truth["item_pose"][0, 2] - truth["basket_pose"][2])

    def _is_over(self, max_m: float) -> bool:
        """Over the basket's floor, and no higher."""
        return self._outside_m() < RIM_M and self._height_m() <= max_m

    def _numbers(self) -> list[float]:
        parts = self.parts()
        truth = parts["privileged"]
        return [
            *self._off() / REACH_M, self._height_m() / HEIGHT_M, self._outside_m() / REACH_M, float(self._is_over(LOW_M)),
            *truth["tcp_to_item"][0] / OPENING_M, *truth["item_size"][0] / SIZE_M, truth["item_velocity"][0, 2] / FAST_M_S,
            2 * parts["agent"]["qpos"][-1] / OPENING_M - 1, float(self._held()), self._last[3], float(self.environment.robot_stopped()),
        ]  # fmt: skip

    def _progress(self) -> float:
        if self._lost():
            return 0.0
        carried = 1 - math.tanh(float(np.linalg.norm(self._off())) / CARRY_M)
        over = max(0.0, 1 - self._outside_m() / RIM_M)
        high = self._rim_m() + OVER_RIM_M
        lowered = float(np.clip((high - self._height_m()) / (high - LOW_M), 0, 1))
        return CARRY_SHARE * carried + LOWER_SHARE * over * lowered + LAID_SHARE * (not self._held())

    def _done(self) -> bool:
        return bool(self.parts()["privileged"]["item_in_place"][0] > 0)

    def _lost(self) -> bool:
        return not self._held() and not self._is_over(TOO_HIGH_M)
