"""What a robot reads of itself, by name, out of an observation: for who has no environment, only what it shows."""

from __future__ import annotations

import fnmatch
from collections.abc import Sequence
from typing import Any

import numpy as np

from .. import arguments

AXES, QUATERNION = ("x", "y", "z"), ("qw", "qx", "qy", "qz")


class RobotNumbers:
    """`names`: those of task["robot_names"], "qpos.joint1": the part of the observation and what its numbers are, in order.

    Beside these there are, made of them: "tcp_turn.TOOL_x", _y, _z, a tool's rotation as a vector (rad, along its axis), and
    "finger.TOOL_left", "_right", half of its opening with a sign, as simulators of two fingers have it.
    """

    def __init__(self, names: Sequence[str]):
        self.names = tuple(names)
        self._parts = tuple(dict.fromkeys(name.partition(".")[0] for name in names))
        self._place = {name: place for place, name in enumerate(names)}
        self._made: dict[str, Any] = {}
        for name in names:
            part, _, number = name.partition(".")
            if part == "tcp_pose" and number.endswith("_qw"):
                self._add_turn(number.removesuffix("_qw"))
            if part == "qpos" and number.endswith("_opening"):
                self._add_fingers(name, number.removesuffix("_opening"))

    def _add_turn(self, tool: str) -> None:
        places = [self._place[f"tcp_pose.{tool}_{part}"] for part in QUATERNION]
        for axis, letter in enumerate(AXES):
            self._made[f"tcp_turn.{tool}_{letter}"] = lambda row, axis=axis: rotation_vector(row[places])[axis]

    def _add_fingers(self, name: str, tool: str) -> None:
        place = self._place[name]
        for side, sign in (("left", 0.5), ("right", -0.5)):
            self._made[f"finger.{tool}_{side}"] = lambda row, sign=sign: sign * row[place]

    def chosen(self, wanted: Sequence[str], where: str) -> tuple[str, ...]:
        """Of the patterns `wanted` ("qpos.joint*") all names, in their order. Raises Error usage.bad_flag for one that fits none."""
        known = (*self.names, *self._made)
        found: list[str] = []
        for pattern in wanted:
            fits = fnmatch.filter(known, pattern)
            found += fits or [arguments.a_name(where, pattern, known)]
        return tuple(found)

    def row(self, observation: dict[str, Any]) -> np.ndarray:
        """All that have a name, as float32, in the order of `names`."""
        groups = {**observation.get("agent", {}), **observation.get("extra", {})}
        ordered = [np.ravel(groups[part]) for part in self._parts]
        return np.concatenate(ordered).astype(np.float32)

    def values(self, row: np.ndarray, names: Sequence[str]) -> np.ndarray:
        made = [self._made[name](row) if name in self._made else row[self._place[name]] for name in names]
        return np.asarray(made, np.float32)


def rotation_vector(quaternion: np.ndarray) -> np.ndarray:
    """Of w, x, y, z, of the shorter way round: along the axis, as long as the angle."""
    w, axis = float(quaternion[0]), np.asarray(quaternion[1:], np.float64)
    if w < 0:
        w, axis = -w, -axis
    length = float(np.linalg.norm(axis))
    if length < 1e-9:
        return 2 * axis
    return axis / length * 2 * np.arctan2(length, w)
