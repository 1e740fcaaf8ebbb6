"""Photos of shops from Python: arguments and errors. What is read of them: tests/unit/photo."""

import contextlib
import json
import subprocess
import sys
import time

import numpy as np
import pytest
from PIL import Image

import marketgen
from conftest import ROOT


@pytest.mark.parametrize("image", ["gone.jpg", ["gone.jpg"]], ids=["one", "list"])
def test_a_missing_photo_is_an_error(tmp_path, image):
    files = tmp_path / image if isinstance(image, str) else [tmp_path / name for name in image]
    with pytest.raises(marketgen.Error) as caught:
        marketgen.generate("", tmp_path / "shop", image=files)
    assert caught.value.code == "input.not_found"
    assert "gone.jpg" in caught.value.where
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("image", [5, [5], ["a.jpg", None], [["a.jpg"]]], ids=str)
def test_images_are_a_path_or_a_list_of_them(tmp_path, image):
    with pytest.raises(marketgen.Error) as caught:
        marketgen.generate("a shop", tmp_path / "shop", image=image)
    assert (caught.value.code, caught.value.where) == ("usage.bad_flag", "image")


def test_nothing_at_all_is_still_an_empty_brief(tmp_path):
    with pytest.raises(marketgen.Error) as caught:
        marketgen.generate("", tmp_path / "shop", image=[])
    assert caught.value.code == "brief.empty"


def test_read_photo_says_what_is_wrong(tmp_path):
    (tmp_path / "words.jpg").write_text("no picture")
    Image.fromarray(np.zeros((20, 20, 3), np.uint8)).save(tmp_path / "small.png")
    for name, code in (("gone.jpg", "input.not_found"), ("words.jpg", "image.bad_file"), ("small.png", "image.too_small")):
        with pytest.raises(marketgen.Error) as caught:
            marketgen.read_photo(tmp_path / name)
        assert caught.value.code == code, name


def test_a_reading_has_all_that_the_file_has(tmp_path, store, renderer):
    renderer.render(store.camera("aisle", 320, 240), quality="fast").save(tmp_path / "aisle.png")
    reading = marketgen.read_photo(tmp_path / "aisle.png")
    assert {"file", "subject", "subject_confidence", "attributes", "palette"} <= reading.keys()
    for one in reading["attributes"]:
        assert 0 <= one["confidence"] <= 1


# ---- A language model that sees them ----

PHOTO = ROOT / "tests/shop_photos/0001-1.jpg"  # the bank is sure of its lamps, not of its light


def saying(text, **step):
    return {"body": {"choices": [{"message": {"content": text}}], "usage": {"prompt_tokens": 900, "completion_tokens": 100}}, **step}


def seeing(*readings):
    attributes = [{"attribute": name, "value": value, "confidence": sure, "material": ""} for name, value, sure in readings]
    return saying(json.dumps({"photos": [{"picture": 1, "attributes": attributes}]}), **{"for": "You look at photos"})


@contextlib.contextmanager
def scripted_server(folder, *steps):
    """A server that plays the script; its address, and a function for what it was asked."""
    folder.mkdir()
    (folder / "script.json").write_text(json.dumps(steps))
    files = [str(folder / name) for name in ("script.json", "log", "port")]
    server = subprocess.Popen([sys.executable, str(ROOT / "tests/support/mock_http_server.py"), *files])
    try:
        deadline = time.monotonic() + 15
        while not (folder / "port").exists():
            assert time.monotonic() < deadline, "the mock server does not start"
            time.sleep(0.05)
        address = f"http://127.0.0.1:{(folder / 'port').read_text()}"
        yield address, lambda: [json.loads(line) for line in (folder / "log").read_text().splitlines()]
    finally:
        server.terminate()
        server.wait()


def test_a_planner_on_a_model_is_shown_the_photos(tmp_path):
    said = {"size": "8x6m", "image": PHOTO}
    with scripted_server(tmp_path / "server", seeing(("light", "cool", 0.9), ("lamps", "line", 0.9)), saying("Lovely!")) as (url, asked):
        with pytest.warns(UserWarning, match="photos: lamps: panel"):
            store = marketgen.generate(
                "a tiny shop with dairy", tmp_path / "one", planner="http:m", planner_url=url, record=tmp_path / "talk", **said
            )
        assert "data:image/png;base64,iVBOR" in asked()[0]["body"]
    assert store.plan["look"]["light_kelvin"] == 5500
    assert store.report["planner"]["kept"] == "offline planner"
    assert (tmp_path / "one/agents/shown-1.png").exists()
    with pytest.warns(UserWarning):
        again = marketgen.generate("a tiny shop with dairy", tmp_path / "two", planner=f"replay:{tmp_path / 'talk'}", **said)
    assert again.plan == store.plan


def test_a_model_keeps_to_its_limits(tmp_path):
    with scripted_server(tmp_path / "server", seeing(("light", "cool", 0.9)), saying("Lovely!")) as (url, asked):
        with pytest.warns(UserWarning, match="not sure of"):
            store = marketgen.generate(
                "a tiny shop with dairy", tmp_path / "shop", size="8x6m", image=PHOTO, planner="http:m", planner_url=url, max_tokens=900
            )
        assert len(asked()) == 1
    assert "planners.over_budget" in store.report["planner"]["why"]


def test_the_offline_planner_talks_to_nobody(tmp_path):
    with pytest.raises(marketgen.Error) as caught:
        marketgen.generate("a shop", tmp_path / "shop", record=tmp_path / "talk")
    assert (caught.value.code, caught.value.where) == ("usage.bad_flag", "planner")
    assert list(tmp_path.iterdir()) == []
