"""What a learner needs: bounds that hold, a truth that is true, an end without `stop`, and a task that can be done."""

import warnings

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.utils.env_checker import check_env

import marketgen

CHECKOUT, AISLE, ONE_ITEM = (
    f"MarketGen/{name}-v1" for name in ("CheckoutUnloading", "InAisleCollection", "CheckoutOneItem")
)
MODES = ("state", "state_robot", "rgbd", "pointcloud")
SMALL = {"width": 32, "height": 24, "points": 200, "segmentation": True}


def boxes_of(space, name=""):
    if isinstance(space, spaces.Dict):
        return {k: v for key, part in space.items() for k, v in boxes_of(part, f"{name}/{key}").items()}
    return {name: space}


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("name", [CHECKOUT, AISLE])
def test_every_number_has_bounds_and_keeps_them(name, mode):
    options = SMALL if mode in ("rgbd", "pointcloud") else {}
    env = gymnasium.make(name, obs_mode=mode, stop_action=False, control_mode="pd_joint_pos", **options)
    for where, box in boxes_of(env.observation_space).items():
        assert np.isfinite(box.low).all() and np.isfinite(box.high).all(), where
        assert (box.low <= box.high).all(), where
    assert np.isfinite(env.action_space.low).all() and np.isfinite(env.action_space.high).all()
    env.action_space.seed(1)
    seen, _ = env.reset(seed=1)
    for _ in range(4 if options else 12):  # wild: from one end of the joints to the other
        assert env.observation_space.contains(seen)
        seen, *_ = env.step(env.action_space.sample())


@pytest.mark.parametrize("name", [CHECKOUT, AISLE, ONE_ITEM])
def test_the_preset_makes_one_row_of_numbers(name):
    env = gymnasium.make(name, preset="rl")
    assert isinstance(env.observation_space, spaces.Box) and len(env.observation_space.shape) == 1
    assert env.observation_space.dtype == np.float32
    assert "stop" not in env.unwrapped.action_names
    assert (env.action_space.low == -1).all() and (env.action_space.high == 1).all()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(env.unwrapped, skip_render_check=True)


def test_options_count_before_the_preset():
    env = gymnasium.make(CHECKOUT, preset="rl", control_mode="pd_joint_delta_pos", flat=False)
    assert env.unwrapped.control_mode == "pd_joint_delta_pos" and isinstance(env.observation_space, spaces.Dict)


@pytest.mark.parametrize(
    ("options", "word"),
    [
        ({"preset": "fast"}, "preset"),
        ({"obs_mode": "truth"}, "obs_mode"),
        ({"flat": True, "obs_mode": "rgbd"}, "flat"),
        ({"obs_mode": "pointcloud", "points": 0}, "points"),
        ({"obs_mode": "pointcloud", "cameras": ()}, "cameras"),
    ],
)
def test_options_that_cannot_be_are_said(options, word):
    with pytest.raises(marketgen.Error) as caught:
        gymnasium.make(CHECKOUT, **options)
    assert caught.value.code == "usage.bad_flag" and word in str(caught.value)


def test_an_option_that_there_is_not_is_said():
    with pytest.raises(TypeError, match="colour"):
        gymnasium.make(CHECKOUT, colour="red")


def test_without_stop_a_random_agent_lives():
    env = gymnasium.make(CHECKOUT, stop_action=False)
    env.action_space.seed(1)
    env.reset(seed=1)
    assert not any(env.step(env.action_space.sample())[2] for _ in range(60))


def test_the_state_is_what_items_say():
    env = gymnasium.make(CHECKOUT)
    seen, info = env.reset(seed=2)
    for _ in range(3):
        action = np.zeros(env.action_space.shape, np.float32)
        action[-1] = -1
        seen, *_ = env.step(action)
    truth, items = seen["privileged"], env.unwrapped.items()
    count = len(items)
    assert truth["item_present"].tolist() == [1.0] * count + [0.0] * (len(truth["item_present"]) - count)
    assert np.allclose(truth["item_pose"][:count], [item["pose"] for item in items], atol=1e-6)
    assert np.allclose(truth["item_size"][:count], [item["size"] for item in items], atol=1e-6)
    assert truth["item_goal"][:count].tolist() == [float(item["goal"]) for item in items]
    assert [item["sku"] for item in items] == [item["sku"] for item in env.unwrapped.episode["items"]]
    assert {item["sku"] for item in items if item["goal"]} == {goal["sku"] for goal in env.unwrapped.episode["goals"]}
    to_item = seen["extra"]["tcp_pose"][:3] + truth["tcp_to_item"][:count]
    assert np.abs(to_item - truth["item_pose"][:count, :3]).max() < 0.2, "one frame: they meet within the items"
    assert info["products"] == {item["segmentation_id"]: item["sku"] for item in items}


def test_equal_instructions_have_equal_ids():
    env = gymnasium.make(CHECKOUT)
    ids = [env.reset(options={"episode": number})[0]["privileged"]["instruction_id"].item() for number in (0, 1, 0)]
    assert ids[0] == ids[2] != ids[1]


def test_robot_state_has_no_truth():
    seen, _ = gymnasium.make(CHECKOUT, obs_mode="state_robot").reset(seed=1)
    assert set(seen) == {"agent", "extra"}


def test_more_items_than_there_is_room_for_is_said():
    env = gymnasium.make(CHECKOUT)
    env.reset(seed=1)
    episode = env.unwrapped.episode
    crowded = {**episode, "items": episode["items"] * 5}
    with pytest.raises(marketgen.Error, match="state_robot"):
        env.reset(options={"episode": crowded})


@pytest.mark.parametrize("name", [CHECKOUT, AISLE])
def test_points_lie_on_the_things_they_show(name):
    env = gymnasium.make(name, obs_mode="pointcloud", points=3000, width=96, height=72, segmentation=True)
    seen, info = env.reset(seed=2)
    cloud = seen["pointcloud"]
    assert cloud["xyz"].shape == (3000, 3) and cloud["rgb"].std() > 5
    again = env.reset(seed=2)[0]["pointcloud"]
    assert all(np.array_equal(cloud[plane], again[plane]) for plane in cloud)
    if name == AISLE:
        lowest = []
        for seed in range(2, 7):  # not every robot begins with the floor in sight
            seen, info = env.reset(seed=seed)
            cloud = seen["pointcloud"]
            lowest.append(np.abs(cloud["xyz"][cloud["segmentation"][:, 0] == 1][:, 2]).min(initial=np.inf))
        assert min(lowest) < 0.01, f"the floor is at 0 in the frame of the robot's base: {lowest}"
        shown = set(np.unique(cloud["segmentation"])) & set(info["products"])
        assert shown
        return
    near = 0
    for item in env.unwrapped.items():
        points = cloud["xyz"][cloud["segmentation"][:, 0] == item["segmentation_id"]].astype(float)
        w, *axis = item["pose"][3:]
        conjugate = -np.array(axis)
        local = points - item["pose"][:3]
        local = local + 2 * np.cross(conjugate, np.cross(conjugate, local) + w * local)
        low, high = item["size"] * (-0.5, -0.5, 0) - 0.001, item["size"] * (0.5, 0.5, 1) + 0.001
        assert ((local >= low) & (local <= high)).all(), item["sku"]
        near += len(points)
    assert near > 50


def test_cameras_and_poses_share_a_frame():
    env = gymnasium.make(CHECKOUT, obs_mode="rgbd", **{"width": 64, "height": 48})
    seen, _ = env.reset(seed=1)
    assert np.array_equal(seen["extra"]["base_pose"], np.zeros(3, np.float32))
    eye = seen["sensor_param"]["scene_camera"]["cam2world_gl"][:3, 3]
    assert np.allclose(eye, (0.82, 0, 0.95), atol=1e-5), "where the station's row puts it"
    hand = seen["sensor_param"]["wrist_camera"]["cam2world_gl"][:3, 3]
    assert np.linalg.norm(hand - seen["extra"]["tcp_pose"][:3]) < 0.3


def pushed_onto_the_area(env, seed):
    """Down behind the box, along it to the area, and away: (rewards, info at the end)."""
    env.reset(seed=seed)
    task, phase, rewards = env.unwrapped, 0, []
    for _ in range(150):
        [item] = task.items()
        box, tool = item["pose"][:3], task.parts()["extra"]["tcp_pose"][:3]
        behind = box[1] + max(item["size"][:2]) / 2 + 0.03
        if phase == 2 and box[1] < -0.13:
            phase = 3
        goal = [(box[0], behind, 0.14), (box[0], behind, 0.03), (box[0], tool[1] - 0.01, 0.03), (tool[0], tool[1] + 0.1, 0.2)]
        way = np.subtract(goal[phase], tool)
        if phase < 2 and np.abs(way).max() < 0.015:
            phase += 1
        action = np.append(np.clip(way / 0.02, -1, 1), -1).astype(np.float32)
        _, reward, terminated, truncated, info = env.step(action)
        rewards.append(reward)
        if terminated or truncated:
            return rewards, terminated, info
    raise AssertionError("it must have ended")


def test_the_first_task_can_be_done_and_pays():
    env = gymnasium.make(ONE_ITEM)
    ends = [pushed_onto_the_area(env, seed) for seed in range(8)]
    done = [(rewards, info) for rewards, terminated, info in ends if terminated]
    assert len(done) >= 6
    for rewards, info in done:
        assert info["is_success"] and info["failure_reason"] == "None"
        assert 0.6 < sum(rewards) <= 1, "what was missing at the start"
        assert max(map(abs, rewards)) < 0.5, "it comes little by little"


def test_nothing_done_is_cut_off_without_success():
    env = gymnasium.make(ONE_ITEM)
    env.reset(seed=1)
    total = 0
    for step in range(1, 200):
        _, reward, terminated, truncated, info = env.step(np.zeros(env.action_space.shape, np.float32))
        total += reward
        if terminated or truncated:
            break
    assert (step, terminated, truncated, info["is_success"]) == (150, False, True, False)
    assert abs(total) < 0.1


def test_closed_fingers_do_not_hold_the_arm():
    """They press on one another beyond their stops, from where no inverse kinematics was found: the arm stood still."""
    env = gymnasium.make(ONE_ITEM, flat=False)
    before = env.reset(seed=0)[0]["extra"]["tcp_pose"]
    for _ in range(15):
        after = env.step(np.array([0, 0.5, 0.5, -1], np.float32))[0]["extra"]["tcp_pose"]
    assert (after - before)[1:3].min() > 0.1


def test_many_in_one_do_what_one_does():
    many = gymnasium.make_vec(ONE_ITEM, num_envs=2)
    rows, infos = many.reset(seed=[4, 5])
    assert rows.shape == (2, *many.single_observation_space.shape) and many.observation_space.contains(rows)
    [skus] = [each for number, each in infos["products"].items() if isinstance(number, int)]
    assert list(skus) == [env.episode["goals"][0]["sku"] for env in many.unwrapped.envs]
    one = gymnasium.make(ONE_ITEM)
    one.reset(seed=5)
    rng = np.random.default_rng(1)
    for _ in range(5):
        actions = rng.uniform(-1, 1, many.action_space.shape).astype(np.float32)
        rows, rewards, *_ = many.step(actions)
        row, reward, *_ = one.step(actions[1])
        assert np.array_equal(rows[1], row) and rewards[1] == reward


def test_evaluation_refuses_the_truth(checkout_file, tmp_path):
    with pytest.raises(marketgen.Error, match="state_robot"):
        marketgen.evaluate(checkout_file, lambda seen: np.zeros(9), tmp_path / "scores", act_limit_s=0, obs_mode="state")
    seen_groups = set()

    def look_and_stop(seen):
        seen_groups.update(seen)
        return np.append(np.zeros(8), 1.0)

    marketgen.evaluate(checkout_file, look_and_stop, tmp_path / "robot", act_limit_s=0, jobs=1)
    assert "privileged" not in seen_groups
