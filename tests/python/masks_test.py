"""Masks of models of pictures: their families, what a picture becomes, duplicates, regions, COCO's runs."""

import concurrent.futures
import hashlib
import pathlib
import time
import types

import numpy as np
import onnx
import pytest
from PIL import Image
from pycocotools import mask as coco

import marketgen
import model_files
from marketgen.models import families, sampling, sessions
from marketgen.models.loaded import Loaded
from marketgen.models.masks import MIN_PREDICTED_IOU, Rules, _Boxes, box_of, grid, masks_of
from marketgen.models.regions import without_small_regions
from marketgen.models.rle import coco_rle

BACKGROUND, RED, GREEN, BLUE = (200, 190, 60), (250, 20, 20), (20, 160, 40), (20, 30, 240)


def picture_with(height, width, *things):
    """Colours, and of each thing (colour, truth) its truth."""
    picture = np.full((height, width, 3), BACKGROUND, np.uint8)
    for colour, truth in things:
        picture[truth] = colour
    return picture, [truth for _, truth in things]


def rectangle(height, width, x, y, w, h):
    made = np.zeros((height, width), bool)
    made[y : y + h, x : x + w] = True
    return made


def disc(height, width, x, y, radius):
    rows, columns = np.mgrid[:height, :width] + 0.5
    return (rows - y) ** 2 + (columns - x) ** 2 < radius**2


def iou(a, b):
    return np.count_nonzero(a & b) / np.count_nonzero(a | b)


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    return tmp_path_factory.mktemp("onnx")


@pytest.fixture(scope="module")
def shelf():
    """A picture with a red rectangle, a blue disc and a small green rectangle, wider than high."""
    h, w = 480, 640
    return picture_with(h, w, (RED, rectangle(h, w, 50, 110, 200, 96)), (BLUE, disc(h, w, 460, 300, 90)), (GREEN, rectangle(h, w, 100, 335, 60, 80)))


def assert_found(masks, truths):
    """Each truth is one mask, the background another, best first, and what is told of a mask is so."""
    assert len(masks) == len(truths) + 1
    background = ~np.any(truths, axis=0)
    for truth in [*truths, background]:
        assert max(iou(mask.pixels, truth) for mask in masks) > 0.9
    assert [mask.predicted_iou for mask in masks] == sorted((mask.predicted_iou for mask in masks), reverse=True)
    assert masks[0].predicted_iou == pytest.approx(0.9 + 0.1 * RED[0] / 255, abs=2e-3) and iou(masks[0].pixels, truths[0]) > 0.9  # the reddest
    for mask in masks:
        assert mask.area == np.count_nonzero(mask.pixels) and mask.box == box_of(mask.pixels)
        assert 0.95 <= mask.stability_score <= 1


# ---- Families ----


@pytest.mark.parametrize("layout", ["first", "open", "half", "last_open", "last_bytes", "last_batch"])
@pytest.mark.parametrize("family", ["sam", "mobile_sam", "sam2"])
def test_every_form_of_a_family_finds_what_there_is(files, shelf, family, layout):
    if family == "sam2":
        two = model_files.sam2_encoder(files / "e.onnx", layout), model_files.sam2_decoder(files / "d.onnx")
    else:
        two = model_files.sam_encoder(files / "e.onnx", layout, family == "mobile_sam"), model_files.sam_decoder(files / "d.onnx", "many")
    segmenter = families.Segmenter(*two)
    assert segmenter.family == family and segmenter.many_points
    assert_found(masks_of(segmenter, shelf[0], Rules(points_per_side=8)), shelf[1])


@pytest.mark.parametrize("layout", ["first", "last_open", "last_bytes", "last_batch"])
def test_what_is_padded_is_nothing_to_the_encoder(files, layout):
    """0 of the values that the models were trained with, whether the file takes these or colours; the picture lies at the upper left."""
    segmenter = families.Segmenter(model_files.sam_encoder(files / "e.onnx", layout), model_files.sam_decoder(files / "d.onnx"))
    seen = segmenter.encode(np.full((50, 100, 3), RED, np.uint8)).features["image_embeddings"][0]
    colour = (np.array(RED, np.float32) - model_files.MEAN) / model_files.DEVIATION
    assert np.abs(seen[:, 32:]).max() < 0.01
    assert np.allclose(seen[:48, :32].reshape(16, 3, 32, 64), colour[None, :, None, None], atol=1e-3)


@pytest.mark.parametrize("size", [(800, 200), (300, 1000), (700, 700), (33, 57)])
def test_whatever_the_shape_of_a_picture(files, size):
    """SAM pads, SAM 2 stretches; both come back to the same pixels."""
    h, w = size
    red, green = rectangle(h, w, w // 8, h // 8, w // 2, h // 4), rectangle(h, w, w // 4, h // 2, w // 2, h // 3)
    picture, truths = picture_with(h, w, (RED, red), (GREEN, green))
    sam = families.Segmenter(model_files.sam_encoder(files / "e.onnx"), model_files.sam_decoder(files / "d.onnx", "many"))
    sam2 = families.Segmenter(model_files.sam2_encoder(files / "e2.onnx"), model_files.sam2_decoder(files / "d2.onnx"))
    for segmenter in (sam, sam2):
        assert_found(masks_of(segmenter, picture, Rules(points_per_side=8)), truths)


def test_one_point_at_a_time_finds_the_same(files, shelf):
    """The official decoder takes one; others say that they take many, and do not."""
    encoder = model_files.sam_encoder(files / "e.onnx")
    found = {}
    for points in ("one", "many", "mixed"):
        segmenter = families.Segmenter(encoder, model_files.sam_decoder(files / f"{points}.onnx", points))
        assert segmenter.many_points == (points == "many")
        found[points] = masks_of(segmenter, shelf[0], Rules(points_per_side=8))
    for other in ("many", "mixed"):
        assert len(found[other]) == len(found["one"]) == 4
        assert all(np.array_equal(a.pixels, b.pixels) for a, b in zip(found[other], found["one"], strict=True))


def test_a_decoder_of_one_mask(files, shelf):
    """As --return-single-mask of the official export makes it."""
    segmenter = families.Segmenter(model_files.sam_encoder(files / "e.onnx", output="embeddings"), model_files.sam_decoder(files / "d.onnx", masks=1))
    assert_found(masks_of(segmenter, shelf[0], Rules(points_per_side=8)), shelf[1])


def test_a_picture_of_one_pixel(files):
    for two in (
        (model_files.sam_encoder(files / "e.onnx"), model_files.sam_decoder(files / "d.onnx")),
        (model_files.sam2_encoder(files / "e2.onnx"), model_files.sam2_decoder(files / "d2.onnx")),
    ):
        [mask] = masks_of(families.Segmenter(*two), np.full((1, 1, 3), RED, np.uint8), Rules(points_per_side=2))
        assert mask.pixels.tolist() == [[True]] and mask.box == (0, 0, 1, 1) and mask.area == 1


def test_files_that_are_no_segmenter(files):
    sam = {"encoder": model_files.sam_encoder(files / "e.onnx"), "decoder": model_files.sam_decoder(files / "d.onnx")}
    sam2 = {"encoder": model_files.sam2_encoder(files / "e2.onnx"), "decoder": model_files.sam2_decoder(files / "d2.onnx")}
    picture = model_files.clip_image(files / "clip.onnx")
    text = files / "text.onnx"
    text.write_text("no model")
    empty = files / "empty.onnx"
    empty.write_bytes(b"")
    cut = model_files.cut_off(pathlib.Path(sam["encoder"]), files / "cut.onnx")
    for encoder, decoder, code, said in [
        (sam["decoder"], sam["encoder"], "model.bad_file", r"Found: .*low_res_masks .* Needed: SAM and MobileSAM: .*orig_im_size.*SAM 2: .*high_res_feats_1"),
        (sam["encoder"], sam2["decoder"], "model.bad_file", "no segmenter that is known here"),
        (sam2["encoder"], sam["decoder"], "model.bad_file", "no segmenter that is known here"),
        (picture, sam["decoder"], "model.bad_file", r"pixel_values \(\? x 3 x 224 x 224, float32\)"),
        (files / "none.onnx", sam["decoder"], "input.not_found", "--sam-encoder names it"),
        (sam["encoder"], files, "input.not_found", "--sam-decoder names it"),
        (text, sam["decoder"], "model.bad_file", "cannot load it"),
        (sam["encoder"], empty, "model.bad_file", "cannot load it"),
        (cut, sam["decoder"], "model.bad_file", "cannot load it"),
    ]:
        with pytest.raises(marketgen.Error, match=said) as caught:
            families.Segmenter(encoder, decoder)
        assert caught.value.code == code


def test_files_that_do_not_fit_together(files):
    graph = model_files.Graph()
    small = graph("AveragePool", "picture", kernel_shape=[16, 16], strides=[16, 16])
    model_files.widened(graph, small, 128, 3, "image_embeddings")
    narrow = graph.write(files / "narrow.onnx", {"picture": ((1, 3, 1024, 1024), 1)}, {"image_embeddings": ((1, 128, 64, 64), 1)})
    with pytest.raises(marketgen.Error, match="it does not run with .*narrow.onnx"):
        families.Segmenter(narrow, model_files.sam_decoder(files / "d.onnx"))
    graph = model_files.Graph()
    graph("GlobalAveragePool", "picture", output="image_embeddings")
    flat = graph.write(files / "oblong.onnx", {"picture": ((1, 3, 512, 1024), 1)}, {"image_embeddings": ((1, 3, 1, 1), 1)})
    with pytest.raises(marketgen.Error, match="its sides would have to be the same"):
        families.Segmenter(flat, model_files.sam_decoder(files / "d.onnx"))


def test_hashes_are_of_the_weights_beside_a_file_too(files):
    file = files / "large.onnx"
    graph = model_files.Graph()
    graph("Add", "x", graph.constant(np.arange(4096)), output="y")
    graph.write(file, {"x": ((4096,), 1)}, {"y": ((4096,), 1)})
    onnx.save(onnx.load(file), file, save_as_external_data=True, location="large_data.bin", size_threshold=0)
    told = sessions.OnnxModel("--sam-encoder", file).files()
    assert [one["file"] for one in told] == ["large.onnx", "large_data.bin"]
    for one in told:
        content = (files / one["file"]).read_bytes()
        assert one["bytes"] == len(content) and one["sha256"] == hashlib.sha256(content).hexdigest()


def test_a_stopped_model_runs_no_more(files):
    segmenter = families.Segmenter(model_files.sam_encoder(files / "e.onnx"), model_files.sam_decoder(files / "d.onnx"))
    segmenter.stop()
    with pytest.raises(sessions.Stopped):
        segmenter.encode(np.zeros((8, 8, 3), np.uint8))


def test_a_run_that_takes_long_is_ended(files):
    """Ten million small steps; stop() comes back soon, and who waits for the run is told."""
    body = onnx.helper.make_graph(
        [onnx.helper.make_node("Identity", ["go"], ["on"]), onnx.helper.make_node("MatMul", ["held", "held"], ["made"])],
        "body",
        [onnx.helper.make_tensor_value_info(name, kind, shape) for name, kind, shape in (("n", 7, ()), ("go", 9, ()), ("held", 1, (64, 64)))],
        [onnx.helper.make_tensor_value_info(name, kind, shape) for name, kind, shape in (("on", 9, ()), ("made", 1, (64, 64)))],
    )
    graph = model_files.Graph()
    graph("Loop", graph.constant(10**7, np.int64), graph.constant(True, bool), "x", output="y", body=body)
    model = sessions.OnnxModel("--sam-encoder", graph.write(files / "long.onnx", {"x": ((64, 64), 1)}, {"y": ((64, 64), 1)}))
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        runs = [pool.submit(model.run, {"x": np.eye(64)}, ["y"]) for _ in range(2)]
        time.sleep(0.5)
        assert not any(run.done() for run in runs)
        began = time.monotonic()
        model.stop()
        assert time.monotonic() - began < 5
        for run in runs:
            with pytest.raises(sessions.Stopped):
                run.result(timeout=10)


def test_one_request_at_a_time_in_a_model():
    """The second begins when the first is answered."""
    inside, most = [], []

    def vectors(_pictures):
        inside.append(1)
        most.append(len(inside))
        time.sleep(0.05)
        inside.pop()
        return np.zeros((1, 3))

    model = types.SimpleNamespace(providers=[], stop=lambda: None)
    loaded = Loaded(None, Rules(), types.SimpleNamespace(files=list, model=model, width=3, vectors=vectors), None)
    with concurrent.futures.ThreadPoolExecutor(6) as pool:
        list(pool.map(loaded.picture_vectors, [[]] * 6))
    assert most == [1] * 6


# ---- Rules ----


def test_every_rule_holds(files, shelf):
    """Each by itself: what one lets through another does not."""
    segmenter = families.Segmenter(model_files.sam2_encoder(files / "e.onnx"), model_files.sam2_decoder(files / "d.onnx"))
    picture, truths = shelf

    def found(**rules):
        return masks_of(segmenter, picture, Rules(points_per_side=4, **rules))

    [best] = found(min_predicted_iou=0.99)
    assert iou(best.pixels, truths[0]) > 0.9
    everything = found(min_predicted_iou=0.5, max_box_iou=1.0)
    whole = [mask.area == picture.shape[0] * picture.shape[1] for mask in everything]
    assert len(whole) == 32 and sum(whole) == 16  # each point's mask, and the whole picture
    assert len(found(min_predicted_iou=0.5, max_box_iou=1.0, min_stability=0.9999)) == 16  # whose edges are sure
    assert MIN_PREDICTED_IOU.keys() == {"sam", "mobile_sam", "sam2"}


def test_what_is_double_is_not_brought_to_size(files, shelf, monkeypatch):
    """That would take most of the time: of 128 masks four are looked at in full."""
    segmenter = families.Segmenter(model_files.sam2_encoder(files / "e.onnx"), model_files.sam2_decoder(files / "d.onnx"))
    enlarged = []
    values = sampling.Part.values
    monkeypatch.setattr(sampling.Part, "values", lambda part: enlarged.append(part) or values(part))
    assert len(masks_of(segmenter, shelf[0], Rules(points_per_side=8))) == len(enlarged) == 4


def test_points_lie_in_the_middles_of_fields():
    assert grid(2).tolist() == [[0.25, 0.25], [0.75, 0.25], [0.25, 0.75], [0.75, 0.75]]
    assert grid(1).tolist() == [[0.5, 0.5]]


def test_doubles_go():
    """Of boxes, best first, as one would by hand."""
    boxes = _Boxes(0.7)
    assert boxes.add_new((0, 0, 100, 100))
    assert not boxes.add_new((0, 0, 100, 71))  # 0.71 of the first
    assert boxes.add_new((0, 0, 100, 70))  # 0.7: not more
    assert boxes.add_new((200, 0, 100, 100))
    assert not boxes.add_new((5, 5, 95, 95))


def test_doubles_go_in_random_boxes():
    random = np.random.default_rng(3)
    given = [tuple(int(v) for v in (*random.integers(0, 60, 2), *random.integers(20, 60, 2))) for _ in range(300)]

    def overlap(a, b):
        shared = [max(0, min(a[i] + a[i + 2], b[i] + b[i + 2]) - max(a[i], b[i])) for i in (0, 1)]
        both = shared[0] * shared[1]
        return both / (a[2] * a[3] + b[2] * b[3] - both)

    kept = []
    for box in given:
        if all(overlap(box, other) <= 0.5 for other in kept):
            kept.append(box)
    boxes = _Boxes(0.5)
    assert [box for box in given if boxes.add_new(box)] == kept
    assert 20 < len(kept) < 200


# ---- Sampling ----


def test_enlarging_is_bilinear_as_others_do_it():
    """Pillow is the judge; where it makes smaller, it also smooths."""
    coarse = np.random.default_rng(5).normal(size=(7, 9)).astype(np.float32)
    made = sampling.bilinear(40, 7) @ coarse @ sampling.bilinear(31, 9).T
    assert np.allclose(made, np.asarray(Image.fromarray(coarse).resize((31, 40), Image.Resampling.BILINEAR)), atol=1e-5)
    assert np.allclose(sampling.bilinear(3, 6) @ np.arange(6), [0.5, 2.5, 4.5])
    assert np.allclose(sampling.bilinear(5, 1), 1)


@pytest.mark.parametrize("seed", range(8))
def test_a_part_is_what_the_whole_has_there(seed):
    random = np.random.default_rng(seed)
    height, width = int(random.integers(1, 300)), int(random.integers(1, 300))
    scaled = families._longest(height, width, 1024)
    way = sampling.padded(height, width, scaled, 1024, (256, 256)) if seed % 2 else sampling.stretched(height, width, (256, 256))
    logits = np.full((256, 256), -8.0, np.float32)
    top, left = random.integers(0, 200, 2)
    logits[top : top + 40, left : left + 25] = random.normal(0, 4, (40, 25))
    whole = way.rows @ logits @ way.columns.T
    part = way.part(logits)
    inside = np.full_like(whole, -2.0)
    if part is not None:
        inside[part.rows, part.columns] = part.values()
    near = np.abs(np.abs(whole) - 1) > 1e-3  # but for what rounding decides
    for threshold in (-1, 0, 1):
        assert np.array_equal((inside > threshold)[near], (whole > threshold)[near])
    if part is not None and part.box() is not None:
        assert part.box() == box_of(whole > 0)
    else:
        assert not (whole > 0).any()


def test_what_is_in_the_padding_alone_is_nothing():
    way = sampling.padded(100, 400, (256, 1024), 1024, (256, 256))
    logits = np.full((256, 256), -8.0, np.float32)
    logits[200:220, 50:70] = 8
    assert way.part(logits) is None and way.part(np.full((256, 256), -8.0, np.float32)) is None


# ---- Regions ----


def regions_by_hand(mask):
    """Sets of pixels that touch, by their sides or corners."""
    left, found = {tuple(place) for place in np.argwhere(mask).tolist()}, []
    while left:
        region, edge = set(), [left.pop()]
        while edge:
            row, column = edge.pop()
            region.add((row, column))
            beside = {(row + i, column + j) for i in (-1, 0, 1) for j in (-1, 0, 1)} & left
            left -= beside
            edge += beside
        found.append(region)
    return found


def cleaned_by_hand(mask, least):
    made = mask.copy()
    for hole in regions_by_hand(~made):
        if len(hole) < least:
            made[tuple(np.array(list(hole)).T)] = True
    islands = regions_by_hand(made)
    largest = max(map(len, islands))
    for island in islands:
        if len(island) < least and len(island) < largest:
            made[tuple(np.array(list(island)).T)] = False
    return made


@pytest.mark.parametrize("seed", range(30))
def test_small_regions_go_as_by_hand(seed):
    random = np.random.default_rng(seed)
    shape = random.integers(1, 40, 2)
    mask = random.random(shape) < (0.2, 0.5, 0.8)[seed % 3]
    mask[random.integers(shape[0]), random.integers(shape[1])] = True
    for least in (2, 5, 50):
        assert np.array_equal(without_small_regions(mask, least), cleaned_by_hand(mask, least))


def test_regions_of_a_spiral_and_of_nothing():
    spiral = np.zeros((21, 21), bool)
    for ring in range(0, 10, 2):  # rings that are joined: one region that turns back on itself
        spiral[ring, ring : 21 - ring] = spiral[20 - ring, ring : 21 - ring] = True
        spiral[ring : 21 - ring, ring] = spiral[ring : 21 - ring, 20 - ring] = True
        spiral[ring : ring + 3, 10] = True
    assert np.array_equal(without_small_regions(spiral, 5), spiral)
    nothing = np.zeros((4, 5), bool)
    assert not without_small_regions(nothing, 100).any()
    speck = nothing.copy()
    speck[2, 3] = True
    assert np.array_equal(without_small_regions(speck, 100), np.ones((4, 5), bool))  # all the rest is a hole
    assert np.array_equal(without_small_regions(speck, 0), speck)


def test_masks_lose_their_specks(files):
    """A disc with a hole and a speck beside it, of the same colour."""
    h, w = 512, 512
    thing = disc(h, w, 250, 250, 120) & ~rectangle(h, w, 248, 248, 16, 16) | rectangle(h, w, 440, 440, 12, 12)
    picture, _ = picture_with(h, w, (RED, thing))
    segmenter = families.Segmenter(model_files.sam2_encoder(files / "e.onnx"), model_files.sam2_decoder(files / "d.onnx"))
    dirty = masks_of(segmenter, picture, Rules(points_per_side=8, min_region_px=0))[0]
    clean = masks_of(segmenter, picture, Rules(points_per_side=8, min_region_px=400))[0]
    assert dirty.box[0] + dirty.box[2] > 440 and not dirty.pixels[255, 255]
    assert clean.pixels[255, 255] and iou(clean.pixels, disc(h, w, 250, 250, 120)) > 0.95
    assert clean.box == box_of(clean.pixels) and clean.area == np.count_nonzero(clean.pixels) and clean.box[0] + clean.box[2] < 400


# ---- COCO ----


def assert_as_coco(mask):
    made, wanted = coco_rle(mask), coco.encode(np.asfortranarray(mask, dtype=np.uint8))
    assert made == {"size": wanted["size"], "counts": wanted["counts"].decode()}
    assert np.array_equal(coco.decode({**made, "counts": made["counts"].encode()}), mask)


@pytest.mark.parametrize("shape", [(1, 1), (1, 7), (9, 1), (5, 4), (64, 48), (480, 640)])
def test_runs_are_those_of_pycocotools(shape):
    random = np.random.default_rng(11)
    for share in (0.0, 0.02, 0.5, 0.98, 1.0):
        assert_as_coco(random.random(shape) < share)
    blocks = np.kron(random.random((3, 3)) < 0.5, np.ones((shape[0], shape[1]))) > 0
    assert_as_coco(blocks)


def test_runs_of_shapes_are_short(shelf):
    for truth in shelf[1]:
        assert_as_coco(truth)
        assert len(coco_rle(truth)["counts"]) < 2500
