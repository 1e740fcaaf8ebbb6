"""marketgen.evaluate() is the program's eval; a policy that fails is a result, not a crash."""

import json
import subprocess

import gymnasium
import numpy as np
import pytest

import marketgen
import policies
from conftest import run


def timeless(results):
    return [{key: value for key, value in result.items() if key != "wall_s"} for result in results]


@pytest.mark.parametrize("act_limit_s", [0, 120])
def test_the_programs_policies_are_the_programs(tasks, tmp_path, act_limit_s):
    ours = marketgen.evaluate(tasks, "random", tmp_path / "ours", jobs=2, act_limit_s=act_limit_s)
    run("eval", "--episodes", tasks, "--policy", "random", "-o", tmp_path / "theirs", "--quiet")
    lines = (tmp_path / "theirs" / "results.jsonl").read_text().splitlines()
    assert timeless(ours.results) == timeless(map(json.loads, lines))
    summary = json.loads((tmp_path / "theirs" / "summary.json").read_text())
    assert {**ours.summary, "mean_wall_s": 0} == {**summary, "mean_wall_s": 0}
    assert ours.summary["episodes"] == 2 and [f["failure"] for f in ours.summary["failures"]] == ["Timeout"]


def test_shards_are_joined_and_ranked(tasks, tmp_path):
    whole = marketgen.evaluate(tasks, "random", tmp_path / "whole")
    parts = [tmp_path / "1", tmp_path / "2"]
    for number, folder in enumerate(parts, start=1):
        assert len(marketgen.evaluate(tasks, "random", folder, shard=f"{number}/2").results) == 1
    with pytest.raises(marketgen.Error) as refused:
        marketgen.merge(parts[:1], tmp_path / "half")
    assert refused.value.code == "results.incomplete" and "2/2" in refused.value.message
    assert not (tmp_path / "half").exists()
    joined = marketgen.merge(reversed(parts), tmp_path / "joined")
    assert timeless(joined.results) == timeless(whole.results)
    marketgen.evaluate(tasks, policies.StopsAtOnce, tmp_path / "stops")
    board = marketgen.leaderboard([joined.folder, tmp_path / "stops"], html=tmp_path / "board.html")
    entries = board["tracks"][0]["entries"]
    assert [(entry["policy"], entry["floor"], entry["episodes"]) for entry in entries] == [("random", True, 2), ("stops", False, 2)]
    assert entries[1]["to_best"]["p_strict"] == 1
    assert "stops" in (tmp_path / "board.html").read_text()
    rows = marketgen.tables("tracks", [joined.folder, tmp_path / "stops"])["rows"]
    assert {row["policy"] for row in rows if not row["source"]} == {"random", "stops"} and any(row["source"] == "paper" for row in rows)
    with pytest.raises(marketgen.Error) as refused:
        marketgen.tables("swap", [joined.folder])
    assert refused.value.code == "usage.bad_flag"


@pytest.mark.parametrize("act_limit_s", [0, 120])
def test_repetitions_draw_anew_and_are_summed_up(tasks, tmp_path, act_limit_s):
    folders = [tmp_path / str(number) for number in (1, 2)]
    first, second = (
        marketgen.evaluate(tasks, "random", folder, repetition=number, act_limit_s=act_limit_s) for number, folder in enumerate(folders, start=1)
    )
    for before, after in zip(first.results, second.results, strict=True):
        assert "repetition" not in before and after["repetition"] == 2
        assert before["episode_hash"] == after["episode_hash"] and before["state_hash"] != after["state_hash"]
    board = marketgen.leaderboard(folders)
    assert [(row["policy"], row["repetitions"], row["strict"]["deviation"]) for row in board["tracks"][0]["repeated"]] == [("random", 2, 0)]


@pytest.mark.parametrize("act_limit_s", [0, 120])
def test_motion_is_what_became_of_it(tasks, tmp_path, act_limit_s):
    scores = marketgen.evaluate(tasks, "random", tmp_path, record_motion=True, act_limit_s=act_limit_s)
    for result in scores.results:
        motion = marketgen.read_motion(tmp_path / "motion" / (result["episode"] + ".bin.gz"))
        assert motion["episode_hash"] == result["episode_hash"] and motion["policy"] == "random"
        assert motion["states"].shape == (result["steps"] + 1, len(motion["dofs"]))
        assert motion["states"].dtype == np.float32 and np.isfinite(motion["states"]).all()
        assert np.ptp(motion["states"], axis=0).max() > 0.01
        kinds = [thing["kind"] for thing in motion["things"]]
        assert kinds.count("basket") == 1 and kinds.count("item") >= 1
        for thing in motion["things"]:
            assert thing["poses"].shape == (len(thing["steps"]), 7) and thing["steps"][-1] <= result["steps"]
            assert np.allclose(np.linalg.norm(thing["poses"][:, 3:], axis=1), 1, atol=1e-5)
        assert motion["track"] == "checkout" and motion["instruction"]
        steps = [event["step"] for event in motion["events"]]
        assert steps == sorted(steps) and all(event["last_step"] <= result["steps"] for event in motion["events"])
    with pytest.raises(marketgen.Error) as refused:
        marketgen.read_motion(tmp_path / "results.jsonl")
    assert refused.value.code == "input.malformed"


def test_sets_are_named(tmp_path):
    scores = marketgen.evaluate("pool/checkout", policies.StopsAtOnce, tmp_path, shard="1/20")
    assert len(scores.results) == 2
    assert json.loads((tmp_path / "run.json").read_text())["set"] == "pool/checkout"


@pytest.mark.parametrize("act_limit_s", [0, 120])
def test_policies_in_python(tasks, tmp_path, act_limit_s):
    scores = marketgen.evaluate(tasks, policies.StopsAtOnce, tmp_path / "a", act_limit_s=act_limit_s)
    assert [result["failure"] for result in scores.results] == ["NoGrasp", "NoGrasp"]
    assert [result["steps"] for result in scores.results] == [1, 1]
    assert {result["policy"] for result in scores.results} == {"stops"}
    assert scores.results == [json.loads(line) for line in open(tmp_path / "a" / "results.jsonl")]
    function = marketgen.evaluate(tasks, policies.still, tmp_path / "b", jobs=2, act_limit_s=act_limit_s)
    assert [result["failure"] for result in function.results] == ["Timeout", "Timeout"]
    assert all(result["simulated_s"] > 2.9 and len(result["state_hash"]) == 32 for result in function.results)


@pytest.mark.slow
def test_realism_is_the_same_by_every_door(tasks, tmp_path):
    """The program's policy, its replay, a policy in Python and an environment: one episode at standard, one state."""

    def still(observation):
        return policies.still(observation)

    ours = marketgen.evaluate(tasks, "random", tmp_path / "ours", realism="standard")
    run("eval", "--episodes", tasks, "--policy", "random", "--realism", "standard", "-o", tmp_path / "theirs", "--quiet")
    lines = (tmp_path / "theirs" / "results.jsonl").read_text().splitlines()
    assert timeless(ours.results) == timeless(map(json.loads, lines))
    assert {result["realism"] for result in ours.results} == {"standard"}
    assert json.loads((tmp_path / "ours" / "run.json").read_text())["realism"] == "standard"
    ideal = marketgen.evaluate(tasks, "random", tmp_path / "ideal")
    assert ideal.results[0]["state_hash"] != ours.results[0]["state_hash"]
    again = ("replay", "--episodes", tasks, "--episode", "0", "--policy", "random", "--results")
    assert "the same" in run(*again, tmp_path / "theirs" / "results.jsonl")
    with pytest.raises(marketgen.Error) as mixed:
        marketgen.leaderboard([tmp_path / "ours", tmp_path / "ideal"])
    assert mixed.value.code == "results.not_comparable"

    python = marketgen.evaluate(tasks, still, tmp_path / "python", act_limit_s=0, realism="standard")
    env = gymnasium.make("MarketGen/CheckoutUnloading-v1", episodes=tasks, realism="standard")
    seen, _ = env.reset(options={"episode": 0})
    over = False
    while not over:
        seen, _, terminated, truncated, info = env.step(still(seen))
        over = terminated or truncated
    assert info["result"]["realism"] == "standard"
    assert info["result"]["state_hash"] == python.results[0]["state_hash"]


def test_realism_goes_on_only_as_it_was(tasks, tmp_path):
    marketgen.evaluate(tasks, "stop", tmp_path / "a", realism="standard")
    with pytest.raises(marketgen.Error) as refused:
        marketgen.evaluate(tasks, "stop", tmp_path / "a", resume=True)
    assert refused.value.where == "realism" and "standard" in refused.value.message
    own = tmp_path / "mine.json"
    own.write_text('{"schema": "market-realism/1", "name": "mine", "latency": {"commands": {"min_s": 0.1, "max_s": 0.1}}}')
    mine = marketgen.evaluate(tasks, "stop", tmp_path / "b", realism=own)
    assert mine.results[0]["realism"].startswith("own-")
    again = ("replay", "--episodes", tasks, "--episode", "0", "--policy", "stop", "--results", tmp_path / "b" / "results.jsonl")
    with pytest.raises(subprocess.CalledProcessError) as unnamed:
        run(*again)
    assert "own-" in unnamed.value.stderr and "--realism" in unnamed.value.stderr
    assert "the same" in run(*again, "--realism", own)


def test_one_code_by_every_door(tasks, tmp_path):
    """The same actions in the same episode have one result, whoever runs it: but for who acted, and how long that took."""

    def stops(observation):
        action = policies.still(observation)
        action[-1] = 1
        return action

    scores = marketgen.evaluate(tasks, stops, tmp_path / "a", act_limit_s=0).results
    apart = marketgen.evaluate(tasks, stops, tmp_path / "b").results
    env = gymnasium.make("MarketGen/CheckoutUnloading-v1", episodes=tasks)
    for number, (here, there) in enumerate(zip(scores, apart, strict=True)):
        env.reset(options={"episode": number})
        info = env.step(stops(None))[-1]
        assert info["failure_reason"] == "Unknown"
        theirs = info["result"] | {key: here[key] for key in ("policy", "isolation", "wall_s", "episode_hash")}
        assert theirs == here
        assert timeless([here]) == timeless([there | {"isolation": here["isolation"]}])


@pytest.mark.parametrize(
    ("what", "code"),
    [
        ("raises", "policy_failed"),
        ("hangs", "policy_hung"),
        ("computes", "policy_slow"),
        ("crashes", "policy_crashed"),
        ("nan", "bad_action"),
        ("short", "bad_action"),
        ("nothing", "bad_action"),
    ],
)
def test_a_policy_that_fails_is_a_result_and_the_next_episode_follows(tasks, tmp_path, what, code):
    marks = tmp_path / "marks"
    marks.mkdir()
    policy = policies.FailsOnce(what, str(marks / "mark"))
    limits = {"act_limit_s": 3, "hang_limit_s": 3 if what == "hangs" else 300}
    scores = marketgen.evaluate(tasks, policy, tmp_path / "a", jobs=1, policy_files=[marks], **limits)
    first, then = scores.results
    assert first["failure"] == "PolicyError" and code in first["detail"]
    assert first["goals"] and first["success_partial"] == 0
    assert then["failure"] != "PolicyError" and then["detail"] == ""


def test_what_was_finished_is_kept(tasks, tmp_path):
    first = marketgen.evaluate(tasks, policies.still, tmp_path / "a", act_limit_s=0)
    file = tmp_path / "a" / "results.jsonl"
    lines = file.read_text().splitlines()
    marked = {**json.loads(lines[1]), "detail": "kept"}
    file.write_text(json.dumps(marked) + "\n" + lines[0][:30])
    with pytest.raises(marketgen.Error) as caught:
        marketgen.evaluate(tasks, policies.still, tmp_path / "a", act_limit_s=0)
    assert caught.value.code == "store.exists"
    again = marketgen.evaluate(tasks, policies.still, tmp_path / "a", resume=True, act_limit_s=0)
    assert again.results[1]["detail"] == "kept"
    assert timeless(again.results[:1]) == timeless(first.results[:1])


def test_what_cannot_be_asked_is_said(tasks, tmp_path):
    for policy, said in ((3, "cannot be called"), ("clairvoyant", "there is no policy")):
        with pytest.raises(marketgen.Error, match=said) as caught:
            marketgen.evaluate(tasks, policy, tmp_path / "a")
        assert caught.value.code == "usage.bad_flag"
    with pytest.raises(marketgen.Error, match="refused in evaluation"):
        marketgen.evaluate(tasks, policies.still, tmp_path / "b", obs_mode="rgbd", segmentation=True)
