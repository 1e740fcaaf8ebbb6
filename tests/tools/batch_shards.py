"""The examples for Slurm and Kubernetes, done here as these would do them: what they merge is what one process makes. Run by ray_test.sh,
in whose environment the check of Kubernetes' own schema is."""

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

EXAMPLES = pathlib.Path(__file__).parents[2] / "examples" / "cluster"
SHARDS = 3
KUBERNETES = "1.33"  # since which backoffLimitPerIndex is stable


@pytest.fixture(scope="module")
def environment():
    """In which `marketgen` is the program."""
    return {**os.environ, "PATH": f"{pathlib.Path(os.environ['MARKETGEN_BINARY']).parent}:{os.environ['PATH']}"}


def test_slurm_s_array_makes_what_one_process_makes(brief, brief_alone, environment, tmp_path):
    told = {**environment, "EPISODES": str(brief), "RESULTS": str(tmp_path / "results"), "POLICY": POLICY, "SLURM_CPUS_PER_TASK": "1"}

    def task(number, of=SHARDS, **more):
        told_here = {**told, "SLURM_ARRAY_TASK_ID": str(number), "SLURM_ARRAY_TASK_COUNT": str(of), **more}
        return subprocess.Popen(["bash", EXAMPLES / "slurm.sh"], env=told_here, stderr=subprocess.PIPE, text=True, start_new_session=True)

    preempted, shard = task(1), tmp_path / "results.shards" / "1" / "results.jsonl"
    wait_for(lambda: shard.exists() and shard.stat().st_size > 0, preempted)
    os.killpg(preempted.pid, signal.SIGTERM)
    assert preempted.wait() != 0 and not (tmp_path / "results.shards" / "1.done").exists()
    kept = shard.read_bytes()
    assert 1 <= kept.count(b"\n") < BRIEF // SHARDS
    ended(task(1))
    assert shard.read_bytes().startswith(kept)
    assert not (tmp_path / "results").exists()
    assert task(4).wait() == 2  # there is no fourth of three
    assert task(2, of=1).wait() == 2  # an array of one task; with SHARDS it is the second of three, as before
    ended(task(2, of=1, SHARDS=str(SHARDS)), last := task(3))
    assert files_of(tmp_path / "results") == brief_alone, last.stderr
    ended(task(3))  # requeued when all was done
    assert files_of(tmp_path / "results") == brief_alone


def wait_for(is_so, process):
    end = time.monotonic() + 120
    while not is_so():
        assert time.monotonic() < end and process.poll() is None, process.communicate()
        time.sleep(0.01)


def ended(*processes):
    for process in processes:
        said = process.communicate()[1]
        assert process.returncode == 0, said


def jobs_of_kubernetes():
    return {job["metadata"]["name"]: job for job in yaml.safe_load_all((EXAMPLES / "kubernetes.yaml").read_text())}


def test_kubernetes_takes_the_jobs():
    jobs = jobs_of_kubernetes()
    for job in jobs.values():
        kubernetes_validate.validate(job, KUBERNETES, strict=True)
        [container] = job["spec"]["template"]["spec"]["containers"]
        claimed = {volume["name"]: volume["persistentVolumeClaim"]["claimName"] for volume in job["spec"]["template"]["spec"]["volumes"]}
        assert claimed == {"data": "marketgen"} and container["volumeMounts"] == [{"name": "data", "mountPath": "/data"}]
    spec = jobs["marketgen-eval"]["spec"]
    [container] = spec["template"]["spec"]["containers"]
    assert container["env"] == [{"name": "SHARDS", "value": str(spec["completions"])}]
    jobs["marketgen-eval"]["spec"]["completion"] = 4  # and it would see a word that is none
    with pytest.raises(kubernetes_validate.ValidationError):
        kubernetes_validate.validate(jobs["marketgen-eval"], KUBERNETES, strict=True)


def test_kubernetes_pods_make_what_one_process_makes(brief, brief_alone, environment, tmp_path):
    jobs = jobs_of_kubernetes()
    (tmp_path / "tasks.jsonl").symlink_to(brief)

    def pod(name, **more):
        """Its container's command, as the kubelet starts it; the volume lies elsewhere, there are fewer shards, and the policy is quick."""
        [container] = jobs[name]["spec"]["template"]["spec"]["containers"]
        told = {one["name"]: one["value"] for one in container.get("env", [])} | more
        told |= {"SHARDS": str(SHARDS)} if "SHARDS" in told else {}
        words = [expanded(word, told) for word in [*container["command"], *container["args"]]]
        words = [word.replace("/data", str(tmp_path)).replace("--policy oracle ", f"--policy {POLICY} ") for word in words]
        return subprocess.run(words, env={**environment, **told}, capture_output=True, text=True)

    for number in range(SHARDS):
        merged = pod("marketgen-merge")
        assert merged.returncode != 0 and not (tmp_path / "results").exists()
        if number > 0:
            missing = [f"{shard + 1}/{SHARDS}" for shard in range(number, SHARDS)]
            assert "results.incomplete" in merged.stderr and all(shard in merged.stderr for shard in missing), merged.stderr
        done = pod("marketgen-eval", JOB_COMPLETION_INDEX=str(number))
        assert done.returncode == 0, done.stderr
    merged = pod("marketgen-merge")
    assert merged.returncode == 0, merged.stderr
    assert files_of(tmp_path / "results") == brief_alone


def expanded(word, variables):
    """$(NAME) of the container's variables; anything else in $(...) is left as it is, and $$ is $."""
    return re.sub(r"\$\$|\$\(([^)]*)\)", lambda found: "$" if found[0] == "$$" else variables.get(found[1], found[0]), word)
