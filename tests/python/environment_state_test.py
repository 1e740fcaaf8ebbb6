"""A state goes on bit for bit, wherever it is put; environments are copied and pickled; MuJoCo's own package opens the model."""

import copy
import pickle
import subprocess
import sys

import gymnasium
import mujoco
import numpy as np
import pytest

import marketgen
from conftest import same

IDS = {
    "checkout": "MarketGen/CheckoutUnloading-v1",
    "aisle": "MarketGen/InAisleCollection-v1",
    "one-item": "MarketGen/CheckoutOneItem-v1",
}


def actions_of(env, count, seed):
    rng = np.random.default_rng(seed)
    actions = rng.uniform(-1, 1, (count, *env.action_space.shape)).astype(np.float32)
    if "stop" in env.unwrapped.action_names:
        actions[:, -1] = -1
    return actions


def trace(env, actions):
    """All that a run shows."""
    seen = []
    for action in actions:
        seen.append((*env.step(action), env.unwrapped.state_hash()))
    return seen


def begun(kind, steps=6, **options):
    env = gymnasium.make(IDS[kind], **options)
    env.reset(seed=3)
    trace(env, actions_of(env, steps, 1))
    return env


@pytest.mark.parametrize("kind", IDS)
def test_a_state_goes_on_bit_for_bit(kind):
    env = begun(kind)
    state = env.unwrapped.get_state()
    before = env.unwrapped.observation()
    further = actions_of(env, 8, 2)
    first = trace(env, further)
    assert same(env.unwrapped.set_state(state), before)
    assert env.unwrapped.get_state() == state
    assert same(trace(env, further), first)
    other = gymnasium.make(IDS[kind])
    other.reset(seed=99)  # another episode, and another place in it
    assert same(other.unwrapped.set_state(state), before)
    assert same(trace(other, further), first)
    for each in (env, other):
        each.unwrapped.set_state(state)
        each.reset()
    assert env.unwrapped.episode == other.unwrapped.episode, "the generator of episodes goes on, too"


def test_the_end_is_part_of_a_state():
    env = begun("one-item")
    trace(env, actions_of(env, 144, 5))
    ended = env.unwrapped.get_state()
    result = env.unwrapped.environment.result()
    assert result
    env.reset(seed=1)
    env.unwrapped.set_state(ended)
    assert env.unwrapped.environment.result() == result
    with pytest.raises(marketgen.Error, match="reset"):
        env.unwrapped.step(env.action_space.sample())


def test_what_was_held_and_pushed_is_part_of_a_state():
    """The ledger of side effects counts on where it was."""
    env = gymnasium.make(IDS["checkout"], control_mode="pd_ee_delta_pos", stop_action=True)
    env.reset(seed=3)
    down = np.array([1, 0, -1, 1, -1], np.float32)
    trace(env, [down] * 25)  # into the basket
    state = env.unwrapped.get_state()
    ends = []
    for _ in range(2):
        env.unwrapped.set_state(state)
        trace(env, [down] * 10)
        ends.append(env.step(np.array([0, 0, 0, 1, 1], np.float32))[4]["result"])
    assert ends[0] == ends[1]
    assert sum(ends[0]["side_effects"][key] for key in ("light_contacts", "firm_contacts", "hard_contacts")) > 0


@pytest.mark.parametrize("kind", IDS)
@pytest.mark.parametrize("way", [copy.deepcopy, copy.copy, lambda env: pickle.loads(pickle.dumps(env))])
def test_copies_go_on_by_themselves(kind, way):
    env = begun(kind, steps=3)
    other = way(env if way is not copy.copy else env.unwrapped)
    assert other.unwrapped is not env.unwrapped
    further = actions_of(env, 3, 7)
    first = trace(env, further)
    assert same(trace(other, further), first)


def test_one_that_has_not_begun_is_copied_too():
    env = copy.deepcopy(gymnasium.make(IDS["one-item"], obs_mode="state_robot"))
    assert env.reset(seed=1)[0].shape == env.observation_space.shape


def test_many_are_copied_and_set():
    many = gymnasium.make_vec(IDS["one-item"], num_envs=2)
    many.reset(seed=1)
    rng = np.random.default_rng(3)
    actions = rng.uniform(-1, 1, (6, *many.action_space.shape)).astype(np.float32)
    trace = lambda these, of: [these.step(action)[:4] for action in of]  # noqa: E731
    trace(many, actions[:3])
    state = many.get_state()
    others = [copy.deepcopy(many), pickle.loads(pickle.dumps(many))]
    first = trace(many, actions[3:])
    assert all(same(trace(other, actions[3:]), first) for other in others)
    many.set_state(state)
    assert same(trace(many, actions[3:]), first)
    with pytest.raises(marketgen.Error, match="1 states for 2"):
        many.set_state(state[:1])


def test_another_process_goes_on(tmp_path):
    env = begun("one-item")
    state, further = env.unwrapped.get_state(), actions_of(env, 5, 2)
    trace(env, further)
    (tmp_path / "state").write_bytes(state)
    np.save(tmp_path / "actions.npy", further)
    program = (
        "import sys, numpy, gymnasium, marketgen\n"
        "env = gymnasium.make('MarketGen/CheckoutOneItem-v1').unwrapped\n"
        "env.set_state(open(sys.argv[1], 'rb').read())\n"
        "for action in numpy.load(sys.argv[2]): env.step(action)\n"
        "print(env.state_hash())"
    )
    command = [sys.executable, "-c", program, str(tmp_path / "state"), str(tmp_path / "actions.npy")]
    said = subprocess.run(command, check=True, capture_output=True, text=True, timeout=120).stdout
    assert said.strip() == env.unwrapped.state_hash()


@pytest.mark.parametrize("spoil", ["nothing", "head", "half", "flipped", "text"])
def test_bytes_that_are_no_state_are_said_and_change_nothing(spoil):
    env = begun("one-item").unwrapped
    state, before = env.get_state(), env.state_hash()
    middle = len(state) - 20000
    bad = {
        "nothing": b"",
        "head": b"x" + state[1:],
        "half": state[: len(state) // 2],
        "flipped": state[:middle] + bytes([state[middle] ^ 1]) + state[middle + 1 :],
        "text": "state",
    }[spoil]
    with pytest.raises(marketgen.Error) as caught:
        env.set_state(bad)
    assert caught.value.code == "physics.bad_command"
    assert env.state_hash() == before and env.get_state() == state


def test_a_state_of_another_store_is_said(store):
    env = gymnasium.make(IDS["checkout"], store=store).unwrapped
    state = begun("checkout").unwrapped.get_state()
    with pytest.raises(marketgen.Error) as caught:
        env.set_state(state)
    assert caught.value.code == "episode.other_store"


def test_before_the_first_reset_there_is_no_state():
    with pytest.raises(marketgen.Error, match="reset"):
        gymnasium.make(IDS["one-item"]).unwrapped.get_state()


def middle_of(item):
    """Of its box, in the frame of its pose."""
    turned = np.zeros(3)
    mujoco.mju_rotVecQuat(turned, np.array([0, 0, item["size"][2] / 2]), item["pose"][3:].astype(float))
    return item["pose"][:3] + turned


@pytest.mark.parametrize("kind", ["checkout", "aisle"])
def test_mujoco_opens_the_model_and_its_state(kind, tmp_path):
    env = begun(kind).unwrapped
    (tmp_path / "model.mjb").write_bytes(env.mujoco_model())
    model = mujoco.MjModel.from_binary_path(str(tmp_path / "model.mjb"))
    data = mujoco.MjData(model)
    mujoco.mj_setState(model, data, env.mujoco_state(), mujoco.mjtState.mjSTATE_INTEGRATION)
    mujoco.mj_forward(model, data)
    if kind == "checkout":
        items = env.items()
        middles = [data.body(f"pool-{i}").xipos - data.body("link0").xpos for i in range(len(items))]
        for item in items:  # in any order: a middle of mass is in its pack
            assert min(np.linalg.norm(middle - middle_of(item)) for middle in middles) < 0.2 * max(item["size"])
    lower, upper = model.joint(1 if kind == "checkout" else 0).range
    assert np.isfinite([lower, upper]).all() and data.time == pytest.approx(0.3)
