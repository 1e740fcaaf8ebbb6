"""What the tests of clusters are run with; ray_test.sh runs them."""

import os
import uuid

import pytest
import ray_support

import marketgen


@pytest.fixture(scope="session")
def mark():
    """In the environment of every process that these tests begin."""
    os.environ[ray_support.MARK] = uuid.uuid4().hex
    return os.environ[ray_support.MARK]


@pytest.fixture(scope="session")
def cluster(mark):
    """One head without cores, and two nodes that have one each."""
    import ray
    from ray.cluster_utils import Cluster

    cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 0, "include_dashboard": False})
    cluster.add_node(num_cpus=1)
    cluster.add_node(num_cpus=1)
    ray.init(address=cluster.address, log_to_driver=False)
    cluster.wait_for_nodes()
    yield cluster
    ray.shutdown()
    cluster.shutdown()


@pytest.fixture(scope="session")
def tasks(tmp_path_factory):
    return ray_support.write_tasks(tmp_path_factory.mktemp("tasks") / "tasks.jsonl", ray_support.SHORT)


@pytest.fixture(scope="session")
def scenes(tasks):
    """What is recorded."""
    return ray_support.write_tasks(tasks.with_name("scenes.jsonl"), range(ray_support.RECORD_EPISODES), limit_s=ray_support.RECORD_S)


@pytest.fixture(scope="session")
def alone(tasks, tmp_path_factory):
    """Results of one process."""
    folder = tmp_path_factory.mktemp("alone") / "results"
    marketgen.evaluate(tasks, ray_support.POLICY, folder)
    assert any(result["hits"] for result in marketgen.evaluation.evaluation_in(str(folder)).results)
    return ray_support.files_of(folder)


@pytest.fixture(scope="session")
def sets_alone(scenes, tmp_path_factory):
    """Datasets of one process, one for each shard."""
    folder, of = tmp_path_factory.mktemp("sets"), ray_support.RECORD_EPISODES // ray_support.RECORD_PART
    for number in range(of):
        marketgen.record(scenes, folder / f"shard-{number:05}", ray_support.POLICY, shard=f"{number + 1}/{of}", **ray_support.RECORDED)
    return ray_support.sets_in(folder)
