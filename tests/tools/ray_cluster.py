"""What marketgen.ray makes over a cluster is what one process makes, also when workers and nodes die. Run by ray_test.sh, where Ray is.

MARKETGEN_BINARY is the program, PYTHONPATH has the module.
"""

import json
import os
import pathlib
import signal
import subprocess

import pytest
import ray
from ray.cluster_utils import Cluster

import marketgen
import marketgen.ray
from marketgen.scaling.crew import SCRATCH

SPECS = [{"prompt": "a kiosk with cold drinks, snacks and one checkout", "size": "6x5m", "seed": seed} for seed in range(6)]
SHORT = (0, 2, 3, 7)  # episodes of the pool that the policy ends within seconds
EPISODES, PART, POLICY = len(SHORT), 1, "oracle-plain"


@pytest.fixture(scope="module", autouse=True)
def cluster():
    """One head without cores, and two nodes that have one each."""
    cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 0, "include_dashboard": False})
    cluster.add_node(num_cpus=1)
    cluster.add_node(num_cpus=1)
    ray.init(address=cluster.address, log_to_driver=False)
    cluster.wait_for_nodes()
    yield cluster
    ray.shutdown()
    cluster.shutdown()


@pytest.fixture(scope="module")
def tasks(tmp_path_factory):
    """Some episodes of the pool."""
    file = tmp_path_factory.mktemp("tasks") / "tasks.jsonl"
    header, *rows = pathlib.Path(marketgen._core.find_episode_file("pool/checkout")).read_text().splitlines()
    file.write_text("\n".join([json.dumps(json.loads(header) | {"episodes": EPISODES}), *(rows[number] for number in SHORT)]) + "\n")
    return file


@pytest.fixture(scope="module")
def alone(tasks, tmp_path_factory):
    """Of one process."""
    folder = tmp_path_factory.mktemp("alone") / "results"
    marketgen.evaluate(tasks, POLICY, folder)
    assert any(result["hits"] for result in marketgen.evaluation.evaluation_in(str(folder)).results)
    return files_of(folder)


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


def workers():
    """Process ids of actors: each has a scratch folder that is called so."""
    found = (int(folder.name.removeprefix(SCRATCH).partition("-")[0]) for folder in pathlib.Path("/tmp").glob(f"{SCRATCH}*"))
    return [pid for pid in found if pathlib.Path("/proc", str(pid)).exists()]


class After:
    """Progress that does something once, after so many jobs."""

    def __init__(self, count, does):
        self.count, self.does, self.told = count, does, []

    def __call__(self, done, total, text):
        self.told.append(text)
        if done == self.count:
            self.does()


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


def test_results_are_those_of_one_process(tasks, alone, tmp_path):
    scores = marketgen.ray.evaluate(tasks, POLICY, tmp_path / "results", part=PART)
    assert len(scores.results) == EPISODES
    assert files_of(tmp_path / "results") == alone


def test_a_killed_worker_loses_and_doubles_nothing(tasks, alone, tmp_path):
    killed = []

    def kill_all():
        killed.extend(workers())
        for pid in killed:
            os.kill(pid, signal.SIGKILL)

    told = After(1, kill_all)
    marketgen.ray.evaluate(tasks, POLICY, tmp_path / "results", part=PART, progress=told)
    assert len(killed) >= 1
    assert sorted(told.told) == [f"shard-{number:05}" for number in range(EPISODES // PART)]
    assert files_of(tmp_path / "results") == alone


def test_a_broken_off_run_goes_on(tasks, alone, tmp_path):
    def stop():
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        marketgen.ray.evaluate(tasks, POLICY, tmp_path / "results", part=PART, progress=After(1, stop))
    assert not (tmp_path / "results").exists()
    with pytest.raises(marketgen.Error, match="store.exists"):
        marketgen.ray.evaluate(tasks, POLICY, tmp_path / "results", part=PART)
    told = After(0, stop)
    marketgen.ray.evaluate(tasks, POLICY, tmp_path / "results", part=PART, resume=True, progress=told)
    assert len(told.told) <= EPISODES // PART - 1
    assert files_of(tmp_path / "results") == alone
    assert not (tmp_path / "results.unfinished").exists()


def test_what_cannot_be_done_is_an_error_of_its_own(tasks, tmp_path):
    with pytest.raises(marketgen.Error) as caught:
        marketgen.ray.evaluate(tasks, "classicl", tmp_path / "results", part=PART)
    assert caught.value.code.startswith(("usage.", "policy."))
    with pytest.raises(marketgen.Error, match="did you mean 'realism'"):
        marketgen.ray.evaluate(tasks, POLICY, tmp_path / "other", realsm="ideal")
    with pytest.raises(marketgen.Error, match="did you mean 'seed'"):
        marketgen.ray.generate([{"sed": 1}], tmp_path / "stores")


def test_a_lost_node_loses_and_doubles_nothing(cluster, tasks, alone, tmp_path):
    """Last: the cluster has one node less then."""
    node = list(cluster.worker_nodes)[0]
    told = After(1, lambda: cluster.remove_node(node, allow_graceful=False))
    marketgen.ray.evaluate(tasks, POLICY, tmp_path / "results", part=PART, progress=told)
    assert sorted(told.told) == [f"shard-{number:05}" for number in range(EPISODES // PART)]
    assert files_of(tmp_path / "results") == alone
