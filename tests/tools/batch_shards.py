"""The examples for Slurm and Kubernetes, done here as these would do them: what they merge is what one process makes. Run by ray_test.sh,
in whose environment the check of Kubernetes' own schema is."""

import json
import os
import pathlib
import re
import signal
import subprocess
import time

import kubernetes_validate
import pytest
import yaml
from ray_support import BRIEF, POLICY, files_of

import marketgen

EXAMPLES = pathlib.Path(__file__).parents[2] / "examples" / "cluster"
SHARDS = 3
KUBERNETES = "1.33"  # since which backoffLimitPerIndex is stable


@pytest.fixture(scope="module")
def environment():
    """In which `marketgen` is the program."""
    return {**os.environ, "PATH": f"{pathlib.Path(os.environ['MARKETGEN_BINARY']).parent}:{os.environ['PATH']}"}


def slurm_task(number, of, episodes, results, environment, **more):
    """One of an array of `of`, as Slurm begins it."""
    told = {"EPISODES": str(episodes), "RESULTS": str(results), "POLICY": POLICY, "SLURM_CPUS_PER_TASK": "1"}
    array = {"SLURM_ARRAY_TASK_ID": str(number), "SLURM_ARRAY_TASK_COUNT": str(of)}
    return subprocess.Popen(["bash", EXAMPLES / "slurm.sh"], env={**environment, **told, **array, **more}, stderr=subprocess.PIPE, text=True, start_new_session=True)


def status_of(task):
    return task.communicate()[1], task.returncode


def has_ended(group):
    """All of it, as Slurm waits before it requeues: the shell ends before the program that it began."""
    end = time.monotonic() + 60
    while time.monotonic() < end:
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return True
        time.sleep(0.05)
    return False


def wait_for(is_so, process):
    end = time.monotonic() + 120
    while not is_so():
        assert time.monotonic() < end and process.poll() is None, process.communicate()
        time.sleep(0.01)


def test_slurm_s_array_makes_what_one_process_makes(brief, brief_alone, environment, tmp_path):
    results = tmp_path / "results"

    def task(number, of=SHARDS, **more):
        return slurm_task(number, of, brief, results, environment, **more)

    preempted, shard = task(1), tmp_path / "results.shards" / "1" / "results.jsonl"
    wait_for(lambda: shard.exists() and b"\n" in shard.read_bytes(), preempted)
    os.killpg(preempted.pid, signal.SIGTERM)
    assert preempted.wait() != 0 and has_ended(preempted.pid) and not (tmp_path / "results.shards" / "1.done").exists()
    kept = shard.read_bytes()
    assert 1 <= kept.count(b"\n") < -(-BRIEF // SHARDS)
    assert status_of(task(1)) == ("", 0)
    assert shard.read_bytes().startswith(kept)
    assert not results.exists()
    assert status_of(task(4))[1] == 2  # there is no fourth of three
    assert status_of(task(2, of=1))[1] == 2  # an array of one task; with SHARDS it is the second of three, as before
    at_once = task(2, of=1, SHARDS=str(SHARDS)), task(3)
    assert [status_of(last) for last in at_once] == [("", 0)] * 2
    assert files_of(results) == brief_alone
    assert status_of(task(3)) == ("", 0)  # requeued when all was done
    assert files_of(results) == brief_alone


def jobs_of_kubernetes():
    return {job["metadata"]["name"]: job for job in yaml.safe_load_all((EXAMPLES / "kubernetes.yaml").read_text())}


def container_of(job):
    [container] = job["spec"]["template"]["spec"]["containers"]
    return container


def pod_of_kubernetes(name, folder, environment, **variables):
    """The container's command, as the kubelet starts it; the volume lies in `folder`, there are fewer shards, and the policy is quick."""
    container = container_of(jobs_of_kubernetes()[name])
    told = {one["name"]: one["value"] for one in container.get("env", [])} | variables
    told |= {"SHARDS": str(SHARDS)} if "SHARDS" in told else {}
    words = [expanded(word, told) for word in [*container["command"], *container["args"]]]
    words = [word.replace("/data", str(folder)).replace("--policy oracle ", f"--policy {POLICY} ") for word in words]
    return subprocess.run(words, env={**environment, **told}, capture_output=True, text=True)


def test_kubernetes_takes_the_jobs():
    jobs = jobs_of_kubernetes()
    for job in jobs.values():
        kubernetes_validate.validate(job, KUBERNETES, strict=True)
        claimed = {volume["name"]: volume["persistentVolumeClaim"]["claimName"] for volume in job["spec"]["template"]["spec"]["volumes"]}
        assert claimed == {"data": "marketgen"} and container_of(job)["volumeMounts"] == [{"name": "data", "mountPath": "/data"}]
    measured = jobs["marketgen-eval"]
    assert container_of(measured)["env"] == [{"name": "SHARDS", "value": str(measured["spec"]["completions"])}]
    measured["spec"]["completion"] = 4  # and it would see a word that is none
    with pytest.raises(kubernetes_validate.ValidationError):
        kubernetes_validate.validate(measured, KUBERNETES, strict=True)


def test_kubernetes_pods_make_what_one_process_makes(brief, brief_alone, environment, tmp_path):
    (tmp_path / "tasks.jsonl").symlink_to(brief)
    for number in range(SHARDS):
        merged = pod_of_kubernetes("marketgen-merge", tmp_path, environment)
        assert merged.returncode != 0 and not (tmp_path / "results").exists()
        if number > 0:
            missing = [f"{shard + 1}/{SHARDS}" for shard in range(number, SHARDS)]
            assert "results.incomplete" in merged.stderr and all(shard in merged.stderr for shard in missing), merged.stderr
        done = pod_of_kubernetes("marketgen-eval", tmp_path, environment, JOB_COMPLETION_INDEX=str(number))
        assert done.returncode == 0, done.stderr
    merged = pod_of_kubernetes("marketgen-merge", tmp_path, environment)
    assert merged.returncode == 0, merged.stderr
    assert files_of(tmp_path / "results") == brief_alone


def test_an_episode_that_cannot_be_run_holds_up_nobody(brief, environment, tmp_path):
    """It is a result, and its shard is whole."""
    header, first, *others = brief.read_text().splitlines()
    impossible = {name: value for name, value in json.loads(first).items() if name not in ("items", "cameras", "lane")}
    impossible |= {"track": "aisle", "robot": "realman-rm75", "start": {"x_m": -900, "y_m": -900, "heading_deg": 0}}  # outside the store
    impossible.pop("certificate", None)  # of the counter
    (tmp_path / "tasks.jsonl").write_text("".join(line + "\n" for line in (header, json.dumps(impossible), *others)))
    marketgen.evaluate(tmp_path / "tasks.jsonl", POLICY, tmp_path / "alone")
    ended = [slurm_task(number + 1, SHARDS, tmp_path / "tasks.jsonl", tmp_path / "of_slurm", environment) for number in range(SHARDS)]
    told = [status_of(task) for task in ended]
    assert [status for _, status in told] == [2, 0, 0] and "1 of 3 episodes could not be run" in told[0][0]
    assert files_of(tmp_path / "of_slurm") == files_of(tmp_path / "alone")
    for number in range(SHARDS):
        assert pod_of_kubernetes("marketgen-eval", tmp_path, environment, JOB_COMPLETION_INDEX=str(number)).returncode == 0
    assert pod_of_kubernetes("marketgen-merge", tmp_path, environment).returncode == 0
    assert files_of(tmp_path / "results") == files_of(tmp_path / "alone")


def expanded(word, variables):
    """$(NAME) of the container's variables; anything else in $(...) is left as it is, and $$ is $."""
    return re.sub(r"\$\$|\$\(([^)]*)\)", lambda found: "$" if found[0] == "$$" else variables.get(found[1], found[0]), word)
