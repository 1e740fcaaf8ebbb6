"""What single and vector environments of a task have in common: where episodes come from, spaces, observations, info."""

from __future__ import annotations

import functools
import json
import math
import os
from collections.abc import Sequence
from typing import Any, Literal, TypedDict

import numpy as np
from gymnasium import spaces

from .. import _core
from ..store import Store, open_store
from .default_store import default_store

Track = Literal["checkout", "aisle"]
ObsMode = Literal["state", "rgbd"]
ControlMode = Literal["pd_joint_pos", "pd_joint_delta_pos", "pd_ee_delta_pos", "pd_ee_delta_pose"]
RewardMode = Literal["sparse", "dense"]
StoreLike = Store | str | os.PathLike[str]


class TaskOptions(TypedDict, total=False):
    """Keyword arguments of every environment; docs/python.md says what each does."""

    episodes: str | os.PathLike[str] | None
    obs_mode: ObsMode
    control_mode: ControlMode
    reward_mode: RewardMode
    tools: str
    cameras: Sequence[str] | None
    width: int
    height: int
    quality: Literal["fast", "balanced", "best"]
    segmentation: bool


def check_name(option: str, value: object, known: Sequence[object]) -> None:
    if value not in known:
        raise _core.Error("usage.bad_flag", option, f"{value!r} is none of {', '.join(map(str, known))}")


@functools.lru_cache(maxsize=4)
def _file_ground(path: str, _changed: int, _bytes: int) -> _core.EpisodeGround:
    return _core.ground_of_file(path)


def ground_of(store: StoreLike | None, episodes: str | os.PathLike[str] | None) -> _core.EpisodeGround:
    """Where episodes are run; environments of one store or file share it."""
    if episodes is None:
        if not isinstance(store, Store):
            store = default_store() if store is None else open_store(store)
        return _core.ground_of_store(store._handle)
    if store is not None:
        raise _core.Error("usage.bad_flag", "store", "an episodes file has its stores in it: give one of the two")
    path = os.path.abspath(os.fspath(episodes))
    try:
        about = os.stat(path)
    except OSError as fault:
        raise _core.Error("input.not_found", path, str(fault.strerror)) from None
    return _file_ground(path, about.st_mtime_ns, about.st_size)


def _box(low: float, high: float, shape: tuple[int, ...], dtype: Any) -> spaces.Box:
    return spaces.Box(low, high, shape, dtype)


class TaskSetup:
    """One task as options choose it. Immutable, and shared by the members of a vector environment."""

    def __init__(
        self,
        track: Track,
        store: StoreLike | None = None,
        *,
        episodes: str | os.PathLike[str] | None = None,
        obs_mode: ObsMode = "state",
        control_mode: ControlMode = "pd_joint_delta_pos",
        reward_mode: RewardMode = "sparse",
        tools: str = "",
        cameras: Sequence[str] | None = None,
        width: int = 128,
        height: int = 128,
        quality: Literal["fast", "balanced", "best"] = "fast",
        segmentation: bool = False,
    ):
        check_name("obs_mode", obs_mode, ("state", "rgbd"))
        if tools and track != "aisle":
            raise _core.Error("usage.bad_flag", "tools", "only robots in aisles have a choice; leave it out")
        self.track, self.control_mode, self.reward_mode, self.tools = track, control_mode, reward_mode, tools
        self.ground = ground_of(store, episodes)
        self.from_file = episodes is not None
        first = self.new_environment()
        known = first.cameras()
        for camera in cameras or ():
            check_name("cameras", camera, known)
        self.cameras = tuple(known if cameras is None else cameras) if obs_mode == "rgbd" else ()
        self.size, self.quality, self.segmentation = (width, height), quality, segmentation
        self.action_names, low, high = zip(*first.action_numbers(), strict=True)
        self.action_space = spaces.Box(np.float32(low), np.float32(high), dtype=np.float32)
        self._parts: list[tuple[str, str, tuple[int, ...], slice]] = []
        end = 0
        for group, name, shape in first.observation_parts():
            start, end = end, end + math.prod(shape)
            self._parts.append((group, name, tuple(shape), slice(start, end)))
        self.row_length = end
        self.observation_space = self._observation_space()

    def new_environment(self) -> _core.Environment:
        return _core.create_environment(self.ground, self.track, self.control_mode, self.reward_mode, self.tools)

    def _observation_space(self) -> spaces.Dict:
        inf = float("inf")
        groups: dict[str, dict[str, spaces.Space]] = {}
        for group, name, shape, _ in self._parts:
            groups.setdefault(group, {})[name] = _box(-inf, inf, shape, np.float32)
        if self.cameras:
            groups["sensor_data"] = {name: spaces.Dict(self._planes()) for name in self.cameras}
            groups["sensor_param"] = {
                name: spaces.Dict(
                    {
                        "cam2world_gl": _box(-inf, inf, (4, 4), np.float32),
                        "extrinsic_cv": _box(-inf, inf, (4, 4), np.float32),
                        "intrinsic_cv": _box(-inf, inf, (3, 3), np.float32),
                    }
                )
                for name in self.cameras
            }
        return spaces.Dict({group: spaces.Dict(parts) for group, parts in groups.items()})

    def _planes(self) -> dict[str, spaces.Space]:
        width, height = self.size
        planes: dict[str, spaces.Space] = {
            "rgb": _box(0, 255, (height, width, 3), np.uint8),
            "depth": _box(0, 32767, (height, width, 1), np.int16),
        }
        if self.segmentation:
            planes["segmentation"] = _box(0, 2**31 - 1, (height, width, 1), np.int32)
        return planes

    def numbers_of(self, rows: np.ndarray) -> dict[str, dict[str, np.ndarray]]:
        """The parts of one row of numbers, or of many: views where they can be."""
        seen: dict[str, dict[str, np.ndarray]] = {}
        for group, name, shape, place in self._parts:
            seen.setdefault(group, {})[name] = rows[..., place].reshape(*rows.shape[:-1], *shape)
        return seen

    def pictures_of(self, environment: _core.Environment) -> dict[str, dict[str, dict[str, np.ndarray]]]:
        """sensor_data and sensor_param as things stand now; nothing without cameras."""
        if not self.cameras:
            return {}
        return {
            "sensor_data": {name: self._picture(environment, name) for name in self.cameras},
            "sensor_param": {name: self._matrices(environment, name) for name in self.cameras},
        }

    def _picture(self, environment: _core.Environment, camera: str) -> dict[str, np.ndarray]:
        frame = environment.render(camera, *self.size, self.quality)
        millimetres = np.rint(frame.depth * 1000)
        millimetres[millimetres > 32767] = 0
        planes = {"rgb": frame.rgb.copy(), "depth": millimetres.astype(np.int16)[..., None]}
        if self.segmentation:
            planes["segmentation"] = frame.instance.astype(np.int32)[..., None]
        return planes

    def _matrices(self, environment: _core.Environment, name: str) -> dict[str, np.ndarray]:
        camera = environment.camera(name, *self.size)
        return {
            "cam2world_gl": camera.cam2world_gl.astype(np.float32),
            "extrinsic_cv": camera.extrinsic_cv.astype(np.float32),
            "intrinsic_cv": camera.intrinsic_cv.astype(np.float32),
        }

    @functools.cached_property
    def episodes(self) -> list[str]:
        """Those of the file, as market-episode/1."""
        return self.ground.episodes()

    def episode_text(self, episode: dict[str, Any] | str | int) -> str:
        """An episode that was asked for: a document, its text, or its number in the file."""
        if isinstance(episode, str):
            return episode
        if isinstance(episode, dict):
            return json.dumps(episode)
        if not 0 <= int(episode) < len(self.episodes):
            raise _core.Error(
                "usage.bad_flag", "episode", f"there is no number {episode}: the file has {len(self.episodes)}"
            )
        return self.episodes[int(episode)]

    def draw(self, seeds: Sequence[int]) -> list[str]:
        """Episodes of seeds, side by side on all cores."""
        return self.ground.draw(self.track, list(seeds), self.tools)

    def map_of(self, environment: _core.Environment) -> dict[str, Any] | None:
        """The functional map of the store, market-layout/1; None at a counter."""
        return None if self.track == "checkout" else json.loads(environment.map())


def outcome_of(result: dict[str, Any], *, stopped: bool) -> dict[str, Any]:
    """What `info` says at the end of an episode, of its market-result/1."""
    success = result["success_strict"]
    return {
        "success": success,
        "is_success": success,
        "success_once": success,
        "success_at_end": success,
        "goal_fraction": result["success_partial"],
        "path_length": result["path_m"],
        "spl": result["spl"],
        "failure_reason": "None" if success else ("Missed" if stopped else "Timeout"),
        "result": result,
    }
