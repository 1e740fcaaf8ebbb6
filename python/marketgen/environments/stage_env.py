"""Stages of the tasks as environments of their own: a curriculum for learners."""

from __future__ import annotations

import json
import math
from typing import Any, ClassVar

import numpy as np
from gymnasium import spaces

from .. import _core
from .task_env import TaskEnv, numbers_of_action
from .task_setup import ControlMode, RewardMode, StoreLike, TaskOptions, TaskSetup

CHOICES = ("episodes", "realism", "split")  # of TaskOptions; the others are a stage's own


def opened_above(number: float, limit: float) -> float:
    """An opening, all or nothing."""
    return 1.0 if number > limit else -1.0


class StageEnv(TaskEnv):
    """Base of the stages. The world, the robot and its limits are those of the whole task; a stage begins nearer to its end,
    shows and takes a few numbers, and has an end of its own.

    An observation is one row in [-1, 1], what each number is says `sees`; an action is one in [-1, 1], `moves`, held for `hold`
    control steps of 0.05 s. The reward is what an action adds to the progress, a number of the state from 0 to 1 that is 1 when
    the stage is done: then the episode ends (terminated), `info["is_success"]` is True. It also ends when the stage cannot be
    done any more (terminated), and after `limit_s` (truncated).

    store, episodes, realism, split, render_mode, render_size, render_camera  as those of the whole task
    """

    limit_s: ClassVar[float]
    hold: ClassVar[int]
    control: ClassVar[ControlMode]
    reward: ClassVar[RewardMode] = "sparse"  # of the core; stages add up their own progress
    moves: ClassVar[tuple[str, ...]]
    sees: ClassVar[tuple[str, ...]]

    def __init__(self, store: StoreLike | None = None, **options: Any):
        super().__init__(store, **options)
        self.action_space = spaces.Box(-1, 1, (len(self.moves),), np.float32)
        self.observation_space = spaces.Box(-1, 1, (len(self.sees),), np.float32)
        self.metadata = {**self.metadata, "render_fps": self.metadata["render_fps"] // self.hold}
        self._places: list[int] = []
        self._last = np.zeros(len(self.moves))
        self._began_s, self._before, self._over = 0.0, 0.0, True

    @classmethod
    def new_setup(cls, store: StoreLike | None, options: TaskOptions) -> TaskSetup:
        for name in options:
            if name not in CHOICES:
                raise _core.Error(
                    "usage.bad_flag", name, f"{cls.__name__} has no such choice; it has: {', '.join(CHOICES)}"
                )
        fixed: TaskOptions = {"control_mode": cls.control, "reward_mode": cls.reward}
        return TaskSetup(
            cls.track, store, station=cls.station, stage=cls.stage, preset="rl", **{**options, **fixed}
        )

    @property
    def action_names(self) -> tuple[str, ...]:
        return self.moves

    # ---- What a stage is. ----

    def _told_names(self) -> tuple[str, ...]:
        """What the numbers of an action are called in the whole task."""
        return self.moves

    def _told(self, numbers: np.ndarray) -> np.ndarray:
        """Of an action, before each control step: what the whole task is told by these names."""
        return numbers

    def _prepare(self) -> None:
        """Before the episode begins, in its world."""

    def _look(self) -> None:
        """After each control step."""

    def _numbers(self) -> list[float]:
        """Those of an observation, scaled so that most lie in [-1, 1]; beyond it they are cut."""
        raise NotImplementedError

    def _progress(self) -> float:
        """From 0 to 1."""
        raise NotImplementedError

    def _done(self) -> bool:
        raise NotImplementedError

    def _lost(self) -> bool:
        """It cannot be done any more."""
        return False

    # ---- Gymnasium's side. ----

    def _begin(self, text: str) -> None:
        super()._begin(text)
        self._episode = json.loads(text)
        self._last = np.zeros(len(self.moves))
        self._places = [self.setup.action_names.index(name) for name in self._told_names()]
        self._prepare()
        self._began_s, self._before, self._over = self.environment.time_s(), self._progress(), False

    def info_of_reset(self, text: str) -> dict[str, Any]:
        return self._info()

    def step(self, action):
        numbers = numbers_of_action(action, self.action_space.shape)
        if self._over:
            raise _core.Error("episode.bad_action", "action", "the episode is over, or has not begun: reset it first")
        if not np.isfinite(numbers).all():
            raise _core.Error("episode.bad_action", "action", f"every number must be finite; it is {numbers.tolist()}")
        ended = self._act(np.clip(numbers, -1, 1))
        done = self._done()
        progress = 1.0 if done else self._progress()
        reward, self._before = progress - self._before, progress
        terminated = done or ended or self._lost()
        truncated = not terminated and self.environment.time_s() - self._began_s > self.limit_s - 1e-6
        self._over = terminated or truncated
        info = self._info() | {"robot_stopped": self.environment.robot_stopped()}
        if self._over:
            info |= {"success": done, "is_success": done}
        return self.observation(), reward, terminated, truncated, info

    def _act(self, numbers: np.ndarray) -> bool:
        """Holds them; whether the world's own episode came to its end."""
        self._last = numbers
        for _ in range(self.hold):  # what the arm sees to itself goes by how things stand now
            full = self._still()
            full[self._places] = self._told(numbers)
            _, terminated, truncated = self._advance(full)
            self._look()
            if terminated or truncated:
                return True
        return False

    def _still(self) -> np.ndarray:
        """An action of the whole task that moves nothing; grippers stay open."""
        full = np.zeros(self.setup.action_space.shape)
        for place, name in enumerate(self.setup.action_names):
            full[place] = float(name.endswith("opening"))
        return full

    def observation(self) -> np.ndarray:
        return np.clip(self._numbers(), -1, 1).astype(np.float32)

    def _own_state(self) -> dict[str, Any]:
        return {"last": self._last.tolist(), "began_s": self._began_s, "before": self._before, "over": self._over}

    def _take_own_state(self, state: dict[str, Any]) -> None:
        self._last = np.array(state["last"])
        self._began_s, self._before, self._over = state["began_s"], state["before"], state["over"]
