"""Episodes of a file in the words that LeRobot expects of environments."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from ..arguments import PathLike
from ..as_recorded import AsRecorded, Seen
from ..recording.acting import FPS

GYM_ID = "marketgen-lerobot/Episodes-v1"


class EpisodesEnv(gymnasium.Env):
    """observation: "agent_pos" (observation.state of datasets) and, with cameras, "pixels" by camera (observation.images.CAMERA).

    A seed names an episode: its number in the file, counted on from the first again after the last; so the consecutive seeds of
    lerobot-eval are consecutive episodes. Without a seed the next one follows. At the end `info` has is_success, goal_fraction, spl
    and failure_reason.
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": FPS}

    def __init__(
        self,
        task: PathLike,
        *,
        cameras: Sequence[str] | None,
        size: tuple[int, int],
        quality: str,
        control_mode: str,
        realism: str,
        render_mode: str | None,
        render_size: tuple[int, int],
        render_camera: str,
    ):
        self._episodes = AsRecorded(
            task,
            cameras=cameras,
            size=size,
            quality=quality,
            control_mode=control_mode,
            realism=realism,
            render_mode=render_mode,
            render_size=render_size,
            render_camera=render_camera,
        )
        self.render_mode = render_mode
        self.task = str(task)
        self._max_episode_steps = self._episodes.max_steps  # LeRobot asks for it by this name
        self._next = 0
        self.action_space = self._episodes.action_space
        self.observation_space = self._space()

    def _space(self) -> spaces.Dict:
        width, height = self._episodes.size
        count = len(self._episodes.robot_names)
        shown: dict[str, spaces.Space] = {"agent_pos": spaces.Box(-np.inf, np.inf, (count,), np.float32)}
        if self._episodes.cameras:
            pictures = {camera: spaces.Box(0, 255, (height, width, 3), np.uint8) for camera in self._episodes.cameras}
            shown["pixels"] = spaces.Dict(pictures)
        return spaces.Dict(shown)

    @property
    def task_description(self) -> str:
        """What LeRobot gives to policies as `task`: the words that datasets have there."""
        return self._episodes.instruction

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None):
        super().reset(seed=seed)
        number = (self._next if seed is None else seed) % len(self._episodes.episodes)
        self._next = number + 1
        return self._told(self._episodes.begin(number)), {}

    def step(self, action: Any):
        seen, reward, terminated, truncated = self._episodes.step(action)
        info: dict[str, Any] = {}
        if (outcome := self._episodes.outcome) is not None:
            info = {"is_success": outcome.success, **dataclasses.asdict(outcome)}
        return self._told(seen), reward, terminated, truncated, info

    def _told(self, seen: Seen) -> dict[str, Any]:
        pictures = {"pixels": dict(seen.pictures)} if seen.pictures else {}
        return {"agent_pos": seen.state, **pictures}

    def render(self) -> np.ndarray | None:
        return self._episodes.render()


# Without wrappers, which hide from LeRobot's 0.4 what the environment has by name (task_description).
gymnasium.register(GYM_ID, entry_point=EpisodesEnv, order_enforce=False, disable_env_checker=True)
