"""COCO exports judged from outside: pycocotools, Pillow, NumPy, and what `query` says of the store."""

import collections
import io
import json
import warnings
from contextlib import redirect_stdout

import numpy as np
import pytest
from conftest import run
from PIL import Image
from pycocotools import mask as masks
from pycocotools.coco import COCO
from pycocotools.cocoeval import COCOeval

# Of pycocotools itself with NumPy 2.
pytestmark = pytest.mark.filterwarnings("ignore:__array__ implementation doesn't accept a copy keyword:DeprecationWarning")

PROMPT = "an untidy shop with dairy, snacks and drinks; some shelves are out of stock; 10 % of the price tags are missing, 10 % wrong price tags"
SIZE = (640, 360)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("coco")
    run("generate", PROMPT, "--size", "9x7m", "--seed", 4, "-o", folder / "store", "--no-previews", "--quiet")
    summary = run(
        *("export", folder / "store", "--format", "coco", "-o", folder / "shelves.json", "--check", "--json", "--quiet"),
        *("--camera-spacing", 1.2, "--size", f"{SIZE[0]}x{SIZE[1]}"),
    )
    (folder / "summary.json").write_text(summary)
    return folder


@pytest.fixture(scope="module")
def coco(folder):
    with warnings.catch_warnings(), redirect_stdout(io.StringIO()):
        warnings.simplefilter("error")
        return COCO(str(folder / "shelves.json"))


def of(coco, category):
    return coco.loadAnns(coco.getAnnIds(catIds=coco.getCatIds(catNms=[category])))


def products(coco):
    return [a for a in coco.dataset["annotations"] if "instance" in a]


def test_counts_are_those_of_the_check(folder, coco):
    summary = json.loads((folder / "summary.json").read_text())
    assert summary["pictures"] == len(coco.imgs) > 10
    assert summary["annotations"] == len(coco.anns)
    assert summary["gaps"] == len(of(coco, "gap")) > 0
    assert summary["price_tags"] == len(of(coco, "price_tag")) > 50
    assert summary["wrong_price_tags"] == sum("fault" in a for a in of(coco, "price_tag")) > 5
    assert summary["missing_price_tags"] == len(of(coco, "missing_price_tag")) > 5
    assert summary["misplaced"] == sum(a["misplaced"] for a in products(coco)) > 0


def test_boxes_and_areas_are_those_of_the_masks(coco):
    for annotation in coco.dataset["annotations"]:
        mask = coco.annToMask(annotation)
        assert mask.shape == SIZE[::-1]
        assert mask.sum() == annotation["area"] == masks.area(annotation["segmentation"]) > 0
        assert annotation["bbox"] == masks.toBbox(annotation["segmentation"]).tolist()
        assert annotation["iscrowd"] == 0
        assert 0 <= annotation["occlusion"] < 1


def test_items_and_tags_share_no_pixel(coco):
    for image in coco.imgs:
        seen = np.zeros(SIZE[::-1], int)
        for annotation in coco.loadAnns(coco.getAnnIds(imgIds=[image])):
            if "instance" in annotation or "text" in annotation:
                seen += coco.annToMask(annotation)
        assert seen.max() <= 1


@pytest.mark.parametrize("kind", ["bbox", "segm"])
def test_truth_against_itself_is_perfect(coco, kind):
    found = [
        {"image_id": a["image_id"], "category_id": a["category_id"], "score": 1.0, "bbox": a["bbox"], "segmentation": a["segmentation"]}
        for a in coco.dataset["annotations"]
    ]
    if kind == "bbox":
        found = [{key: value for key, value in row.items() if key != "segmentation"} for row in found]
    with redirect_stdout(io.StringIO()):
        judge = COCOeval(coco, coco.loadRes(found), kind)
        judge.params.maxDets = [1, 100, 1000]
        judge.evaluate()
        judge.accumulate()
    # Of all sizes, with up to 1,000 a picture; -1 where there is nothing to find. (By size truth and finding may differ: COCOeval
    # takes a found box's own area, and of truth the mask's.)
    precision = judge.eval["precision"][:, :, :, 0, -1]
    assert (precision >= 0).any()
    assert precision[precision >= 0].min() == pytest.approx(1, abs=1e-12)


def test_pictures_are_there(folder, coco):
    for image in coco.imgs.values():
        with Image.open(folder / image["file_name"]) as color:
            assert (color.format, color.size, color.mode) == ("JPEG", SIZE, "RGB")
            assert np.asarray(color).std() > 5
        with Image.open(folder / image["depth_file"]) as depth:
            assert (depth.format, depth.size) == ("PNG", SIZE)
            assert depth.mode.startswith("I")


def test_depth_and_pose_put_items_where_the_store_has_them(folder, coco):
    """Back-projected by the camera matrix and pose, the middle of an item's pixels is near the item."""
    places = {row["id"]: np.array([row["x_m"], row["y_m"], row["z_m"]]) for row in json.loads(run("query", folder / "store", "products", "--format", "json"))}
    far = 0
    for image in coco.imgs.values():
        with Image.open(folder / image["depth_file"]) as picture:
            depth = np.asarray(picture).astype(float) / 1000
        k, pose = np.array(image["camera_matrix"]), np.array(image["world_from_camera"])
        for annotation in coco.loadAnns(coco.getAnnIds(imgIds=[image["id"]])):
            if annotation.get("occlusion") > 0.2 or "instance" not in annotation:
                continue
            y, x = np.nonzero(coco.annToMask(annotation))
            rays = np.linalg.inv(k) @ np.stack([x, y, np.ones_like(x)])
            points = pose[:3, :3] @ (rays * depth[y, x]) + pose[:3, 3:]
            away = np.abs(points.mean(axis=1) - places[annotation["instance"]])
            far += away[0] > 0.3 or away[1] > 0.3 or away[2] > 0.4
            assert abs(annotation["depth_m"] - depth[y, x].mean()) < 1e-3
    assert far == 0


def test_prices_and_gaps_are_those_of_the_planogram(folder, coco):
    planogram = json.loads(run("query", folder / "store", "planogram", "--format", "json"))
    rows = {(r["fixture"], "front" if r["side"] == 0 else "back", r["level"] + 1, r["position"] + 1): r for r in planogram}
    place = lambda a: tuple(a["place"][key] for key in ("fixture", "side", "shelf", "position"))  # noqa: E731
    for tag in of(coco, "price_tag"):
        row = rows[place(tag)]
        assert (tag["sku"], tag["promotion"]) == (row["sku"], row["promotion"])
        assert (tag["price"] == row["price"]) == ("fault" not in tag)
        assert tag.get("fault", "wrong_price") == "wrong_price"
        assert f"{tag['price']:.2f} €" in tag["text"]
    tagged = {place(tag) for tag in of(coco, "price_tag")}
    for missing in of(coco, "missing_price_tag"):
        assert missing["sku"] == rows[place(missing)]["sku"] and place(missing) not in tagged
    empty = collections.Counter()
    for gap in of(coco, "gap"):
        row = rows[place(gap)]
        assert gap["sku"] == row["sku"]
        empty[row["units"] == 0] += 1
        assert "column" not in gap or 1 <= gap["column"] <= row["facings"]
    assert empty[True] > 0
    for item in products(coco):
        if "place" in item:
            assert rows[place(item)]["sku"] == item.get("planogram_sku", item["sku"])


def test_what_has_units_on_all_columns_is_no_gap(folder, coco):
    """Every block that is sold out and seen by a camera square before it has its gaps."""
    skus = {category["name"] for category in coco.cats.values()}
    assert {"gap", "price_tag"} < skus
    assert all(category["supercategory"] for category in coco.cats.values())
    sold_out = [r for r in json.loads(run("query", folder / "store", "planogram", "--format", "json")) if r["units"] == 0]
    seen = {(g["place"]["fixture"], g["place"]["shelf"], g["place"]["position"]) for g in of(coco, "gap")}
    missing = [r for r in sold_out if (r["fixture"], r["level"] + 1, r["position"] + 1) not in seen]
    assert len(missing) <= len(sold_out) / 3, missing
