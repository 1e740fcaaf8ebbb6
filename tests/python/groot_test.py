"""Policies in servers of GR00T: what is theirs alone. What all servers have in common stands in outside_test.py."""

import json
import pathlib

import numpy as np
import pytest

import marketgen
from marketgen.outside.groot import batched, packed, unpacked
from outside_test import NOT_ISOLATED, server

pytest.importorskip("zmq")
pytest.importorskip("msgpack")

SERVER = pathlib.Path(__file__).with_name("groot_server.py")
ROW = """
arm:
  about: numbers alone
  observation:
    state:
      joints: {numbers: ['qpos.joint*']}
    language:
      task: {words: instruction}
  action: {keys: [joints, rest], space: joint_targets, numbers: all}
"""


@pytest.fixture
def adapter(tmp_path):
    file = tmp_path / "arm.yaml"
    file.write_text(ROW)
    return str(file)


@NOT_ISOLATED
def test_a_server_acts(tasks, tmp_path, adapter):
    with server(tmp_path, program=SERVER) as address:
        scores = marketgen.evaluate(tasks, f"groot://{address}", tmp_path / "a", adapter=adapter, jobs=2)
    assert [(result["failure"], result["steps"]) for result in scores.results] == [("Unknown", 2)] * 2
    assert {result["policy"] for result in scores.results} == {"groot(arm)"}


@NOT_ISOLATED
@pytest.mark.parametrize(
    ("fault", "code", "said"),
    [
        ("raises", "policy_failed", "no such embodiment"),
        ("babbles", "bad_answer", "msgpack"),
        ("pickles", "bad_answer", "msgpack"),
        ("bare", "bad_answer", "dict in place of a list"),
        ("batch", "bad_answer", "(2, 4, 7)"),
        ("nan", "bad_answer", "step 2 of its actions has nan for joint4"),
        ("narrow", "bad_answer", "8 numbers"),
        ("short", "bad_answer", "(1, 0, 7)"),
        ("uneven", "bad_answer", "joints (4, 7), rest (3, 2)"),
        ("unnamed", "bad_answer", "'rest'"),
        ("words", "bad_answer", "no array"),
        ("late", "policy_hung", "3 s"),
    ],
)
def test_what_is_wrong_with_a_server_fails_its_episode(tasks, tmp_path, adapter, fault, code, said):
    """A late answer is not taken for that to the next question."""
    with server(tmp_path, fault, tmp_path / "mark", SERVER) as address:
        scores = marketgen.evaluate(tasks, f"groot://{address}", tmp_path / "a", adapter=adapter, jobs=1, hang_limit_s=3)
    first, then = scores.results
    assert first["failure"] == "PolicyError" and f"episode.{code}" in first["detail"] and said in first["detail"]
    assert then["failure"] == "Unknown" and then["steps"] == 2


@NOT_ISOLATED
@pytest.mark.parametrize(("fault", "code"), [("dies", "server_lost"), ("hangs", "policy_hung")])
def test_a_server_that_is_gone_ends_the_run_and_its_episode_is_kept(tasks, tmp_path, adapter, fault, code):
    """It answers one at a time: while it hangs nobody else is answered, either."""
    limits = {"start_limit_s": 1, "hang_limit_s": 2}
    with server(tmp_path, fault, tmp_path / "mark", SERVER) as address, pytest.raises(marketgen.Error) as ended:
        marketgen.evaluate(tasks, f"groot://{address}", tmp_path / "a", adapter=adapter, jobs=1, **limits)
    assert ended.value.code == "episode.no_policy" and ended.value.where == address
    [kept] = map(json.loads, (tmp_path / "a" / "results.jsonl").read_text().splitlines())
    assert kept["failure"] == "PolicyError" and f"episode.{code}" in kept["detail"]


@NOT_ISOLATED
@pytest.mark.parametrize(("fault", "said"), [("version", "Unknown endpoint: reset"), ("nowhere", "1 s")])
def test_a_run_without_its_server_does_not_begin(tasks, tmp_path, adapter, fault, said):
    with server(tmp_path, fault, program=SERVER) as address:
        where = "localhost:9" if fault == "nowhere" else address
        with pytest.raises(marketgen.Error) as refused:
            marketgen.evaluate(tasks, f"groot://{where}", tmp_path / "a", adapter=adapter, start_limit_s=1)
    assert refused.value.code == "episode.no_policy" and said in refused.value.message


def test_messages_are_those_of_its_own_client():
    """An array is the bytes of an .npy file under as_npy; names are texts, not bytes."""
    message = packed({"endpoint": "get_action", "data": batched({"state": {"x": np.zeros(2, np.float32)}, "task": "go"})})
    read = unpacked(message)
    assert read["endpoint"] == "get_action" and read["data"]["state"]["x"].shape == (1, 1, 2) and read["data"]["task"] == [["go"]]
    assert b"\x93NUMPY" in message and b"\xb1__ndarray_class__" in message
