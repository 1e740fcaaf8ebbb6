"""Programs of others are shown the episodes as datasets have them; that LeRobot and vla-eval take it, tools/check_lerobot and
tools/check_vla_eval show."""

import json
import logging

import gymnasium
import numpy as np
import pytest

import marketgen
import record_test
from marketgen.as_recorded import AsRecorded

SHORT_S, SIZE, CAMERA = (1.0, 1.5), (64, 48), "wrist_camera"


@pytest.fixture(scope="module")
def tasks(tmp_path_factory):
    """One box on a counter, twice."""
    env = gymnasium.make("MarketGen/CheckoutOneItem-v1").unwrapped
    episodes = []
    for seed, limit_s in enumerate(SHORT_S):
        env.reset(seed=seed)
        episodes.append(env.episode | {"limit_s": limit_s})
    file = tmp_path_factory.mktemp("as_recorded") / "tasks.jsonl"
    marketgen.write_episodes(file, episodes)
    return file


@pytest.fixture(scope="module")
def episodes(tasks):
    return AsRecorded(tasks, cameras=[CAMERA], size=SIZE)


def test_recorded_actions_show_the_recorded_frames(tasks, episodes, tmp_path):
    marketgen.record(tasks, tmp_path / "set", record_test.sways, size=SIZE)
    recorded = record_test.Reader(tmp_path / "set")
    assert episodes.episodes == tuple(row["episode_id"] for row in recorded.episodes)
    assert list(episodes.robot_names) == recorded.info["features"]["observation.state"]["names"]
    assert list(episodes.action_names) == recorded.info["features"]["action"]["names"]
    for number, row in enumerate(recorded.episodes):
        seen = episodes.begin(number)
        assert [episodes.instruction] == row["tasks"]
        states, film = recorded.of_episode(number, "observation.state"), recorded.video(number, CAMERA)
        for frame, action in enumerate(recorded.of_episode(number, "action")):
            assert episodes.outcome is None
            assert np.array_equal(seen.state, states[frame].astype(np.float32)) and seen.state.dtype == np.float32
            assert record_test.psnr(seen.pictures[CAMERA], film[frame][1]) > 30
            seen, _, terminated, truncated = episodes.step(action)
            assert (terminated or truncated) == (frame + 1 == row["length"])
        told = episodes.outcome
        assert (told.success, told.goal_fraction, told.failure_reason) == (row["success"], row["goal_fraction"], row["failure"])
    assert episodes.max_steps == max(row["length"] for row in recorded.episodes)


def test_what_is_not_finite_fails_the_episode_as_in_evaluate(episodes, caplog):
    episodes.begin(0)
    with caplog.at_level(logging.WARNING, "marketgen"):
        _, reward, terminated, _ = episodes.step(np.full(episodes.action_space.shape, np.nan))
    assert terminated and reward == 0 and episodes.outcome.failure_reason == "PolicyError" and not episodes.outcome.success
    assert episodes.episodes[0] in caplog.text and "joint1" in caplog.text
    episodes.begin(0)
    assert episodes.outcome is None  # and the next one follows


def test_another_number_of_actions_is_no_failed_episode(episodes):
    episodes.begin(0)
    with pytest.raises(marketgen.Error) as refused:
        episodes.step(np.zeros(7))
    assert refused.value.code == "episode.bad_action" and "(9,)" in refused.value.message


def test_a_file_of_two_robots_is_refused(tasks, tmp_path):
    lines = [json.loads(line) for line in tasks.read_text().splitlines()]
    lines[2] = lines[2] | {"tools": "suction"}
    mixed = tmp_path / "mixed.jsonl"
    mixed.write_text("".join(json.dumps(line) + "\n" for line in lines))
    with pytest.raises(marketgen.Error, match="of one robot") as refused:
        AsRecorded(mixed)
    assert refused.value.code == "usage.bad_flag"
