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
def brief(tmp_path_factory):
    """A file of episodes that end soon."""
    return ray_support.write_tasks(tmp_path_factory.mktemp("brief") / "brief.jsonl", range(ray_support.BRIEF), limit_s=ray_support.BRIEF_S)


@pytest.fixture(scope="session")
def brief_alone(brief, tmp_path_factory):
    """Their results of one process."""
    folder = tmp_path_factory.mktemp("alone") / "results"
    marketgen.evaluate(brief, ray_support.POLICY, folder)
    return ray_support.files_of(folder)


@pytest.fixture(scope="session")
def sets_alone(brief, tmp_path_factory):
    """Their datasets of one process, one for each shard."""
    folder, of = tmp_path_factory.mktemp("sets"), len(ray_support.SHARDS)
    for number, name in enumerate(ray_support.SHARDS):
        marketgen.record(brief, folder / name, ray_support.POLICY, shard=f"{number + 1}/{of}", **ray_support.RECORDED)
    return ray_support.sets_in(folder)
