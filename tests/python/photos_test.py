"""Photos of shops from Python: arguments and errors. What is read of them: tests/unit/photo."""

import numpy as np
import pytest
from PIL import Image

import marketgen


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
