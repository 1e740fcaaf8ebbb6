"""What environments show: spaces, and observations that lie in them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from gymnasium import spaces

from .. import _core

FAR_MM = 32767  # of depth pictures
# Parts of an observation that say nothing to a network: a hash, and at a counter a constant.
NOT_FLAT = {"checkout": {"instruction_id", "base_pose"}, "aisle": {"instruction_id"}}


class Observations:
    """Of one choice of options. Immutable.

    cameras       of the pictures or the points; empty: none
    size          (width, height) of their pictures
    segmentation  object numbers, too
    points        how many points there are instead of pictures; 0: pictures
    flat          one row of numbers instead of a dict
    """

    def __init__(
        self,
        environment: _core.Environment,
        track: str,
        *,
        cameras: tuple[str, ...],
        size: tuple[int, int],
        quality: str,
        segmentation: bool,
        points: int,
        flat: bool,
    ):
        self.cameras, self.size, self.quality = cameras, size, quality
        self.segmentation, self.points, self.flat = segmentation, points, flat
        self._parts: list[tuple[str, str, tuple[int, ...], slice]] = []
        lows: list[np.ndarray] = []
        highs: list[np.ndarray] = []
        flat_places: list[int] = []
        self._named: list[tuple[str, int]] = []  # the robot's numbers, and where they stand in a row
        end = 0
        for group, name, shape, low, high, names in environment.observation_parts():
            start, end = end, end + math.prod(shape)
            self._parts.append((group, name, tuple(shape), slice(start, end)))
            lows.append(np.asarray(low, np.float32))
            highs.append(np.asarray(high, np.float32))
            self._named += [(name if number == name else f"{name}.{number}", start + i) for i, number in enumerate(names)]
            if name not in NOT_FLAT[track]:
                flat_places += range(start, end)
        self.row_length = end
        self._low, self._high = np.concatenate(lows), np.concatenate(highs)
        self._flat_places = np.asarray(flat_places)
        [self._base] = [place for _, name, _, place in self._parts if name == "base_pose"]
        ground = float(self._high[self._base.start])
        # Points lie in the robot's frame: in aisles as far as from one end of a store to the other.
        self._farthest = ground if track == "checkout" else 2 * ground
        self._drives = track == "aisle"
        self.space = self._flat_space() if flat else self._dict_space()

    def _flat_space(self) -> spaces.Box:
        places = self._flat_places
        return spaces.Box(self._low[places], self._high[places], dtype=np.float32)

    def _dict_space(self) -> spaces.Dict:
        groups: dict[str, dict[str, spaces.Space]] = {}
        for group, name, shape, place in self._parts:
            low, high = self._low[place].reshape(shape), self._high[place].reshape(shape)
            groups.setdefault(group, {})[name] = spaces.Box(low, high, dtype=np.float32)
        if self.points:
            groups["pointcloud"] = self._point_planes()
        elif self.cameras:
            groups["sensor_data"] = {name: spaces.Dict(self._planes()) for name in self.cameras}
            groups["sensor_param"] = {name: spaces.Dict(self._matrix_spaces()) for name in self.cameras}
        return spaces.Dict({group: spaces.Dict(parts) for group, parts in groups.items()})

    def _planes(self) -> dict[str, spaces.Space]:
        width, height = self.size
        planes: dict[str, spaces.Space] = {
            "rgb": spaces.Box(0, 255, (height, width, 3), np.uint8),
            "depth": spaces.Box(0, FAR_MM, (height, width, 1), np.int16),
        }
        if self.segmentation:
            planes["segmentation"] = spaces.Box(0, 2**31 - 1, (height, width, 1), np.int32)
        return planes

    def _point_planes(self) -> dict[str, spaces.Space]:
        far = self._farthest
        planes: dict[str, spaces.Space] = {
            "xyz": spaces.Box(-far, far, (self.points, 3), np.float32),
            "rgb": spaces.Box(0, 255, (self.points, 3), np.uint8),
        }
        if self.segmentation:
            planes["segmentation"] = spaces.Box(0, 2**31 - 1, (self.points, 1), np.int32)
        return planes

    def _matrix_spaces(self) -> dict[str, spaces.Space]:
        low, high = -np.ones((4, 4), np.float32), np.ones((4, 4), np.float32)
        low[:3, 3], high[:3, 3] = -4 * self._farthest, 4 * self._farthest
        # The narrowest field of view of our cameras is 10 degrees: a focal length of six widths.
        return {
            "cam2world_gl": spaces.Box(low, high, dtype=np.float32),
            "extrinsic_cv": spaces.Box(low, high, dtype=np.float32),
            "intrinsic_cv": spaces.Box(0, 6.0 * max(self.size), (3, 3), np.float32),
        }

    def numbers_of(self, rows: np.ndarray) -> Any:
        """One row of numbers, or many, as the space has them: views where they can be."""
        return rows[..., self._flat_places] if self.flat else self.parts_of(rows)

    @property
    def robot_names(self) -> tuple[str, ...]:
        """What each of the robot's own numbers is, whatever else is shown: "qpos.joint1", "tcp_pose.tool_x"."""
        return tuple(name for name, _ in self._named)

    def robot_numbers(self, row: np.ndarray) -> np.ndarray:
        """Those of a row."""
        return row[[place for _, place in self._named]]

    def parts_of(self, rows: np.ndarray) -> dict[str, dict[str, np.ndarray]]:
        seen: dict[str, dict[str, np.ndarray]] = {}
        for group, name, shape, place in self._parts:
            seen.setdefault(group, {})[name] = rows[..., place].reshape(*rows.shape[:-1], *shape)
        return seen

    def pictures_of(self, environment: _core.Environment, row: np.ndarray) -> dict[str, Any]:
        """sensor_data and sensor_param, or pointcloud, as things stand now; nothing without cameras. `row`: its numbers."""
        if not self.cameras:
            return {}
        if self.points:
            return {"pointcloud": self._cloud(environment, row)}
        return {
            "sensor_data": {name: self._picture(environment, name) for name in self.cameras},
            "sensor_param": {name: self._matrices(environment, name) for name in self.cameras},
        }

    def _picture(self, environment: _core.Environment, camera: str) -> dict[str, np.ndarray]:
        frame = environment.render(camera, *self.size, self.quality)
        millimetres = np.rint(frame.depth * 1000)
        millimetres[millimetres > FAR_MM] = 0
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

    def _cloud(self, environment: _core.Environment, row: np.ndarray) -> dict[str, np.ndarray]:
        """Points evenly out of those that the cameras see, row by row; where they see fewer, some of them again."""
        base_from_ground = self._base_from_ground(row)
        parts = [self._points_of(environment, name, base_from_ground) for name in self.cameras]
        xyz, rgb, objects = (np.concatenate(planes) for planes in zip(*parts, strict=True))
        count = len(xyz)
        chosen = np.arange(self.points) * count // self.points if count else np.zeros(0, int)
        cloud = {"xyz": np.zeros((self.points, 3), np.float32), "rgb": np.zeros((self.points, 3), np.uint8)}
        cloud["xyz"][: len(chosen)], cloud["rgb"][: len(chosen)] = xyz[chosen], rgb[chosen]
        if self.segmentation:
            cloud["segmentation"] = np.zeros((self.points, 1), np.int32)
            cloud["segmentation"][: len(chosen), 0] = objects[chosen]
        return cloud

    def _base_from_ground(self, row: np.ndarray) -> np.ndarray:
        if not self._drives:
            return np.eye(4)
        x, y, heading = row[self._base].astype(np.float64)
        cos, sin = math.cos(heading), math.sin(heading)
        turn = np.array([[cos, sin], [-sin, cos]])
        inverse = np.eye(4)
        inverse[:2, :2], inverse[:2, 3] = turn, -turn @ (x, y)
        return inverse

    def _points_of(
        self, environment: _core.Environment, name: str, base_from_ground: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        frame, camera = environment.render(name, *self.size, self.quality), environment.camera(name, *self.size)
        k, depth = camera.intrinsic_cv, frame.depth.astype(np.float64)
        height, width = depth.shape
        across = (np.arange(width) - k[0, 2]) / k[0, 0] * depth
        down = ((np.arange(height) - k[1, 2]) / k[1, 1])[:, None] * depth
        seen = np.stack([across, -down, -depth, np.ones_like(depth)], -1).reshape(-1, 4)
        xyz = seen @ (base_from_ground @ camera.cam2world_gl).T[:, :3]
        there = (depth.reshape(-1) > 0) & (np.abs(xyz) <= self._farthest).all(1)
        rgb, objects = frame.rgb.reshape(-1, 3), frame.instance.reshape(-1)
        return xyz[there].astype(np.float32), rgb[there], objects[there].astype(np.int32)
