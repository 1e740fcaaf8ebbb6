"""`hybrid` with servers that are there: the program's client and the model server understand one another."""

import json
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import model_files
import pytest
from model_requests import Served

import marketgen

LOOK_S, GRASP_S = 6, 12  # time for a look; for that and a grasp


@pytest.fixture(scope="module")
def basket(checkout_file, tmp_path_factory):
    """A file of one basket, with so much time."""

    def with_limit(limit_s):
        header, first, _ = checkout_file.read_text().splitlines()
        file = tmp_path_factory.mktemp("tasks") / "basket.jsonl"
        file.write_text(json.dumps({**json.loads(header), "episodes": 1}) + "\n" + json.dumps({**json.loads(first), "limit_s": limit_s}) + "\n")
        return file

    return with_limit


def test_masks_of_the_model_server(basket, tmp_path):
    folder = tmp_path / "onnx"
    folder.mkdir()
    files = ["--sam-encoder", model_files.sam_encoder(folder / "encoder.onnx"), "--sam-decoder", model_files.sam_decoder(folder / "decoder.onnx")]
    server = Served(*files, "--points-per-side", 6)
    try:
        name = f"hybrid(masks=http://127.0.0.1:{server.port})+target+language"
        scores = marketgen.evaluate(basket(LOOK_S), name, tmp_path / "results")
    finally:
        server.end()
    (result,) = scores.results
    asked = result["parts"]["masks"]
    assert result["policy"] == name and "grasps" not in result["parts"]
    assert asked["questions"] > 0 and asked["answered"] == asked["questions"] and asked["offline"] == 0
    assert scores.summary["parts"]["masks"] == asked


class Proposer(BaseHTTPRequestHandler):
    """One grasp straight ahead on the middle of what it is sent, as AnyGrasp's server of GenManip says it."""

    asked = []

    def log_message(self, *_):
        pass

    def do_POST(self):
        sent = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        self.asked.append((self.path, sorted(sent)))
        depths, scale = sent["depths"], sent["scale"]
        v, u = len(depths) // 2, len(depths[0]) // 2
        z = depths[v][u] / scale
        at = [(u - sent["cx"]) / sent["fx"] * z, (v - sent["cy"]) / sent["fy"] * z, z]
        ahead = {"translation": at, "rotation_matrix": [[0, 1, 0], [0, 0, 1], [1, 0, 0]], "depth": 0.02, "score": 0.7}
        body = json.dumps({"grasp_groups": [ahead]}).encode()
        self.send_response(200)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)


def test_grasps_of_a_server(basket, tmp_path):
    server = ThreadingHTTPServer(("127.0.0.1", 0), Proposer)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        url = f"http://127.0.0.1:{server.server_address[1]}"
        scores = marketgen.evaluate(basket(GRASP_S), f"hybrid(grasps={url})+target+language", tmp_path / "results")
    finally:
        server.shutdown()
        server.server_close()
    asked = scores.results[0]["parts"]["grasps"]
    assert asked["answered"] == asked["questions"] == len(Proposer.asked) > 0
    assert {path for path, _ in Proposer.asked} == {"/process"}
    assert {tuple(names) for _, names in Proposer.asked} == {("colors", "cx", "cy", "dense_mode", "depths", "fx", "fy", "scale")}
