"""A dataset as LeRobot reads it, beside its files as pyarrow and PyAV do; run by tools/check_lerobot in LeRobot's environment.

    python tools/check_lerobot.py DATASET
"""

import json
import pathlib
import sys

import av
import numpy as np
import pyarrow.parquet
import torch
from lerobot.datasets.lerobot_dataset import LeRobotDataset

BATCH = 16
WINDOW_S = [-0.1, 0.0, 0.05]  # of actions around a frame, as policies with a horizon ask for them


def frames_of(root, key, row, info):
    """(frames, height, width, 3): the pictures of an episode."""
    path = info["video_path"].format(video_key=key, chunk_index=row[f"videos/{key}/chunk_index"], file_index=row[f"videos/{key}/file_index"])
    with av.open(str(root / path)) as video:
        pictures = [frame.to_ndarray(format="rgb24") for frame in video.decode(video=0)]
    begin = round(row[f"videos/{key}/from_timestamp"] * info["fps"])
    return np.array(pictures[begin : begin + row["length"]])


def main():
    root = pathlib.Path(sys.argv[1])
    info = json.loads((root / "meta/info.json").read_text())
    table = pyarrow.parquet.ParquetDataset(root / "data").read()
    rows = pyarrow.parquet.ParquetDataset(root / "meta/episodes").read().to_pylist()
    tasks = pyarrow.parquet.read_table(root / "meta/tasks.parquet").to_pylist()
    task_of = {row["task_index"]: row["task"] for row in tasks}
    keys = [key for key, feature in info["features"].items() if feature["dtype"] == "video"]
    videos = {key: np.concatenate([frames_of(root, key, row, info) for row in rows]) for key in keys}
    numbers = {name: np.array(table[name].to_pylist()) for name in table.column_names}

    dataset = LeRobotDataset("marketgen/check", root=root, video_backend="pyav")
    assert (dataset.num_episodes, dataset.num_frames, dataset.fps) == (len(rows), table.num_rows, info["fps"])
    seen = 0
    for batch in torch.utils.data.DataLoader(dataset, batch_size=BATCH, num_workers=2):
        here = slice(seen, seen + len(batch["index"]))
        for name, values in numbers.items():
            assert np.array_equal(batch[name].numpy(), values[here]), (name, seen)
        for key in keys:
            shown = (batch[key].permute(0, 2, 3, 1).numpy() * 255).round().astype(int)
            assert np.abs(shown - videos[key][here]).max() <= 2, (key, seen, np.abs(shown - videos[key][here]).max())
        assert batch["task"] == [task_of[i] for i in numbers["task_index"][here]], seen
        seen += len(batch["index"])
    assert seen == table.num_rows
    stats = json.loads((root / "meta/stats.json").read_text())
    for name, told in stats.items():
        for key, value in told.items():
            assert np.allclose(dataset.meta.stats[name][key], value), (name, key)

    windows = LeRobotDataset("marketgen/check", root=root, video_backend="pyav", delta_timestamps={"action": WINDOW_S}, episodes=[len(rows) - 1])
    first = windows[0]
    last = numbers["action"][rows[-1]["dataset_from_index"] :]
    assert np.array_equal(first["action"].numpy(), last[[0, 0, 1]]) and first["action_is_pad"].tolist() == [True, False, False]
    print(f"LeRobot reads {len(rows)} episodes, {seen} frames, {len(keys)} cameras: the same numbers and pictures")


if __name__ == "__main__":
    main()
