"""What `--env.type=marketgen` of LeRobot's programs is."""

from __future__ import annotations

import dataclasses
from typing import Any

from lerobot.configs.types import FeatureType, PolicyFeature
from lerobot.envs.configs import EnvConfig

from ..arguments import camera_names
from ..as_recorded import AsRecorded
from ..environments.task_env import FILM_CAMERA
from ..recording.acting import FPS
from ..recording.features import ACTION, PICTURES, STATE
from .episodes_env import GYM_ID


@EnvConfig.register_subclass("marketgen")
@dataclasses.dataclass
class MarketGenEnv(EnvConfig):
    """The options of record(), which must be those that the policy's dataset was recorded with.

    task           a file of `marketgen episodes`, or a set that comes with the program
    cameras        "scene_camera,wrist_camera"; "none": numbers alone; empty: both at the counter, the head's in the aisles
    render_camera, render_width, render_height  of the films that lerobot-eval leaves
    features       are made of these, whatever is given
    """

    task: str | None = "pool/checkout"
    fps: int = FPS
    cameras: str = ""
    observation_width: int = 256
    observation_height: int = 256
    quality: str = "fast"
    control_mode: str = "pd_joint_pos"
    realism: str = "ideal"
    render_mode: str | None = "rgb_array"
    render_camera: str = FILM_CAMERA
    render_width: int = 320
    render_height: int = 240

    def __post_init__(self) -> None:
        shown = AsRecorded(self.task or "", **self._recorded())
        pixels = {f"pixels/{camera}": PICTURES + camera for camera in shown.cameras}
        self.features = {
            ACTION: PolicyFeature(FeatureType.ACTION, shown.action_space.shape),
            "agent_pos": PolicyFeature(FeatureType.STATE, (len(shown.robot_names),)),
            **{name: PolicyFeature(FeatureType.VISUAL, (self.observation_height, self.observation_width, 3)) for name in pixels},
        }
        self.features_map = {ACTION: ACTION, "agent_pos": STATE, **pixels}

    def _recorded(self) -> dict[str, Any]:
        return {
            "cameras": camera_names(self.cameras) if self.cameras else None,
            "size": (self.observation_width, self.observation_height),
            "quality": self.quality,
            "control_mode": self.control_mode,
            "realism": self.realism,
        }

    @property
    def package_name(self) -> str:
        return __package__

    @property
    def gym_id(self) -> str:
        return GYM_ID

    @property
    def gym_kwargs(self) -> dict[str, Any]:
        rendering = {
            "render_mode": self.render_mode,
            "render_size": (self.render_width, self.render_height),
            "render_camera": self.render_camera,
        }
        return {"task": self.task, **self._recorded(), **rendering}
