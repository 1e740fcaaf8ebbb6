"""What was recorded so far: DATASET.unfinished, a folder for each episode that is done.

Each appears whole, by a rename, when its episode is over; so whenever the process is killed, all finished episodes are there, and
going on records the others. A dataset is made of them at the end.
"""

from __future__ import annotations

import dataclasses
import json
import os
import pathlib
import shutil
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import Error
from .acting import Take
from .outputs import on_disk, write, write_json, writing
from .statistics import PictureCounts

if TYPE_CHECKING:
    import pyarrow

    from .features import Numbers

SETTINGS = "recording.json"


@dataclasses.dataclass(frozen=True)
class Part:
    """One episode of those that were acted out.

    folder   has numbers.parquet and CAMERA.mp4, when it was kept
    told     id, seed, kept, task, frames, success, goal_fraction, failure, state_hash, pictures; of one that could not be run
             id, seed, kept and error
    """

    folder: pathlib.Path
    told: dict[str, Any]

    @property
    def kept(self) -> bool:
        return self.told["kept"]

    def numbers(self, columns: list[str] | None = None) -> pyarrow.Table:
        import pyarrow.parquet

        return pyarrow.parquet.read_table(self.folder / "numbers.parquet", columns=columns)

    def values(self, name: str) -> np.ndarray:
        """(frames,) or (frames, numbers)."""
        [column] = self.numbers([name]).columns
        return array_of(column)

    def video(self, camera: str) -> pathlib.Path:
        return self.folder / f"{camera}.mp4"

    def counts(self, camera: str) -> PictureCounts:
        return PictureCounts.from_json(self.told["pictures"][camera])


def array_of(column: pyarrow.ChunkedArray) -> np.ndarray:
    """(rows,), or (rows, numbers) of a column of lists that are all as long."""
    import pyarrow

    if not pyarrow.types.is_fixed_size_list(column.type):
        return column.to_numpy()
    return np.concatenate([chunk.flatten().to_numpy() for chunk in column.chunks]).reshape(len(column), column.type.list_size)


def column_of(rows: np.ndarray, kind: Numbers) -> pyarrow.Array:
    import pyarrow

    one = pyarrow.from_numpy_dtype(np.dtype(kind.dtype))
    flat = pyarrow.array(rows.reshape(-1), one)
    return flat if kind.names is None else pyarrow.FixedSizeListArray.from_arrays(flat, len(kind.names))


class Unfinished:
    """The folder. `settings`: what was asked for, as JSON has it; going on with other settings is refused."""

    def __init__(self, folder: pathlib.Path, settings: dict[str, Any], *, resume: bool):
        self.folder = folder
        there = folder / SETTINGS
        if there.exists():
            if not resume:
                message = "a recording was broken off there: go on with resume=True (--resume), or remove it"
                raise Error("store.exists", str(folder), message)
            self._compare(json.loads(there.read_text(encoding="utf-8")), settings)
        else:
            write_json(there, settings)
        for part in folder.glob(".*~part"):
            shutil.rmtree(part) if part.is_dir() else part.unlink()

    def _compare(self, before: dict[str, Any], now: dict[str, Any]) -> None:
        for name, value in now.items():
            if before.get(name) != value:
                raise Error(
                    "usage.bad_flag",
                    name,
                    f"{value!r}: the recording that was broken off in {self.folder} has {before.get(name)!r}; go on with that, "
                    "or remove the folder",
                )

    def _place(self, number: int) -> pathlib.Path:
        return self.folder / f"{number:06}"

    def part(self, number: int) -> Part | None:
        """What is there of an episode, by its number in the file."""
        place = self._place(number)
        try:
            return Part(place, json.loads((place / "episode.json").read_text(encoding="utf-8")))
        except FileNotFoundError:
            return None

    def keep(self, number: int, told: dict[str, Any], take: Take | None, kinds: dict[str, Numbers]) -> Part:
        """`take`: None of what is not to be in the dataset."""
        place = self._place(number)
        beside = place.with_name(f".{place.name}~part")
        with writing(beside):
            beside.mkdir()
        if take is not None:
            self._write_take(beside, take, kinds)
        write_json(beside / "episode.json", told)
        with writing(place):
            on_disk(beside)
            beside.replace(place)
            on_disk(self.folder)
        return Part(place, told)

    def _write_take(self, into: pathlib.Path, take: Take, kinds: dict[str, Numbers]) -> None:
        import pyarrow
        import pyarrow.parquet

        table = pyarrow.table({name: column_of(rows, kinds[name]) for name, rows in take.numbers.items()})
        sink = pyarrow.BufferOutputStream()
        pyarrow.parquet.write_table(table, sink)
        write(into / "numbers.parquet", sink.getvalue().to_pybytes())
        for camera, video in take.videos.items():
            write(into / f"{camera}.mp4", video)

    def remove(self) -> None:
        shutil.rmtree(self.folder)

    def remove_if_empty(self) -> None:
        """When not one episode was finished."""
        if {entry.name for entry in os.scandir(self.folder)} <= {SETTINGS, ".lock"}:
            self.remove()
