"""Policies in servers of others: the protocol, rows of adapters, and everything that can be wrong with a server."""

import contextlib
import json
import pathlib
import subprocess
import sys
import time

import numpy as np
import pytest

import marketgen
from marketgen.outside.adaptation import Adaptation
from marketgen.outside.adapters import adapter_named, read_rows
from marketgen.outside.openpi import OpenPi, packed, unpacked
from marketgen.outside.robot_numbers import RobotNumbers, rotation_vector
from marketgen.policy_process import PolicyFailed

pytest.importorskip("websockets")
pytest.importorskip("msgpack")

SERVER = pathlib.Path(__file__).with_name("openpi_server.py")
ROW = """
mine:
  about: numbers alone
  observation:
    observation.state: {numbers: all}
  action: {keys: [actions], space: joint_targets, numbers: all}
"""
NOT_ISOLATED = pytest.mark.filterwarnings("ignore::marketgen.IsolationWarning")


@contextlib.contextmanager
def server(folder, fault="nothing", mark=None, program=SERVER):
    """host:port of one that runs."""
    port = folder / f"port-{fault}"
    words = [sys.executable, program, port, fault, *([mark] if mark else [])]
    with subprocess.Popen(list(map(str, words))) as process:
        try:
            until = time.monotonic() + 60
            while not port.exists():
                assert process.poll() is None and time.monotonic() < until
                time.sleep(0.05)
            yield f"localhost:{port.read_text()}"
        finally:
            process.kill()


@pytest.fixture
def adapter(tmp_path):
    file = tmp_path / "mine.yaml"
    file.write_text(ROW)
    return str(file)


@NOT_ISOLATED
def test_a_server_acts(tasks, tmp_path, adapter):
    with server(tmp_path) as address:
        scores = marketgen.evaluate(tasks, f"openpi://{address}", tmp_path / "a", adapter=adapter, jobs=2)
        again = marketgen.evaluate(tasks, f"remote:openpi://{address}", tmp_path / "b", adapter=adapter, name="pi")
    assert [result["failure"] for result in scores.results] == ["Unknown", "Unknown"]
    assert [result["steps"] for result in scores.results] == [2, 2]  # the third of its four steps says stop
    assert {result["isolation"] for result in scores.results} == {"none"}
    assert {result["policy"] for result in scores.results} == {"openpi(mine)"}
    assert {result["policy"] for result in again.results} == {"pi"}
    assert [result["state_hash"] for result in again.results] == [result["state_hash"] for result in scores.results]


@NOT_ISOLATED
@pytest.mark.parametrize(
    ("fault", "code", "said"),
    [
        ("hangs", "policy_hung", "2 s"),
        ("late", "policy_hung", "2 s"),
        ("closes", "server_lost", "closed"),
        ("raises", "policy_failed", "no such prompt"),
        ("babbles", "bad_answer", "msgpack"),
        ("objects", "bad_answer", "object"),
        ("nan", "bad_answer", "step 2 of its actions has nan for joint4"),
        ("narrow", "bad_answer", "7 numbers"),
        ("short", "bad_answer", "(0, 9)"),
        ("deep", "bad_answer", "(2, 2, 2, 9)"),
        ("words", "bad_answer", "no array"),
        ("unnamed", "bad_answer", "'action'"),
        ("list", "bad_answer", "list"),
    ],
)
def test_what_is_wrong_with_a_server_fails_its_episode_and_the_next_follows(tasks, tmp_path, adapter, fault, code, said):
    with server(tmp_path, fault, tmp_path / "mark") as address:
        scores = marketgen.evaluate(tasks, f"openpi://{address}", tmp_path / "a", adapter=adapter, jobs=1, hang_limit_s=2)
    first, then = scores.results
    assert first["failure"] == "PolicyError" and f"episode.{code}" in first["detail"] and said in first["detail"]
    assert then["failure"] == "Unknown" and then["detail"] == "" and then["steps"] == 2


@NOT_ISOLATED
def test_what_was_finished_is_kept_when_a_server_dies(tasks, tmp_path, adapter):
    """The episode in which it died is a result; without a server there is no next, and --resume goes on with another one."""
    with server(tmp_path, "dies") as address, pytest.raises(marketgen.Error) as ended:
        marketgen.evaluate(tasks, f"openpi://{address}", tmp_path / "a", adapter=adapter, jobs=1, start_limit_s=1)
    assert ended.value.code == "episode.no_policy" and address in ended.value.where
    [kept] = map(json.loads, (tmp_path / "a" / "results.jsonl").read_text().splitlines())
    assert kept["failure"] == "PolicyError" and "episode.server_lost" in kept["detail"]
    with server(tmp_path) as address:
        scores = marketgen.evaluate(tasks, f"openpi://{address}", tmp_path / "a", adapter=adapter, resume=True)
    assert scores.results[0] == kept and scores.results[1]["failure"] == "Unknown"


@NOT_ISOLATED
@pytest.mark.parametrize("fault", ["protocol", "nowhere"])
def test_a_run_without_its_server_does_not_begin(tasks, tmp_path, adapter, fault):
    with server(tmp_path, fault) as address:
        where = address if fault == "protocol" else "localhost:9"
        with pytest.raises(marketgen.Error) as refused:
            marketgen.evaluate(tasks, f"openpi://{where}", tmp_path / "a", adapter=adapter, start_limit_s=1)
    assert refused.value.code == "episode.no_policy" and refused.value.where == where
    assert not (tmp_path / "a" / "results.jsonl").exists()


def test_the_command_is_the_call(tasks, tmp_path, adapter):
    def command(*words):
        return subprocess.run([sys.executable, "-m", "marketgen.evaluate", "--episodes", tasks, *words], capture_output=True, text=True)

    marketgen.evaluate(tasks, "random", tmp_path / "random")
    with server(tmp_path) as address:
        words = ("--policy", f"openpi://{address}", "--adapter", adapter, "-o", tmp_path / "a", "--quiet")
        done = command(*words, "--against", tmp_path / "random")
        twice = command(*words)
    assert done.returncode == 0, done.stderr
    assert "SR strict" in done.stdout and "openpi(mine)" in done.stdout and "random" in done.stdout
    assert twice.returncode == 2 and "store.exists" in twice.stderr
    gone = command(*words, "--resume", "--start-limit-s", "1")
    assert gone.returncode == 2 and "episode.no_policy" in gone.stderr


@pytest.mark.parametrize(
    ("policy", "options", "said"),
    [
        ("openpi://localhost", {}, "HOST:PORT"),
        ("openpi://localhost:99999", {}, "HOST:PORT"),
        ("openai://localhost:80", {}, "openpi://HOST:PORT"),
        ("openpi://localhost:80", {"adapter": "openpi-libera"}, "openpi-libero"),
        ("openpi://localhost:80", {"control_mode": "pd_joint_pos"}, "leave it out"),
        ("openpi://localhost:80", {"policy_files": ["/tmp"]}, "its own affair"),
        ("random", {"adapter": "marketgen"}, "rows of adapters"),
        ("random", {"name": "luck"}, "random"),
        ("python:nowhere_at_all:Mine", {}, "no such module"),
        ("python:policies", {}, "MODULE:NAME"),
    ],
)
@NOT_ISOLATED
def test_what_cannot_be_asked_is_said(tasks, tmp_path, policy, options, said):
    with pytest.raises(marketgen.Error) as refused:
        marketgen.evaluate(tasks, policy, tmp_path / "a", **options)
    assert said in str(refused.value) and refused.value.code in ("usage.bad_flag", "input.not_found")


def test_a_policy_of_a_module(tasks, tmp_path):
    scores = marketgen.evaluate(tasks, "python:policies:StopsAtOnce", tmp_path / "a")
    assert [result["failure"] for result in scores.results] == ["NoGrasp", "NoGrasp"]
    assert {result["policy"] for result in scores.results} == {"StopsAtOnce"}


# ---- The protocol ----


def test_messages_are_those_of_openpi_client():
    """Bytes as openpi-client 0.1.2 packs them, of its msgpack_numpy.packb."""
    value = {"actions": np.arange(6, dtype=np.float32).reshape(2, 3), "prompt": "take it"}
    theirs = bytes.fromhex(
        "82a7616374696f6e7384c40b5f5f6e6461727261795f5fc3c40464617461c418000000000000803f"
        "0000004000004040000080400000a040c4056474797065a33c6634c4057368617065920203a670726f"
        "6d7074a774616b65206974"
    )
    assert packed(value) == theirs
    read = unpacked(theirs)
    assert read["prompt"] == "take it" and np.array_equal(read["actions"], value["actions"])


def test_a_step_over_loopback_takes_little(tmp_path):
    """3 ms is what is allowed; the least of many says what it costs, whoever else computes."""
    seen = {"observation.state": np.zeros(27, np.float32), **{f"camera{i}": np.zeros((224, 224, 3), np.uint8) for i in (1, 2)}}
    with server(tmp_path) as address:
        model = OpenPi(address, 10, 10)
        model.begin()
        taken = []
        for _ in range(100):
            began = time.perf_counter()
            model.infer(seen)
            taken.append(time.perf_counter() - began)
        model.close()
    assert min(taken) < 0.003, sorted(taken)[:5]


def test_an_interrupt_is_heard_while_a_server_hangs(tmp_path, monkeypatch):
    with server(tmp_path, "hangs") as address:
        model = OpenPi(address, 10, 0)
        model.begin()
        monkeypatch.setattr(marketgen._core, "check_interrupt", interrupted)
        with pytest.raises(KeyboardInterrupt):
            model.infer({"observation.state": np.zeros(9, np.float32)})


def interrupted():
    raise KeyboardInterrupt


# ---- Rows of adapters ----

ACTIONS = (*(f"joint{number}" for number in range(1, 8)), "tool_opening", "stop")
ROBOT = (
    *(f"qpos.joint{number}" for number in range(1, 8)),
    *("qpos.tool_opening", *(f"tcp_pose.tool_{part}" for part in ("x", "y", "z", "qw", "qx", "qy", "qz")), "stopped"),
)
HALF = np.sqrt(0.5)
SEEN = {
    "agent": {"qpos": np.array([1, 2, 3, 4, 5, 6, 7, 0.08]), "stopped": np.zeros(1)},
    "extra": {"tcp_pose": np.array([0.3, 0.1, 0.4, HALF, 0, 0, HALF])},
    "sensor_data": {"scene_camera": {"rgb": np.full((4, 6, 3), 255, np.uint8)}, "wrist_camera": {"rgb": np.zeros((4, 6, 3), np.uint8)}},
}


def task(names=ACTIONS, units=None):
    return {
        "instruction": "Take it.",
        "action_names": names,
        "action_units": units or [(1, "rad")] * 7 + [(0, ""), (0, "")],
        "robot_names": ROBOT,
    }


def test_every_row_of_the_program_is_readable():
    rows = read_rows(str(pathlib.Path(marketgen._core.data_folder()) / "policy_adapters.yaml"))
    assert {"marketgen", "openpi-libero", "openpi-droid"} <= rows.keys()
    for row in rows.values():
        assert row.about and row.options()["obs_mode"] == "rgbd"


def test_observations_are_as_the_model_has_them():
    told = Adaptation(adapter_named("openpi-libero"), task(TOOL_ACTIONS, TOOL_UNITS), SEEN).told(SEEN)
    assert told["prompt"] == "Take it." and told["observation/image"].dtype == np.uint8
    assert np.allclose(told["observation/state"], [0.3, 0.1, 0.4, 0, 0, np.pi / 2, 0.04, -0.04])
    droid = Adaptation(adapter_named("openpi-droid"), task(units=[(0.1, "rad")] * 7 + [(0, ""), (0, "")]), SEEN).told(SEEN)
    assert np.allclose(droid["observation/joint_position"], np.arange(1, 8)) and np.allclose(droid["observation/gripper_position"], 0)


TOOL_ACTIONS = ("tool_x", "tool_y", "tool_z", "tool_turn_x", "tool_turn_y", "tool_turn_z", "tool_opening", "stop")
TOOL_UNITS = [(0.02, "m")] * 3 + [(0.1, "rad")] * 3 + [(0, ""), (0, "")]


def test_actions_are_as_the_environment_has_them():
    """Half a unit of LIBERO is 25 mm, which is 1.25 of the environment's 20 mm; its gripper is closed at 1."""
    adaptation = Adaptation(adapter_named("openpi-libero"), task(TOOL_ACTIONS, TOOL_UNITS), SEEN)
    chunk = np.zeros((10, 7))
    chunk[:, 0], chunk[:, 5], chunk[:, 6] = 0.5, -0.1, 1
    actions = adaptation.actions({"actions": chunk})
    assert actions.shape == (5, 8)  # of ten it executes five
    assert np.allclose(actions[0], [1.25, 0, 0, 0, 0, -0.5, -1, -1])


MOVES = ("tool_x", "tool_y", "tool_z", "tool_opening", "stop")


def led(tmp_path, numbers):
    """Of a model that says places of the tool, in centimetres."""
    file = tmp_path / "row.yaml"
    file.write_text(ROW.replace("joint_targets, numbers: all", f"tool_targets, unit_m: 0.01, numbers: {numbers}"))
    return Adaptation(adapter_named(str(file)), task(MOVES, [(0.02, "m")] * 3 + [(0, ""), (0, "")]), SEEN)


def test_targets_of_the_tool_are_steps_from_where_it_is_when_they_are_executed(tmp_path):
    """A third of the way each: of the centimetre ahead and down a sixth of the environment's 20 mm."""
    adaptation = led(tmp_path, "[tool_x, tool_y, tool_z, tool_opening]")
    actions = adaptation.actions({"actions": np.array([[31, 10, 39, -1.0]] * 2)})
    assert np.allclose(adaptation.executed(actions[0], SEEN), [1 / 6, 0, -1 / 6, -1, -1], atol=1e-6)  # the tool is at 0.3, 0.1, 0.4 m
    moved = {**SEEN, "extra": {**SEEN["extra"], "tcp_pose": SEEN["extra"]["tcp_pose"] + np.array([[0.01, 0, -0.005, 0, 0, 0, 0]])}}
    assert np.allclose(adaptation.executed(actions[1], moved), [0, 0, -1 / 12, -1, -1], atol=1e-6)


def test_a_far_target_is_gone_to_straight(tmp_path):
    adaptation = led(tmp_path, "[tool_x, tool_z, '-']")
    [action] = adaptation.actions({"actions": np.array([[110, 20.0, 7]])})
    assert np.allclose(adaptation.executed(action, SEEN), [1, 0, -0.25, 1, -1], atol=1e-6)  # 0.8 m ahead and 0.2 m down; to the side it stays


def test_what_the_model_does_not_say_stays_as_it_is(tmp_path):
    file = tmp_path / "row.yaml"
    file.write_text(
        ROW.replace("all}\n  action", "['qpos.joint*', stopped]}\n  action").replace("numbers: all}", "numbers: ['-', joint2]}")
    )
    adaptation = Adaptation(adapter_named(str(file)), task(), SEEN)
    assert np.allclose(adaptation.told(SEEN)["observation.state"], [1, 2, 3, 4, 5, 6, 7, 0])
    assert np.allclose(adaptation.actions({"actions": np.array([9, 8.0])}), [[1, 8, 3, 4, 5, 6, 7, 1, -1]])


def test_lengths_of_answers_are_checked(tmp_path):
    file = tmp_path / "row.yaml"
    file.write_text(ROW.replace("joint_targets, numbers: all}", "joint_targets, numbers: all, length: 4, execute: 2}"))
    adaptation = Adaptation(adapter_named(str(file)), task(), SEEN)
    assert adaptation.actions({"actions": np.zeros((4, 9))}).shape == (2, 9)
    with pytest.raises(PolicyFailed, match="5 steps of actions; the adapter mine wants 4"):
        adaptation.actions({"actions": np.zeros((5, 9))})


def test_robot_numbers_are_a_dataset_s():
    numbers = RobotNumbers(ROBOT)
    assert np.allclose(numbers.row(SEEN)[[0, 7, 8, 15]], [1, 0.08, 0.3, 0])
    assert np.allclose(rotation_vector(np.array([-HALF, 0, 0, -HALF])), [0, 0, np.pi / 2])
    assert np.allclose(rotation_vector(np.array([1.0, 0, 0, 0])), 0)


@pytest.mark.parametrize(
    ("was", "instead", "code", "where"),
    [
        ("numbers: all}\n", "nubmers: all}\n", "json.wrong_type", "/mine/observation/observation.state/nubmers"),
        ("space: joint_targets", "space: joint_target", "json.unknown_name", "/mine/action/space"),
        ("space: joint_targets", "spice: joint_targets", "json.missing_field", "/mine/action"),
        ("keys: [actions], ", "keys: [], ", "json.wrong_type", "/mine/action/keys"),
        ("numbers: all}\n", "picture: scene_camera}\n", "json.missing_field", "/mine"),
        ("  about", "  rounds: 3\n  about", "json.unknown_field", "/mine/rounds"),
        ("keys: [actions]", "keys: [actions], execute: 0", "json.out_of_range", "/mine/action/execute"),
        ("keys: [actions]", "keys: [actions], execute: 9, length: 4", "json.out_of_range", "/mine/action/execute"),
        ("keys: [actions]", "keys: [actions], gripper: {closed: 1, open: 1}", "json.out_of_range", "/mine/action/gripper"),
        ("keys: [actions]", "keys: [actions], unit_m: .nan", "json.wrong_type", "/mine/action/unit_m"),
        ("keys: [actions]", "keys: [actions], keys: [twice]", "yaml.syntax", ":6"),
        ("about: numbers", "about: &a numbers", "json.wrong_type", None),
        ("mine:", "mine", "yaml.syntax", None),
    ],
)
def test_what_is_wrong_with_a_row_is_said_with_its_place(tmp_path, was, instead, code, where):
    file = tmp_path / "row.yaml"
    assert was in ROW
    file.write_text(ROW.replace(was, instead, 1))
    if where is None and code == "json.wrong_type":  # an anchor alone does no harm
        assert adapter_named(str(file)).about == "numbers alone"
        return
    with pytest.raises(marketgen.Error) as refused:
        adapter_named(str(file))
    assert refused.value.code == code and str(file) in refused.value.where
    assert where is None or refused.value.where.endswith(where)


@pytest.mark.parametrize("text", ["a: &a [x]\nb: *a\n", "\xff", "[1, 2]", "", "- a", "{" * 5000])
def test_what_is_no_file_of_rows(tmp_path, text):
    file = tmp_path / "row.yaml"
    file.write_bytes(text.encode("latin-1"))
    with pytest.raises(marketgen.Error) as refused:
        adapter_named(f"{file}:mine")
    assert refused.value.code in ("yaml.syntax", "json.wrong_type", "json.too_deep", "input.not_utf8")


@pytest.mark.parametrize(
    ("was", "instead", "said"),
    [
        ("observation.state: {numbers: all}", "state: {numbers: [qpos.joint9]}", "qpos.joint9"),
        ("numbers: all}\n", "picture: head_camera}\n  pictures: {size: [8, 8]}\n", "head_camera"),
        ("joint_targets, numbers: all", "joint_targets, numbers: [lift]", "lift"),
        ("joint_targets, numbers: all", "joint_targets, numbers: [joint1, joint1]", "twice"),
    ],
)
def test_a_row_for_another_robot_is_said(tmp_path, was, instead, said):
    file = tmp_path / "row.yaml"
    assert was in ROW
    file.write_text(ROW.replace(was, instead, 1))
    with pytest.raises(marketgen.Error) as refused:
        Adaptation(adapter_named(str(file)), task(), SEEN)
    assert refused.value.code == "usage.bad_flag" and said in refused.value.message
