"""Runs over Ray that are ended from outside leave nobody behind, and what was finished is kept. Run by ray_test.sh."""

import json
import os
import signal
import subprocess
import sys
import time
import uuid

import pytest
import ray
from ray_support import MARK, PART, RECORDED, SHARDS, After, files_of, finished_in, marked, sets_in, until

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
# Says at once that it has done, but first waits, in all episodes after the first job's, until nobody holds it: however quick a machine is,
# work is left when a run is ended.
HELD = """
import pathlib
import time
import numpy
class Held:
    def begin(self, task, observation):
        while task["instruction"] in {later!r} and pathlib.Path({hold!r}).exists():
            time.sleep(0.05)
        self.count = len(task["action_names"])
    def act(self, observation):
        return numpy.full(self.count, 1.0)
"""


@pytest.fixture
def held(brief, tmp_path):
    """Such a policy, and the file that holds it as long as it is there."""
    words = [json.loads(line)["instruction"] for line in brief.read_text().splitlines()[1:]]
    first = words[:: len(SHARDS)]  # episodes are dealt out one by one
    later = sorted(set(words) - set(first))
    assert later
    hold = tmp_path / "hold"
    hold.touch()
    (tmp_path / "held.py").write_text(HELD.format(later=later, hold=str(hold)))
    return f"{tmp_path / 'held.py'}:Held", hold


def begun(mark, address, call, *words, **options):
    """A process group of its own, as a shell gives to what it starts, which has just finished its first job. Ctrl-C reaches it also where
    these tests themselves run in a background that ignores it, which processes inherit."""
    told = [sys.executable, "-c", SCRIPT, address, call, *map(str, words), repr(options)]
    script = subprocess.Popen(
        told,
        env={**os.environ, MARK: mark},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    assert script.stdout is not None and script.stdout.readline().startswith("shard-"), script.communicate()[1]
    return script


def test_ctrl_c_ends_everything_within_seconds(brief, held, tmp_path):
    """Ray's own processes, too, where the script has started Ray."""
    policy, hold = held
    mark = uuid.uuid4().hex
    script = begun(mark, "local", "evaluate", brief, policy, tmp_path / "results", part=PART, workers=2)
    assert len(marked(mark, "ray::")) >= 1 and len(marked(mark, "raylet")) >= 1
    kept = finished_in(tmp_path / "results")
    os.killpg(script.pid, signal.SIGINT)
    began = time.monotonic()
    _, said = script.communicate(timeout=SECONDS)
    assert "KeyboardInterrupt" in said and script.returncode != 0
    assert until(lambda: not marked(mark), SECONDS), marked(mark)
    assert time.monotonic() - began < SECONDS
    assert kept and kept <= finished_in(tmp_path / "results") and not (tmp_path / "results").exists()
    hold.unlink()
    told = After(0, None)
    marketgen.ray.evaluate(brief, policy, tmp_path / "results", part=PART, resume=True, progress=told)
    assert 0 < len(told.told) <= len(SHARDS) - len(kept)
    marketgen.evaluate(brief, policy, tmp_path / "alone")
    assert files_of(tmp_path / "results") == files_of(tmp_path / "alone")


def test_a_killed_script_leaves_no_worker_at_a_cluster(cluster, mark, brief, held, tmp_path):
    """It cannot tidy up; the cluster, which goes on, does."""
    policy, hold = held
    script = begun(mark, cluster.address, "record", brief, tmp_path / "sets", policy, part=PART, **RECORDED)
    kept = finished_in(tmp_path / "sets")
    assert marked(mark, "ray::Worker")
    os.kill(script.pid, signal.SIGKILL)
    script.communicate()
    assert until(lambda: not marked(mark, "ray::Worker"), SECONDS), marked(mark)
    assert kept and finished_in(tmp_path / "sets") == kept
    hold.unlink()
    marketgen.ray.record(brief, tmp_path / "sets", policy, part=PART, resume=True, **RECORDED)
    for number, name in enumerate(SHARDS):
        marketgen.record(brief, tmp_path / "alone" / name, policy, shard=f"{number + 1}/{len(SHARDS)}", **RECORDED)
    assert sets_in(tmp_path / "sets") == sets_in(tmp_path / "alone")
    assert len(ray.nodes()) >= 3
