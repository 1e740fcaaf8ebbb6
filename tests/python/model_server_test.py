"""`python -m marketgen.model_server`: what clients ask and are answered, what it refuses, how it begins and ends."""

import concurrent.futures
import hashlib
import http.client
import io
import json
import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import time

import numpy as np
import pytest
from PIL import Image
from pycocotools import mask as coco

import model_files
from masks_test import iou
from model_requests import FORM, IMAGE, PICTURE, PNG, PROGRAM, RLE, THINGS, H, Served, W, form, malformed, png


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    folder = tmp_path_factory.mktemp("onnx")
    made = {
        "sam_encoder": model_files.sam_encoder(folder / "sam_encoder.onnx"),
        "sam_decoder": model_files.sam_decoder(folder / "sam_decoder.onnx"),
        "sam2_encoder": model_files.sam2_encoder(folder / "sam2_encoder.onnx"),
        "sam2_decoder": model_files.sam2_decoder(folder / "sam2_decoder.onnx"),
        "image": model_files.clip_image(folder / "image.onnx"),
        "wide": model_files.clip_image(folder / "wide.onnx", batch=1, width=5),
        "text": model_files.clip_text(folder / "text.onnx", folder / "tokenizer.json"),
        "tokenizer": str(folder / "tokenizer.json"),
    }
    return made


def sam2_flags(files):
    return ["--sam-encoder", files["sam2_encoder"], "--sam-decoder", files["sam2_decoder"]]


def clip_flags(files):
    return ["--clip-image", files["image"], "--clip-text", files["text"], "--tokenizer", files["tokenizer"]]


@pytest.fixture(scope="module")
def served(files):
    """With everything, and few points."""
    server = Served(*sam2_flags(files), *clip_flags(files), "--points-per-side", 8, "--threads", 1)
    yield server
    code, out, err = server.end(signal.SIGTERM)
    assert code == 0 and "Traceback" not in err and "warning" not in err, err


@pytest.fixture(scope="module")
def bare(files):
    """With texts alone."""
    server = Served("--clip-text", files["text"], "--tokenizer", files["tokenizer"], "--quiet")
    yield server
    assert server.end() == (0, "", "")


# ---- What is answered ----


def test_it_says_what_it_has(served, files):
    status, health = served.ask("GET", "/health")
    assert status == 200 and health["ok"] is True
    assert health["masks"]["family"] == "sam2" and health["masks"]["rules"]["points_per_side"] == 8
    assert health["masks"]["rules"]["min_predicted_iou"] == 0.8 and health["embed"]["width"] == 3
    told = [*health["masks"]["files"], *health["embed"]["image"]["files"], *health["embed"]["text"]["files"]]
    assert [one["file"] for one in told] == ["sam2_encoder.onnx", "sam2_decoder.onnx", "image.onnx", "text.onnx", "tokenizer.json"]
    for one, file in zip(told, ("sam2_encoder", "sam2_decoder", "image", "text", "tokenizer"), strict=True):
        assert one["sha256"] == hashlib.sha256(pathlib.Path(files[file]).read_bytes()).hexdigest()
    assert served.said[:3] == ["masks sam2: sam2_encoder.onnx, sam2_decoder.onnx", "image vectors: image.onnx", "text vectors: text.onnx, tokenizer.json"]


@pytest.mark.parametrize("fields", [[("image", "shelf.png", PNG)], [IMAGE], [("image", None, PNG)]], ids=["file", "bytes", "field"])
def test_masks_as_genmanip_asks_for_them(served, fields):
    """`requests.post(url, files={"image": open(file, "rb")})`; rows of true and false, areas."""
    status, document = served.post("/generate_masks", *fields)
    assert status == 200 and list(document) == ["masks"] and len(document["masks"]) == 3
    for truth in [*THINGS, ~(THINGS[0] | THINGS[1])]:
        assert max(iou(np.array(mask["segmentation"]), truth) for mask in document["masks"]) > 0.9
    for mask in document["masks"]:
        assert list(mask) == ["segmentation", "area", "bbox", "predicted_iou", "stability_score"]
        pixels = np.array(mask["segmentation"])
        assert pixels.dtype == bool and pixels.shape == (H, W) and np.count_nonzero(pixels) == mask["area"]
        rows, columns = np.nonzero(pixels)
        assert mask["bbox"] == [columns.min(), rows.min(), np.ptp(columns) + 1, np.ptp(rows) + 1]
    assert [mask["predicted_iou"] for mask in document["masks"]] == sorted((mask["predicted_iou"] for mask in document["masks"]), reverse=True)


def test_masks_as_coco_writes_them(served):
    """By a field of the form or by the address; the same masks."""
    plain = served.post("/generate_masks", IMAGE)[1]["masks"]
    by_field = served.post("/generate_masks", IMAGE, RLE)[1]["masks"]
    status, by_address = served.ask("POST", "/generate_masks?format=coco_rle", form(IMAGE), FORM)
    assert status == 200 and by_field == by_address["masks"] and len(json.dumps(by_field)) < 5000
    for packed, mask in zip(by_field, plain, strict=True):
        decoded = coco.decode({"size": packed["segmentation"]["size"], "counts": packed["segmentation"]["counts"].encode()})
        assert np.array_equal(decoded, np.array(mask["segmentation"])) and packed["area"] == mask["area"]
        assert coco.toBbox({**packed["segmentation"], "counts": packed["segmentation"]["counts"].encode()}).tolist() == packed["bbox"]


def test_pictures_of_every_kind(served):
    """JPEG, grey, 16 bits, a palette, transparency, turned by a camera: the same things are found."""
    jpeg = png(PICTURE, format="JPEG", quality=95)
    turned = Image.fromarray(np.rot90(PICTURE))
    exif = turned.getexif()
    exif[0x0112] = 6  # to be turned by a quarter, clockwise
    written = io.BytesIO()
    turned.save(written, "JPEG", quality=95, exif=exif)
    palette = io.BytesIO()
    Image.fromarray(PICTURE).quantize(8).save(palette, "PNG")
    clear = np.dstack([PICTURE, np.where(THINGS[0] | THINGS[1], 255, 0).astype(np.uint8)])
    for content in (jpeg, written.getvalue(), palette.getvalue(), png(clear)):
        status, document = served.post("/generate_masks", ("image", "p", content), RLE)
        assert status == 200
        masks = [coco.decode({**mask["segmentation"], "counts": mask["segmentation"]["counts"].encode()}) > 0 for mask in document["masks"]]
        assert all(max(iou(mask, truth) for mask in masks) > 0.88 for truth in THINGS)
    grey = np.where(THINGS[0], 60000, 9000).astype(np.uint16)
    deep, flat = (served.post("/generate_masks", ("image", "p", content), RLE) for content in (png(grey), png((grey >> 8).astype(np.uint8))))
    assert deep == flat and deep[0] == 200 and len(deep[1]["masks"]) == 2


def test_a_picture_of_one_pixel(served):
    for content in (png(PICTURE[:1, :1]), png(PICTURE[:1, :1], format="JPEG")):
        status, document = served.post("/generate_masks", ("image", "p", content), RLE)
        assert status == 200 and [(mask["area"], mask["bbox"], mask["segmentation"]) for mask in document["masks"]] == [(1, [0, 0, 1, 1], {"size": [1, 1], "counts": "01"})]
        assert served.post("/generate_masks", ("image", "p", content))[1]["masks"][0]["segmentation"] == [[True]]
        assert served.post("/embed_image", ("image", "p", content))[0] == 200


def test_vectors_of_pictures_and_words_can_be_compared(served):
    plain = {word: png(np.full((40, 60, 3), np.array(colour) * 255, np.uint8)) for word, colour in [("red", (1, 0, 0)), ("green", (0, 1, 0)), ("blue", (0, 0, 1))]}
    status, pictures = served.post("/embed_image", *(("image", word, content) for word, content in plain.items()))
    assert status == 200 and np.shape(pictures["embeddings"]) == (3, 3)
    words = {"texts": [f"a {word} tin" for word in plain] + ["Red", "red " * 200]}
    status, texts = served.ask("POST", "/embed_text", json.dumps(words))
    assert status == 200 and np.shape(texts["embeddings"]) == (5, 3)
    for vectors in (pictures, texts):
        assert np.allclose(np.linalg.norm(vectors["embeddings"], axis=1), 1)
    likeness = np.array(texts["embeddings"][:3]) @ np.array(pictures["embeddings"]).T
    assert likeness.argmax(axis=1).tolist() == [0, 1, 2]
    assert np.allclose(texts["embeddings"][3:], [[1, 0, 0]] * 2, atol=1e-6)
    one = served.post("/embed_image", ("image", "p", plain["green"]))[1]["embeddings"]
    assert np.allclose(one[0], pictures["embeddings"][1])


def test_clip_sees_the_middle_of_a_picture(served):
    picture = np.full((100, 300, 3), (255, 0, 0), np.uint8)
    picture[:, 100:200] = (0, 0, 255)
    [vector] = served.post("/embed_image", ("image", "p", png(picture)))[1]["embeddings"]
    assert vector[2] > 0.99 > 0.1 > vector[0]
    thread = np.full((2, 6000, 3), (0, 255, 0), np.uint8)
    assert served.post("/embed_image", ("image", "p", png(thread)))[1]["embeddings"][0][1] > 0.99


@pytest.mark.parametrize("form_of", [{"attention": False}, {"length": 7}, {"output": "pooled"}], ids=str)
def test_texts_by_other_exports(files, tmp_path, form_of):
    """Without a mask of attention, of a fixed length, with another name."""
    from marketgen.models.embedder import TextEmbedder

    made = TextEmbedder(model_files.clip_text(tmp_path / "t.onnx", tmp_path / "t.json", **form_of), tmp_path / "t.json")
    vectors = made.vectors(["red", "a green green tin", "blue " * 90])
    assert np.allclose(np.linalg.norm(vectors, axis=1), 1) and vectors.argmax(axis=1).tolist() == [0, 1, 2]


def test_pictures_one_by_one(files):
    """A file that takes one at a time."""
    from marketgen.models.embedder import ImageEmbedder

    made = ImageEmbedder(files["wide"])
    assert made.vectors([PICTURE, PICTURE[::-1], PICTURE]).shape == (3, 5) and made.width == 5


# ---- At the same time, and again ----


def test_many_at_the_same_time_are_answered_as_alone(served):
    pictures = [png(np.roll(PICTURE, 8 * i, axis=1)) for i in range(6)]
    asked = [("/generate_masks", ("image", "p", picture), RLE) for picture in pictures]
    asked += [("/embed_image", ("image", "p", picture)) for picture in pictures]
    alone = [served.post(*one) for one in asked]
    with concurrent.futures.ThreadPoolExecutor(12) as pool:
        together = list(pool.map(lambda one: served.post(*one), asked))
    assert together == alone and {status for status, _ in alone} == {200}


def test_a_connection_is_kept(served):
    connection = http.client.HTTPConnection("127.0.0.1", served.port, timeout=60)
    for _ in range(3):
        for path, body, wanted in [("/generate_masks", form(IMAGE), 200), ("/generate_masks", form(RLE), 400), ("/nowhere", form(IMAGE), 404)]:
            connection.request("POST", path, body, FORM)
            answer = connection.getresponse()
            assert answer.status == wanted and json.loads(answer.read())
            held = connection.sock
            assert held is not None
    connection.close()


def test_old_clients_get_the_rows_too(served):
    """HTTP/1.0 knows no chunks."""
    body = form(IMAGE)
    head = f"POST /generate_masks HTTP/1.0\r\nContent-Type: {FORM['Content-Type']}\r\nContent-Length: {len(body)}\r\n\r\n"
    answer = served.raw(head.encode() + body)
    assert b"chunked" not in answer and len(json.loads(answer.partition(b"\r\n\r\n")[2])["masks"]) == 3


# ---- What is refused ----

LARGE = png(np.zeros((4100, 4100), np.uint8))


@pytest.mark.parametrize(
    ("path", "fields", "said"),
    [
        ("/generate_masks", [], "'image'; the form has none"),
        ("/generate_masks", [("picture", "p", PNG)], "the form has 'picture'"),
        ("/generate_masks", [IMAGE, IMAGE], "2 pictures; 1 are the most"),
        ("/generate_masks", [("image", "p", b"")], "empty"),
        ("/generate_masks", [("image", "p", b"GIF89a not one of ours")], "neither a PNG nor a JPEG"),
        ("/generate_masks", [("image", "p", PNG[: len(PNG) // 2])], "broken"),
        ("/generate_masks", [("image", "p", LARGE)], "4100 x 4100 pixels; 16,777,216 are the most"),
        ("/generate_masks", [IMAGE, ("format", None, b"png")], "format is 'png'; it is booleans or coco_rle"),
        ("/embed_image", [], "'image'; the form has none"),
        ("/embed_image", [("image", "p", PNG)] * 65, "65 pictures; 64 are the most"),
        ("/embed_image", [("image", "p", b"no")], "neither a PNG nor a JPEG"),
    ],
    ids=lambda value: value if isinstance(value, str) else None,
)
def test_forms_that_are_refused(served, path, fields, said):
    status, document = served.post(path, *fields)
    assert status == 400 and list(document) == ["error"] and said in document["error"]


@pytest.mark.parametrize(
    "body",
    [b"", b"{", b"[]", b"{}", b'{"texts": "red"}', b'{"texts": []}', b'{"texts": [1]}', b'{"texts": ["\\ud800"]}', b"[" * 100_000, json.dumps({"texts": ["a"] * 257}).encode(), json.dumps({"texts": ["a" * 4097]}).encode()],
    ids=range(11),
)
def test_texts_that_are_refused(served, body):
    status, document = served.ask("POST", "/embed_text", body)
    assert status == 400 and list(document) == ["error"]


def test_a_model_that_fails_is_told_and_goes_on(bare):
    status, document = bare.ask("POST", "/embed_text", b'{"texts": ["red", "beyond"]}')
    assert status == 500 and "indices element out of data bounds" in document["error"], document
    assert bare.ask("POST", "/embed_text", b'{"texts": ["green"]}') == (200, {"embeddings": [[0.0, 1.0, 0.0]]})


def test_parts_that_are_not_loaded_say_their_flags(bare):
    assert bare.ask("GET", "/health")[1]["masks"] is None and bare.ask("GET", "/health")[1]["embed"]["image"] is None
    assert bare.post("/generate_masks", IMAGE) == (503, {"error": "this server has no model for it: start it with --sam-encoder and --sam-decoder"})
    assert bare.post("/embed_image", IMAGE) == (503, {"error": "this server has no model for it: start it with --clip-image"})
    assert bare.ask("POST", "/embed_text", b'{"texts": ["red"]}') == (200, {"embeddings": [[1.0, 0.0, 0.0]]})


def test_other_places_and_methods(served):
    assert served.ask("GET", "/") == (404, {"error": "there is /generate_masks, /embed_image, /embed_text, /health"})
    assert served.ask("GET", "/generate_masks") == (405, {"error": "/generate_masks takes POST"})
    assert served.ask("POST", "/health", b"x") == (405, {"error": "/health takes GET"})
    for method in ("PUT", "DELETE", "OPTIONS"):
        assert served.ask(method, "/health")[0] == 501


def test_a_body_that_is_too_large(served):
    """A client that asks first, as curl does, sends nothing of it."""
    head = f"POST /generate_masks HTTP/1.1\r\nHost: x\r\nContent-Type: {FORM['Content-Type']}\r\nContent-Length: {65 << 20}\r\nExpect: 100-continue\r\n\r\n"
    answer = served.raw(head.encode())
    assert answer.startswith(b"HTTP/1.1 413 ") and b"67,108,864 are the most" in answer
    status, document = served.ask("POST", "/generate_masks", bytes((64 << 20) + 1), FORM)
    assert status == 413 and "67,108,864 are the most" in document["error"]
    status, document = served.ask("POST", "/embed_text", bytes((1 << 20) + 1))
    assert status == 413 and "1,048,576 are the most" in document["error"]
    assert served.ask("GET", "/health")[0] == 200


MALFORMED = list(malformed())


def test_there_are_many_malformed_requests():
    assert len(MALFORMED) >= 50


@pytest.mark.parametrize("number", range(len(MALFORMED)))
def test_malformed_requests_are_refused_and_the_next_is_answered(served, number):
    answer = served.raw(MALFORMED[number])
    if answer:  # or the connection is closed, where no request was sent whole
        head, _, body = answer.partition(b"\r\n\r\n")
        if head.startswith(b"HTTP/"):
            assert re.match(rb"HTTP/1\.1 (400|411|413|414|417|431|501|505) ", head), answer[:200]
        else:  # the answer to HTTP/0.9 has no head
            body = answer
        assert list(json.loads(body)) == ["error"], answer[:300]
    assert served.ask("GET", "/health")[0] == 200


# ---- Beginning and ending ----


def failed(*flags):
    done = subprocess.run([*PROGRAM, *map(str, flags)], capture_output=True, text=True, timeout=120)
    assert done.stdout == "" and "Traceback" not in done.stderr, done.stderr
    return done.returncode, done.stderr


def test_bad_flags_are_said(files, tmp_path):
    sam2, clip = sam2_flags(files), clip_flags(files)
    text = tmp_path / "text.json"
    text.write_text("{}")
    for flags, said in [
        ([], "error[usage.bad_flag] --sam-encoder: name a model"),
        (sam2[:2], "error[usage.bad_flag] --sam-decoder: --sam-encoder and --sam-decoder belong together"),
        (sam2[2:], "error[usage.bad_flag] --sam-encoder: --sam-encoder and --sam-decoder belong together"),
        (clip[:4], "error[usage.bad_flag] --tokenizer: --clip-text and --tokenizer belong together"),
        ([*sam2, "--points-per-side", 0], "error[usage.bad_flag] --points-per-side: 0: expected a whole number from 1 to 64"),
        ([*sam2, "--min-stability", 2], "--min-stability: 2.0: expected a number from 0 to 1"),
        ([*sam2, "--min-predicted-iou", "nan"], "--min-predicted-iou"),
        ([*sam2, "--max-box-iou", -1], "--max-box-iou"),
        ([*sam2, "--min-region-px", -1], "--min-region-px"),
        ([*sam2, "--threads", -1], "--threads"),
        ([*sam2, "--port", 70_000], "--port: 70000: expected a whole number from 0 to 65535"),
        ([*sam2, "--host", "203.0.113.7"], "error[usage.bad_flag] --host 203.0.113.7 --port 5002: "),
        (["--sam-encoder", "none.onnx", *sam2[2:]], "error[input.not_found] none.onnx: --sam-encoder names it"),
        ([*clip[:4], "--tokenizer", "none.json"], "none.json"),
        ([*clip[:4], "--tokenizer", text], "error[model.bad_file]"),
        (["--clip-image", files["wide"], *clip[2:]], "its vectors have 3 numbers, those of"),
        (["--clip-image", files["text"]], "--clip-image"),
        (["--clip-text", files["image"], *clip[4:]], "--clip-text takes input_ids (N, L), and attention_mask at most; found: "),
        (["--sam-encoder", files["image"], *sam2[2:]], "no segmenter that is known here"),
    ]:
        code, err = failed(*flags)
        assert code == 2 and said in err and err.startswith("error["), (flags, err)


def test_a_port_that_is_taken(served, files):
    code, err = failed(*clip_flags(files), "--port", served.port)
    assert code == 2 and "Address already in use; --port 0 takes a free one" in err


def test_it_serves_at_the_other_loopback(files):
    try:
        socket.create_server(("::1", 0), family=socket.AF_INET6).close()
    except OSError:
        pytest.skip("this machine has no IPv6")
    process = subprocess.Popen([*PROGRAM, *clip_flags(files), "--host", "::1", "--port", "0"], stdout=subprocess.PIPE, text=True)
    lines = iter(process.stdout.readline, "")
    port = next(found[1] for line in lines if (found := re.match(r"serving at http://\[::1\]:(\d+);", line)))
    connection = http.client.HTTPConnection("::1", int(port), timeout=60)
    connection.request("GET", "/health")
    assert connection.getresponse().status == 200
    connection.close()
    process.send_signal(signal.SIGINT)
    assert process.wait(timeout=60) == 0


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_it_ends_in_the_middle_of_a_picture(files, number):
    """4,096 points one at a time take long; nobody waits for them."""
    server = Served("--sam-encoder", files["sam_encoder"], "--sam-decoder", files["sam_decoder"], "--points-per-side", 64)
    with concurrent.futures.ThreadPoolExecutor(1) as pool:
        asked = pool.submit(lambda: server.post("/generate_masks", IMAGE))
        time.sleep(1)
        began = time.monotonic()
        code, _, err = server.end(number)
        assert code == 0 and time.monotonic() - began < 8 and "Traceback" not in err, err
        try:
            assert asked.result(timeout=60) == (503, {"error": "the server is ending"})
        except (ConnectionError, http.client.HTTPException):
            pytest.fail("the client was left without an answer")


def test_a_closed_terminal_does_not_end_it_under_nohup(files):
    process = subprocess.Popen(["nohup", *PROGRAM, *clip_flags(files), "--port", "0"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    assert any("serving at" in line for line in iter(process.stdout.readline, ""))
    process.send_signal(signal.SIGHUP)
    with pytest.raises(subprocess.TimeoutExpired):
        process.wait(timeout=1)
    process.send_signal(signal.SIGTERM)
    assert process.wait(timeout=60) == 0


def test_it_ends_while_it_loads(files):
    """As all commands that are interrupted: 130."""
    program = "import sys, marketgen.model_server as server\ndef waits(*_):\n    raise KeyboardInterrupt\nserver.Segmenter = waits\nsys.exit(server.main(sys.argv[1:]))"
    done = subprocess.run([sys.executable, "-c", program, *sam2_flags(files)], capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "interrupted\n")


def test_without_its_packages_it_says_which(files, tmp_path):
    """`pip install marketgen` alone."""
    for package, flags in [("onnxruntime", clip_flags(files)[:2]), ("PIL", sam2_flags(files)), ("tokenizers", clip_flags(files)[2:])]:
        folder = tmp_path / package
        folder.mkdir()
        (folder / f"{package}.py").write_text("raise ImportError\n")
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(folder), os.environ.get("PYTHONPATH", "")])}
        done = subprocess.run([*PROGRAM, *flags], capture_output=True, text=True, timeout=60, env=environment)
        assert done.returncode == 2 and "pip install 'marketgen[models]'" in done.stderr, done.stderr


def test_its_lines_are_one_for_each_request(files):
    server = Served(*clip_flags(files))
    server.ask("GET", "/health")
    server.raw(b"GET /\x1b[31m\xff HTTP/1.1\r\n\r\n")
    _, _, err = server.end()
    lines = err.splitlines()
    assert len(lines) == 2 and re.fullmatch(r"GET /health HTTP/1\.1 200 \d+\.\d{3} s", lines[0]), lines
    assert err.isascii() and "\x1b" not in err
