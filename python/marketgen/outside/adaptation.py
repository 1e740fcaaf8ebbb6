"""An adapter at work in one episode: observations as the model wants them, and its answers as actions of the environment."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ..errors import Error
from ..policy_process import PolicyFailed
from .adapters import ALL, Adapter, Leaf, Numbers, Picture
from .robot_numbers import RobotNumbers

OPENING, STOP, NOTHING = "tool_opening", "stop", "-"
BAD_ANSWER = "episode.bad_answer"
# Of the way to a tool's target, in one control step. An arm answers some steps late: told to go all of it, it swings by 6 cm to
# either side for good; at half of it it goes 2 cm too far once, from 0.35 on down it does not (a Panda at the counter, 6 cm away).
SHARE_OF_WAY = 1 / 3


class Adaptation:
    """Of one task. Raises Error usage.bad_flag where the adapter names what the robot does not have.

    task         what the policy was told: instruction, action_names, action_units, robot_names
    observation  the first one
    """

    def __init__(self, adapter: Adapter, task: Mapping[str, Any], observation: dict[str, Any]):
        self._adapter, self._instruction = adapter, task["instruction"]
        self._robot = RobotNumbers(task["robot_names"])
        self._names = tuple(task["action_names"])
        self._chosen = {leaf: self._named(leaf) for leaf in adapter.leaves() if isinstance(leaf, Numbers)}
        for leaf in adapter.leaves():
            if isinstance(leaf, Picture) and leaf.camera not in observation.get("sensor_data", {}):
                raise Error("usage.bad_flag", "adapter", f"{adapter.name} wants pictures of {leaf.camera!r}, which this robot does not have")
        self.numbers = self._numbers_of_action()
        self._places = [self._names.index(name) if name != NOTHING else -1 for name in self.numbers]
        self._units = dict(zip(self._names, task["action_units"], strict=True))
        self._tools = self._tools_led()
        self._scale, self._offset = self._scales()
        self._rest = self._at_rest(observation)

    def _named(self, leaf: Numbers) -> tuple[str, ...]:
        if leaf.names == ALL:
            return self._robot.names
        return self._robot.chosen(leaf.names, f"adapter {self._adapter.name}")

    def _numbers_of_action(self) -> tuple[str, ...]:
        wanted = self._adapter.action.numbers
        if wanted == ALL:
            return self._names
        if not wanted:
            return tuple(name for name in self._names if name != STOP)
        named = [name for name in wanted if name != NOTHING]
        unknown = [name for name in named if name not in self._names]
        if unknown:
            raise Error(
                "usage.bad_flag",
                "adapter",
                f"{self._adapter.name} has actions of {unknown[0]!r}; those of this robot are {', '.join(self._names)}",
            )
        if len(set(named)) != len(named):
            raise Error("usage.bad_flag", "adapter", f"{self._adapter.name} names a number of the action twice")
        return wanted

    def _tools_led(self) -> list[tuple[list[int], list[int], np.ndarray]]:
        """Of tool_targets, for each tool: places of its axes in an action, and in what the robot reads; what 1 of an action is in m."""
        led: dict[str, list[str]] = {}
        if self._adapter.action.space == "tool_targets":
            for name in self.numbers:
                if f"tcp_pose.{name}" in self._robot.names:
                    led.setdefault(name[:-1], []).append(name)
        return [
            (
                [self._names.index(name) for name in axes],
                [self._robot.names.index(f"tcp_pose.{name}") for name in axes],
                np.array([self._units[name][0] for name in axes]),
            )
            for axes in led.values()
        ]

    def _scales(self) -> tuple[np.ndarray, np.ndarray]:
        """By which the model's numbers become those of an action: times the first, plus the second."""
        row, targets = self._adapter.action, {place for places, _, _ in self._tools for place in places}
        scale, offset = np.ones(len(self.numbers)), np.zeros(len(self.numbers))
        for place, name in enumerate(self.numbers):
            if name.endswith(OPENING):  # closed: -1, open: 1
                scale[place] = 2 / (row.open - row.closed)
                offset[place] = -1 - row.closed * scale[place]
            elif self._places[place] in targets:
                scale[place] = row.unit_m
            elif name != NOTHING and self._units[name][0]:
                unit, dimension = self._units[name]
                scale[place] = (row.unit_m if dimension == "m" else row.unit_rad) / unit
        return scale, offset

    def _at_rest(self, observation: dict[str, Any]) -> np.ndarray:
        """Of numbers that the model does not say: joints stay, tools are open, nothing drives, and it has not done."""
        rest = np.zeros(len(self._names))
        held = dict(zip(self._robot.names, self._robot.row(observation), strict=True))
        for place, name in enumerate(self._names):
            if name == STOP:
                rest[place] = -1
            elif name.endswith(OPENING):
                rest[place] = 1
            elif self._adapter.action.space == "joint_targets":
                rest[place] = held.get(f"qpos.{name}", 0.0)
        return rest

    def told(self, observation: dict[str, Any]) -> dict[str, Any]:
        """What the model is sent."""
        row = self._robot.row(observation)

        def made(part: Any) -> Any:
            if isinstance(part, dict):
                return {name: made(inner) for name, inner in part.items()}
            return self._value(part, observation, row)

        return made(self._adapter.observation)

    def _value(self, leaf: Leaf, observation: dict[str, Any], row: np.ndarray) -> Any:
        if isinstance(leaf, Picture):
            return self._picture(observation["sensor_data"][leaf.camera]["rgb"])
        if isinstance(leaf, Numbers):
            values = self._robot.values(row, self._chosen[leaf])
            return np.float32(leaf.scale) * values + np.float32(leaf.offset)
        return self._instruction

    def _picture(self, rgb: np.ndarray) -> np.ndarray:
        if self._adapter.layout == "chw":
            rgb = np.ascontiguousarray(np.moveaxis(rgb, -1, 0))
        return rgb if self._adapter.values == "bytes" else rgb.astype(np.float32) / np.float32(255)

    def actions(self, answer: Any) -> np.ndarray:
        """A row a control step, for executed(), of the model's answer. Raises PolicyFailed episode.bad_answer."""
        said = self._said(answer)
        steps = said[: self._adapter.action.execute] * self._scale + self._offset
        actions = np.tile(self._rest, (len(steps), 1))
        for column, place in enumerate(self._places):
            if place >= 0:
                actions[:, place] = steps[:, column]
        return actions

    def executed(self, action: np.ndarray, observation: dict[str, Any]) -> np.ndarray:
        """A row of actions() as the environment takes it now: for a tool's target a step straight there, as long as steps can be."""
        if not self._tools:
            return action
        row, action = self._robot.row(observation), action.copy()
        for places, read, unit_m in self._tools:
            step = SHARE_OF_WAY * (action[places] - row[read]) / unit_m
            action[places] = step / max(1.0, float(np.abs(step).max()))
        return action

    def _said(self, answer: Any) -> np.ndarray:
        """Its numbers, (steps, numbers of a step), finite."""
        row = self._adapter.action
        if not isinstance(answer, Mapping):
            raise PolicyFailed(BAD_ANSWER, f"{type(answer).__name__} in place of fields; the adapter wants {', '.join(row.keys)}")
        parts = [_array(answer, key) for key in row.keys]
        if len({len(part) for part in parts}) > 1:
            shapes = ", ".join(f"{key} {part.shape}" for key, part in zip(row.keys, parts, strict=True))
            raise PolicyFailed(BAD_ANSWER, f"its parts are of different lengths: {shapes}")
        said = np.concatenate(parts, axis=1)
        self._check_shape(said)
        if not np.isfinite(said).all():
            step, number = (int(place) for place in np.argwhere(~np.isfinite(said))[0])
            raise PolicyFailed(BAD_ANSWER, f"step {step} of its actions has {said[step, number]} for {self.numbers[number]}")
        return said

    def _check_shape(self, said: np.ndarray) -> None:
        row = self._adapter.action
        steps, count = said.shape
        if count != len(self.numbers):
            raise PolicyFailed(
                BAD_ANSWER,
                f"a step of its actions has {count} numbers; the adapter {self._adapter.name} wants {len(self.numbers)}: "
                f"{', '.join(self.numbers)}",
            )
        least = row.length or row.execute or 1
        if steps < least or (row.length is not None and steps != row.length):
            wanted = f"{row.length}" if row.length is not None else f"{least} or more"
            raise PolicyFailed(BAD_ANSWER, f"{steps} steps of actions; the adapter {self._adapter.name} wants {wanted}")


def _array(answer: Mapping[str, Any], key: str) -> np.ndarray:
    """(steps, numbers) of one part."""
    if key not in answer:
        raise PolicyFailed(BAD_ANSWER, f"it has no {key!r}; it has {', '.join(map(repr, answer)) or 'nothing'}")
    try:
        numbers = np.asarray(answer[key])
    except ValueError:
        numbers = np.empty(0, object)
    if numbers.dtype.kind not in "biuf":
        raise PolicyFailed(BAD_ANSWER, f"{key!r} is no array of numbers")
    if numbers.ndim == 1:
        numbers = numbers[None]
    if numbers.ndim == 3 and len(numbers) == 1:  # of a batch of one
        numbers = numbers[0]
    if numbers.ndim != 2 or 0 in numbers.shape:
        raise PolicyFailed(BAD_ANSWER, f"{key!r} has shape {np.shape(answer[key])}; expected (steps, numbers of a step)")
    return numbers.astype(np.float64)
