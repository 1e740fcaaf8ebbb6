"""One environment of either task."""

from __future__ import annotations

import json
from typing import Any, ClassVar, Literal, Unpack

import gymnasium
import numpy as np

from .. import _core
from .task_setup import StoreLike, TaskOptions, TaskSetup, Track, check_name, outcome_of

MOST_SEED = 2**32


def numbers_of_action(action: Any, shape: tuple[int, ...]) -> np.ndarray:
    """Raises Error episode.bad_action when it has another shape or is no array of numbers."""
    try:
        numbers = np.ascontiguousarray(action, np.float64)
    except (TypeError, ValueError):
        raise _core.Error("episode.bad_action", "action", f"it is no array of {shape} numbers") from None
    if numbers.shape != shape:
        raise _core.Error("episode.bad_action", "action", f"shape {numbers.shape}; expected {shape}")
    return numbers


class TaskEnv(gymnasium.Env):
    """Base of CheckoutUnloading and InAisleCollection, which say what the task is."""

    metadata = {"render_modes": ["rgb_array"], "render_fps": 20}
    track: ClassVar[Track]

    def __init__(
        self,
        store: StoreLike | None = None,
        *,
        render_mode: Literal["rgb_array"] | None = None,
        setup: TaskSetup | None = None,
        **options: Unpack[TaskOptions],
    ):
        check_name("render_mode", render_mode, (None, "rgb_array"))
        self.setup = TaskSetup(self.track, store, **options) if setup is None else setup
        self.render_mode = render_mode
        self.control_mode, self.cameras = self.setup.control_mode, self.setup.cameras
        self.action_space, self.observation_space = self.setup.action_space, self.setup.observation_space
        self.environment = self.setup.new_environment()
        self._episode: dict[str, Any] = {}

    @property
    def action_names(self) -> tuple[str, ...]:
        """What each number of an action is."""
        return self.setup.action_names

    @property
    def episode(self) -> dict[str, Any]:
        """The market-episode/1 that runs; not for the agent: it has the goals' poses and a way to reach them."""
        return self._episode

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None):
        text, drawn = self.next_episode(seed, options)
        if text is None:
            text = self.setup.draw([drawn])[0]
        row = np.empty((1, self.setup.row_length), np.float32)
        _core.reset_environments([self.environment], [text], row)
        return self._seen(row[0]), self.info_of_reset(text)

    def next_episode(self, seed: int | None, options: dict[str, Any] | None) -> tuple[str | None, int]:
        """The episode that was asked for, or else the seed of which one is to be drawn."""
        super().reset(seed=seed)
        episode = (options or {}).get("episode")
        if episode is None:
            return None, int(self.np_random.integers(MOST_SEED))
        return self.setup.episode_text(episode), 0

    def info_of_reset(self, text: str) -> dict[str, Any]:
        self._episode = json.loads(text)
        info = self._info()
        layout = self.setup.map_of(self.environment)
        if layout is not None:
            info |= {"map": layout, "categories": self._episode.get("categories", [])}
        return info

    def step(self, action):
        numbers = numbers_of_action(action, self.action_space.shape)
        row = np.empty((1, self.setup.row_length), np.float32)
        reward, terminated, truncated = np.zeros(1), np.zeros(1, bool), np.zeros(1, bool)
        _core.step_environments([self.environment], numbers[None], row, reward, terminated, truncated)
        info = self.info_of_step(terminated=bool(terminated[0]), truncated=bool(truncated[0]))
        return self._seen(row[0]), float(reward[0]), bool(terminated[0]), bool(truncated[0]), info

    def info_of_step(self, *, terminated: bool, truncated: bool) -> dict[str, Any]:
        info = self._info()
        if terminated or truncated:
            info |= outcome_of(json.loads(self.environment.result()), stopped=terminated)
        return info

    def _info(self) -> dict[str, Any]:
        return {"instruction": self._episode["instruction"], "time_s": self.environment.time_s()}

    def _seen(self, row: np.ndarray) -> dict[str, Any]:
        return {**self.setup.numbers_of(row), **self.setup.pictures_of(self.environment)}

    def state_hash(self) -> str:
        """32 hex digits over the physics: equal states, equal hashes."""
        return self.environment.state_hash()

    def render(self):
        if self.render_mode is None:
            return None
        return self.environment.render("film_camera", 640, 480, "balanced").rgb.copy()
