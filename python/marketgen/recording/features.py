"""What a frame of a dataset has, and the names of its numbers."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

STATE, ACTION, PICTURES = "observation.state", "action", "observation.images."
REWARD, DONE, SUCCESS = "next.reward", "next.done", "next.success"
TIME, FRAME, EPISODE, INDEX, TASK, SUBTASK = "timestamp", "frame_index", "episode_index", "index", "task_index", "subtask_index"


@dataclasses.dataclass(frozen=True)
class Numbers:
    """Of each frame `names` many, or one without a name."""

    dtype: str
    names: tuple[str, ...] | None = None

    @property
    def shape(self) -> tuple[int, ...]:
        return (1,) if self.names is None else (len(self.names),)

    def rows(self, values: Any) -> np.ndarray:
        """(frames, numbers), or (frames,) where they have no names."""
        made = np.asarray(values, np.dtype(self.dtype))
        return made.reshape(-1) if self.names is None else made.reshape(-1, len(self.names))


def acted(robot_names: tuple[str, ...], action_names: tuple[str, ...]) -> dict[str, Numbers]:
    """What an episode says of itself, wherever in a dataset it comes to stand."""
    return {
        ACTION: Numbers("float32", action_names),
        STATE: Numbers("float32", robot_names),
        REWARD: Numbers("float32"),
        DONE: Numbers("bool"),
        SUCCESS: Numbers("bool"),
        TIME: Numbers("float32"),
        FRAME: Numbers("int64"),
        SUBTASK: Numbers("int64"),
    }


# What depends on the episodes before it.
PLACED = {EPISODE: Numbers("int64"), INDEX: Numbers("int64"), TASK: Numbers("int64")}


def described(numbers: dict[str, Numbers], videos: dict[str, dict[str, Any]], size: tuple[int, int]) -> dict[str, Any]:
    """`features` of info.json. `videos`: what is said of each camera's."""
    width, height = size
    pictures = {
        PICTURES + camera: {
            "dtype": "video",
            "shape": [height, width, 3],
            "names": ["height", "width", "channels"],
            "info": about,
        }
        for camera, about in videos.items()
    }
    rows = {
        name: {"dtype": one.dtype, "shape": list(one.shape), "names": None if one.names is None else list(one.names)}
        for name, one in numbers.items()
    }
    return {ACTION: rows.pop(ACTION), STATE: rows.pop(STATE), **pictures, **rows}
