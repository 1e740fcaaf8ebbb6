"""What marketgen.ray makes over a cluster is what one process makes, also when workers and nodes die. Run by ray_test.sh, where Ray is.

MARKETGEN_BINARY is the program, PYTHONPATH has the module.
"""

import os
import pathlib
import signal
import subprocess

import pytest
from ray_support import PART, POLICY, RECORDED, SHARDS, SHORT, After, files_of, finished_in, sets_in, stop, workers, write_tasks

import marketgen
import marketgen.ray

pytestmark = pytest.mark.usefixtures("cluster")

SPECS = [{"prompt": "a kiosk with cold drinks, snacks and one checkout", "size": "6x5m", "seed": seed} for seed in range(6)]


class KillsAll(After):
    """All workers, after so many jobs."""

    def __init__(self, count):
        super().__init__(count, self._kill)
        self.killed = []

    def _kill(self):
        self.killed = workers()
        for pid in self.killed:
            os.kill(pid, signal.SIGKILL)


def test_stores_are_those_of_one_process(tmp_path):
    made = marketgen.ray.generate(SPECS, tmp_path / "stores", workers=2)
    for number, (spec, folder) in enumerate(zip(SPECS, made, strict=True)):
        marketgen.generate(folder=tmp_path / f"alone-{number}", **spec)
        assert files_of(folder) == files_of(tmp_path / f"alone-{number}")
    assert len({marketgen.open_store(folder).manifest["seed"] for folder in made}) == len(SPECS)
    assert not (tmp_path / "stores.unfinished").exists()


def test_episodes_are_those_of_the_program(tmp_path):
    marketgen.generate(folder=tmp_path / "shop", **SPECS[3])
    [file] = marketgen.ray.draw([tmp_path / "shop"], tmp_path / "tasks", count=1, seed=3)
    words = ["episodes", tmp_path / "shop", "--count", 1, "--seed", 3, "-o", tmp_path / "alone.jsonl", "--quiet"]
    subprocess.run([os.environ["MARKETGEN_BINARY"], *map(str, words)], check=True)
    assert pathlib.Path(file).read_bytes() == (tmp_path / "alone.jsonl").read_bytes()


def test_results_are_those_of_one_process(tmp_path):
    """Of episodes that are solved."""
    tasks = write_tasks(tmp_path / "tasks.jsonl", SHORT)
    scores = marketgen.ray.evaluate(tasks, POLICY, tmp_path / "results", part=1)
    alone = marketgen.evaluate(tasks, POLICY, tmp_path / "alone")
    assert len(scores.results) == len(SHORT) and any(result["hits"] for result in alone.results)
    assert files_of(tmp_path / "results") == files_of(tmp_path / "alone")


def test_a_killed_worker_loses_and_doubles_nothing(brief, brief_alone, tmp_path):
    told = KillsAll(1)
    marketgen.ray.evaluate(brief, POLICY, tmp_path / "results", part=PART, progress=told)
    assert len(told.killed) >= 1
    assert sorted(told.told) == SHARDS
    assert files_of(tmp_path / "results") == brief_alone


def test_datasets_are_those_of_one_process_also_when_a_worker_is_killed(brief, sets_alone, tmp_path):
    """Numbers, videos, statistics and README.md, to the byte."""
    told = KillsAll(1)
    made = marketgen.ray.record(brief, tmp_path / "sets", POLICY, part=PART, progress=told, **RECORDED)
    assert len(told.killed) >= 1
    assert [pathlib.Path(folder).name for folder in made] == sorted(told.told) == SHARDS
    assert all(any(name.endswith(".mp4") for name in files) for files in sets_alone.values())
    assert sets_in(tmp_path / "sets") == sets_alone
    assert not (tmp_path / "sets.unfinished").exists()


def test_a_broken_off_run_goes_on(brief, brief_alone, tmp_path):
    with pytest.raises(KeyboardInterrupt):
        marketgen.ray.evaluate(brief, POLICY, tmp_path / "results", part=PART, progress=After(1, stop))
    assert not (tmp_path / "results").exists()
    with pytest.raises(marketgen.Error, match="store.exists"):
        marketgen.ray.evaluate(brief, POLICY, tmp_path / "results", part=PART)
    kept = finished_in(tmp_path / "results")
    told = After(0, stop)
    marketgen.ray.evaluate(brief, POLICY, tmp_path / "results", part=PART, resume=True, progress=told)
    assert len(kept) >= 1 and len(told.told) == len(SHARDS) - len(kept)
    assert files_of(tmp_path / "results") == brief_alone
    assert not (tmp_path / "results.unfinished").exists()


def test_a_lost_node_loses_and_doubles_nothing(cluster, brief, brief_alone, tmp_path):
    node = list(cluster.worker_nodes)[0]
    told = After(1, lambda: cluster.remove_node(node, allow_graceful=False))
    try:
        marketgen.ray.evaluate(brief, POLICY, tmp_path / "results", part=PART, progress=told)
    finally:
        cluster.add_node(num_cpus=1)
    assert sorted(told.told) == SHARDS
    assert files_of(tmp_path / "results") == brief_alone
