"""What single and vector environments of a task have in common: where episodes come from, options, spaces, info."""

from __future__ import annotations

import functools
import json
import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Literal, TypedDict

import numpy as np
from gymnasium import spaces

from .. import _core
from ..arguments import Progress, a_name, a_path, a_progress, episodes_path
from ..store import Store, open_store
from .observations import Observations

if TYPE_CHECKING:
    from typing import Unpack  # since Python 3.11

Track = Literal["checkout", "aisle"]
ObsMode = Literal["state", "state_robot", "rgbd", "pointcloud"]
ControlMode = Literal["pd_joint_pos", "pd_joint_delta_pos", "pd_ee_delta_pos", "pd_ee_delta_pose"]
RewardMode = Literal["sparse", "dense", "shaped"]
StoreLike = Store | str | os.PathLike[str]
CHECKOUT_STATION, ONE_ITEM_STATION = "checkout", "one-item"
Stage = Literal["whole", "drive", "pick", "place", "open"]


class TaskOptions(TypedDict, total=False):
    """Keyword arguments of every environment; docs/python.md says what each does."""

    episodes: str | os.PathLike[str] | None
    preset: Literal["rl"] | None
    obs_mode: ObsMode
    control_mode: ControlMode
    reward_mode: RewardMode
    stop_action: bool
    flat: bool
    tools: str
    split: Literal["planned", "certified", "paper", "all"] | None
    cameras: Sequence[str] | None
    width: int
    height: int
    points: int
    quality: Literal["fast", "balanced", "best"]
    segmentation: bool
    realism: str | os.PathLike[str]


DEFAULTS: TaskOptions = {
    "episodes": None,
    "obs_mode": "state",
    "control_mode": "pd_joint_delta_pos",
    "reward_mode": "sparse",
    "stop_action": True,
    "flat": False,
    "tools": "",
    "split": None,
    "cameras": None,
    "width": 128,
    "height": 128,
    "points": 4096,
    "quality": "fast",
    "segmentation": False,
    "realism": "ideal",
}
# What a learner starts from; options that are given count before these.
PRESETS: dict[str | None, TaskOptions] = {
    None: {},
    "rl": {
        "obs_mode": "state",
        "control_mode": "pd_ee_delta_pos",
        "reward_mode": "shaped",
        "stop_action": False,
        "flat": True,
    },
}


def full_options(preset: str | None, options: TaskOptions) -> dict[str, Any]:
    """All of them. Raises Error usage.bad_flag for those that do not go together, TypeError for one that there is not."""
    a_name("preset", preset, tuple(PRESETS))
    unknown = [name for name in options if name not in DEFAULTS]
    if unknown:
        raise TypeError(f"there is no option {unknown[0]!r}; there are: preset, {', '.join(DEFAULTS)}")
    wanted: dict[str, Any] = {**DEFAULTS, **PRESETS[preset], **options}
    a_name("obs_mode", wanted["obs_mode"], ("state", "state_robot", "rgbd", "pointcloud"))
    if wanted["flat"] and wanted["obs_mode"] not in ("state", "state_robot"):
        raise _core.Error("usage.bad_flag", "flat", "only obs_mode='state' and 'state_robot' make one row of numbers")
    if wanted["obs_mode"] == "pointcloud" and not 1 <= wanted["points"] <= 10**7:
        raise _core.Error("usage.bad_flag", "points", f"{wanted['points']} is not within 1 to 10,000,000")
    return wanted


@functools.lru_cache(maxsize=4)
def _file_ground(path: str, _changed: int, _bytes: int) -> _core.EpisodeGround:
    return _core.ground_of_file(path)


@functools.lru_cache(maxsize=2)
def _pool_ground(track: Track) -> _core.EpisodeGround:
    return _core.ground_of_pool(track)


def ground_of(track: Track, store: StoreLike | None, episodes: str | os.PathLike[str] | None) -> _core.EpisodeGround:
    """Where episodes are run; environments of one store or file share it. Without either: the pool that comes with us."""
    if episodes is None:
        if store is None:
            return _pool_ground(track)
        return _core.ground_of_store((store if isinstance(store, Store) else open_store(store))._handle)
    if store is not None:
        raise _core.Error("usage.bad_flag", "store", "an episodes file has its stores in it: give one of the two")
    path = episodes_path("episodes", episodes)
    try:
        about = os.stat(path)
    except OSError as fault:
        raise _core.Error("input.not_found", path, str(fault.strerror)) from None
    return _file_ground(path, about.st_mtime_ns, about.st_size)


class TaskSetup:
    """One task as options choose it. Immutable, and shared by the members of a vector environment."""

    def __init__(
        self,
        track: Track,
        store: StoreLike | None = None,
        *,
        station: str = CHECKOUT_STATION,
        stage: Stage = "whole",
        preset: str | None = None,
        **options: Unpack[TaskOptions],
    ):
        self._made_of = (track, store, station, stage, preset, options)
        wanted = full_options(preset, options)
        self.track, self.station, self.stage, self.tools = track, station, stage, wanted["tools"]
        self.split = _split_of(wanted["split"], draws=store is not None and station == CHECKOUT_STATION)
        self.control_mode, self.reward_mode = wanted["control_mode"], wanted["reward_mode"]
        self.stop_action, self.obs_mode = bool(wanted["stop_action"]), wanted["obs_mode"]
        # Object numbers, or the true state, without their products would be of no use; else nothing tells a SKU.
        self.shows_truth = bool(wanted["segmentation"]) or self.obs_mode == "state"
        self.realism = a_path("realism", wanted["realism"])
        self.ground = ground_of(track, store, wanted["episodes"])
        self.has_file = store is None
        self.store = store
        first = self.new_environment()
        self.observations = Observations(
            first,
            track,
            cameras=self._cameras_of(first, wanted["cameras"]),
            size=(wanted["width"], wanted["height"]),
            quality=wanted["quality"],
            segmentation=wanted["segmentation"],
            points=wanted["points"] if self.obs_mode == "pointcloud" else 0,
            flat=wanted["flat"],
        )
        self.cameras = self.observations.cameras
        self.observation_space, self.row_length = self.observations.space, self.observations.row_length
        self.action_names, low, high, units, dimensions = zip(*first.action_numbers(), strict=True)
        self.action_units = tuple(zip(units, dimensions, strict=True))  # what 1 stands for: (0.02, "m"); (0, ""): a share
        self.action_space = spaces.Box(np.float32(low), np.float32(high), dtype=np.float32)
        self._products: dict[str, dict[int, str]] = {}

    def __reduce__(self):  # another process makes it anew
        return _setup_again, self._made_of

    def __deepcopy__(self, memo: dict[int, Any]) -> TaskSetup:
        return self  # nothing in it changes

    def _cameras_of(self, environment: _core.Environment, wanted: Sequence[str] | None) -> tuple[str, ...]:
        known = environment.cameras()
        for camera in wanted or ():
            a_name("cameras", camera, known)
        if self.obs_mode not in ("rgbd", "pointcloud"):
            return ()
        if wanted is not None and not wanted and self.obs_mode == "pointcloud":
            raise _core.Error("usage.bad_flag", "cameras", "points come from at least one camera")
        return tuple(environment.usual_cameras() if wanted is None else wanted)

    def new_environment(self) -> _core.Environment:
        return _core.create_environment(
            self.ground,
            self.track,
            self.control_mode,
            self.reward_mode,
            self.tools,
            self.station,
            self.stop_action,
            self.obs_mode == "state",
            1 if self.station == ONE_ITEM_STATION or self.stage != "whole" else 0,
            self.realism,
            self.stage,
        )

    @functools.cached_property
    def episodes(self) -> list[str]:
        """Those of the file or the pool, as market-episode/1."""
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

    def draw(self, seeds: Sequence[int], progress: Progress | None = None) -> list[str]:
        """Episodes of seeds, side by side on all cores."""
        if self.stage != "whole":
            return [self.ground.draw_stage(self.stage, self.tools, seed) for seed in seeds]
        if self.station == ONE_ITEM_STATION:
            return [self.ground.draw_one_item(seed) for seed in seeds]
        return self.ground.draw(self.track, list(seeds), self.tools, self.split, a_progress(progress))

    def map_of(self, environment: _core.Environment) -> dict[str, Any] | None:
        """The functional map of the store, market-layout/1; None at a counter."""
        return None if self.track == "checkout" else json.loads(environment.map())

    def products_of(self, environment: _core.Environment, scene_hash: str) -> dict[int, str]:
        """SKUs by the numbers of pictures. Those of a whole store are thousands: they are kept."""
        if self.track == "checkout":
            return environment.products()
        if scene_hash not in self._products:
            self._products[scene_hash] = environment.products()
        return dict(self._products[scene_hash])


def _split_of(split: str | None, *, draws: bool) -> str:
    if split is None:
        return "planned"
    a_name("split", split, ("planned", "certified", "paper", "all"))
    if not draws:
        raise _core.Error("usage.bad_flag", "split", "only episodes that are drawn from a store have a choice: give a store")
    return split


def _setup_again(
    track: Track, store: StoreLike | None, station: str, stage: Stage, preset: str | None, options: TaskOptions
) -> TaskSetup:
    return TaskSetup(track, store, station=station, stage=stage, preset=preset, **options)


def outcome_of(result: dict[str, Any]) -> dict[str, Any]:
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
        "failure_reason": result["failure"],
        "result": result,
    }
