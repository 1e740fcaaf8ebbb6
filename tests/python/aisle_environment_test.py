"""The robot in the aisles keeps Gymnasium's contract, too, and knows beforehand what it may know."""

import json
import warnings

import gymnasium
import mujoco
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import marketgen
from conftest import same

NAME = "MarketGen/InAisleCollection-v1"
JOINTS = 17  # lift, two arms of seven, head
CONTROL = {"pd_joint_pos": 17, "pd_joint_delta_pos": 17, "pd_ee_delta_pos": 6 + 3, "pd_ee_delta_pose": 12 + 3}


def make(store, aisle_episode, **options):
    env = gymnasium.make(NAME, store=store, **options)
    seen, info = env.reset(seed=1, options={"episode": aisle_episode})
    return env, seen, info


def still(env, seen, **numbers):
    action = np.zeros(env.action_space.shape, np.float32)
    if env.unwrapped.control_mode == "pd_joint_pos":
        action[:JOINTS] = seen["agent"]["qpos"][:JOINTS]
    names = env.unwrapped.action_names
    action[names.index("stop")] = -1
    for name, value in numbers.items():
        action[names.index(name)] = value
    return action


@pytest.mark.parametrize("options", [{}, {"obs_mode": "rgbd", "width": 32, "height": 24, "segmentation": True}])
def test_the_checker_has_no_complaint(aisle_file, options):
    env = gymnasium.make(NAME, episodes=aisle_file, render_mode="rgb_array", **options)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(env.unwrapped, skip_render_check=False)


def test_what_it_sees_and_knows_beforehand(store, aisle_episode):
    env, seen, info = make(store, aisle_episode, obs_mode="rgbd", width=48, height=32)
    assert seen["agent"]["qpos"].shape == (JOINTS + 2,) and seen["agent"]["qvel"].shape == (JOINTS,)
    assert seen["extra"]["tcp_pose"].shape == (2, 7)
    start = aisle_episode["start"]
    wanted = (start["x_m"], start["y_m"], np.radians(start["heading_deg"]))
    assert np.allclose(seen["extra"]["base_pose"], wanted, atol=1e-4)
    head = seen["sensor_data"]["head_camera"]
    assert head["rgb"].shape == (32, 48, 3) and head["rgb"].std() > 1 and (head["depth"] > 0).any()
    assert info["instruction"] == aisle_episode["instruction"]
    assert info["categories"] == [{"goal": 0, **place} for place in aisle_episode["categories"]]
    assert "products" not in info
    assert info["map"] == store.layout
    _, _, _, _, later = env.step(still(env, seen))
    assert set(later) == {"instruction", "time_s", "robot_stopped"}


def test_wrists_have_cameras_that_see_their_grippers(store, aisle_episode):
    wrists = ("left_wrist_camera", "right_wrist_camera")
    env, seen, _ = make(store, aisle_episode, obs_mode="rgbd", width=64, height=48, cameras=("head_camera", *wrists))
    assert list(seen["sensor_data"]) == ["head_camera", *wrists]
    base = seen["extra"]["base_pose"]
    turn = np.array([[np.cos(base[2]), -np.sin(base[2])], [np.sin(base[2]), np.cos(base[2])]])
    for hand, name in enumerate(wrists):
        tool = seen["extra"]["tcp_pose"][hand][:3]
        there = np.append(turn @ tool[:2] + base[:2], tool[2])
        camera = seen["sensor_param"][name]["cam2world_gl"]
        off = np.linalg.inv(camera) @ np.append(there, 1)
        assert 0.1 < -off[2] < 0.4 and abs(off[0]) < 0.02, f"the tool is ahead of {name}: {off}"
        depth = seen["sensor_data"][name]["depth"]
        assert 0 < depth[depth > 0].min() < 400, "mm to its own fingers"
        assert seen["sensor_data"][name]["rgb"].std() > 5


def test_the_map_errs_by_its_realism(store, aisle_episode):
    _, _, info = make(store, aisle_episode, obs_mode="state_robot", realism="hard")
    told, there = info["map"]["fixtures"], store.layout["fixtures"]
    off = [abs(a[axis] - b[axis]) for a, b in zip(told, there, strict=True) for axis in ("x_mm", "y_mm")]
    assert 10 < max(off) <= 50
    assert {**info["map"], "fixtures": 0} == {**store.layout, "fixtures": 0}


def test_goods_that_are_elsewhere_are_seen_there(store, aisle_episode, tmp_path):
    """With a realism that moves goods each episode has pictures of its own world, whichever came before it in the same environment."""
    moved = tmp_path / "moved.json"
    moved.write_text('{"schema": "market-realism/1", "name": "moved", "goods": {"place_m": 0.01, "turn_deg": 5}}')
    options = {"obs_mode": "rgbd", "width": 96, "height": 72}

    def picture(env, episode):
        seen, _ = env.reset(seed=1, options={"episode": episode})
        return seen["sensor_data"]["head_camera"]["depth"]

    other = {**aisle_episode, "seed": aisle_episode.get("seed", 0) + 1}
    env, fresh = (gymnasium.make(NAME, store=store, realism=str(moved), **options) for _ in range(2))
    shown = [picture(env, episode) for episode in (aisle_episode, other, aisle_episode)]
    as_stocked = picture(gymnasium.make(NAME, store=store, **options), aisle_episode)
    assert np.array_equal(shown[0], shown[2]) and np.array_equal(shown[1], picture(fresh, other))
    assert not np.array_equal(shown[0], shown[1]) and not np.array_equal(shown[0], as_stocked)


@pytest.mark.parametrize("control", CONTROL)
def test_every_control_mode_moves_the_arms_and_the_lift(store, aisle_episode, control):
    env, before, _ = make(store, aisle_episode, control_mode=control)
    assert env.action_space.shape == (CONTROL[control] + 2 + 2 + 1,)
    lift = {"lift": 0.35 if control == "pd_joint_pos" else 1.0}
    bent = before["agent"]["qpos"][2] + 0.1 if control == "pd_joint_pos" else 1.0
    arm = {"left_tool_x": 1.0} if "ee" in control else {"left_joint2": bent}
    for _ in range(4):
        after, *_ = env.step(still(env, before, **lift, **arm))
    moved = after["agent"]["qpos"] - before["agent"]["qpos"]
    assert moved[0] > 0.005
    assert np.abs(moved[1:8]).max() > 0.01
    assert np.abs(moved[8:15]).max() < 0.01, "the other arm holds still"


def test_a_camera_does_not_tell_where_the_robot_truly_stands(store, aisle_episode, tmp_path):
    """Rammed against a shelf the wheels slip. The camera's place slips with base_pose, and keeps to the base."""
    env, seen, _ = make(store, aisle_episode, obs_mode="rgbd", width=32, height=24)

    def from_reckoned_base(observation, place):
        x, y, heading = observation["extra"]["base_pose"].astype(float)
        turn = np.array([[np.cos(heading), np.sin(heading)], [-np.sin(heading), np.cos(heading)]])
        return turn @ (place - (x, y))

    def head(observation):
        return from_reckoned_base(observation, observation["sensor_param"]["head_camera"]["cam2world_gl"][:2, 3])

    (tmp_path / "model.mjb").write_bytes(env.unwrapped.mujoco_model())
    model = mujoco.MjModel.from_binary_path(str(tmp_path / "model.mjb"))
    data = mujoco.MjData(model)

    def truly(observation):
        mujoco.mj_setState(model, data, env.unwrapped.mujoco_state(), mujoco.mjtState.mjSTATE_INTEGRATION)
        mujoco.mj_kinematics(model, data)
        return from_reckoned_base(observation, data.body("base").xpos[:2])

    began = head(seen), truly(seen)
    assert np.allclose(began[1], 0, atol=1e-4)
    for _ in range(400):  # 6 m: to the other end of the shop, whatever stands there
        seen, *_ = env.step(still(env, seen, drive=0.3))
        if np.linalg.norm(truly(seen)) > 0.3:
            break  # before base_pose is at the end of its space, which is the shop
    assert np.linalg.norm(truly(seen)) > 0.1, "the wheels slipped"
    assert np.allclose(head(seen), began[0], atol=0.02)


def test_the_base_drives_and_the_tools_ride_along(store, aisle_episode):
    env, before, _ = make(store, aisle_episode)
    for _ in range(6):
        after, *_ = env.step(still(env, before, drive=0.1, turn=0.1))
    moved = after["extra"]["base_pose"] - before["extra"]["base_pose"]
    heading = before["extra"]["base_pose"][2]
    assert moved[:2] @ (np.cos(heading), np.sin(heading)) > 0.01 and moved[2] > 0.01
    assert np.allclose(after["extra"]["tcp_pose"], before["extra"]["tcp_pose"], atol=0.01), "in the base's frame"


def test_the_end_has_a_result(store, aisle_episode):
    env, seen, _ = make(store, aisle_episode)
    _, reward, terminated, truncated, info = env.step(still(env, seen, stop=1.0))
    assert (reward, terminated, truncated) == (0, True, False)
    assert info["failure_reason"] == "Unknown" and info["path_length"] >= 0 and info["spl"] == 0
    assert info["result"]["schema"] == "market-result/1"
    with pytest.raises(marketgen.Error) as caught:
        env.unwrapped.step(still(env, seen))
    assert caught.value.code == "episode.bad_action"


def test_dense_rewards_grow_on_the_way(store, aisle_episode):
    env, seen, _ = make(store, aisle_episode, reward_mode="dense")
    rewards = [env.step(still(env, seen))[1] for _ in range(2)]
    assert all(0 < reward < 1 for reward in rewards)


def test_episodes_of_a_file_are_picked_by_seed_or_number(aisle_file, aisle_episode):
    env = gymnasium.make(NAME, episodes=aisle_file)
    ids = {env.reset(seed=seed)[1]["instruction"] for seed in range(6)}
    assert ids == {"Fetch one.", "Fetch two."}
    assert env.reset(options={"episode": 1})[1]["instruction"] == "Fetch two."
    with pytest.raises(marketgen.Error, match="the file has 2"):
        env.reset(options={"episode": 2})
    first, _ = env.reset(seed=3)
    again, _ = env.reset(seed=3)
    assert same(first, again)


def test_files_and_stores_that_do_not_fit_are_said(store, aisle_file, aisle_episode, tmp_path):
    with pytest.raises(marketgen.Error, match="one of the two"):
        gymnasium.make(NAME, store=store, episodes=aisle_file)
    with pytest.raises(marketgen.Error) as caught:
        gymnasium.make(NAME, episodes=tmp_path / "none.jsonl")
    assert caught.value.code == "input.not_found"
    with pytest.raises(marketgen.Error) as caught:
        gymnasium.make("MarketGen/CheckoutUnloading-v1", episodes=aisle_file).reset(seed=1)
    assert caught.value.code == "episode.impossible"
    cut = tmp_path / "cut.jsonl"
    cut.write_text(aisle_file.read_text()[:-40])
    with pytest.raises(marketgen.Error) as caught:
        gymnasium.make(NAME, episodes=cut)
    assert caught.value.code == "episode.truncated"
    with pytest.raises(marketgen.Error) as caught:
        make(store, {**aisle_episode, "scene_hash": "0" * 32})
    assert caught.value.code == "episode.other_store"
    with pytest.raises(marketgen.Error) as caught:
        make(store, {**aisle_episode, "track": "checkout"})
    assert caught.value.code == "episode.unknown_track"


def test_bad_actions_change_nothing(store, aisle_episode):
    env, seen, _ = make(store, aisle_episode)
    env = env.unwrapped
    before = env.state_hash()
    with pytest.raises(marketgen.Error, match="drive"):
        env.step(still(env, seen, drive=np.nan))
    with pytest.raises(marketgen.Error, match="shape"):
        env.step(still(env, seen)[1:])
    assert env.state_hash() == before


def test_stepping_before_a_reset_is_said(store):
    with pytest.raises(marketgen.Error, match="reset it first"):
        gymnasium.make(NAME, store=store).unwrapped.step(np.zeros(22, np.float32))


def test_a_cup_instead_of_the_right_gripper(store, aisle_episode):
    env, seen, _ = make(store, aisle_episode | {"tools": "suction"}, tools="suction")
    assert seen["agent"]["external_force"].shape == (2,)
    assert seen["agent"]["sealed"].shape == (2,) and not seen["agent"]["sealed"].any()
    cup = JOINTS + 1  # its opening
    sucks = env.step(still(env, seen, right_tool_opening=-1))[0]["agent"]
    assert sucks["qpos"][cup] == 0 and not sucks["sealed"].any(), "nothing is there"
    lets_go = env.step(still(env, seen, right_tool_opening=1))[0]["agent"]
    assert lets_go["qpos"][cup] == pytest.approx(0.05)
    with pytest.raises(marketgen.Error, match="the episode is for"):
        make(store, aisle_episode | {"tools": "suction"})
    with pytest.raises(marketgen.Error, match="suctoin"):
        gymnasium.make(NAME, store=store, tools="suctoin")


@pytest.mark.parametrize("options", [{"tools": "suction"}])
def test_the_checker_has_no_complaint_of_a_cup(store, aisle_episode, options):
    env = gymnasium.make(NAME, store=store, **options).unwrapped
    env.setup.draw = lambda seeds, progress=None: [json.dumps(aisle_episode | options)] * len(seeds)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.filterwarnings("ignore", message=".*infinity.*")
        check_env(env, skip_render_check=True)
