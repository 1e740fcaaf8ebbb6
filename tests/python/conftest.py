"""Python tests run on the build tree: MARKETGEN_BINARY is the program, PYTHONPATH has the module."""

import copy
import json
import os
import pathlib
import subprocess

import gymnasium
import numpy as np
import pytest

import marketgen

ROOT = pathlib.Path(__file__).parents[2]
PROGRAM = os.environ.get("MARKETGEN_BINARY", str(ROOT / "build/release/marketgen"))
PROMPT = "a corner shop with cold drinks, snacks and one checkout"


def pytest_configure(config):
    config.addinivalue_line("markers", "slow: left out of `make test`, run by `make slow`")


def run(*arguments):
    """The program's standard output."""
    return subprocess.run([PROGRAM, *map(str, arguments)], check=True, capture_output=True, text=True).stdout


@pytest.fixture(scope="session")
def store(tmp_path_factory):
    return marketgen.generate(PROMPT, tmp_path_factory.mktemp("stores") / "shop", seed=5, size="9x7m")


@pytest.fixture(scope="session")
def renderer(store):
    return store.renderer()


@pytest.fixture
def unmoved(renderer):
    """The renderer with nothing moved and no robots, before and after."""
    yield renderer
    renderer.move()
    renderer.set_robots([])
    renderer.set_people(0)


def same(a, b):
    """Equal, whatever they are made of: dicts and lists of arrays, texts and numbers."""
    if isinstance(a, dict):
        return isinstance(b, dict) and a.keys() == b.keys() and all(same(a[key], b[key]) for key in a)
    if isinstance(a, (list, tuple)):
        return len(a) == len(b) and all(same(x, y) for x, y in zip(a, b, strict=True))
    if isinstance(a, np.ndarray) and a.dtype == object:
        return a.shape == np.shape(b) and all(same(x, y) for x, y in zip(a.flat, b.flat, strict=True))
    return np.array_equal(a, b)


@pytest.fixture(scope="session")
def checkout_file(store, tmp_path_factory):
    """Two baskets of the store."""
    file = tmp_path_factory.mktemp("episodes") / "checkout.jsonl"
    run("episodes", store.folder, "--track", "checkout", "--count", 2, "--seed", 3, "-o", file, "--quiet")
    return file


@pytest.fixture(scope="session")
def tasks(checkout_file, tmp_path_factory):
    """The two baskets, with a second for each."""
    header, *episodes = checkout_file.read_text().splitlines()
    short = [json.dumps({**json.loads(episode), "limit_s": 1}) for episode in episodes]
    file = tmp_path_factory.mktemp("tasks") / "tasks.jsonl"
    file.write_text("".join(line + "\n" for line in (header, *short)))
    return file


@pytest.fixture(scope="session")
def aisle_file(store, checkout_file, tmp_path_factory):
    """Two tasks in the aisles, made by hand: drawing one takes half a minute. The header is that of the baskets."""
    header, first, _ = checkout_file.read_text().splitlines()
    rows = [row for row in json.loads(header)["products"]]
    env = gymnasium.make("MarketGen/InAisleCollection-v1", store=store).unwrapped
    aisle = max(store.layout["aisles"], key=lambda aisle: aisle["width_mm"])
    x, y = np.mean(aisle["polygon_mm"], axis=0) / 1000
    episodes = []
    for row in rows:
        episode = {key: json.loads(first)[key] for key in ("schema", "store", "scene_hash", "plan_hash")}
        episode |= {
            "id": f"aisle/{len(episodes)}",
            "track": "aisle",
            "robot": "realman-rm75",
            "instruction": f"Fetch {('one', 'two')[len(episodes)]}.",
            "goals": [{"sku": row["sku"], "count": 1}],
            "start": {"x_m": round(float(x), 3), "y_m": round(float(y), 3), "heading_deg": 30.0},
            "categories": [{"sku": row["sku"], "category": row["category"], "x_m": 1.0, "y_m": 2.0}],
            "limit_s": 60,
        }
        try:
            env.reset(options={"episode": episode})
        except marketgen.Error as error:  # the product stands too high, or behind a door
            assert error.code == "catalog.unknown_sku", error
            continue
        episodes.append(episode)
        if len(episodes) == 2:
            break
    file = tmp_path_factory.mktemp("episodes") / "aisle.jsonl"
    file.write_text("".join(line + "\n" for line in (header, *map(json.dumps, episodes))))
    return file


@pytest.fixture
def aisle_episode(aisle_file):
    return copy.deepcopy(json.loads(aisle_file.read_text().splitlines()[1]))
