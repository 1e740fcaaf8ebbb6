"""The stages of the tasks: Gymnasium's contract, numbers in [-1, 1], the same again from a seed, and each can be done and pays."""

import copy
import pathlib
import sys
import warnings

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import marketgen

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "examples"))
import stage_scripts

STAGES = ("DriveToProduct", "PickFromShelf", "PlaceInBasket", "OpenCooler")


def make(name, **options):
    return gymnasium.make(f"MarketGen/{name}-v1", **options)


def at_random(rng, env):
    """But for a hand that keeps what it has: what it drops ends the episode."""
    action = rng.uniform(-1, 1, env.action_space.shape)
    if isinstance(env.unwrapped, marketgen.environments.PlaceInBasket):
        action[-1] = -1
    return action


@pytest.mark.parametrize("name", STAGES)
def test_the_checker_has_no_complaint(name):
    env = make(name, render_mode="rgb_array", render_size=(64, 48))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(env.unwrapped, skip_render_check=False)


@pytest.mark.parametrize("name", STAGES)
def test_numbers_lie_in_boxes_of_one(name):
    env = make(name)
    for box in (env.action_space, env.observation_space):
        assert (box.low == -1).all() and (box.high == 1).all() and box.dtype == np.float32
    assert env.observation_space.shape == (len(env.unwrapped.sees),)
    assert env.action_space.shape == (len(env.unwrapped.action_names),)
    rng = np.random.default_rng(1)
    seen, _ = env.reset(seed=1)
    rows = [seen]
    for _ in range(15):
        rows.append(env.step(at_random(rng, env))[0])
    assert all(env.observation_space.contains(row) for row in rows)
    assert np.abs(np.diff(rows, axis=0)).max() > 0.01


@pytest.mark.parametrize("name", STAGES)
def test_equal_seeds_repeat_bit_for_bit_and_others_do_not(name):
    runs = []
    for seed in (3, 3, 4):
        env = make(name)
        rng = np.random.default_rng(5)
        rows = [env.reset(seed=seed)[0]]
        for _ in range(5):
            row, reward, *_ = env.step(at_random(rng, env))
            rows.append(np.append(row, reward))
        runs.append((rows, env.unwrapped.state_hash()))
    assert all(np.array_equal(a, b) for a, b in zip(runs[0][0], runs[1][0], strict=True))
    assert runs[0][1] == runs[1][1] != runs[2][1]


@pytest.mark.parametrize("name", STAGES)
def test_a_copy_goes_on_alike(name):
    env = make(name)
    env.reset(seed=2)
    rng = np.random.default_rng(1)
    for _ in range(4):
        env.step(at_random(rng, env))
    other = copy.deepcopy(env)
    for _ in range(4):
        action = at_random(rng, env)
        (seen, reward, *ends, _), (again, same, *also, _) = env.step(action), other.step(action)
        assert np.array_equal(seen, again) and reward == same and ends == also


@pytest.mark.parametrize("name", STAGES)
def test_what_is_no_number_is_refused_wherever_it_stands(name):
    env = make(name)
    for place in range(env.action_space.shape[0]):
        env.reset(seed=3)
        action = np.zeros(env.action_space.shape, np.float32)
        action[place] = np.nan
        with pytest.raises(marketgen.Error) as caught:
            env.step(action)
        assert caught.value.code == "episode.bad_action"
        env.step(np.zeros(env.action_space.shape))  # nothing of it is kept


@pytest.mark.parametrize("name", STAGES)
def test_nothing_done_is_cut_off_without_success(name):
    env = make(name)
    env.reset(seed=1)
    still, total = np.zeros(env.action_space.shape), 0.0
    if name != "DriveToProduct":
        still[-1] = -1 if name == "PlaceInBasket" else 1  # a hand that holds, or an open one
    steps = round(env.unwrapped.limit_s / (0.05 * env.unwrapped.hold))
    for step in range(1, steps + 1):
        _, reward, terminated, truncated, info = env.step(still)
        total += reward
        assert (terminated, truncated) == (False, step == steps)
        assert ("is_success" in info) == truncated
    assert info["is_success"] is False and abs(total) < 0.1
    with pytest.raises(marketgen.Error) as caught:
        env.step(still)
    assert caught.value.code == "episode.bad_action"


@pytest.mark.parametrize("name", STAGES)
def test_each_can_be_done_and_pays(name):
    env = make(name)
    policy = stage_scripts.of(env)
    done = 0
    for seed in range(6):
        seen, _ = env.reset(seed=seed)
        begun, total, over = env.unwrapped._before, 0.0, False
        while not over:
            seen, reward, terminated, truncated, info = env.step(policy(seen))
            total, over = total + reward, terminated or truncated
        if info["is_success"]:
            assert terminated and total == pytest.approx(1 - begun)
            done += 1
        else:
            assert total < 0.95 - begun
    assert done >= 4


@pytest.mark.parametrize(
    ("name", "options", "word"),
    [("DriveToProduct", {"obs_mode": "rgbd"}, "obs_mode"), ("PlaceInBasket", {"control_mode": "pd_joint_pos"}, "control_mode")],
)
def test_what_a_stage_fixes_is_no_choice(name, options, word):
    with pytest.raises(marketgen.Error) as caught:
        make(name, **options)
    assert caught.value.code == "usage.bad_flag" and word in str(caught.value)


def test_the_box_is_in_the_hand():
    env = make("PlaceInBasket")
    held = [dict(zip(env.unwrapped.sees, env.reset(seed=seed)[0], strict=True))["held"] for seed in range(6)]
    assert held == [1.0] * 6, "of seed 0 the hand does not get hold of the first box that is drawn"


@pytest.mark.parametrize("name", ["DriveToProduct", "PickFromShelf", "OpenCooler"])
def test_it_begins_at_rest_and_free(name):
    """Where the robot is put it touches nothing: what stands there stays, and nothing stops it."""
    env = make(name)
    for seed in range(4):
        env.reset(seed=seed)
        assert env.unwrapped.parts()["agent"]["external_force"].max() < 1
        before = env.unwrapped.items()[0]["pose"]
        still = np.zeros(env.action_space.shape)
        if name != "DriveToProduct":
            still[-1] = 1
        *_, info = env.step(still)
        assert not info["robot_stopped"]
        assert np.abs(env.unwrapped.items()[0]["pose"] - before)[:3].max() < 0.003


def test_an_episode_without_a_witness_is_said():
    env = make("DriveToProduct")
    env.reset(seed=1)
    episode = {**env.unwrapped.episode, "certificate": {"proved": [], "witness": []}}
    with pytest.raises(marketgen.Error) as caught:
        env.reset(options={"episode": episode})
    assert caught.value.code == "episode.impossible" and "planned" in str(caught.value)


@pytest.mark.slow
def test_chance_opens_no_door():
    env = make("OpenCooler")
    env.action_space.seed(1)
    totals = []
    for seed in range(10):
        env.reset(seed=seed)
        total, over = 0.0, False
        while not over:
            _, reward, terminated, truncated, info = env.step(env.action_space.sample())
            total, over = total + reward, terminated or truncated
        assert info["is_success"] is False
        totals.append(total)
    assert max(totals) < 0.5


def test_doors_of_both_stores_and_both_leaves_are_drawn():
    env = make("OpenCooler")
    doors = set()
    for seed in range(16):
        env.reset(seed=seed)
        doors.add((env.unwrapped.episode["store"], env.unwrapped.episode["certificate"]["witness"][0]["door"]["id"]))
    assert len(doors) == 4


def test_a_hand_that_is_told_to_press_on_does_not():
    """On bar or glass, straight or aslant, with an open hand: the world never feels what no clean episode has."""
    env = make("OpenCooler")
    for seed, along in ((0, 0.0), (3, 0.5), (4, -0.5), (6, -1.0)):
        env.reset(seed=seed)
        hardest = 0.0
        for _ in range(40):
            *_, terminated, _, info = env.step(np.array([-1.0, along, 1.0]))
            assert not terminated and not info["robot_stopped"]
            hardest = max(hardest, env.unwrapped.parts()["agent"]["external_force"].max())
        assert 1 < hardest < 50


def test_joints_keep_their_speed_whatever_is_told():
    """An arm that is told to go as far as it can, this way and that: no joint is faster than its limit by more than a push makes it."""
    env = make("OpenCooler")
    env.reset(seed=4)
    [(twice, names)] = [(row[4], row[5]) for row in env.unwrapped.environment.observation_parts() if row[1] == "qvel"]
    arms = [place for place, name in enumerate(names) if name.startswith(("left_", "right_"))]
    most = np.array(twice)[arms] / 2
    rng = np.random.default_rng(3)
    for _ in range(60):
        _, _, terminated, truncated, _ = env.step(np.sign(rng.uniform(-1, 1, env.action_space.shape)))
        assert (np.abs(env.unwrapped.parts()["agent"]["qvel"][arms]) <= 1.2 * most).all()
        if terminated or truncated:
            env.reset(seed=5)
