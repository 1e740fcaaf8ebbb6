"""The second stage of In-Aisle Item Collection."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np

from .led_hand import LedHand
from .stage_env import StageEnv, opened_above

OUT_M, LOST_M = 0.15, 0.15  # out of the shelf when it is taken; below its board when it has fallen
LYING_COS = math.cos(math.radians(45))  # of how far it leans, when it has fallen over
AHEAD_M, ASIDE_M, UP_M, LIFTED_M = 0.006, 0.004, 0.001, 0.02  # 1, in a control step; what is held is raised by itself, so far
ALIGN_SHARE, REACH_SHARE, HELD_SHARE, OUT_SHARE = 0.1, 0.25, 0.15, 0.4
BESIDE_M, NEAR_M, SQUEEZED_M = 0.01, 0.06, 0.004  # of the tanhs; a hand so much narrower than the product does not reach it
REACH_M, FINE_M, SIZE_M, OPENING_M, FAST_M_S, HARD_N = 0.12, 0.015, 0.1, 0.0896, 0.3, 50.0  # what 1 stands for


def witness_arm(episode: dict[str, Any]) -> str | None:
    """Which arm takes its product; None when nobody knows, which reset() then says."""
    witness = episode["certificate"].get("witness")
    return witness[0]["arm"] if witness else None


class PickFromShelf(StageEnv):
    """The robot of In-Aisle Item Collection stands before a shelf, an open hand 12 cm before a product: it is to take it off.

    An action moves that arm's tool as the hand points (ahead: 1 = 6 mm, to the left: 1 = 4 mm, 20 times a second) and opens (above 0)
    or closes its gripper, 5 times a second; what the hand holds the arm itself raises by 2 cm. Base, lift and the other arm stand
    still. The product, the arm, the hand's turn and height are those by which the episode's certificate shows that it can be taken;
    the robot stands up to 2 cm and 2 degrees off. It has 8 s. Done: the hand holds it 15 cm out of where it stood. Lost: it leans by
    45 degrees, or lies 15 cm deeper. The observation is the truth.

    Progress: 0.1 (1 - tanh(beside / 1 cm)) + 0.25 (1 - tanh(before / 6 cm)) exp(-(beside / 1 cm)^2) of a hand that is open as far as
    the product is wide, or holds it + when it is held, 0.15 + 0.4 (out / 15 cm, 0 to 1); done: 1, lost: 0.
    """

    track, stage = "aisle", "pick"
    control = "pd_ee_delta_pose"
    limit_s, hold = 8.0, 4
    moves = ("tool_ahead", "tool_aside", "tool_opening")
    sees = (
        "ahead", "aside", "aside_fine", "up", "width", "depth", "height", "room", "moved_ahead", "moved_aside", "moved_up", "upright",
        "out", "speed", "opening", "held", "pressed", "last_ahead", "last_aside", "last_opening", "stopped",
    )  # fmt: skip

    def __init__(self, *args: Any, **options: Any):
        self._left = True
        super().__init__(*args, **options)
        self._stood = np.zeros(3)  # where the product stood, in the frame of the base
        self._hand = LedHand(np.array([0, 0, 0, 0.5, 0.5, 0.5, 0.5]))

    def _told_names(self) -> tuple[str, ...]:
        side = "left" if self._left else "right"
        told = ("tool_x", "tool_y", "tool_z", "tool_turn_x", "tool_turn_y", "tool_turn_z", "tool_opening")
        return tuple(f"{side}_{name}" for name in told)

    def _begin(self, text: str) -> None:
        self._left = witness_arm(json.loads(text)) == "left_arm"
        super()._begin(text)

    def _prepare(self) -> None:
        self._stood = self._item("pose")[:3].astype(float)
        self._hand = LedHand(self._tool())

    def _item(self, what: str) -> np.ndarray:
        return self.parts()["privileged"][f"item_{what}"][0]

    def _tool(self) -> np.ndarray:
        return self.parts()["extra"]["tcp_pose"].reshape(-1, 7)[0 if self._left else 1]

    def _to_product(self) -> np.ndarray:
        return self._hand.axes @ self.parts()["privileged"]["tcp_to_item"][0 if self._left else 1, 0]

    def _moved(self) -> np.ndarray:
        return self._item("pose")[:3] - self._stood

    def _out_m(self) -> float:
        """Out of the shelf, as the robot faces it."""
        return float(-self._moved()[0])

    def _upright(self) -> float:
        _, x, y, _ = self._item("pose")[3:]
        return float(1 - 2 * (x * x + y * y))

    def _held(self) -> bool:
        return bool(self._item("held") > 0)

    def _opening_m(self) -> float:
        return float(self.parts()["agent"]["qpos"][-2 if self._left else -1])

    # ---- What it does and sees. ----

    def _told(self, numbers: np.ndarray) -> np.ndarray:
        raises = self._held() and self._hand.place[2] < self._hand.height_m + LIFTED_M
        asked_m = np.array([AHEAD_M * numbers[0], ASIDE_M * numbers[1], UP_M * raises])
        move = self._hand.told(self._tool(), asked_m, stopped=self.environment.robot_stopped())
        return np.append(move, opened_above(numbers[2], 0))

    def _numbers(self) -> list[float]:
        ahead, aside, up = self._to_product()
        size, opening = self._item("size"), self._opening_m()
        force = self.parts()["agent"]["external_force"][0 if self._left else -1]
        return [
            ahead / REACH_M, aside / REACH_M, aside / FINE_M, up / REACH_M, *size / SIZE_M - 0.5, (opening - size[1]) / SIZE_M,
            *self._hand.axes @ self._moved() / REACH_M, 2 * self._upright() - 1, self._out_m() / OUT_M,
            float(np.linalg.norm(self._item("velocity"))) / FAST_M_S, 2 * opening / OPENING_M - 1, float(self._held()), force / HARD_N,
            *self._last, float(self.environment.robot_stopped()),
        ]  # fmt: skip

    def _progress(self) -> float:
        if self._lost():
            return 0.0
        ahead, aside, _ = self._to_product()
        beside = abs(aside) / BESIDE_M
        done, held = ALIGN_SHARE * (1 - math.tanh(beside)), self._held()
        if held or self._opening_m() > self._item("size")[1] - SQUEEZED_M:
            done += REACH_SHARE * (1 - math.tanh(abs(ahead) / NEAR_M)) * math.exp(-(beside**2))
        return done + held * (HELD_SHARE + OUT_SHARE * float(np.clip(self._out_m() / OUT_M, 0, 1)))

    def _done(self) -> bool:
        return self._held() and self._out_m() >= OUT_M

    def _lost(self) -> bool:
        return bool(self._moved()[2] < -LOST_M or self._upright() < LYING_COS)

    def _own_state(self) -> dict[str, Any]:
        return {**super()._own_state(), "stood": self._stood.tolist(), "hand": self._hand.state()}

    def _take_own_state(self, state: dict[str, Any]) -> None:
        super()._take_own_state(state)
        self._stood, self._hand = np.array(state["stood"]), LedHand.of_state(state["hand"])
