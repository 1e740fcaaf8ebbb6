"""The actions of a dataset lead to its states again: bit for bit, as its files have them (float32), and to the same physics at the
end (float64, by its hash)."""

from __future__ import annotations

import json
import pathlib
from typing import Any

import numpy as np

from .. import arguments
from ..arguments import PathLike, Progress
from ..errors import Error
from .dataset import DATA_PATH, SETTINGS_PATH, settings_in
from .features import ACTION, DONE, REWARD, STATE
from .parts import array_of
from .recorder import check_installed, contents_hash, told_realism


def replay_check(
    dataset: PathLike, episodes: PathLike, *, realism: PathLike | None = None, progress: Progress | None = None
) -> int:
    """Executes the actions of each episode of a dataset of record() and compares what the robot reads, rewards, the end and the
    state of physics then. Returns how many frames were the same.

    dataset   the folder
    episodes  the file that it was recorded of
    realism   the file, where the dataset was recorded with one

    Raises Error episode.not_repeated at the first that differs; usage.bad_flag for other episodes or another realism.
    """
    check_installed()
    import pyarrow.parquet

    root = pathlib.Path(arguments.a_path("dataset", dataset))
    path, told = arguments.episodes_path("episodes", episodes), arguments.a_progress(progress)
    settings = _settings(root, path)
    env = _environment(path, settings, settings["realism"] if realism is None else arguments.a_path("realism", realism))
    rows = pyarrow.parquet.ParquetDataset(root / "meta/episodes").read()
    by_id = {json.loads(text)["id"]: text for text in env.setup.episodes}
    frames = 0
    for number, row in enumerate(rows.select(_COLUMNS).to_pylist()):
        if told is not None:
            told(number, rows.num_rows, row["episode_id"])
        frames += _replay(env, by_id[row["episode_id"]], row, _frames_of(root, row))
    return frames


_COLUMNS = ["episode_id", "episode_index", "length", "state_hash", "data/chunk_index", "data/file_index"]


def _settings(root: pathlib.Path, path: str) -> dict[str, Any]:
    settings = settings_in(root)
    if settings is None:
        raise Error("input.not_found", str(root / SETTINGS_PATH), "it is not there: expected a dataset of marketgen.record()")
    if settings["episodes_sha256"] != contents_hash(path):
        raise Error("usage.bad_flag", "episodes", f"{path} is not what the dataset was recorded of: {settings['episodes']}")
    return settings


def _environment(path: str, settings: dict[str, Any], realism: str) -> Any:
    from ..stages import Stages

    if told_realism(realism) != settings["realism"]:
        raise Error("usage.bad_flag", "realism", f"{realism!r}: the dataset was recorded with {settings['realism']}")
    options = {"control_mode": settings["control_mode"], "tools": settings["tools"], "realism": realism, "obs_mode": "state_robot"}
    return Stages(path, options).environment(settings["track"], settings["station"])


def _frames_of(root: pathlib.Path, row: dict[str, Any]) -> dict[str, np.ndarray]:
    import pyarrow.parquet

    path = root / DATA_PATH.format(chunk_index=row["data/chunk_index"], file_index=row["data/file_index"])
    index = row["episode_index"]
    table = pyarrow.parquet.read_table(path, columns=[ACTION, STATE, REWARD, DONE], filters=[("episode_index", "=", index)])
    return {name: array_of(table[name]) for name in table.column_names}


def _replay(env: Any, episode: str, row: dict[str, Any], frames: dict[str, np.ndarray]) -> int:
    def check(same: bool, frame: int, what: str) -> None:
        if not same:
            raise Error("episode.not_repeated", f"{row['episode_id']}, frame {frame}", f"{what} is not as the dataset has it")

    env.reset(seed=0, options={"episode": episode})
    for frame, action in enumerate(frames[ACTION]):
        check(env.robot_numbers().tobytes() == frames[STATE][frame].tobytes(), frame, STATE)
        _, reward, terminated, truncated, _ = env.step(action)
        check(np.float32(reward) == frames[REWARD][frame], frame, REWARD)
        check((terminated or truncated) == frames[DONE][frame], frame, DONE)
    check(env.state_hash() == row["state_hash"], row["length"], "the state of physics")
    return len(frames[ACTION])
