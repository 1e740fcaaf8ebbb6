"""Runs over Ray that are ended from outside leave nobody behind, and what was finished is kept. Run by ray_test.sh."""

import os
import signal
import subprocess
import sys
import time
import uuid

import pytest
import ray
from ray_support import MARK, PART, POLICY, RECORDED, SHARDS, After, files_of, finished_in, marked, sets_in, until

import marketgen
import marketgen.ray

pytestmark = pytest.mark.usefixtures("cluster")

# As a script of a user's, with Ray as `address` has it; it says when the first job is done.
SCRIPT = """
import sys, marketgen.ray, ray
address, call, *words = sys.argv[1:]
ray.init(address, log_to_driver=False)
options = eval(words.pop())
getattr(marketgen.ray, call)(*words, **options, progress=lambda done, total, text: print(text, flush=True))
"""
SECONDS = 20  # that a machine which computes something else needs, too


def begun(mark, address, call, *words, **options):
    """A process group of its own, as a shell gives to what it starts, which has just finished its first job."""
    told = [sys.executable, "-c", SCRIPT, address, call, *map(str, words), repr(options)]
    script = subprocess.Popen(told, env={**os.environ, MARK: mark}, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True)
    assert script.stdout is not None and script.stdout.readline().startswith("shard-"), script.communicate()[1]
    return script


def test_ctrl_c_ends_everything_within_seconds(brief, brief_alone, tmp_path):
    """Ray's own processes, too, where the script has started Ray."""
    mark = uuid.uuid4().hex
    script = begun(mark, "local", "evaluate", brief, POLICY, tmp_path / "results", part=PART, workers=2)
    assert len(marked(mark, "ray::")) >= 1 and len(marked(mark, "raylet")) >= 1
    kept = finished_in(tmp_path / "results")
    os.killpg(script.pid, signal.SIGINT)
    began = time.monotonic()
    _, said = script.communicate(timeout=SECONDS)
    assert "KeyboardInterrupt" in said and script.returncode != 0
    assert until(lambda: not marked(mark), SECONDS), marked(mark)
    assert time.monotonic() - began < SECONDS
    assert kept and kept <= finished_in(tmp_path / "results") and not (tmp_path / "results").exists()
    told = After(0, None)
    marketgen.ray.evaluate(brief, POLICY, tmp_path / "results", part=PART, resume=True, progress=told)
    assert len(told.told) <= len(SHARDS) - len(kept)
    assert files_of(tmp_path / "results") == brief_alone


def test_a_killed_script_leaves_no_worker_at_a_cluster(cluster, mark, brief, sets_alone, tmp_path):
    """It cannot tidy up; the cluster, which goes on, does."""
    script = begun(mark, cluster.address, "record", brief, tmp_path / "sets", POLICY, part=PART, **RECORDED)
    kept = finished_in(tmp_path / "sets")
    assert marked(mark, "ray::Worker")
    os.kill(script.pid, signal.SIGKILL)
    script.communicate()
    assert until(lambda: not marked(mark, "ray::Worker"), SECONDS), marked(mark)
    assert kept and finished_in(tmp_path / "sets") == kept
    marketgen.ray.record(brief, tmp_path / "sets", POLICY, part=PART, resume=True, **RECORDED)
    assert sets_in(tmp_path / "sets") == sets_alone
    assert len(ray.nodes()) >= 3
