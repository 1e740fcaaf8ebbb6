"""Logs of drives become a dataset whose actions lead to the states that were driven."""

import gzip
import json
import pathlib

import gymnasium
import numpy as np
import pytest

import marketgen
from marketgen.record import main

CHECKOUT = "MarketGen/CheckoutUnloading-v1"
GRID = 1 / 1024  # of a drive's numbers


@pytest.fixture(scope="module")
def env():
    return gymnasium.make(CHECKOUT, episodes="pool/checkout", control_mode="pd_ee_delta_pose", obs_mode="state_robot").unwrapped


def pool():
    header, *lines = pathlib.Path(marketgen._core.find_episode_file("pool/checkout")).read_text().splitlines()
    return json.loads(header), lines


def drive(env, path, row, *, steps=12, done=False):
    """Drives the pool's basket in that row for some steps, and writes the log as `marketgen view` does."""
    header, lines = pool()
    spec = json.loads(lines[row])
    env.reset(seed=0, options={"episode": spec})
    actions = np.zeros((steps, len(env.action_names)))
    actions[:, :3] = np.round(np.random.default_rng(row).uniform(-0.5, 0.5, (steps, 3)) / GRID) * GRID
    actions[:, -2:] = 1, -1
    if done:
        actions[-1, -1] = 1
    for action in actions:
        env.step(action)
    log = {
        "schema": "market-drive/1",
        "program": marketgen.__version__,
        "control_mode": "pd_ee_delta_pose",
        "realism": "ideal",
        "action_names": list(env.action_names),
        "actions": actions.ravel().tolist(),
        "over": done,
        "success": False,
        "state_hash": env.state_hash(),
    }
    lines = [json.dumps(log), json.dumps(header | {"episodes": 1}), json.dumps(spec)]
    path.write_bytes(gzip.compress("".join(f"{line}\n" for line in lines).encode()))
    return path


@pytest.fixture(scope="module")
def logs(env, tmp_path_factory):
    folder = tmp_path_factory.mktemp("drives")
    return [drive(env, folder / "a.drive.jsonl.gz", 0), drive(env, folder / "b.drive.jsonl.gz", 1, done=True)]


def test_a_dataset_of_drives_is_what_was_driven(logs, tmp_path, capsys):
    folder = tmp_path / "driven"
    assert main(["--teleop", *map(str, logs), "-o", str(folder), "--cameras", "none", "--quiet"]) == 0
    assert "2 episodes" in capsys.readouterr().out
    import pyarrow.parquet

    frames = pyarrow.parquet.ParquetDataset(folder / "data").read()
    told = np.array(frames["action"].to_pylist(), np.float32)
    # The first log breaks off: it ends with a stop that nobody drove.
    assert frames["episode_index"].to_pylist() == [0] * 13 + [1] * 12
    driven = [np.array(marketgen._core.read_drive(str(log))["action_names"]) for log in logs]
    assert (driven[0] == driven[1]).all()
    actions = [np.frombuffer(marketgen._core.read_drive(str(log))["actions"]).reshape(12, -1) for log in logs]
    np.testing.assert_array_equal(told[:12], actions[0])
    np.testing.assert_array_equal(told[13:], actions[1])
    assert told[12, -1] == 1
    assert told[12, -2] == 1, "the tool stays open"
    assert not told[12, :-2].any()
    settings = json.loads((folder / "meta/marketgen.json").read_text())
    assert settings["policy"] == "teleop"
    assert settings["control_mode"] == "pd_ee_delta_pose"
    episodes = f"{folder}.episodes.jsonl"
    assert marketgen.replay_check(folder, episodes) == 25
    assert main([episodes, "--check", str(folder), "--quiet"]) == 0


def test_a_log_that_leads_elsewhere_is_refused(logs, tmp_path):
    log, *rest = gzip.decompress(logs[1].read_bytes()).decode().splitlines()
    for change in ({"state_hash": "0" * 32}, {"actions": [0.25, *json.loads(log)["actions"][1:]]}):
        path = tmp_path / "other.drive.jsonl.gz"
        path.write_bytes(gzip.compress("".join(f"{line}\n" for line in (json.dumps(json.loads(log) | change), *rest)).encode()))
        with pytest.raises(marketgen.Error) as error:
            marketgen.record_drives([path], tmp_path / "none", cameras=[])
        assert error.value.code == "episode.not_repeated"
        assert not (tmp_path / "none").exists()


@pytest.mark.parametrize(("words", "code"), [
    (["--teleop", "{a}", "{a}"], "usage.bad_flag"),
    (["--teleop", "{a}", "--policy", "oracle"], "usage.bad_flag"),
    (["--teleop", "nowhere.gz"], "input.not_found"),
    (["pool/checkout", "--teleop", "{a}"], "usage.bad_flag"),
    ([], "usage.bad_flag"),
])
def test_what_does_not_go_together_is_said(words, code, logs, tmp_path, capsys):
    status = main([*(word.format(a=logs[0]) for word in words), "-o", str(tmp_path / "none"), "--quiet"])
    assert status == 2
    assert code in capsys.readouterr().err
