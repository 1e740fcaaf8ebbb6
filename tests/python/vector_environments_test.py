"""Many environments in one call are what each is alone, bit for bit, however they begin anew."""

import gymnasium
import numpy as np
import pytest

import marketgen
from conftest import same

CHECKOUT, AISLE = "MarketGen/CheckoutUnloading-v1", "MarketGen/InAisleCollection-v1"


def actions_of(space, steps, seed=7):
    """Random, and an agent that stops now and then."""
    rng = np.random.default_rng(seed)
    drawn = rng.uniform(-1, 1, (steps, *space.shape)).astype(np.float32)
    drawn[..., -1] = np.where(rng.random((steps, space.shape[0])) < 0.3, 1, -1)
    return drawn


def run(env, steps):
    out = [env.reset(seed=4)]
    out += [env.step(action) for action in actions_of(env.action_space, steps)]
    return out


@pytest.mark.parametrize("mode", ["NextStep", pytest.param("SameStep", marks=pytest.mark.slow)])
@pytest.mark.parametrize("options", [{}, {"obs_mode": "rgbd", "width": 24, "height": 16, "reward_mode": "dense"}])
def test_many_are_gymnasiums_many(store, mode, options):
    native = gymnasium.make_vec(CHECKOUT, num_envs=3, store=store, autoreset_mode=mode, **options)
    assert isinstance(native, marketgen.environments.CheckoutUnloadingVector)
    alone = gymnasium.make_vec(
        CHECKOUT,
        num_envs=3,
        vectorization_mode="sync",
        vector_kwargs={"autoreset_mode": gymnasium.vector.AutoresetMode(mode)},
        store=store,
        **options,
    )
    assert native.observation_space == alone.observation_space and native.action_space == alone.action_space
    steps = 4 if options else 8
    for i, (one, other) in enumerate(zip(run(native, steps), run(alone, steps), strict=True)):
        assert all(same(a, b) for a, b in zip(one, other, strict=True)), f"step {i}"
    assert native.observation_space.contains(one[0])


def test_without_autoreset_the_mask_says_who_begins_anew(store):
    env = gymnasium.make_vec(CHECKOUT, num_envs=2, store=store, autoreset_mode="Disabled")
    first, _ = env.reset(seed=4)
    actions = np.zeros(env.action_space.shape, np.float32)
    actions[:, -1] = 1, -1
    _, _, terminated, _, infos = env.step(actions)
    assert terminated.tolist() == [True, False] and infos["_success"].tolist() == [True, False]
    with pytest.raises(marketgen.Error, match=r"\[0\] are over"):
        env.step(actions)
    seen, infos = env.reset(seed=4, options={"reset_mask": terminated})
    assert np.array_equal(seen["agent"]["qpos"][0], first["agent"]["qpos"][0])
    assert infos["_instruction"].tolist() == [True, False]
    actions[:, -1] = -1
    env.step(actions)
    with pytest.raises(ValueError, match="reset_mask"):
        env.reset(options={"reset_mask": np.array([False, False])})


def test_robots_in_aisles_share_a_store_and_its_renderer(store, aisle_file):
    options = {"obs_mode": "rgbd", "width": 24, "height": 16}
    many = gymnasium.make_vec(AISLE, num_envs=2, episodes=aisle_file, **options)
    seen, _ = many.reset(seed=1)
    actions = np.zeros(many.action_space.shape, np.float32)
    actions[:, -3], actions[:, -1] = (0.2, -0.1), -1
    for _ in range(3):
        moved, *_ = many.step(actions)
    for i in range(2):
        alone = gymnasium.make(AISLE, episodes=aisle_file, **options)
        alone.reset(seed=1 + i)
        for _ in range(3):
            then, *_ = alone.step(actions[i])
        assert same(then, {g: {k: _one(v, i) for k, v in parts.items()} for g, parts in moved.items()})
        assert many.envs[i].state_hash() == alone.unwrapped.state_hash()


def _one(value, i):
    return {k: v[i] for k, v in value.items()} if isinstance(value, dict) else value[i]


def test_one_bad_action_stops_none(store):
    env = gymnasium.make_vec(CHECKOUT, num_envs=2, store=store)
    env.reset(seed=4)
    before = env.call("state_hash")
    actions = np.zeros(env.action_space.shape, np.float32)
    actions[1, 2] = np.inf
    with pytest.raises(marketgen.Error, match="environment 1") as caught:
        env.step(actions)
    assert caught.value.code == "episode.bad_action"
    with pytest.raises(marketgen.Error, match="shape"):
        env.step(actions[0])
    assert env.call("state_hash") == before


def test_the_same_memory_when_asked_for(store):
    env = gymnasium.make_vec(CHECKOUT, num_envs=2, store=store, copy=False)
    first, _ = env.reset(seed=4)
    then, *_ = env.step(np.zeros(env.action_space.shape, np.float32))
    assert np.shares_memory(first["agent"]["qpos"], then["agent"]["qpos"])
