"""Episodes of a file as record() shows them, for evaluation programs of others (marketgen.lerobot, marketgen.vla_eval): what a
policy learned from a dataset, it is given here."""

from __future__ import annotations

import dataclasses
import json
import logging
import math
import time
from collections.abc import Sequence
from typing import Any

import numpy as np

from . import arguments
from .arguments import PathLike
from .environments.task_env import FILM_CAMERA, RENDER_SIZE, numbers_of_action
from .environments.task_setup import ControlMode, outcome_of
from .errors import Error
from .recording.acting import FPS
from .recording.staging import documents_of, episodes_of, place_of, stages_of

FAILS = ("physics.failed", "episode.bad_action")  # an episode, as in evaluate(); the next one follows
_LOG = logging.getLogger("marketgen")


@dataclasses.dataclass(frozen=True)
class Seen:
    """What a frame of a dataset has of the robot.

    state     observation.state, float32
    pictures  observation.images.CAMERA by camera, (height, width, 3), bytes
    """

    state: np.ndarray
    pictures: dict[str, np.ndarray]


@dataclasses.dataclass(frozen=True)
class Outcome:
    """Of an episode that is over; the words are those of market-result/1."""

    success: bool
    goal_fraction: float
    spl: float
    failure_reason: str


class AsRecorded:
    """Options as those of record().

    episodes       of the file, their ids in its order
    max_steps      of the longest one, 20 a second
    render_mode    "rgb_array": render() draws, with render_size and render_camera

    Raises Error input.*, usage.bad_flag, episode.*.
    """

    def __init__(
        self,
        episodes: PathLike,
        *,
        cameras: Sequence[str] | None = None,
        size: tuple[int, int] = (256, 256),
        quality: str = "fast",
        control_mode: ControlMode = "pd_joint_pos",
        realism: PathLike = "ideal",
        render_mode: str | None = None,
        render_size: tuple[int, int] = RENDER_SIZE,
        render_camera: str = FILM_CAMERA,
    ):
        path = arguments.episodes_path("episodes", episodes)
        self._texts = episodes_of(path)
        documents = documents_of(self._texts)
        place = place_of(documents, path)
        self.track = place["track"]
        self.episodes = tuple(document["id"] for document in documents)
        self.max_steps = math.ceil(max(document["limit_s"] for document in documents) * FPS)
        options = {
            "cameras": None if cameras is None else tuple(cameras),
            "quality": quality,
            "control_mode": control_mode,
            "realism": arguments.a_path("realism", realism),
        }
        stages = stages_of(path, place, arguments.a_size("size", size), options)
        rendering = {"render_mode": render_mode, "render_size": render_size, "render_camera": render_camera}
        self._env = stages.environment(place["track"], place["station"], **rendering)
        self.size, self.cameras = self._env.setup.observations.size, self._env.cameras
        self.action_space, self.action_names = self._env.action_space, self._env.action_names
        self.robot_names, self.instruction = self._env.robot_names, ""
        self.outcome: Outcome | None = None  # of the last step
        self._seen: Seen | None = None
        self._number, self._began = 0, 0.0

    def begin(self, number: int) -> Seen:
        """The episode of that number in the file, from its beginning."""
        seen, info = self._env.reset(seed=0, options={"episode": self._texts[number]})
        self.instruction, self.outcome = info["instruction"], None
        self._number, self._began = number, time.monotonic()
        self._seen = self._shown(seen)
        return self._seen

    def step(self, action: Any) -> tuple[Seen, float, bool, bool]:
        """What is seen then, the reward, terminated, truncated. An action that is not finite, or physics that fail, end the episode
        as they do in evaluate(): without success. Raises Error episode.bad_action for another shape."""
        numbers = numbers_of_action(action, self.action_space.shape)
        try:
            seen, reward, terminated, truncated, info = self._env.step(numbers)
        except Error as error:
            if error.code not in FAILS:
                raise
            return self._failed(error)
        self._seen = self._shown(seen)
        if terminated or truncated:
            self.outcome = _told(info)
        return self._seen, reward, terminated, truncated

    def render(self) -> np.ndarray | None:
        return self._env.render()

    def _shown(self, seen: dict[str, Any]) -> Seen:
        return Seen(self._env.robot_numbers(), {camera: seen["sensor_data"][camera]["rgb"] for camera in self.cameras})

    def _failed(self, error: Error) -> tuple[Seen, float, bool, bool]:
        _LOG.warning("%s: the episode has failed: %s", self.episodes[self._number], error)
        broken, by_policy = [error.code, error.where, error.message], error.code == "episode.bad_action"
        wall_s = time.monotonic() - self._began
        result = self._env.environment.judged("outside", "none", "None", broken, by_policy, wall_s)
        self.outcome = _told(outcome_of(json.loads(result)))
        assert self._seen is not None
        return self._seen, 0.0, True, False


def _told(info: dict[str, Any]) -> Outcome:
    return Outcome(bool(info["success"]), float(info["goal_fraction"]), float(info["spl"]), str(info["failure_reason"]))
