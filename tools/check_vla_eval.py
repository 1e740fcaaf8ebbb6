"""The parts of tools/check_vla_eval.

    check_vla_eval.py draw FILE              two episodes of the task of examples/imitate.py
    check_vla_eval.py wait PORT              until the server answers
    check_vla_eval.py compare FOLDER         what vla-eval wrote beside the dataset
"""

import json
import pathlib
import sys
import time
import urllib.request

WAIT_S = 60


def draw(file):
    sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "examples"))
    import imitate

    imitate.draw(pathlib.Path(file), 0, 2)


def wait(port):
    end = time.monotonic() + WAIT_S
    while True:
        try:
            with urllib.request.urlopen(f"http://127.0.0.1:{port}/health", timeout=5):
                return
        except OSError:
            if time.monotonic() > end:
                raise
            time.sleep(0.5)


def compare(folder):
    import pyarrow.parquet

    root = pathlib.Path(folder)
    rows = pyarrow.parquet.ParquetDataset(root / "dataset/meta/episodes").read().to_pylist()
    recorded = {row["episode_id"]: (row["success"], row["goal_fraction"], row["length"]) for row in rows}
    assert any(success for success, _, _ in recorded.values()), f"the oracle solved none: {recorded}"
    [file] = (root / "results").glob("*_aggregate.json")
    measured = {}
    for task in json.loads(file.read_text())["tasks"]:
        [episode] = task["episodes"]
        assert "failure_detail" not in episode, episode
        metrics = episode["metrics"]
        measured[task["task"]] = (metrics["success"], metrics["goal_fraction"], episode["steps"])
    assert measured == recorded, f"vla-eval: {measured}; recorded: {recorded}"
    print(f"vla-eval measures as recorded: {measured}")


if __name__ == "__main__":
    {"draw": draw, "wait": wait, "compare": compare}[sys.argv[1]](sys.argv[2])
