"""The oracle acts in Python's environments, in the numbers of their actions, and reaches its goals."""

import gymnasium
import numpy as np
import pytest

import marketgen

CHECKOUT = "MarketGen/CheckoutUnloading-v1"


def play(env, policy, seen, limit=4000):
    for step in range(1, limit):
        seen, reward, terminated, truncated, info = env.step(policy(seen))
        if terminated or truncated:
            return step, reward, info
    raise AssertionError("it does not end")


@pytest.mark.parametrize("control_mode", ["pd_joint_pos", "pd_joint_delta_pos"])
def test_it_unloads_a_basket(checkout_file, control_mode):
    env = gymnasium.make(CHECKOUT, episodes=checkout_file, control_mode=control_mode)
    policy = marketgen.policies.oracle(env)
    seen, _ = env.reset(options={"episode": 1})  # one that it solves in either mode: it solves some 97 of 100
    _, reward, info = play(env, policy, seen)
    assert info["success"] and info["goal_fraction"] == 1 and reward == 1, info
    assert policy.failure() == "None"


@pytest.mark.slow
def test_it_fetches_in_the_aisles():
    env = gymnasium.make("MarketGen/InAisleCollection-v1", control_mode="pd_joint_pos")
    policy = marketgen.policies.oracle(env)
    seen, _ = env.reset(options={"episode": 1})  # the quickest of the first few of the pool
    _, reward, info = play(env, policy, seen)
    assert info["success"] and reward == 1, info


def test_each_reset_is_a_new_beginning(checkout_file):
    env = gymnasium.make(CHECKOUT, episodes=checkout_file, control_mode="pd_joint_pos")
    policy = marketgen.policies.oracle(env)
    hashes = []
    for _ in range(2):
        seen, _ = env.reset(options={"episode": 1})
        for _ in range(20):
            action = policy(seen)
            assert env.action_space.contains(action)
            seen, *_ = env.step(action)
        hashes.append(env.unwrapped.state_hash())
    assert hashes[0] == hashes[1]


@pytest.mark.slow
def test_many_at_once_are_each_alone(checkout_file):
    many = marketgen.make_vec(CHECKOUT, 2, episodes=checkout_file, control_mode="pd_joint_pos")
    policy = marketgen.policies.oracle(many)
    seen, _ = many.reset(seed=3)
    for _ in range(12):
        seen, *_ = many.step(policy(seen))
    for i in range(2):
        env = gymnasium.make(CHECKOUT, episodes=checkout_file, control_mode="pd_joint_pos")
        alone = marketgen.policies.oracle(env)
        one, _ = env.reset(seed=3 + i)
        for _ in range(12):
            one, *_ = env.step(alone(one))
        assert env.unwrapped.state_hash() == many.envs[i].state_hash()


def test_it_says_when_nothing_runs(checkout_file):
    env = gymnasium.make(CHECKOUT, episodes=checkout_file, control_mode="pd_joint_pos")
    with pytest.raises(marketgen.Error, match="reset the environment first") as caught:
        marketgen.policies.oracle(env)()
    assert caught.value.code == "episode.bad_action"


def test_modes_of_the_tool_are_refused_with_the_way(checkout_file):
    env = gymnasium.make(CHECKOUT, episodes=checkout_file, control_mode="pd_ee_delta_pose")
    with pytest.raises(marketgen.Error, match="control_mode='pd_joint_pos' or 'pd_joint_delta_pos'"):
        marketgen.policies.oracle(env)
