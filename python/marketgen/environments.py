"""Gymnasium environments. Importing marketgen registers them where Gymnasium is installed.

    gymnasium.make("MarketGen/CheckoutUnloading-v1", store="shop", obs_mode="rgbd", control_mode="pd_ee_delta_pose")
"""

from __future__ import annotations

import functools
import json
import os
import pathlib
from typing import Any, Literal

import gymnasium
import numpy as np
from gymnasium import spaces

from . import _core
from .store import Store, generate, open_store

DEFAULT_PROMPT = "a corner shop of 63 m2 with cold drinks, snacks, canned food and one checkout"
CAMERAS = ("scene_camera", "wrist_camera")
JOINT_STEP = 0.1  # rad in a control step: 2 rad/s, the slowest of the Panda's joints turns at 2.175
TOOL_STEP, TURN_STEP = 0.02, 0.1  # m and rad in a control step
GRIP_N = 20.0

MOST_KEPT_EPISODES = 1000
_drawn_episodes: dict[tuple[str, int], str] = {}

ObsMode = Literal["state", "rgbd"]
ControlMode = Literal["pd_joint_pos", "pd_joint_delta_pos", "pd_ee_delta_pos", "pd_ee_delta_pose"]
RewardMode = Literal["sparse", "dense"]
MOVES = {"pd_joint_pos": 7, "pd_joint_delta_pos": 7, "pd_ee_delta_pos": 3, "pd_ee_delta_pose": 6}


@functools.lru_cache(maxsize=1)
def default_store() -> Store:
    """A small shop, made once into the cache folder."""
    folder = pathlib.Path(_core.cache_folder()) / "stores" / f"{_core.__version__}-corner-shop"
    if not (folder / "store.json").exists():
        try:
            return generate(DEFAULT_PROMPT, folder, seed=1, size="9x7m")
        except _core.Error as error:
            if error.code != "store.exists":  # another process was first
                raise
    return open_store(folder)


def _box(low: float, high: float, shape: tuple[int, ...], dtype: Any) -> spaces.Box:
    return spaces.Box(low, high, shape, dtype)


def _product(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Of two quaternions w, x, y, z."""
    (w, v), (u, t) = (a[0], a[1:]), (b[0], b[1:])
    return np.concatenate(([w * u - v @ t], w * t + u * v + np.cross(v, t)))


class CheckoutUnloading(gymnasium.Env):
    """A Panda behind a checkout counter puts the named products from a basket onto the unloading area.

    store         a Store, its folder, or None for a small shop in the cache folder
    obs_mode      "state": the arm alone; "rgbd": pictures of `cameras`, too
    control_mode  what the first numbers of an action are, 20 a second; all are in [-1, 1] but those of pd_joint_pos:
                    pd_joint_pos        7 joint angles, rad
                    pd_joint_delta_pos  7, 1 = 0.1 rad from the last target
                    pd_ee_delta_pos     3, 1 = 20 mm along x, y, z of the station (x over the counter, z up)
                    pd_ee_delta_pose    6, and 1 = 0.1 rad about those axes
                  Then the gripper: -1 closed, 1 open. Then `stop`: above 0, the agent says that it has done.
    reward_mode   "sparse": at the end, the share of the goals; "dense": each step from 0 to 1, nearer is more
    width, height, quality  of the pictures
    segmentation  object numbers with the pictures: for training, never for evaluation

    `reset(options={"episode": {...}})` takes a market-episode/1 document, in 20 ms; otherwise `seed` draws one from the
    store's stock, in a second or two.
    Ends when the agent stops (terminated) or the time is over (truncated); judged 2 s later:
    `info` then has success, goal_fraction and the whole `result` (market-result/1). Before, only `instruction` and `time_s`.
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": 20}

    def __init__(
        self,
        store: Store | str | os.PathLike[str] | None = None,
        *,
        obs_mode: ObsMode = "state",
        control_mode: ControlMode = "pd_joint_delta_pos",
        reward_mode: RewardMode = "sparse",
        cameras: tuple[str, ...] = CAMERAS,
        width: int = 128,
        height: int = 128,
        quality: Literal["fast", "balanced", "best"] = "fast",
        segmentation: bool = False,
        render_mode: Literal["rgb_array"] | None = None,
    ):
        for name, value, known in (
            ("obs_mode", obs_mode, ("state", "rgbd")),
            ("control_mode", control_mode, tuple(MOVES)),
            ("reward_mode", reward_mode, ("sparse", "dense")),
            ("render_mode", render_mode, (None, "rgb_array")),
        ):
            if value not in known:
                raise _core.Error("usage.bad_flag", name, f"{value!r} is none of {', '.join(map(str, known))}")
        if not isinstance(store, Store):
            store = default_store() if store is None else open_store(store)
        self.store, self.render_mode = store, render_mode
        self.obs_mode, self.control_mode, self.reward_mode = obs_mode, control_mode, reward_mode
        self.cameras, self.segmentation = tuple(cameras) if obs_mode == "rgbd" else (), segmentation
        self._size, self._quality = (width, height), quality
        self._world = _core.Checkout(store._handle)
        self._lower, self._upper, self._opening = map(np.array, self._world.joint_limits())
        self.action_space = self._action_space()
        self.observation_space = self._observation_space()
        self._episode: dict[str, Any] = {}
        self._target = np.zeros(7)

    def _action_space(self) -> spaces.Box:
        count = MOVES[self.control_mode] + 2
        low, high = -np.ones(count, np.float32), np.ones(count, np.float32)
        if self.control_mode == "pd_joint_pos":
            low[:7], high[:7] = self._lower, self._upper
        return spaces.Box(low, high, dtype=np.float32)

    def _observation_space(self) -> spaces.Dict:
        inf = float("inf")
        space = {
            "agent": spaces.Dict(
                {"qpos": _box(-inf, inf, (8,), np.float32), "qvel": _box(-inf, inf, (7,), np.float32)}
            ),
            "extra": spaces.Dict({"tcp_pose": _box(-inf, inf, (7,), np.float32)}),
        }
        if self.cameras:
            width, height = self._size
            planes = {
                "rgb": _box(0, 255, (height, width, 3), np.uint8),
                "depth": _box(0, 32767, (height, width, 1), np.int16),
            }
            if self.segmentation:
                planes["segmentation"] = _box(0, 2**31 - 1, (height, width, 1), np.int32)
            matrices = {
                "cam2world_gl": _box(-inf, inf, (4, 4), np.float32),
                "extrinsic_cv": _box(-inf, inf, (4, 4), np.float32),
                "intrinsic_cv": _box(-inf, inf, (3, 3), np.float32),
            }
            space["sensor_data"] = spaces.Dict({name: spaces.Dict(dict(planes)) for name in self.cameras})
            space["sensor_param"] = spaces.Dict({name: spaces.Dict(dict(matrices)) for name in self.cameras})
        return spaces.Dict(space)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None):
        super().reset(seed=seed)
        episode = (options or {}).get("episode")
        if episode is None:
            text = self._drawn(int(self.np_random.integers(2**32)))
        else:
            text = episode if isinstance(episode, str) else json.dumps(episode)
        self._world.reset(text)
        self._episode = json.loads(text)
        _, position, _, _ = self._world.observe()
        self._target = np.array(position)
        return self._observation(), self._info()

    def _drawn(self, seed: int) -> str:
        """The episode of a seed: goods are dropped into the basket until they rest, a second or two. Kept, for those
        who come back to their seeds."""
        key = (self.store.manifest["scene_hash"], seed)
        if key not in _drawn_episodes:
            while len(_drawn_episodes) >= MOST_KEPT_EPISODES:
                _drawn_episodes.pop(next(iter(_drawn_episodes)))
            _drawn_episodes[key] = self._world.sample(seed, 0)
        return _drawn_episodes[key]

    def step(self, action):
        action = np.asarray(action, np.float64)
        if action.shape != self.action_space.shape:
            raise _core.Error(
                "episode.bad_action", "action", f"shape {action.shape}; expected {self.action_space.shape}"
            )
        if not np.isfinite(action).all():
            raise _core.Error("episode.bad_action", "action", "expected finite numbers")
        if not self._episode or self._world.done():
            raise _core.Error("episode.bad_action", "step", "the episode is over: reset it first")
        move, grip, stop = action[:-2], np.clip(action[-2], -1, 1), bool(action[-1] > 0)
        target = np.ascontiguousarray(self._wanted_joints(move))
        self._world.step(target, float((grip + 1) / 2 * self._opening), GRIP_N, stop)
        self._target = np.clip(target, self._lower, self._upper)
        over = self._world.done()
        observation, info, reward = self._observation(), self._info(), 0.0
        if over:
            result = json.loads(self._world.finish())
            info.update(self._outcome(result, stopped=stop))
            reward = result["success_partial"]
        if self.reward_mode == "dense":
            reward = self._dense_reward(info)
        return observation, float(reward), over and stop, over and not stop, info

    def _wanted_joints(self, move: np.ndarray) -> np.ndarray:
        if self.control_mode == "pd_joint_pos":
            return move
        move = np.clip(move, -1, 1)
        if self.control_mode == "pd_joint_delta_pos":
            return self._target + JOINT_STEP * move
        pose = np.array(self._world.tool_pose())
        pose[:3] += TOOL_STEP * move[:3]
        turn = TURN_STEP * move[3:]
        angle = float(np.linalg.norm(turn))
        if angle > 0:
            turned = np.concatenate(([np.cos(angle / 2)], np.sin(angle / 2) * turn / angle))
            pose[3:] = _product(turned, pose[3:])
        return np.array(self._world.joints_for(pose))

    def _observation(self) -> dict[str, Any]:
        _, position, velocity, opening = self._world.observe()
        seen: dict[str, Any] = {
            "agent": {"qpos": np.float32([*position, opening]), "qvel": np.float32(velocity)},
            "extra": {"tcp_pose": np.float32(self._world.tool_pose())},
        }
        if self.cameras:
            seen["sensor_data"] = {name: self._picture(name) for name in self.cameras}
            seen["sensor_param"] = {name: self._matrices(name) for name in self.cameras}
        return seen

    def _picture(self, camera: str) -> dict[str, np.ndarray]:
        frame = self._world.render(camera, *self._size, self._quality)
        millimetres = np.rint(frame.depth * 1000)
        millimetres[millimetres > 32767] = 0
        planes = {"rgb": frame.rgb.copy(), "depth": millimetres.astype(np.int16)[..., None]}
        if self.segmentation:
            planes["segmentation"] = frame.instance.astype(np.int32)[..., None]
        return planes

    def _matrices(self, name: str) -> dict[str, np.ndarray]:
        camera = self._world.camera(name, *self._size)
        return {
            "cam2world_gl": camera.cam2world_gl.astype(np.float32),
            "extrinsic_cv": camera.extrinsic_cv.astype(np.float32),
            "intrinsic_cv": camera.intrinsic_cv.astype(np.float32),
        }

    def _info(self) -> dict[str, Any]:
        return {"instruction": self._episode["instruction"], "time_s": self._world.observe()[0]}

    @staticmethod
    def _outcome(result: dict[str, Any], *, stopped: bool) -> dict[str, Any]:
        success = result["success_strict"]
        reason = "None" if success else ("Missed" if stopped else "Timeout")
        return {
            "success": success,
            "is_success": success,
            "success_once": success,
            "success_at_end": success,
            "goal_fraction": result["success_partial"],
            "failure_reason": reason,
            "result": result,
        }

    def _dense_reward(self, info: dict[str, Any]) -> float:
        """Mean over the goals of 1 - tanh(3 d), d in metres from the unloading area's middle; 1 when all are met."""
        if info.get("success"):
            return 1.0
        middle = np.array(self._world.unloading_center())
        poses = np.array(self._world.item_poses())
        nearness = 1 - np.tanh(3 * np.linalg.norm(poses[:, :2] - middle, axis=1))
        skus = [item["sku"] for item in self._episode["items"]]
        shares: list[float] = []
        for goal in self._episode["goals"]:
            best = sorted((nearness[i] for i, sku in enumerate(skus) if sku == goal["sku"]), reverse=True)
            shares += best[: goal["count"]]
        return float(np.mean(shares))

    def render(self):
        if self.render_mode is None:
            return None
        return self._world.render("scene_camera", 640, 480, "balanced").rgb.copy()


gymnasium.register("MarketGen/CheckoutUnloading-v1", entry_point="marketgen.environments:CheckoutUnloading")
