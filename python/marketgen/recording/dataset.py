"""A LeRobot dataset v3.0 of recorded episodes.

    meta/info.json, stats.json, tasks.parquet, subtasks.parquet, episodes/chunk-000/file-000.parquet
    data/chunk-000/file-000.parquet              the numbers of many episodes, a row group each
    videos/observation.images.CAMERA/chunk-000/file-000.mp4

as https://github.com/huggingface/lerobot reads it (src/lerobot/datasets). It is made beside and renamed when it is whole.
"""

from __future__ import annotations

import dataclasses
import json
import pathlib
import shutil
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..policies import SUBTASKS
from .acting import FPS
from .features import EPISODE, INDEX, PICTURES, PLACED, SUBTASK, TASK, Numbers, described
from .outputs import on_disk, write_json, writing
from .parts import Part, array_of, column_of
from .statistics import PictureCounts, Statistics, of_numbers
from .video import about_video, join

if TYPE_CHECKING:
    import pyarrow

VERSION = "v3.0"
CHUNK_FILES, DATA_MB, VIDEO_MB = 1000, 100, 200  # LeRobot's own: files of a folder; sizes at which the next file is begun
MEGABYTE = 2**20
DATA_PATH = "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"
VIDEO_PATH = "videos/{video_key}/chunk-{chunk_index:03d}/file-{file_index:03d}.mp4"
EPISODES_PATH = "meta/episodes/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"
SETTINGS_PATH = "meta/marketgen.json"  # ours: what was recorded, and how
ROWS_AT_ONCE = 100  # of episodes, in a row group


@dataclasses.dataclass(frozen=True)
class About:
    """What all episodes of a dataset share."""

    robot: str
    kinds: dict[str, Numbers]
    cameras: tuple[str, ...]
    codec: str
    size: tuple[int, int]


@dataclasses.dataclass(frozen=True)
class FileNumber:
    """Which file of a kind: chunk-000/file-000, then file-001."""

    chunk: int = 0
    file: int = 0

    def next(self) -> FileNumber:
        return FileNumber(self.chunk + 1, 0) if self.file == CHUNK_FILES - 1 else FileNumber(self.chunk, self.file + 1)

    def path(self, root: pathlib.Path, template: str, **names: str) -> pathlib.Path:
        return root / template.format(chunk_index=self.chunk, file_index=self.file, **names)

    def told(self, prefix: str) -> dict[str, int]:
        return {f"{prefix}/chunk_index": self.chunk, f"{prefix}/file_index": self.file}


class Tables:
    """Tables, one after another, in as few parquet files as their size allows."""

    def __init__(self, root: pathlib.Path, template: str, max_bytes: int):
        self._root, self._template, self._max_bytes = root, template, max_bytes
        self.number, self._writer, self._sink = FileNumber(), None, None

    def room_for(self, size: int) -> FileNumber:
        """The file in which a table of so many bytes will stand: another when this one is full."""
        if self._sink is not None and self._sink.tell() + size > self._max_bytes:
            with writing(self.number.path(self._root, self._template)):
                self.close()
            self.number = self.number.next()
        return self.number

    def add(self, table: pyarrow.Table) -> None:
        """A row group of that file."""
        import pyarrow.parquet

        path = self.number.path(self._root, self._template)
        with writing(path):
            if self._writer is None:
                path.parent.mkdir(parents=True, exist_ok=True)
                self._sink = path.open("wb")
                self._writer = pyarrow.parquet.ParquetWriter(self._sink, table.schema, compression="snappy")
            self._writer.write_table(table)

    def close(self) -> None:
        if self._writer is not None:
            self._writer.close()
            self._sink.close()
        self._writer = self._sink = None


def write_dataset(
    folder: pathlib.Path,
    parts: Sequence[Part],
    about: About,
    also: dict[str, Any],
    finish: Callable[[pathlib.Path], None],
) -> None:
    """`parts`: in their order, all of them kept. `also`: what settings_in() will find. `finish`: adds what else is to be in the folder.

    Raises Error io.cannot_write.
    """
    beside = folder.with_name(f".{folder.name}~part")
    with writing(beside):
        shutil.rmtree(beside, ignore_errors=True)
        beside.mkdir(parents=True)
    try:
        _fill(beside, parts, about, also)
        finish(beside)
        with writing(folder):
            for entry in sorted(beside.rglob("*"), reverse=True):
                on_disk(entry)
            if folder.is_dir():
                folder.rmdir()  # an empty one
            beside.replace(folder)
            on_disk(folder.parent)
    finally:
        shutil.rmtree(beside, ignore_errors=True)


def settings_in(folder: pathlib.Path) -> dict[str, Any] | None:
    """What the dataset there was recorded with; None where no dataset of ours is."""
    try:
        return json.loads((folder / SETTINGS_PATH).read_text(encoding="utf-8"))
    except (FileNotFoundError, NotADirectoryError):
        return None


def counted_in(folder: pathlib.Path) -> tuple[int, int, int]:
    """Episodes of that dataset, how many of them reached all goals, frames."""
    import pyarrow.parquet

    rows = pyarrow.parquet.ParquetDataset(folder / "meta/episodes").read(["success", "length"]).to_pydict()
    return len(rows["success"]), sum(rows["success"]), sum(rows["length"])


def _fill(root: pathlib.Path, parts: Sequence[Part], about: About, also: dict[str, Any]) -> None:
    tasks = list(dict.fromkeys(part.told["task"] for part in parts))
    rows: list[dict[str, Any]] = [_row_of(number, part) for number, part in enumerate(parts)]
    _write_data(root, parts, rows, about, tasks)
    videos = {camera: _write_videos(root, parts, rows, about, camera) for camera in about.cameras}
    _write_episodes(root, rows)
    _write_names(root / "meta/tasks.parquet", TASK, tasks)
    _write_names(root / "meta/subtasks.parquet", SUBTASK, SUBTASKS)
    write_json(root / "meta/stats.json", _listed(_statistics(root, parts, about)))
    frames = sum(part.told["frames"] for part in parts)
    info = {
        "codebase_version": VERSION,
        "robot_type": about.robot,
        "total_episodes": len(parts),
        "total_frames": frames,
        "total_tasks": len(tasks),
        "chunks_size": CHUNK_FILES,
        "data_files_size_in_mb": DATA_MB,
        "video_files_size_in_mb": VIDEO_MB,
        "fps": FPS,
        "splits": {"train": f"0:{len(parts)}"},
        "data_path": DATA_PATH,
        "video_path": VIDEO_PATH if about.cameras else None,
        "features": described({**about.kinds, **PLACED}, videos, about.size),
    }
    write_json(root / "meta/info.json", info)
    write_json(root / SETTINGS_PATH, also)


def _row_of(number: int, part: Part) -> dict[str, Any]:
    told = part.told
    return {
        "episode_index": number,
        "tasks": [told["task"]],
        "length": told["frames"],
        "episode_id": told["id"],
        "seed": told["seed"],
        "success": told["success"],
        "goal_fraction": told["goal_fraction"],
        "failure": told["failure"],
        "state_hash": told["state_hash"],
    }


def _write_data(
    root: pathlib.Path, parts: Sequence[Part], rows: list[dict[str, Any]], about: About, tasks: list[str]
) -> None:
    files, begin = Tables(root, DATA_PATH, DATA_MB * MEGABYTE), 0
    number_of = {task: number for number, task in enumerate(tasks)}
    for number, (part, row) in enumerate(zip(parts, rows, strict=True)):
        frames = part.told["frames"]
        placed = {
            EPISODE: np.full(frames, number),
            INDEX: np.arange(begin, begin + frames),
            TASK: np.full(frames, number_of[part.told["task"]]),
        }
        table = part.numbers()
        for name, values in placed.items():
            table = table.append_column(name, column_of(values, PLACED[name]))
        row |= files.room_for(table.nbytes).told("data")
        row |= {"dataset_from_index": begin, "dataset_to_index": begin + frames}
        row |= {f"stats/{name}": of_numbers(array_of(table[name])) for name in table.column_names}
        files.add(table)
        begin += frames
    files.close()


def _write_videos(
    root: pathlib.Path, parts: Sequence[Part], rows: list[dict[str, Any]], about: About, camera: str
) -> dict[str, Any]:
    """What info.json says of them."""
    key, number = PICTURES + camera, FileNumber()
    for together in _that_fit(parts, camera):
        path = number.path(root, VIDEO_PATH, video_key=key)
        join([part.video(camera) for part, _ in together], path, FPS)
        begin = 0
        for part, i in together:
            end = begin + part.told["frames"]
            rows[i] |= number.told(f"videos/{key}")
            rows[i] |= {f"videos/{key}/from_timestamp": begin / FPS, f"videos/{key}/to_timestamp": end / FPS}
            rows[i][f"stats/{key}"] = part.counts(camera).statistics()
            begin = end
        number = number.next()
    return about_video(about.codec, about.size, FPS)


def _that_fit(parts: Sequence[Part], camera: str) -> Iterator[list[tuple[Part, int]]]:
    """Those whose videos go into one file, with their numbers."""
    together: list[tuple[Part, int]] = []
    size = 0
    for i, part in enumerate(parts):
        more = part.video(camera).stat().st_size
        if together and size + more > VIDEO_MB * MEGABYTE:
            yield together
            together, size = [], 0
        together.append((part, i))
        size += more
    yield together


def _write_episodes(root: pathlib.Path, rows: list[dict[str, Any]]) -> None:
    """Statistics are columns of their own, "stats/FEATURE/mean"; each row says in which file it stands."""
    import pyarrow

    files = Tables(root, EPISODES_PATH, DATA_MB * MEGABYTE)
    for begin in range(0, len(rows), ROWS_AT_ONCE):
        some = [_flat(row) for row in rows[begin : begin + ROWS_AT_ONCE]]
        table = pyarrow.table({name: _column([row[name] for row in some], name) for name in some[0]})
        for name, value in files.room_for(table.nbytes).told("meta/episodes").items():
            table = table.append_column(name, pyarrow.array([value] * len(some)))
        files.add(table)
    files.close()


def _column(values: list[Any], name: str) -> pyarrow.Array:
    import pyarrow

    return pyarrow.array(values, pyarrow.uint64() if name == "seed" else None)


def _flat(row: dict[str, Any]) -> dict[str, Any]:
    made: dict[str, Any] = {}
    for name, value in row.items():
        made |= {f"{name}/{key}": one.tolist() for key, one in value.items()} if isinstance(value, dict) else {name: value}
    return made


def _write_names(path: pathlib.Path, number: str, names: Sequence[str]) -> None:
    """What the rows of the feature `number` ("task_index") mean, as pandas reads it: the names ("task") are the index."""
    import pyarrow
    import pyarrow.parquet

    name = number.removesuffix("_index")
    table = pyarrow.table({number: np.arange(len(names)), name: list(names)})
    columns = [
        {"name": number, "field_name": number, "pandas_type": "int64", "numpy_type": "int64", "metadata": None},
        {"name": name, "field_name": name, "pandas_type": "unicode", "numpy_type": "object", "metadata": None},
    ]
    pandas = {"index_columns": [name], "column_indexes": [], "columns": columns}
    with writing(path):
        pyarrow.parquet.write_table(table.replace_schema_metadata({"pandas": json.dumps(pandas)}), path)


def _statistics(root: pathlib.Path, parts: Sequence[Part], about: About) -> dict[str, Statistics]:
    """Over all frames, not over the episodes' own."""
    import pyarrow.parquet

    data = pyarrow.parquet.ParquetDataset(root / "data")
    made = {name: of_numbers(array_of(data.read([name])[name])) for name in (*about.kinds, *PLACED)}
    for camera in about.cameras:
        counts = PictureCounts()
        for part in parts:
            counts.add_all(part.counts(camera))
        made[PICTURES + camera] = counts.statistics()
    return made


def _listed(statistics: dict[str, Statistics]) -> dict[str, dict[str, list]]:
    return {name: {key: value.tolist() for key, value in one.items()} for name, one in statistics.items()}
