"""What can be wrong with a cluster: each fault is an Error that names the place and what mends it, or a recorded failure, and nothing that
was finished is lost. Run by ray_test.sh."""

import contextlib
import json
import subprocess

import pytest
from ray_support import BRIEF, PART, POLICY, RECORDED, After, files_of, finished_in, stop

import marketgen
import marketgen.ray
from marketgen.scaling.crew import Terms, Worker
from marketgen.scaling.jobs import Job

pytestmark = pytest.mark.usefixtures("cluster")

KIOSK = {"prompt": "a kiosk with cold drinks, snacks and one checkout", "size": "6x5m"}
ON_THE_NODE = {"cpus": 2, "workers": 1}  # jobs of two cores are done by node_with() alone
FAULTY = """
import os
import time
import numpy
class Faulty:
    def begin(self, task, observation):
        if task["instruction"] == {words!r}:
            {fault}
        self.count = len(task["action_names"])
    def act(self, observation):
        return numpy.full(self.count, 1.0)
"""


@contextlib.contextmanager
def node_with(cluster, **environment):
    """A node of two cores with this environment."""
    node = cluster.add_node(num_cpus=2, env_vars={name: str(value) for name, value in environment.items()})
    cluster.wait_for_nodes()
    try:
        yield
    finally:
        cluster.remove_node(node)


@pytest.fixture
def small_disk(tmp_path):
    """What makes a folder on a disk of so many kB, and one that makes it larger."""
    folder = tmp_path / "disk"
    folder.mkdir()

    def of(size_kb, *more):
        options = ",".join([*more, f"size={size_kb}k"])
        return subprocess.run(["mount", "-t", "tmpfs", "-o", options, "none", folder], capture_output=True).returncode == 0

    if not of(4):
        pytest.skip("disks cannot be mounted here")
    yield folder, lambda size_kb: of(size_kb, "remount")
    subprocess.run(["umount", "--lazy", folder], check=True)


def faulty(brief, folder, fault):
    """A policy that says at once that it has done, but does this at the second episode."""
    words = [json.loads(line)["instruction"] for line in brief.read_text().splitlines()[1:]]
    assert words.count(words[1]) == 1
    (folder / "faulty.py").write_text(FAULTY.format(words=words[1], fault=fault))
    return f"{folder / 'faulty.py'}:Faulty"


def failed(call, *words, **options):
    with pytest.raises(marketgen.Error) as caught:
        call(*words, **options)
    return caught.value


def test_what_cannot_be_done_is_an_error_of_its_own(brief, tmp_path):
    fault = failed(marketgen.ray.evaluate, brief, "classicl", tmp_path / "results", part=PART)
    assert fault.code.startswith(("usage.", "policy.")) and "(shard-0" in fault.message
    assert not (tmp_path / "results.unfinished").exists()  # where nothing is finished there is nothing to go on with
    assert "did you mean 'realism'" in str(failed(marketgen.ray.evaluate, brief, POLICY, tmp_path / "other", realsm="ideal"))
    assert "did you mean 'seed'" in str(failed(marketgen.ray.generate, [{"sed": 1}], tmp_path / "stores"))
    fault = failed(marketgen.ray.generate, [KIOSK | {"size": "0x0m"}], tmp_path / "stores")
    assert "(store-00000, on " in fault.message


def test_workers_that_fit_no_node_are_refused(brief, tmp_path):
    fault = failed(marketgen.ray.evaluate, brief, POLICY, tmp_path / "results", cpus=500)
    assert (fault.code, fault.where) == ("usage.bad_flag", "cpus") and "largest node" in fault.message
    assert not (tmp_path / "results.unfinished").exists()


def test_a_node_without_the_data_is_said(cluster, brief, tmp_path):
    with node_with(cluster, MARKETGEN_DATA=tmp_path / "nowhere"):
        for call, words in ((marketgen.ray.generate, [[KIOSK], tmp_path / "a"]), (marketgen.ray.evaluate, [brief, POLICY, tmp_path / "b"]), (marketgen.ray.record, [brief, tmp_path / "c", POLICY])):
            fault = failed(call, *words, **ON_THE_NODE)
            assert str(tmp_path / "nowhere") in str(fault) and "MARKETGEN_DATA" in fault.message and "00000, on " in fault.message


def test_a_node_without_a_cache_makes_the_same(cluster, tmp_path):
    """Not even one that could be written."""
    marketgen.generate(folder=tmp_path / "alone", **KIOSK)
    with node_with(cluster, MARKETGEN_CACHE="/proc/nowhere"):
        [made] = marketgen.ray.generate([KIOSK], tmp_path / "stores", **ON_THE_NODE)
    assert files_of(made) == files_of(tmp_path / "alone")


def test_a_node_with_another_marketgen_is_said(cluster, brief, tmp_path):
    _, fault = Worker().do(Job("draw", "store-00007", {}), Terms(cpus=1, version="0.0.1"), None)
    assert fault[0] == "usage.unavailable" and "0.0.1" in fault[2] and marketgen._core.__version__ in fault[2]
    (tmp_path / "marketgen").mkdir()
    (tmp_path / "marketgen" / "__init__.py").write_text("raise ImportError('broken')")
    with node_with(cluster, PYTHONPATH=tmp_path):
        fault = failed(marketgen.ray.evaluate, brief, POLICY, tmp_path / "results", **ON_THE_NODE)
    assert fault.code == "usage.unavailable" and "install" in fault.message


def test_a_worker_whose_disk_is_full_loses_nothing_that_is_finished(cluster, brief, brief_alone, tmp_path, small_disk):
    into = tmp_path / "results"
    with pytest.raises(KeyboardInterrupt):
        marketgen.ray.evaluate(brief, POLICY, into, part=PART, progress=After(1, stop))
    kept = finished_in(into)
    with node_with(cluster, TMPDIR=small_disk[0]):
        fault = failed(marketgen.ray.evaluate, brief, POLICY, into, part=PART, resume=True, **ON_THE_NODE)
        assert fault.code == "io.cannot_write" and str(small_disk[0]) in fault.where and "No space left" in fault.message and "on " in fault.message
        assert kept and finished_in(into) == kept
    marketgen.ray.evaluate(brief, POLICY, into, part=PART, resume=True)
    assert files_of(into) == brief_alone


def test_a_full_disk_of_the_caller_loses_nothing_that_is_finished(brief, brief_alone, small_disk):
    folder, grow = small_disk
    fault = failed(marketgen.ray.evaluate, brief, POLICY, folder / "results", part=PART)
    assert fault.code == "io.cannot_write" and str(folder) in fault.where and "No space left" in fault.message
    assert grow(1 << 14)
    marketgen.ray.evaluate(brief, POLICY, folder / "results", part=PART, resume=True)
    assert files_of(folder / "results") == brief_alone


def test_a_policy_that_hangs_is_a_recorded_failure(brief, tmp_path):
    policy = faulty(brief, tmp_path, "time.sleep(1000)")
    scores = marketgen.ray.evaluate(brief, policy, tmp_path / "results", part=4, hang_limit_s=10)
    alone = marketgen.evaluate(brief, policy, tmp_path / "alone", hang_limit_s=10)
    assert [result["failure"] for result in scores.results].count("PolicyError") == 1
    assert "episode.policy_hung" in scores.results[1]["detail"]
    assert len(alone.results) == BRIEF and files_of(tmp_path / "results") == files_of(tmp_path / "alone")


def test_a_policy_that_hangs_ends_a_recording_and_what_is_finished_is_kept(brief, tmp_path):
    policy = faulty(brief, tmp_path, "time.sleep(1000)")
    fault = failed(marketgen.ray.record, brief, tmp_path / "sets", policy, part=1, workers=1, episode_limit_s=20, **RECORDED)
    assert fault.code == "episode.policy_hung" and "20 s" in fault.message and "(shard-00001, on " in fault.message
    assert len(finished_in(tmp_path / "sets")) == 1




def test_a_job_that_kills_its_workers_is_named_and_what_is_finished_is_kept(brief, tmp_path):
    """As memory that is too little does."""
    policy = faulty(brief, tmp_path, "os._exit(3)")
    fault = failed(marketgen.ray.record, brief, tmp_path / "sets", policy, part=1, workers=1, **RECORDED)
    assert (fault.code, fault.where) == ("program.failed", "shard-00001") and "3 workers died over it" in fault.message
    assert len(finished_in(tmp_path / "sets")) == 1
