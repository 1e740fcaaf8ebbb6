"""People in the aisles: the same people in every run, in parts, gone on with and run again; and they are there."""

import json

import pytest

import marketgen
from conftest import run
from evaluation_test import timeless

SECONDS = 6


@pytest.fixture(scope="module")
def crowd(aisle_file, tmp_path_factory):
    """The tasks in the aisles with some seconds for each, and a realism with people."""
    folder = tmp_path_factory.mktemp("crowd")
    header, *episodes = aisle_file.read_text().splitlines()
    short = [json.dumps({**json.loads(episode), "limit_s": SECONDS}) for episode in episodes]
    (folder / "tasks.jsonl").write_text("".join(line + "\n" for line in (header, *short)))
    (folder / "busy.json").write_text('{"schema": "market-realism/1", "name": "busy", "people": {"per_m2": 0.15}}')
    return folder / "tasks.jsonl", folder / "busy.json"


@pytest.fixture(scope="module")
def whole(crowd, tmp_path_factory):
    tasks, busy = crowd
    folder = tmp_path_factory.mktemp("whole")
    return marketgen.evaluate(tasks, "random", folder, realism=busy, record_motion=True), folder


def test_the_ledger_has_them(crowd, whole, tmp_path):
    tasks, _ = crowd
    for result in whole[0].results:
        effects = result["side_effects"]
        assert effects["person_contacts"] == 0 and effects["person_hardest_n"] == 0
        assert 0.2 < effects["person_distance_m"] <= 2 and effects["person_near_s"] >= 0
    alone = marketgen.evaluate(tasks, "random", tmp_path / "alone")
    assert not any("person" in key for result in alone.results for key in result["side_effects"])


def test_every_run_is_the_same(crowd, whole, tmp_path):
    tasks, busy = crowd
    again = marketgen.evaluate(tasks, "random", tmp_path / "again", realism=busy, jobs=2)
    assert timeless(again.results) == timeless(whole[0].results)
    for number, result in enumerate(whole[0].results):
        said = run(
            *("replay", "--episodes", tasks, "--episode", number, "--policy", "random", "--realism", busy),
            *("--results", whole[1] / "results.jsonl", "--json", "--quiet"),
        )
        replayed = json.loads(said)
        assert replayed["state_hash"] == result["state_hash"] and replayed["side_effects"] == result["side_effects"]


def test_parts_are_joined(crowd, whole, tmp_path):
    tasks, busy = crowd
    parts = [tmp_path / "1", tmp_path / "2"]
    for number, folder in enumerate(parts, start=1):
        marketgen.evaluate(tasks, "random", folder, realism=busy, shard=f"{number}/2", record_motion=True)
    joined = marketgen.merge(parts, tmp_path / "joined")
    assert timeless(joined.results) == timeless(whole[0].results)
    for number, folder in enumerate(parts):
        name = "motion/" + whole[0].results[number]["episode"] + ".bin.gz"
        assert (folder / name).read_bytes() == (whole[1] / name).read_bytes()


def test_a_run_that_was_broken_off_goes_on(crowd, whole, tmp_path):
    tasks, busy = crowd
    marketgen.evaluate(tasks, "random", tmp_path / "run", realism=busy)
    results = tmp_path / "run" / "results.jsonl"
    results.write_text(results.read_text().splitlines(keepends=True)[0])
    on = marketgen.evaluate(tasks, "random", tmp_path / "run", realism=busy, resume=True)
    assert timeless(on.results) == timeless(whole[0].results)
