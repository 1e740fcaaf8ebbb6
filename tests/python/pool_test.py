"""Environments that were given neither a store nor episodes draw from the pool that comes with the program, at once."""

import time

import gymnasium
import numpy as np
import pytest

import marketgen

IDS = {
    "checkout": "MarketGen/CheckoutUnloading-v1",
    "aisle": "MarketGen/InAisleCollection-v1",
    "one-item": "MarketGen/CheckoutOneItem-v1",
}


@pytest.fixture
def untouched_cache(tmp_path, monkeypatch):
    """Nothing that another run left behind helps."""
    monkeypatch.setenv("MARKETGEN_CACHE", str(tmp_path))
    marketgen.environments.task_setup._pool_ground.cache_clear()
    yield
    marketgen.environments.task_setup._pool_ground.cache_clear()


@pytest.mark.parametrize("kind", IDS)
def test_it_begins_at_once(untouched_cache, kind):
    started = time.perf_counter()
    env = gymnasium.make(IDS[kind])
    env.reset(seed=1)
    # Measured: 0.1 s at the counter, 0.8 s in the aisles, where the store is made from its plan. Drawing takes 5 s and more.
    assert time.perf_counter() - started < 4
    env.step(env.action_space.sample())


def test_sixteen_begin_in_seconds(untouched_cache):
    started = time.perf_counter()
    many = gymnasium.make_vec(IDS["checkout"], num_envs=16)
    _, infos = many.reset(seed=1)
    assert time.perf_counter() - started < 30  # measured: 0.4 s, 7 s with a compiler on both cores; drawing them takes 80 s and more
    assert len(set(infos["instruction"])) > 8


@pytest.mark.parametrize("kind", IDS)
def test_seeds_draw_alike_and_differ(kind):
    env = gymnasium.make(IDS[kind])
    drawn = [[env.reset(seed=seed)[1] and env.unwrapped.episode for seed in (1, 2, 3, 4)] for _ in range(2)]
    assert drawn[0] == drawn[1]
    assert len({str(episode["items"]) + str(episode["goals"]) for episode in drawn[0]}) > 1


def test_episodes_of_the_pool_have_numbers():
    env = gymnasium.make(IDS["checkout"])
    env.reset(options={"episode": 0})
    first = env.unwrapped.episode["id"]
    env.reset(options={"episode": 1})
    assert env.unwrapped.episode["id"] != first
    with pytest.raises(marketgen.Error, match="no number"):
        env.reset(options={"episode": 100000})


def test_a_shop_of_40_m2_serves(tmp_path):
    shop = marketgen.generate("a kiosk of 40 m2 with snacks and cold drinks", tmp_path / "kiosk", seed=56)  # few kiosks have a light box
    shell = shop.layout["shell"]
    assert 35 < shell["width_mm"] * shell["depth_mm"] / 1e6 < 45
    env = gymnasium.make(IDS["checkout"], store=shop)
    seen, info = env.reset(seed=3)
    assert 2 <= len(env.unwrapped.episode["items"]) < 12 and info["instruction"]
    assert env.observation_space.contains(seen)
    one = gymnasium.make(IDS["one-item"], store=shop)
    assert np.isfinite(one.reset(seed=1)[0]).all()
