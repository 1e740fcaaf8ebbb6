"""What people drove in the page of `marketgen view`, as a dataset: record_drives().

A log has its episode and the action of every control step; played in the environment of the same episode it leads to the same
states, which is checked.
"""

from __future__ import annotations

import dataclasses
import json
import os
import pathlib
from collections.abc import Sequence
from typing import Any

import numpy as np

from .. import _core, arguments
from ..arguments import PathLike
from ..errors import Error
from ..policies import SUBTASKS
from .outputs import write


@dataclasses.dataclass(frozen=True)
class Drive:
    """One log. `actions`: (steps, numbers), float32; the state of physics after them has `state_hash`."""

    path: str
    episode: str
    header: dict[str, Any]  # of an episodes file
    spec: str  # market-episode/1, as it stands in a file
    control_mode: str
    realism: str
    actions: np.ndarray
    over: bool
    state_hash: str


def read_drive(path: str) -> Drive:
    """Raises Error input.*, json.*, episode.*."""
    told = _core.read_drive(path)
    header, spec = told["episodes"].splitlines()
    numbers = np.frombuffer(told["actions"], np.float64).reshape(-1, len(told["action_names"]))
    return Drive(
        path=path,
        episode=told["episode"],
        header=json.loads(header),
        spec=spec,
        control_mode=told["control_mode"],
        realism=told["realism"],
        actions=numbers.astype(np.float32),
        over=told["over"],
        state_hash=told["state_hash"],
    )


class Drives:
    """Several logs that go into one dataset: each of another episode, all of one control mode and realism.

    Raises Error usage.bad_flag for others.
    """

    name = "teleop"

    def __init__(self, logs: Sequence[PathLike]):
        paths = [arguments.a_path("teleop", log) for log in logs]
        if not paths:
            raise Error("usage.bad_flag", "teleop", "name at least one log of a drive")
        drives = [read_drive(path) for path in paths]
        first = drives[0]
        self._by_episode: dict[str, Drive] = {}
        for drive in drives:
            for what in ("control_mode", "realism"):
                if getattr(drive, what) != getattr(first, what):
                    message = f"its {what} is {getattr(drive, what)}, that of {first.path} {getattr(first, what)}: a dataset has one"
                    raise Error("usage.bad_flag", drive.path, message)
            if drive.episode in self._by_episode:
                other = self._by_episode[drive.episode].path
                raise Error("usage.bad_flag", drive.path, f"is of the episode {drive.episode}, as {other}: name one of them")
            self._by_episode[drive.episode] = drive
        self.control_mode, self.realism = first.control_mode, first.realism

    def episodes_file(self) -> str:
        """One episodes file with the episodes of all logs, in their order."""
        drives = list(self._by_episode.values())
        header = dict(drives[0].header)
        stores: dict[str, Any] = {}
        products: dict[str, Any] = {}
        for drive in drives:
            for name in ("split", "unseen", "rows_hash"):
                if drive.header.get(name) != header.get(name):
                    raise Error("usage.bad_flag", drive.path, f"its episode was drawn with another {name} than that of {drives[0].path}")
            for store in drive.header["stores"]:
                stores.setdefault(store["scene_hash"], store)
            for product in drive.header["products"]:
                if products.setdefault(product["sku"], product) != product:
                    raise Error("usage.bad_flag", drive.path, f"its product {product['sku']} is another one than in a log before it")
        header |= {"episodes": len(drives), "stores": list(stores.values()), "products": list(products.values())}
        header.pop("drawn", None)  # of the files that they are from
        return "".join(f"{line}\n" for line in (json.dumps(header, ensure_ascii=False), *(drive.spec for drive in drives)))

    def player(self, env: Any) -> DrivePlayer:
        return DrivePlayer(self._by_episode, env)


class DrivePlayer:
    """Plays the log of the episode that runs, and then stops. Raises Error episode.not_repeated where it leads to another state."""

    def __init__(self, by_episode: dict[str, Drive], env: Any):
        self._by_episode, self._env = by_episode, env

    def begin(self, _info: dict[str, Any], _seen: Any) -> None:
        self._drive = self._by_episode[self._env.episode["id"]]
        self._played = 0

    def act(self, _seen: Any) -> np.ndarray:
        actions = self._drive.actions
        if self._played < len(actions):
            self._played += 1
            return actions[self._played - 1]
        self._check()
        return stopped(actions[-1], self._env.action_names)

    def subtask(self) -> int:
        """A person does not say what an action is for."""
        return SUBTASKS.index("none")

    def end(self) -> None:
        """The episode is over. A log that goes on behind that was not followed."""
        if self._played < len(self._drive.actions):
            raise self._error(f"it was over after {self._played} of {len(self._drive.actions)} steps")
        if self._drive.over:
            self._check()

    def _check(self) -> None:
        if self._env.state_hash() != self._drive.state_hash:
            raise self._error("its actions lead to another state of physics: it was driven with another version of marketgen")

    def _error(self, message: str) -> Error:
        return Error("episode.not_repeated", self._drive.path, message)


def stopped(action: np.ndarray, names: tuple[str, ...]) -> np.ndarray:
    """Nothing moves any more, tools hold what they hold, and the driver says that it is done."""
    holds = np.array([name.endswith("opening") for name in names])
    made = np.where(holds, action, np.float32(0))
    made[names.index("stop")] = 1
    return made


def write_episodes_file(drives: Drives, folder: str) -> str:
    """Beside the dataset, which is recorded of it and checked with it; its path. Raises Error io.cannot_write."""
    path = pathlib.Path(os.path.abspath(folder) + ".episodes.jsonl")
    write(path, drives.episodes_file().encode())
    return str(path)
