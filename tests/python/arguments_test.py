"""Bad values of every public function are errors that name Python's arguments, and nothing has been done."""

import pathlib
import re

import gymnasium
import numpy as np
import pytest

import marketgen
from conftest import PROMPT, ROOT
from marketgen.errors import in_python

CHECKOUT = "MarketGen/CheckoutUnloading-v1"

# What each argument cannot be, by the call that takes it.
GENERATE = [
    ("prompt", 3),
    ("prompt", None),
    ("folder", 3),
    ("seed", -1),
    ("seed", 2**64),
    ("seed", 1.5),
    ("seed", "7"),
    ("seed", True),
    ("size", (9, 7)),
    ("size", "9x"),
    ("profile", "supermarkt-eu"),
    ("profile", 7),
    ("style", "scandinavia"),
    ("country", "uss"),
    ("country", 3),
    ("time", "Sat 25:00"),
    ("time", 17),
    ("vary", "fill=3"),
    ("vary", {"fil": 3}),
    ("vary", {"fill": -1}),
    ("vary", {"fill": "3"}),
    ("vary", {3: 3}),
    ("plan", 5),
    ("floor_plan", 5),
    ("floor_plan_scale", 3),
    ("image", 5),
    ("image", [5]),
    ("planner", 5),
    ("planner", "opnai:m"),
    ("planner", "http:m"),  # without an address
    ("planner_url", 7),
    ("record", 5),
    ("max_tokens", -1),
    ("max_tokens", 1.5),
    ("max_seconds", "long"),
    ("max_usd", "cheap"),
    ("max_usd", 1.0),  # without prices
    ("usd_per_million", (1,)),
    ("catalogs", "mine.csv"),
    ("catalogs", [3]),
    ("previews", "yes"),
    ("strict", 2),
]


@pytest.mark.parametrize(("argument", "value"), GENERATE, ids=str)
def test_generate_names_its_arguments(tmp_path, argument, value):
    given = {"prompt": PROMPT, "folder": tmp_path / "shop", argument: value}
    with pytest.raises(marketgen.Error) as caught:
        marketgen.generate(**given)
    assert argument in caught.value.where, caught.value
    assert_pythonic(caught.value)
    assert list(tmp_path.iterdir()) == []


def assert_pythonic(error):
    outside_quotes = re.sub(r'"[^"]*"', "", str(error))
    assert not re.search(r"--[a-z]|\bflag\b(?!:)", outside_quotes.replace("usage.bad_flag", "")), str(error)
    assert "incompatible function arguments" not in str(error)


CALLS = {
    "folder": [lambda on: marketgen.open_store(5)],
    "catalogs": [lambda on: marketgen.open_store(on.store.folder, catalogs=on.store.folder)],
    "say": [lambda on: on.store.edit(3), lambda on: on.store.patches(3), lambda on: on.store.edit()],
    "patches": [
        lambda on: on.store.edit(patches="swap"),
        lambda on: on.store.edit(patches=[3]),
        lambda on: on.store.edit(patches=[{"set_look": {"floor": object()}}]),
        lambda on: on.store.edit(patches=[{"swop_leaves": {}}]),
    ],
    "planogram": [
        lambda on: on.store.edit(planogram=5),
        lambda on: marketgen.generate("", on.folder, plan=on.store.folder + "/plan.json", planogram=5),
        lambda on: on.store.edit("swap dairy and bakery", planogram="shelves.csv"),
        lambda on: on.store.compliance(5),
    ],
    "request": [lambda on: on.store.shop(3), lambda on: on.store.shop("")],
    "sold_out": [lambda on: on.store.shop("milk", sold_out="dairy-milk"), lambda on: on.store.shop("milk", sold_out=[3])],
    "planner": [lambda on: on.store.shop("milk", planner="opnai:m"), lambda on: on.store.shop("milk", planner=5)],
    "max_usd": [lambda on: on.store.shop("milk", planner="openai:m", max_usd=1.0)],
    "region": [
        lambda on: on.store.settle("1,1,2,2"),
        lambda on: on.store.settle((1, 1, 2)),
        lambda on: on.store.settle((2, 1, 1, 2)),
        lambda on: on.store.settle((0, 0, float("inf"), 9)),
        lambda on: on.store.settle((0, 0, 9, 7)),  # more than can move at once
    ],
    "seconds": [lambda on: on.store.settle((0, 0, 0.1, 0.1), seconds=-1), lambda on: on.store.settle((0, 0, 0.1, 0.1), seconds="long")],
    "lift_m": [lambda on: on.store.settle((0, 0, 0.1, 0.1), lift_m=1), lambda on: on.store.settle((0, 0, 0.1, 0.1), lift_m=None)],
    "soft": [lambda on: on.store.settle((0, 0, 0.1, 0.1), soft="no")],
    "path": [lambda on: marketgen.read_photo(5), lambda on: marketgen.read_motion(5)],
    "record_motion": [
        lambda on: marketgen.evaluate(on.tasks, record_motion="yes", folder=on.folder),
        lambda on: marketgen.evaluate(on.tasks, lambda seen: None, record_motion=True, folder=on.folder),
    ],
    "record_decisions": [
        lambda on: marketgen.evaluate(on.tasks, record_decisions="yes", folder=on.folder),
        lambda on: marketgen.evaluate(on.tasks, lambda seen: None, record_decisions=True, folder=on.folder),
    ],
    "table": [lambda on: on.store.query("produce"), lambda on: on.store.query(3)],
    "where": [
        lambda on: on.store.query("products", 3),
        lambda on: on.store.query("products", "colour=red"),
        lambda on: on.store.query("products", "price"),
    ],
    "name": [lambda on: on.store.camera(3), lambda on: marketgen.make_vec("Checkout"), lambda on: marketgen.make_vec(3), lambda on: marketgen.evaluate(on.tasks, lambda seen: None, on.folder, name=5)],
    "camera": [
        lambda on: on.store.camera("isle"),
        lambda on: on.renderer.render("aisle"),
        lambda on: on.renderer.with_noise(on.frame, None),
        lambda on: on.renderer.annotate(on.frame, "aisle"),
        lambda on: marketgen.camera_to_dict("aisle"),
        lambda on: marketgen.camera_from_dict({"fx": object()}),
        lambda on: marketgen.camera_from_dict({"fx": "wide"}),
    ],
    "width": [lambda on: on.store.camera("aisle", width=0), lambda on: on.store.camera("aisle", 64.5, 48)],
    "height": [lambda on: on.store.camera("aisle", 64, 2**40)],
    "fine_print": [lambda on: on.store.renderer(fine_print="no")],
    "keep_light": [lambda on: on.store.renderer(keep_light=None)],
    "mode": [lambda on: on.renderer.render(on.camera, mode="fast"), lambda on: on.renderer.render(on.camera, mode=1)],
    "quality": [lambda on: on.renderer.render(on.camera, quality="ultra")],
    "samples": [lambda on: on.renderer.render(on.camera, samples=-1), lambda on: on.renderer.render(on.camera, samples=2**40)],
    "time_s": [lambda on: on.renderer.render(on.camera, time_s=float("nan")), lambda on: on.renderer.set_people(1, "noon")],
    "count": [lambda on: on.renderer.set_people(-1), lambda on: on.renderer.set_people(2.5), lambda on: on.renderer.set_people(1000)],
    "denoise": [lambda on: on.renderer.render(on.camera, mode="path", denoise="none at all")],
    "exposure_stops": [lambda on: on.renderer.render(on.camera, exposure_stops="more")],
    "frame": [lambda on: on.renderer.annotate(on.frame.rgb, on.camera), lambda on: on.renderer.with_noise(None, on.camera)],
    "seed": [lambda on: on.renderer.with_noise(on.frame, on.camera, seed=-1)],
    "number": [lambda on: on.renderer.with_noise(on.frame, on.camera, number=0.5)],
    "robots": [lambda on: on.renderer.set_robots("realman-rm65@4,3"), lambda on: on.renderer.set_robots([3])],
    "products": [
        lambda on: on.renderer.move({0: (1, 2, 3)}),
        lambda on: on.renderer.move({-1: (0, 0, 0, 1, 0, 0, 0)}),
        lambda on: on.renderer.move({0: (np.nan, 0, 0, 1, 0, 0, 0)}),
        lambda on: on.renderer.move([0]),
    ],
    "joints": [lambda on: on.renderer.move(joints={0: "open"}), lambda on: on.renderer.move(joints={0.5: 0})],
    "shots": [lambda on: marketgen.render_batch([]), lambda on: marketgen.render_batch([on.camera])],
    "rgb": [lambda on: marketgen.render_batch([(on.renderer, on.camera)], rgb=[0])],
    "depth": [lambda on: marketgen.render_batch([(on.renderer, on.camera)], depth=np.zeros((1, 48, 64)))],
    "policy": [lambda on: marketgen.evaluate(on.tasks, 3, on.folder), lambda on: marketgen.evaluate(on.tasks, "oracel", on.folder)],
    "episodes": [lambda on: marketgen.evaluate(3, "oracle", on.folder), lambda on: marketgen.write_episodes(on.folder, [])],
    "jobs": [lambda on: marketgen.evaluate(on.tasks, jobs=-1, folder=on.folder)],
    "resume": [lambda on: marketgen.evaluate(on.tasks, resume="yes", folder=on.folder)],
    "act_limit_s": [lambda on: marketgen.evaluate(on.tasks, act_limit_s=-1, folder=on.folder)],
    "hang_limit_s": [lambda on: marketgen.evaluate(on.tasks, hang_limit_s=float("nan"), folder=on.folder)],
    "start_limit_s": [lambda on: marketgen.evaluate(on.tasks, start_limit_s="long", folder=on.folder)],
    "repetition": [lambda on: marketgen.evaluate(on.tasks, repetition=0, folder=on.folder), lambda on: marketgen.evaluate(on.tasks, repetition="2", folder=on.folder)],
    "shard": [lambda on: marketgen.evaluate(on.tasks, shard="5/4", folder=on.folder), lambda on: marketgen.evaluate(on.tasks, shard=2, folder=on.folder)],
    "results": [
        lambda on: marketgen.merge(on.tasks, on.folder),
        lambda on: marketgen.leaderboard("oracle"),
        lambda on: marketgen.leaderboard([]),
        lambda on: marketgen.tables("tracks", []),
    ],
    "folders": [lambda on: marketgen.tables("swap", "classical"), lambda on: marketgen.tables("goals", 3)],
    "kind": [lambda on: marketgen.tables("table2", [on.folder]), lambda on: marketgen.tables(2, [on.folder])],
    "html": [lambda on: marketgen.leaderboard([on.folder], html=3)],
    "adapter": [
        lambda on: marketgen.evaluate(on.tasks, "openpi://localhost:80", on.folder, adapter="openpi"),
        lambda on: marketgen.evaluate(on.tasks, "openpi://localhost:80", on.folder, adapter=5),
        lambda on: marketgen.evaluate(on.tasks, "oracle", on.folder, adapter="marketgen"),
        lambda on: marketgen.evaluate(on.tasks, lambda seen: None, on.folder, adapter="marketgen"),
    ],
    "file": [lambda on: marketgen.write_episodes(5, [{}])],
    "like": [lambda on: marketgen.write_episodes(on.folder, [{}], like=5)],
    "policy_files": [lambda on: marketgen.evaluate(on.tasks, policy_files="weights.pt", folder=on.folder)],
    "num_envs": [lambda on: marketgen.make_vec(CHECKOUT, 0, store=on.store)],
    "render_mode": [
        lambda on: marketgen.environments.CheckoutUnloading(on.store, render_mode="human"),
        lambda on: marketgen.make_vec(CHECKOUT, store=on.store, render_mode="ansi"),
    ],
    "render_size": [
        lambda on: gymnasium.make(CHECKOUT, store=on.store, render_size=640),
        lambda on: gymnasium.make(CHECKOUT, store=on.store, render_size=(640, 0)),
    ],
    "render_camera": [lambda on: gymnasium.make(CHECKOUT, store=on.store, render_camera="aisle")],
    "obs_mode": [lambda on: gymnasium.make(CHECKOUT, store=on.store, obs_mode="pixels")],
    "control_mode": [lambda on: gymnasium.make(CHECKOUT, store=on.store, control_mode="torque")],
    "realism": [
        lambda on: gymnasium.make(CHECKOUT, store=on.store, realism="standart"),
        lambda on: gymnasium.make(CHECKOUT, store=on.store, realism=5),
        lambda on: marketgen.evaluate(on.tasks, "stop", on.folder, realism=5),
        lambda on: marketgen.evaluate(on.tasks, "stop", on.folder, realism="harder"),
    ],
    "reward_mode": [lambda on: gymnasium.make(CHECKOUT, store=on.store, reward_mode="none")],
    "cameras": [lambda on: gymnasium.make(CHECKOUT, store=on.store, obs_mode="rgbd", cameras=["wrist"])],
    "env": [
        lambda on: marketgen.policies.oracle(3),
        lambda on: marketgen.policies.oracle(gymnasium.make(CHECKOUT, store=on.store, control_mode="pd_ee_delta_pos")),
    ],
}


class On:
    """What the calls are made on."""


@pytest.fixture(scope="module")
def on(store, renderer, checkout_file, tmp_path_factory):
    made = On()
    made.store, made.renderer, made.tasks = store, renderer, checkout_file
    made.camera = store.camera("aisle", 64, 48)
    made.frame = renderer.render(made.camera, quality="fast")
    made.folder = tmp_path_factory.mktemp("results") / "none"
    return made


@pytest.mark.parametrize(("argument", "call"), [(name, call) for name, calls in CALLS.items() for call in calls])
def test_every_function_names_its_arguments(on, argument, call):
    with pytest.raises(marketgen.Error) as caught:
        call(on)
    assert argument in caught.value.where or f"no {argument}" in caught.value.message, caught.value
    assert caught.value.message
    assert_pythonic(caught.value)
    assert not on.folder.exists()


def test_results_that_are_there_are_said_in_python(on, tmp_path):
    (tmp_path / "results.jsonl").write_text("{}\n")
    with pytest.raises(marketgen.Error, match="go on with resume=True") as caught:
        marketgen.evaluate(on.tasks, "random", tmp_path)
    assert caught.value.code == "store.exists"


def test_every_public_function_is_tried_above():
    """A new argument of a public function needs a bad value here."""
    import inspect

    functions = [marketgen.generate, marketgen.open_store, marketgen.read_photo, marketgen.evaluate, marketgen.render_batch]
    functions += [marketgen.merge, marketgen.leaderboard, marketgen.tables, marketgen.read_motion, marketgen.write_episodes]
    functions += [marketgen.Store.edit, marketgen.Store.patches, marketgen.Store.compliance, marketgen.Store.shop, marketgen.Store.settle, marketgen.Store.query, marketgen.Store.camera, marketgen.Store.renderer]
    # marketgen.record: record_test.py
    functions += [getattr(marketgen.Renderer, name) for name in ("render", "with_noise", "annotate", "set_robots", "set_people", "move")]
    tried = {name for name, _ in GENERATE} | set(CALLS) | {"progress"}  # progress: notebook_test.py
    for function in functions:
        for name in inspect.signature(function).parameters:
            assert name in tried | {"self", "options", "instance", "value"}, f"{function.__name__}({name}=)"


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("go on with --resume", "go on with resume=True"),
        ("take --denoise own", 'take denoise="own"'),
        ("--where price<abc", "where price<abc"),
        ("took longer than 3 s (--act-limit-s)", "took longer than 3 s (act_limit_s)"),
        ("--size 24 x 15 m", "size 24 x 15 m"),
        ('run "marketgen assets import FILE --unit mm"', 'run "marketgen assets import FILE --unit mm"'),
        ("a -- b and a--b", "a -- b and a--b"),
    ],
)
def test_flags_are_arguments_in_python(text, wanted):
    assert in_python(text) == wanted


def test_no_message_of_the_library_shows_a_flag():
    """Whatever flag a text of the library names, Python shows none."""
    texts = []
    for file in sorted((ROOT / "src" / "marketgen").rglob("*.cpp")):
        texts += re.findall(r'"((?:[^"\\\n]|\\.)*--[a-z](?:[^"\\\n]|\\.)*)"', file.read_text(encoding="utf-8"))
    assert len(texts) > 20
    for text in texts:
        shown = in_python(text.replace('\\"', '"'))
        assert not re.search("--[a-z]", re.sub(r'"[^"]*"?', "", shown)), text


def test_paths_may_be_path_objects(on, tmp_path):
    on.frame.save(tmp_path / "aisle.png")
    assert (tmp_path / "aisle.png").stat().st_size > 100
    assert marketgen.open_store(pathlib.Path(on.store.folder)).manifest == on.store.manifest
