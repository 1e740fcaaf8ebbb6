"""What the tests of clusters share: comparing folders, finding processes, and breaking runs off."""

import json
import os
import pathlib
import time

import marketgen
from marketgen.scaling.crew import SCRATCH

POLICY = "oracle-plain"
SHORT = (0, 2, 3, 7)  # episodes of the pool that the policy ends within seconds
BRIEF, BRIEF_S, PART = 8, 2.0, 2  # others, of which only the first two seconds are acted out
SHARDS = [f"shard-{number:05}" for number in range(BRIEF // PART)]
RECORDED = {"cameras": ["wrist_camera"], "size": (64, 48)}
MARK = "MARKETGEN_RAY_TEST"  # of the environment: processes that a test has begun, whoever begot them


def write_tasks(file, numbers, **changed):
    """These episodes of the pool."""
    header, *rows = pathlib.Path(marketgen._core.find_episode_file("pool/checkout")).read_text().splitlines()
    lines = [json.loads(header) | {"episodes": len(numbers)}, *(json.loads(rows[number]) | changed for number in numbers)]
    file.write_text("".join(json.dumps(line) + "\n" for line in lines))
    return file


def files_of(folder):
    """Every file's bytes, but for times and memory."""
    return {str(file.relative_to(folder)): without_wall(file) for file in sorted(pathlib.Path(folder).rglob("*")) if file.is_file()}


def without_wall(file):
    if file.name == "results.jsonl":
        return [json.dumps({key: value for key, value in json.loads(row).items() if key != "wall_s"}) for row in file.read_text().splitlines()]
    if file.name == "summary.json":
        return {key: value for key, value in json.loads(file.read_text()).items() if "wall" not in key}
    if file.name == "report.json":
        report = json.loads(file.read_text())
        return {key: value for key, value in report.items() if key not in ("timing_s", "peak_rss_mb")}
    return file.read_bytes()


def sets_in(folder):
    """The files of each dataset of marketgen.ray.record()."""
    return {place.name: files_of(place) for place in sorted(pathlib.Path(folder).iterdir()) if place.is_dir()}


def finished_in(folder):
    """Keys of the jobs that a run which was broken off has done."""
    unfinished = pathlib.Path(f"{folder}.unfinished")
    return {place.name for place in unfinished.iterdir() if not place.name.startswith(".")} if unfinished.exists() else set()


def workers():
    """Process ids of this test's actors that have had a job: each has a scratch folder that is called so."""
    ours = marked(os.environ[MARK])
    found = (int(folder.name.removeprefix(SCRATCH).partition("-")[0]) for folder in pathlib.Path("/tmp").glob(f"{SCRATCH}*"))
    return [pid for pid in found if pid in ours]


def marked(mark, word=""):
    """Command lines of the processes with this mark that have `word` in them, by process id; this one is none of them."""
    found = {}
    for place in pathlib.Path("/proc").iterdir():
        if not place.name.isdecimal() or int(place.name) == os.getpid():
            continue
        try:
            if f"{MARK}={mark}".encode() in (place / "environ").read_bytes().split(b"\0"):
                words = (place / "cmdline").read_bytes().replace(b"\0", b" ").decode()
                found |= {int(place.name): words} if words and word in words else {}  # without words: ended, not yet waited for
        except OSError:  # it has ended meanwhile
            continue
    return found


def until(is_so, limit_s):
    """Whether it became so within that time."""
    end = time.monotonic() + limit_s
    while not is_so():
        if time.monotonic() > end:
            return False
        time.sleep(0.2)
    return True


class After:
    """Progress that does something once, after so many jobs."""

    def __init__(self, count, does):
        self.count, self.does, self.told = count, does, []

    def __call__(self, done, total, text):
        self.told.append(text)
        if done == self.count:
            self.does()


def stop():
    raise KeyboardInterrupt
