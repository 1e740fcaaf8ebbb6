"""One environment of either task."""

from __future__ import annotations

import copy
import json
from typing import TYPE_CHECKING, Any, ClassVar, Literal

import gymnasium
import numpy as np

from .. import _core, arguments
from ..store import Store, open_store
from ..views import View, watch
from .state import generator_of, packed, random_state, unpacked
from .task_setup import CHECKOUT_STATION, Stage, StoreLike, TaskOptions, TaskSetup, Track, outcome_of

if TYPE_CHECKING:
    from typing import Unpack  # since Python 3.11

MAX_SEED = 2**32
FILM_CAMERA, RENDER_SIZE = "film_camera", (640, 480)


def numbers_of_action(action: Any, shape: tuple[int, ...]) -> np.ndarray:
    """Raises Error episode.bad_action when it has another shape or is no array of numbers."""
    try:
        numbers = np.ascontiguousarray(action, np.float64)
    except (TypeError, ValueError):
        raise _core.Error("episode.bad_action", "action", f"it is no array of {shape} numbers") from None
    if numbers.shape != shape:
        raise _core.Error("episode.bad_action", "action", f"shape {numbers.shape}; expected {shape}")
    return numbers


class Rendering:
    """How render() draws. Raises Error usage.bad_flag for what it cannot draw."""

    def __init__(self, environment: _core.Environment, mode: Any, size: Any, camera: Any):
        if mode == "human":
            raise _core.Error(
                "usage.bad_flag",
                "render_mode",
                "'human': no window is opened here; take \"rgb_array\" and show what render() returns, "
                "or let gymnasium.make(..., render_mode=\"human\") open one (it needs pygame)",
            )
        self.mode = arguments.a_name("render_mode", mode, (None, "rgb_array"))
        self.size = arguments.a_size("render_size", size)
        self.camera = arguments.a_name("render_camera", camera, (FILM_CAMERA, *environment.cameras()))

    def picture(self, environment: _core.Environment) -> np.ndarray | None:
        if self.mode is None:
            return None
        return environment.render(self.camera, *self.size, "balanced").rgb.copy()


class TaskEnv(gymnasium.Env):
    """Base of CheckoutUnloading and InAisleCollection, which say what the task is."""

    metadata = {"render_modes": ["rgb_array"], "render_fps": 20}
    track: ClassVar[Track]
    station: ClassVar[str] = CHECKOUT_STATION
    stage: ClassVar[Stage] = "whole"
    preset: ClassVar[str | None] = None  # unless another is given

    def __init__(
        self,
        store: StoreLike | None = None,
        *,
        render_mode: Literal["rgb_array"] | None = None,
        render_size: tuple[int, int] = RENDER_SIZE,
        render_camera: str = FILM_CAMERA,
        setup: TaskSetup | None = None,
        **options: Unpack[TaskOptions],
    ):
        self.setup = self.new_setup(store, options) if setup is None else setup
        self.control_mode, self.cameras = self.setup.control_mode, self.setup.cameras
        self.action_space, self.observation_space = self.setup.action_space, self.setup.observation_space
        self.environment = self.setup.new_environment()
        self._rendering = Rendering(self.environment, render_mode, render_size, render_camera)
        self.render_mode = render_mode
        self._episode: dict[str, Any] = {}
        self._view: View | None = None
        self._row = np.zeros(self.setup.row_length, np.float32)

    @classmethod
    def new_setup(cls, store: StoreLike | None, options: TaskOptions) -> TaskSetup:
        return TaskSetup(
            cls.track, store, station=cls.station, stage=cls.stage, **{"preset": cls.preset, **options}
        )

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
            text = self.setup.draw([drawn], (options or {}).get("progress"))[0]
        self._begin(text)
        return self.observation(), self.info_of_reset(text)

    def _begin(self, text: str) -> None:
        row = np.empty((1, self.setup.row_length), np.float32)
        _core.reset_environments([self.environment], [text], row)
        self._row = row[0]
        self._tell(began=True)

    def next_episode(self, seed: int | None, options: dict[str, Any] | None) -> tuple[str | None, int]:
        """The episode that was asked for, or else the seed of which one is to be drawn."""
        super().reset(seed=seed)
        episode = (options or {}).get("episode")
        if episode is None:
            return None, int(self.np_random.integers(MAX_SEED))
        return self.setup.episode_text(episode), 0

    def info_of_reset(self, text: str) -> dict[str, Any]:
        self._episode = json.loads(text)
        info = self._info()
        if self.setup.shows_truth:
            info |= {"products": self.setup.products_of(self.environment, self._episode["scene_hash"])}
        layout = self.setup.map_of(self.environment)
        if layout is not None:
            info |= {"map": layout, "categories": json.loads(self.environment.task()).get("categories", [])}
        return info

    def step(self, action):
        reward, terminated, truncated = self._advance(numbers_of_action(action, self.action_space.shape))
        info = self.info_of_step(terminated=terminated, truncated=truncated)
        return self.observation(), reward, terminated, truncated, info

    def _advance(self, numbers: np.ndarray) -> tuple[float, bool, bool]:
        """One control step: reward, terminated, truncated."""
        row = np.empty((1, self.setup.row_length), np.float32)
        reward, terminated, truncated = np.zeros(1), np.zeros(1, bool), np.zeros(1, bool)
        _core.step_environments([self.environment], numbers[None], row, reward, terminated, truncated)
        self._row = row[0]
        self._tell(began=False)
        return float(reward[0]), bool(terminated[0]), bool(truncated[0])

    def info_of_step(self, *, terminated: bool, truncated: bool) -> dict[str, Any]:
        info = self._info()
        info["robot_stopped"] = self.environment.robot_stopped()
        if cuts := self.environment.tool_cuts():
            info |= dict(zip(("tool_cut_m", "tool_cut_rad"), np.array(cuts).T, strict=True))
        if terminated or truncated:
            info |= outcome_of(json.loads(self.environment.result()))
        return info

    def _info(self) -> dict[str, Any]:
        return {"instruction": self._episode["instruction"], "time_s": self.environment.time_s()}

    def observation(self) -> Any:
        """What the last reset(), step() or set_state() showed."""
        seen = self.setup.observations
        numbers = seen.numbers_of(self._row)
        return numbers if seen.flat else {**numbers, **seen.pictures_of(self.environment, self._row)}

    @property
    def robot_names(self) -> tuple[str, ...]:
        """What each of robot_numbers() is: "qpos.joint1", "tcp_pose.tool_x", "external_force.ARM"."""
        return self.setup.observations.robot_names

    def robot_numbers(self) -> np.ndarray:
        """What the robot read of itself at the last reset(), step() or set_state(): its joints, tools, place and contacts in
        one row of float32, in every obs_mode."""
        return self.setup.observations.robot_numbers(self._row)

    def parts(self) -> dict[str, dict[str, np.ndarray]]:
        """The numbers of that observation by name, of a flat one, too."""
        return self.setup.observations.parts_of(self._row)

    # ---- The truth: for training and tests, never for evaluation. ----

    def items(self) -> list[dict[str, Any]]:
        """Where things are: sku, pose (x, y, z, qw, qx, qy, qz of the footprint's middle), size, goal, held, in_place,
        segmentation_id.

        In the frame of the robot's base, metres. At a counter all things of the episode; in aisles, for each goal, as many as
        are asked for: those in the basket, then those next to the robot.
        """
        rows = self.environment.items()
        return [{**row, "pose": np.array(row["pose"]), "size": np.array(row["size"])} for row in rows]

    def get_state(self) -> bytes:
        """Everything that the rest of the episode depends on, and the generator of further ones: set_state() goes on from it
        bit for bit, here or in another environment of the same store and action options, in another process too."""
        head = {
            "episode": self._episode,
            "random": random_state(self.np_random),
            "seed": self._np_random_seed,
            "own": self._own_state(),
        }
        return packed(head, self.environment.save())

    def set_state(self, state: bytes) -> Any:
        """Goes back, or over, to where get_state() was called; returns the observation there.

        Raises Error physics.bad_command for other bytes, episode.other_store for an episode of another store. As with pickle,
        bytes of strangers may do harm.
        """
        head, body = unpacked(state)
        row = np.empty((1, self.setup.row_length), np.float32)
        before = None
        if head["episode"] != self._episode:
            before = self.get_state() if self._episode else None
            self._begin(json.dumps(head["episode"]))
            self._episode = head["episode"]
        try:
            self.environment.restore(body, row)
        except _core.Error:
            if before is not None:
                self.set_state(before)
            raise
        self._row = row[0]
        self._tell(began=True)
        self._np_random, self._np_random_seed = generator_of(head["random"]), head["seed"]
        self._take_own_state(head["own"])
        return self.observation()

    def _own_state(self) -> dict[str, Any]:
        """What a task knows of the running episode beside its world, as JSON has it."""
        return {}

    def _take_own_state(self, state: dict[str, Any]) -> None:
        """Goes on from what _own_state() gave."""

    def mujoco_model(self) -> bytes:
        """The physics as an MJB file's bytes: mujoco.MjModel.from_binary_path() of MuJoCo's own package opens it."""
        return self.environment.mujoco_model()

    def mujoco_state(self) -> np.ndarray:
        """How that model stands now: mujoco.mj_setState(model, data, state, mujoco.mjtState.mjSTATE_INTEGRATION)."""
        return np.array(self.environment.mujoco_state())

    def __reduce__(self):
        """copy and pickle: an environment made anew of the same options, set to the same state."""
        begun = bool(self._episode)
        about = {"spec": self.spec, "random": self._np_random, "seed": self._np_random_seed}
        return _env_again, (type(self), self.setup, self._rendering_options(), self.get_state() if begun else None, about)

    def _rendering_options(self) -> dict[str, Any]:
        drawing = self._rendering
        return {"render_mode": self.render_mode, "render_size": drawing.size, "render_camera": drawing.camera}

    def state_hash(self) -> str:
        """32 hex digits over the physics: equal states, equal hashes."""
        return self.environment.state_hash()

    def show(self, *, store: StoreLike | None = None, height: int = 600, port: int = 0) -> View:
        """The episode as it runs, in a notebook's cell or a browser at the address that it says: after each reset(), step() and
        set_state() the page has what the world has. One looks on; it is acted here.

        store   where the episode is: of an environment that was made of a file or a pool; by itself that of the environment
        height  of the cell, pixels
        port    to listen on, of 127.0.0.1; 0 any free one

        Served until close() of the answer, which a `with` does, or until show() is called again, or Python ends; a page of
        another episode is loaded anew. Raises Error episode.bad_action before the first reset(), usage.bad_flag without a
        store, episode.other_store where the episode is of another one; those of Store.show().
        """
        if not self._episode:
            raise _core.Error("episode.bad_action", "show", "no episode has begun: reset it first")
        where = self.setup.store if store is None else store
        if where is None:
            raise _core.Error("usage.bad_flag", "store", "the environment was made without a store: name the folder of the episode's")
        opened = where if isinstance(where, Store) else open_store(where)
        if opened.manifest["scene_hash"] != self._episode["scene_hash"]:
            raise _core.Error("episode.other_store", opened.folder, "the episode is of another store: name that one's folder")
        if self._view is not None:
            self._view.close()
        self._view = watch(opened._handle, height, port)
        self._tell(began=True)
        return self._view

    def _tell(self, *, began: bool) -> None:
        if self._view is not None and not self._view.closed:
            self._view._served.watch(self.environment, self.setup.ground, began)

    def render(self):
        return self._rendering.picture(self.environment)


def _env_again(
    kind: type[TaskEnv], setup: TaskSetup, rendering: dict[str, Any], state: bytes | None, about: dict[str, Any]
) -> TaskEnv:
    env = kind(setup=setup, **rendering)
    env.spec = about["spec"]
    env._np_random, env._np_random_seed = copy.deepcopy(about["random"]), about["seed"]
    if state is not None:
        env.set_state(state)
    return env
