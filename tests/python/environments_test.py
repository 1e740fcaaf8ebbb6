"""Environments keep Gymnasium's contract, repeat bit for bit, and say what is wrong with an action."""

import copy
import json
import warnings

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import marketgen
from conftest import same

NAME = "MarketGen/CheckoutUnloading-v1"
CONTROL = ("pd_joint_pos", "pd_joint_delta_pos", "pd_ee_delta_pos", "pd_ee_delta_pose")


def make(store, **options):
    return gymnasium.make(NAME, store=store, **options)


def still(env, stop=-1.0, seen=None):
    """An action that holds the arm where it is; pd_joint_pos needs to know where that is."""
    action = np.zeros(env.action_space.shape, np.float32)
    if env.unwrapped.control_mode == "pd_joint_pos":
        action[:7] = seen["agent"]["qpos"][:7]
    action[-2:] = 1.0, stop
    return action


def short_episode(store, seconds):
    env = make(store)
    env.reset(seed=3)
    episode = copy.deepcopy(env.unwrapped.episode)
    episode["limit_s"] = seconds
    return episode


@pytest.mark.parametrize(
    "options",
    [{}, pytest.param({"obs_mode": "rgbd", "width": 32, "height": 24, "segmentation": True}, marks=pytest.mark.slow)],
)
def test_the_checker_has_no_complaint(store, options):
    env = make(store, render_mode="rgb_array", **options)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(env.unwrapped, skip_render_check=False)


def test_what_presses_on_the_arm_is_told(store):
    env = make(store)
    seen, _ = env.reset(options={"episode": short_episode(store, 60)})
    assert seen["agent"]["external_force"].shape == (1,) and not seen["agent"]["external_force"].any()
    forces = []
    for joint, steps in ((0, 25), (1, 100)):  # aside, then down until it leans on the counter
        action = still(env)
        action[joint] = -1 if joint == 0 else 1
        forces += [env.step(action)[0]["agent"]["external_force"][0] for _ in range(steps)]
    assert max(forces) > 5


def test_a_cup_instead_of_the_gripper(store):
    episode = short_episode(store, 60) | {"tools": "suction"}
    env = make(store, tools="suction")
    seen, _ = env.reset(options={"episode": episode})
    assert seen["agent"]["sealed"].shape == (1,) and not seen["agent"]["sealed"].any()
    action = still(env)
    lets_go = env.step(action)[0]["agent"]
    assert lets_go["qpos"][7] == pytest.approx(0.05)
    action[-2] = -1
    sucks = env.step(action)[0]["agent"]
    assert sucks["qpos"][7] == 0 and not sucks["sealed"].any(), "nothing is there"
    with pytest.raises(marketgen.Error, match="the episode is for"):
        make(store).reset(options={"episode": episode})
    with pytest.raises(marketgen.Error, match="suctoin"):
        make(store, tools="suctoin")


def test_episodes_are_drawn_by_the_split_that_is_asked_for(store):
    drawn = {split: json.loads(make(store, split=split).unwrapped.setup.draw([3])[0]) for split in ("planned", "all")}
    assert drawn["planned"]["certificate"]["witness"]
    assert not drawn["all"]["certificate"]["witness"]
    with pytest.raises(marketgen.Error, match="planed"):
        make(store, split="planed")
    with pytest.raises(marketgen.Error, match="give a store"):
        gymnasium.make(NAME, split="all")  # of the pool


def test_equal_seeds_repeat_bit_for_bit_pictures_included(store):
    runs = []
    for _ in range(2):
        env = make(store, obs_mode="rgbd", width=48, height=36, cameras=("scene_camera", "wrist_camera"))
        rng = np.random.default_rng(5)
        seen = [env.reset(seed=3)[0]]
        for _ in range(6):
            action = rng.uniform(-1, 1, env.action_space.shape).astype(np.float32)
            action[-1] = -1
            seen.append(env.step(action)[0])
        runs.append((seen, env.unwrapped.state_hash()))
    assert runs[0][1] == runs[1][1]
    assert all(same(a, b) for a, b in zip(runs[0][0], runs[1][0], strict=True))
    scene = runs[0][0][0]["sensor_data"]["scene_camera"]
    assert scene["rgb"].std() > 10 and (scene["depth"] > 300).mean() > 0.9


def test_other_seeds_are_other_episodes(store):
    env = make(store)
    assert env.reset(seed=3)[1]["instruction"] != env.reset(seed=4)[1]["instruction"]


@pytest.mark.parametrize("control", CONTROL)
def test_every_control_mode_moves_the_arm(store, control):
    env = make(store, control_mode=control)
    before = env.reset(seed=3)[0]
    action = still(env, seen=before)
    action[0] += 0.5
    for _ in range(4):
        after, *_ = env.step(action)
    assert np.abs(after["agent"]["qpos"] - before["agent"]["qpos"]).max() > 0.01
    env.reset(seed=3)
    for _ in range(4):
        held, *_ = env.step(still(env, seen=before))
    assert np.abs(held["agent"]["qpos"][:7] - before["agent"]["qpos"][:7]).max() < 0.01


def test_tool_steps_go_where_they_say(store):
    env = make(store, control_mode="pd_ee_delta_pos")
    before = env.reset(seed=3)[0]["extra"]["tcp_pose"]
    action = still(env)
    action[2] = 1.0  # up
    for _ in range(5):
        after = env.step(action)[0]["extra"]["tcp_pose"]
    assert after[2] - before[2] > 0.05
    assert np.abs(after[:2] - before[:2]).max() < 0.02


def test_stopping_at_once_meets_no_goal(store):
    env = make(store)
    env.reset(seed=3)
    _, reward, terminated, truncated, info = env.step(still(env, stop=1.0))
    assert (terminated, truncated, reward) == (True, False, 0)
    assert info["success"] is False and info["goal_fraction"] == 0 and info["failure_reason"] == "Unknown"
    assert info["result"]["schema"] == "market-result/1"
    with pytest.raises(marketgen.Error) as caught:
        env.unwrapped.step(still(env))
    assert caught.value.code == "episode.bad_action"


def test_time_runs_out(store):
    env = make(store)
    env.reset(options={"episode": short_episode(store, 1)})
    for step in range(1, 100):
        _, _, terminated, truncated, info = env.step(still(env))
        if truncated:
            break
        assert set(info) == {"instruction", "time_s", "robot_stopped"}
    assert step == 20 and not terminated and info["failure_reason"] == "Timeout"


def test_dense_rewards_are_shares(store):
    env = make(store, reward_mode="dense")
    env.reset(seed=3)
    rewards = [env.step(still(env))[1] for _ in range(3)]
    assert all(0 < reward < 1 for reward in rewards)


@pytest.mark.parametrize("spoil", ["nan", "shape", "short", "words"])
def test_bad_actions_change_nothing(store, spoil):
    env = make(store).unwrapped
    env.reset(seed=3)
    before = env.state_hash()
    action = still(env)
    if spoil == "nan":
        action[1] = np.nan
    else:
        action = {"short": action[:-1], "shape": action[None], "words": "left"}[spoil]
    with pytest.raises(marketgen.Error) as caught:
        env.step(action)
    assert caught.value.code == "episode.bad_action"
    assert env.state_hash() == before


@pytest.mark.parametrize(
    ("change", "code"),
    [
        (
            {"items": [{"sku": "no-such-sku"}], "goals": [{"sku": "no-such-sku", "text": "no such thing"}], "certificate": {}},
            "catalog.unknown_sku",
        ),
        ({"scene_hash": "0" * 32}, "episode.other_store"),
        ({"robot": "panda-2"}, "robot.unknown"),
        ({"track": "juggling"}, "json.unknown_name"),
    ],
)
def test_bad_episodes_are_said(store, change, code):
    env = make(store)
    episode = {**short_episode(store, 5), **change}
    with pytest.raises(marketgen.Error) as caught:
        env.reset(options={"episode": json.dumps(episode)})
    assert caught.value.code == code


def test_bad_names_are_said(store):
    with pytest.raises(marketgen.Error, match="pd_joint_pos"):
        make(store, control_mode="torque")
