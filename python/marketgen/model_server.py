"""Serves vision models that you have as ONNX files: masks of everything in a picture by SAM, MobileSAM or SAM 2, vectors of CLIP.

    python -m marketgen.model_server --sam-encoder encoder.onnx --sam-decoder decoder.onnx
    python -m marketgen.model_server --clip-image vision.onnx --clip-text text.onnx --tokenizer tokenizer.json --port 5003

Ctrl-C and SIGTERM end it, exit status 0; docs/models.md has what is asked and answered.
"""

from __future__ import annotations

import argparse
import ipaddress
import signal
import sys
from typing import Any

from . import arguments
from .command_line import ended
from .errors import Error
from .models.embedder import ImageEmbedder, TextEmbedder, fit
from .models.families import Segmenter
from .models.loaded import Loaded
from .models.masks import MAX_POINTS_PER_SIDE, MIN_PREDICTED_IOU, Rules
from .models.serving import ModelServer

PORT = 5002  # GenManip's


def main(words: list[str] | None = None) -> int:
    given = _parser().parse_args(words)
    for number in (signal.SIGTERM, signal.SIGHUP):
        if signal.getsignal(number) != signal.SIG_IGN:  # as under nohup
            signal.signal(number, signal.default_int_handler)  # they end it as Ctrl-C does
    return ended(lambda: _serve(given))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m marketgen.model_server",
        description="Serves SAM, MobileSAM or SAM 2 and CLIP, as ONNX files that you have, over HTTP (docs/models.md).",
        epilog="example: python -m marketgen.model_server --sam-encoder encoder.onnx --sam-decoder decoder.onnx",
    )
    add = parser.add_argument
    add("--sam-encoder", metavar="FILE", help="ONNX: pictures to features")
    add("--sam-decoder", metavar="FILE", help="ONNX: features and points to masks")
    add("--clip-image", metavar="FILE", help="ONNX: pictures to vectors")
    add("--clip-text", metavar="FILE", help="ONNX: texts to vectors")
    add("--tokenizer", metavar="FILE", help="the tokenizer.json that --clip-text was trained with")
    add("--host", default="127.0.0.1", help="address to serve at (default: %(default)s: this machine alone)")
    add("--port", type=int, default=PORT, help="0: any free one (default: %(default)s)")
    add("--threads", type=int, default=0, metavar="N", help="cores for a model (default: all)")
    add("--points-per-side", type=int, default=32, metavar="N", help="of the grid at which masks are asked for (default: %(default)s)")
    add("--min-predicted-iou", type=float, metavar="X", help="keep masks of which the model thinks better (default: 0.88; SAM 2: 0.8)")
    add("--min-stability", type=float, default=0.95, metavar="X", help="keep masks whose edges are as sure (default: %(default)g)")
    add("--max-box-iou", type=float, default=0.7, metavar="X", help="of two masks' boxes; above it one goes (default: %(default)g)")
    add("--min-region-px", type=int, default=100, metavar="N", help="smaller islands and holes of masks go; 0: none (default: %(default)s)")
    add("--quiet", action="store_true", help="no line for each request")
    return parser


def _serve(given: argparse.Namespace) -> int:
    loaded = _loaded(given)
    server = _server(given, loaded)
    try:
        host = f"[{given.host}]" if ":" in given.host else given.host
        for line in _told(loaded.health):
            print(line)
        print(f"serving at http://{host}:{server.server_port}; Ctrl-C ends it", flush=True)
        server.serve_forever()
    except KeyboardInterrupt:
        pass
    server.end()
    return 0


def _loaded(given: argparse.Namespace) -> Loaded:
    """Raises Error usage.*, input.not_found, model.bad_file."""
    threads = arguments.a_whole("--threads", given.threads, 0, 1024)
    _together(given, "sam_encoder", "sam_decoder")
    _together(given, "clip_text", "tokenizer")
    rules = _rules(given)
    if not (given.sam_encoder or given.clip_image or given.clip_text):
        raise Error("usage.bad_flag", "--sam-encoder", "name a model: --sam-encoder with --sam-decoder, --clip-image, or --clip-text with --tokenizer")
    masks = Segmenter(given.sam_encoder, given.sam_decoder, threads) if given.sam_encoder else None
    images = ImageEmbedder(given.clip_image, threads) if given.clip_image else None
    texts = TextEmbedder(given.clip_text, given.tokenizer, threads) if given.clip_text else None
    fit(images, texts)
    return Loaded(masks, rules(masks.family if masks else "sam"), images, texts)


def _together(given: argparse.Namespace, *names: str) -> None:
    flags = {f"--{name.replace('_', '-')}": getattr(given, name) for name in names}
    missing = [flag for flag, value in flags.items() if not value]
    if len(missing) == 1:
        raise Error("usage.bad_flag", missing[0], f"{' and '.join(flags)} belong together: name both")


def _rules(given: argparse.Namespace) -> Any:
    """By the family, which says how well the model must think of a mask where nobody does."""
    known = {
        "points_per_side": arguments.a_whole("--points-per-side", given.points_per_side, 1, MAX_POINTS_PER_SIDE),
        "min_stability": arguments.a_number("--min-stability", given.min_stability, 0, 1),
        "max_box_iou": arguments.a_number("--max-box-iou", given.max_box_iou, 0, 1),
        "min_region_px": arguments.a_whole("--min-region-px", given.min_region_px, 0, 10**6),
    }
    least = given.min_predicted_iou
    if least is not None:
        arguments.a_number("--min-predicted-iou", least, 0, 1)
    return lambda family: Rules(min_predicted_iou=MIN_PREDICTED_IOU[family] if least is None else least, **known)


def _server(given: argparse.Namespace, loaded: Loaded) -> ModelServer:
    port = arguments.a_whole("--port", given.port, 0, 65535)
    try:
        made = ModelServer(given.host, port, loaded, given.quiet)
    except OSError as fault:
        raise Error("usage.bad_flag", f"--host {given.host} --port {port}", f"{fault.strerror or fault}; --port 0 takes a free one") from None
    if not ipaddress.ip_address(made.server_address[0]).is_loopback:
        print(f"warning: --host {given.host}: whoever reaches this machine can use the models; there are no keys", file=sys.stderr)
    return made


def _told(health: dict[str, Any]) -> list[str]:
    """For people: what is loaded."""
    parts = {"masks": health["masks"], **{f"{name} vectors": part for name, part in (health["embed"] or {}).items() if name != "width"}}
    family = f" {health['masks']['family']}" if health["masks"] else ""
    return [f"{name}{family if name == 'masks' else ''}: {', '.join(file['file'] for file in part['files'])}" for name, part in parts.items() if part]


if __name__ == "__main__":
    sys.exit(main())
