"""A policy in Python is told a task and observations, and finds out nothing else of its episode's truth."""

import json
import pathlib
import shutil
import sys
import warnings

import numpy as np
import pytest

import marketgen
import policies
from marketgen import answers, confinement
from marketgen.policy_process import PolicyFailed, PolicyProcess
from marketgen.policy_sight import sight

pytestmark = pytest.mark.skipif(confinement.version() == 0, reason="this kernel has no Landlock")


@pytest.fixture
def project(tasks, store, tmp_path, monkeypatch):
    """A folder as people have them: code, weights, a store and episodes side by side, and on sys.path."""
    folder = tmp_path / "project"
    (folder / "notes").mkdir(parents=True)
    shutil.copy(tasks, folder / "tasks.jsonl")
    shutil.copy(tasks, folder / "older.jsonl")
    (folder / "twin.dat").hardlink_to(folder / "tasks.jsonl")
    shutil.copytree(store.folder, folder / "shop")
    (folder / "weights.pt").write_text("3 1 4")
    monkeypatch.syspath_prepend(folder)
    monkeypatch.chdir(folder)
    return folder


@pytest.fixture
def spied(project):
    """What the spy noted, and the results."""
    secrets = ["tasks.jsonl", "older.jsonl", "twin.dat", "shop/scene.bin", "shop/layout.json", "results/results.jsonl"]
    pool = pathlib.Path(marketgen._core.data_folder()) / "benchmark" / "pool" / "checkout.jsonl"
    paths = [str(project / name) for name in secrets] + ["tasks.jsonl", str(pool)]
    spy = policies.Spy(project / "notes", [*paths, str(project / "weights.pt")])
    scores = marketgen.evaluate("tasks.jsonl", spy, "results", jobs=1, policy_files=["notes"])
    return {file.stem: json.loads(file.read_text()) for file in (project / "notes").iterdir()}, scores


def test_a_spy_opens_its_weights_and_nothing_of_the_truth(project, spied):
    found, scores = spied
    assert [result["failure"] for result in scores.results] == ["Unknown", "Unknown"], scores.results
    assert {result["isolation"] for result in scores.results} == {"landlock"}
    assert found["opened"] == [str(project / "weights.pt")]
    assert found["written"] == []
    assert found["traced"] == [False, False]
    assert list(policies.episodes_in(project)) and found["episodes"] == []
    assert found["signalled"] is (confinement.version() < confinement.SCOPES_SINCE)
    named = json.dumps([found["held"], found["environment"], found["command"]])
    assert "tasks.jsonl" not in named and "scene.bin" not in named and "results.jsonl" not in named
    assert set(found["held"]) <= {"0", "1", "2", "3", "4", "5"}


def values_of(document):
    """All texts and numbers of an episode, as they may be written."""
    if isinstance(document, dict):
        return {value for part in document.values() for value in values_of(part)}
    if isinstance(document, list):
        return {value for part in document for value in values_of(part)}
    return {str(document)}


def test_what_it_is_told_has_no_pose_witness_seed_or_id(tasks, spied):
    told = spied[0]["told"]
    header, *episodes = map(json.loads, tasks.read_text().splitlines())
    for episode in episodes:
        assert episode["items"] and episode["certificate"]
        hidden = {key: episode[key] for key in ("id", "store", "scene_hash", "plan_hash", "items")}
        known = values_of([product["sku"] for product in header["products"]])
        for value in values_of(hidden) - known:
            # Short numbers (1, 0.5) stand for many things.
            assert len(value) < 6 or (value not in told["task"] and value not in told["observation"]), value
    assert not {"items", "certificate", "seed", "start", "id", "scene_hash", "plan_hash", "store"} & set(told["names"])
    assert set(told["names"]) == {
        *("schema", "track", "station", "robot", "tools", "cameras", "instruction", "goals", "categories", "limit_s"),
        *("action_names", "action_units", "robot_names", "catalogue"),
    } - ({"station"} if "station" not in told["names"] else set())


@pytest.mark.slow
def test_in_the_aisles_it_knows_the_map_and_where_categories_are(aisle_file, tmp_path):
    (tmp_path / "notes").mkdir()
    spy = policies.Spy(tmp_path / "notes", [])
    marketgen.evaluate(aisle_file, spy, tmp_path / "results", jobs=1, policy_files=[tmp_path / "notes"])
    told = json.loads((tmp_path / "notes" / "told.json").read_text())
    assert {"map", "categories", "catalogue"} <= set(told["names"]) and "start" not in told["names"]


def test_the_same_actions_have_the_same_end_apart_and_here(tasks, tmp_path):
    def end(folder, **options):
        return [result["state_hash"] for result in marketgen.evaluate(tasks, policies.still, folder, **options).results]

    with pytest.warns(marketgen.IsolationWarning, match="act_limit_s=0"):
        here = end(tmp_path / "a", act_limit_s=0)
    assert end(tmp_path / "b") == here


def test_without_isolation_it_is_said_once_and_stands_in_the_results(tasks, tmp_path, monkeypatch):
    monkeypatch.setattr(confinement, "version", lambda: 0)
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        scores = marketgen.evaluate(tasks, policies.StopsAtOnce, tmp_path / "a")
    [warning] = [one for one in said if one.category is marketgen.IsolationWarning]
    assert "Landlock" in str(warning.message) and warning.filename == __file__
    assert {result["isolation"] for result in scores.results} == {"none"}


# ---- A policy that only its own process loads ----


def test_a_policy_in_a_file_is_loaded_where_it_acts(project):
    (project / "aside.py").write_text("STOP = 1\n")
    (project / "mine.py").write_text(
        "import numpy as np, aside\n"
        "class Mine:\n"
        "    def act(self, observation):\n"
        "        action = np.zeros(9); action[-1] = aside.STOP\n"
        "        return action\n"
    )
    scores = marketgen.evaluate("tasks.jsonl", "mine.py:Mine", "results", jobs=1)
    assert [(result["policy"], result["steps"], result["detail"]) for result in scores.results] == [("Mine", 0, "")] * 2  # it stopped at once
    assert "mine" not in sys.modules and "aside" not in sys.modules


@pytest.mark.parametrize(
    ("policy", "code", "said"),
    [
        ("mine.py:Other", "episode.no_policy", "Other"),
        ("broken.py:Mine", "episode.no_policy", "ZeroDivisionError"),
        ("needs.py:Mine", "episode.no_policy", "nowhere_to_be_found"),
        ("missing.py:Mine", "input.not_found", "not there"),
        ("mine.py:no name", "usage.bad_flag", "FILE.py:NAME"),
    ],
)
def test_one_that_cannot_be_loaded_says_why(project, policy, code, said):
    (project / "mine.py").write_text("class Mine: pass\n")
    (project / "broken.py").write_text("1 / 0\n")
    (project / "needs.py").write_text("import nowhere_to_be_found\n")
    with pytest.raises(marketgen.Error, match=said) as caught:
        marketgen.evaluate("tasks.jsonl", policy, "results", jobs=1)
    assert caught.value.code == code


def test_a_file_that_it_may_not_open_is_an_error_that_says_what_mends_it(tmp_path):
    (tmp_path / "weights.pt").write_text("3 1 4")
    with pytest.raises(marketgen.Error, match="policy_files"):
        PolicyProcess(policies.ReadsAtStart(str(tmp_path / "weights.pt")), 100, sight=sight([])).ask("act", None)


# ---- Answers ----


def test_no_answer_is_run_where_it_is_read(tmp_path):
    bomb = tmp_path / "bomb"
    player = PolicyProcess(policies.Answers(lambda: policies.Bomb(str(bomb))), 100)
    assert player.ask("act", None) == answers.Unsendable("Bomb")
    player.close()
    assert not bomb.exists()


def test_a_process_that_writes_something_else_has_crashed():
    player = PolicyProcess(policies.Babbles(), 100)
    with pytest.raises(PolicyFailed, match="no answer") as caught:
        player.ask("act", None)
    assert caught.value.code == "episode.policy_crashed"


@pytest.mark.parametrize("value", [None, True, 3, 2.5, "NoGrasp", np.arange(6, dtype=np.float32).reshape(2, 3), [1, 2.5]])
def test_answers_come_through(value):
    word, read = answers.unpacked(answers.packed("ok", value))
    assert word == "ok" and type(read) is (np.ndarray if isinstance(value, (list, np.ndarray)) else type(value))
    assert np.array_equal(read, value)


@pytest.mark.parametrize("value", [object(), [[1], [1, 2]], {"a": 1}, np.array(["text"]), np.array([None])])
def test_what_is_no_number_does_not_travel(value):
    assert answers.unpacked(answers.packed("ok", value)) == ("ok", answers.Unsendable(type(value).__name__))


@pytest.mark.parametrize(
    "message",
    [
        *(b"", b"{", b"[1]", b"3", b'["ok"]', b'["other", 1]', b"\x80\x04N.", b"[" * 100_000),
        *(b'["ok", {"dtype": "O", "shape": [1]}]\n12345678', b'["ok", {"dtype": "<f8", "shape": [1000000000000]}]\n12345678'),
    ],
)
def test_what_is_no_answer_is_an_error(message):
    with pytest.raises(ValueError, match="no answer"):
        answers.unpacked(message)
