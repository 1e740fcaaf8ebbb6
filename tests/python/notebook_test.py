"""What notebooks need: policies from a cell, pictures that show themselves, progress, and work that stops when told to."""

import base64
import io
import json
import os
import re
import signal
import subprocess
import sys
import threading
import time

import gymnasium
import numpy as np
import pytest
from PIL import Image

import marketgen
from conftest import PROMPT

# What somebody types: neither a module nor guarded by __name__.
CELL = """
import numpy as np, marketgen, sys
STOP = 1.0
def action():
    made = np.zeros(9, np.float32)
    made[-1] = STOP
    return made
class Mine:
    def act(self, observation):
        return action()
print("once")
scores = marketgen.evaluate(sys.argv[1], Mine, sys.argv[2], jobs=1)
print([result["failure"] for result in scores.results], [result["detail"] for result in scores.results])
"""


@pytest.mark.parametrize("where", ["cell", "script"])
def test_a_policy_of_no_module_acts_in_a_process_of_its_own(checkout_file, tmp_path, where):
    script = tmp_path / "mine.py"
    script.write_text(CELL)
    source = ["-"] if where == "cell" else [str(script)]
    command = [sys.executable, *source, str(checkout_file), str(tmp_path / "out")]
    run = subprocess.run(command, input=CELL, capture_output=True, text=True, timeout=120)
    assert run.returncode == 0, run.stderr
    assert run.stdout.splitlines() == ["once", "['Unknown', 'Unknown'] ['', '']"]


def test_a_function_of_a_function_travels_too(checkout_file, tmp_path):
    action = np.zeros(9, np.float32)
    action[-1] = 1
    scores = marketgen.evaluate(checkout_file, lambda seen: action, tmp_path / "a", jobs=1)
    assert [result["detail"] for result in scores.results] == ["", ""]


def test_what_cannot_travel_is_said_with_the_way(checkout_file, tmp_path):
    class Holds:
        def __init__(self):
            self.lock = threading.Lock()

        def act(self, observation):
            return np.zeros(9, np.float32)

    with pytest.raises(marketgen.Error, match="give a class.*act_limit_s=0") as caught:
        marketgen.evaluate(checkout_file, Holds(), tmp_path / "a")
    assert (caught.value.code, caught.value.where) == ("usage.bad_flag", "policy")
    assert not (tmp_path / "a").exists()


def test_a_frame_shows_itself(store, renderer):
    frame = renderer.render(store.camera("aisle", 64, 48), quality="fast")
    shown = np.asarray(Image.open(io.BytesIO(frame._repr_png_())))
    assert np.array_equal(shown, frame.rgb)
    assert repr(frame) == "<marketgen.Frame 64 x 48>"


def test_a_store_shows_itself(store):
    page = store._repr_html_()
    for name, count in store.manifest["counts"].items():
        assert re.search(rf"{name}</th><td[^>]*>{count:,}</td>", page)
    pictures = re.findall(r"data:image/png;base64,([^']+)'", page)
    assert [base64.b64decode(picture) for picture in pictures] == [store._repr_png_()], "the aisle was not drawn"
    assert np.asarray(Image.open(io.BytesIO(store._repr_png_()))).std() > 5


class Told:
    """Keeps what it was told, by whom, and raises at `raises_at`."""

    def __init__(self, raises_at=None):
        self.reports, self.threads, self.raises_at = [], set(), raises_at

    def __call__(self, done, total, text):
        self.reports.append((done, total, text))
        self.threads.add(threading.get_ident())
        if text == self.raises_at:
            raise LookupError("enough")

    def check(self):
        assert self.threads == {threading.get_ident()}, "told in the thread that called"
        assert all(0 <= done <= total for done, total, _ in self.reports)
        assert self.reports[-1][0] == self.reports[-1][1], "told of the end"


def test_generating_tells_its_stages_and_changes_nothing(store, tmp_path):
    told = Told()
    made = marketgen.generate(PROMPT, tmp_path / "shop", seed=5, size="9x7m", progress=told)
    told.check()
    stages = list(dict.fromkeys(text for _, _, text in told.reports))
    assert stages == ["plan", "repair", "layout", "scene", "audit", "save"]
    assert made.manifest["scene_hash"] == store.manifest["scene_hash"]


def test_pictures_tell_how_far_they_are(store):
    told = Told()
    renderer = store.renderer(progress=told)
    told.check()
    assert ("geometry" in {text for _, _, text in told.reports}) and len(told.reports) >= 4
    drawing = Told()
    told_of = renderer.render(store.camera("aisle", 96, 64), mode="path", samples=4, progress=drawing)
    drawing.check()
    assert np.array_equal(told_of.rgb, renderer.render(store.camera("aisle", 96, 64), mode="path", samples=4).rgb)


def test_what_progress_raises_ends_the_work_and_nothing_else(tmp_path):
    others = []
    elsewhere = threading.Thread(
        target=lambda: others.append(marketgen.generate(PROMPT, tmp_path / "other", seed=6, size="9x7m", progress=Told()))
    )
    elsewhere.start()
    with pytest.raises(LookupError, match="enough"):
        marketgen.generate(PROMPT, tmp_path / "shop", seed=5, size="9x7m", progress=Told(raises_at="layout"))
    elsewhere.join()
    assert [entry.name for entry in tmp_path.iterdir()] == ["other"], "nothing is left of the one that was ended"
    assert len(others) == 1
    marketgen.generate(PROMPT, tmp_path / "shop", seed=5, size="9x7m", progress=Told())


@pytest.mark.parametrize("policy", ["random", "mine"])
def test_an_evaluation_tells_its_episodes_and_keeps_what_was_finished(checkout_file, tmp_path, policy):
    header, first, second = checkout_file.read_text().splitlines()
    tasks = tmp_path / "tasks.jsonl"
    tasks.write_text("\n".join([header, *(json.dumps({**json.loads(row), "limit_s": 1}) for row in (first, second))]) + "\n")
    asked = {"jobs": 1, "act_limit_s": 0, "policy": policy if policy == "random" else lambda seen: np.zeros(9, np.float32)}
    told = Told()
    marketgen.evaluate(tasks, folder=tmp_path / "a", progress=told, **asked)
    told.check()
    assert told.reports[0] == (0, 2, "episodes") and told.reports[-1] == (2, 2, "episodes")

    class EndsAfterOne(Told):
        def __call__(self, done, total, text):
            super().__call__(done, total, text)
            if done == 1:
                raise LookupError("enough")

    ending = EndsAfterOne()
    try:
        marketgen.evaluate(tasks, folder=tmp_path / "b", progress=ending, **asked)
    except LookupError:
        assert (tmp_path / "b" / "results.jsonl").read_text().count("\n") >= 1
    else:
        assert all(done != 1 for done, _, _ in ending.reports), "the second was as quick as the report"


def test_drawing_an_episode_tells_too(store):
    told = Told()
    env = gymnasium.make("MarketGen/CheckoutUnloading-v1", store=store)
    env.reset(seed=77, options={"progress": told})
    told.check()
    assert told.reports[0] == (0, 1, "episodes")
    with pytest.raises(LookupError):
        env.reset(seed=78, options={"progress": Told(raises_at="episodes")})


@pytest.mark.parametrize("value", [3, "bar", [print]])
def test_progress_that_cannot_be_called_is_said(store, tmp_path, value):
    with pytest.raises(marketgen.Error, match="progress") as caught:
        marketgen.generate(PROMPT, tmp_path / "shop", progress=value)
    assert caught.value.code == "usage.bad_flag"


LONG = {
    "generate": "[marketgen.generate('a supermarket of 2500 m2', f'{out}/{i}', size='60x42m') for i in range(1000)]",
    "evaluate": "marketgen.evaluate(tasks, lambda seen: numpy.zeros(9, numpy.float32), out, act_limit_s=0)",
    "oracle": "marketgen.evaluate(tasks, 'oracle', out)",
    "with progress": "marketgen.evaluate(tasks, 'oracle', out, progress=lambda done, total, text: None)",
}


@pytest.mark.parametrize("what", LONG)
def test_control_c_ends_long_work(checkout_file, tmp_path, what):
    code = (
        "import sys, numpy, marketgen\ntasks, out = sys.argv[1:]\nprint('begins', flush=True)\n"
        f"try:\n    {LONG[what]}\nexcept KeyboardInterrupt:\n    print('ended')\nelse:\n    print('finished')\n"
    )
    command = [sys.executable, "-c", code, str(checkout_file), str(tmp_path / "out")]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, start_new_session=True)
    try:
        assert process.stdout.readline() == "begins\n"
        time.sleep(1.0)
        began = time.monotonic()
        os.kill(process.pid, signal.SIGINT)
        said, _ = process.communicate(timeout=60)
        took = time.monotonic() - began
    finally:
        process.kill()
    assert said == "ended\n" and process.returncode == 0
    assert took < 20
