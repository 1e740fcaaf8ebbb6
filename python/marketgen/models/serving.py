"""HTTP for models: docs/models.md has what is asked and answered. No names, no keys: it is meant for one machine."""

from __future__ import annotations

import http.server
import json
import socket
import socketserver
import sys
import threading
import time
import urllib.parse
from collections.abc import Iterable, Iterator
from http import HTTPStatus
from typing import Any

from .forms import BadForm, Part, parts_of
from .loaded import Loaded, NotLoaded
from .masks import Mask, as_json
from .pictures import BadPicture, picture_of
from .rle import coco_rle
from .sessions import Stopped

MAX_FORM, MAX_TEXTS_BODY = 64 << 20, 1 << 20  # bytes of a body
MAX_PICTURES, MAX_TEXTS, MAX_LETTERS = 64, 256, 4096
SILENCE_S, END_S = 30.0, 5.0  # of a client in the middle of a request; for answers under way when the server ends
PIECE = 1 << 16
NO_LENGTH = "say the body's Content-Length; other encodings of it are not read"
BOOLEANS, COCO_RLE = "booleans", "coco_rle"


class Refused(Exception):
    """A request that is not answered: an HTTP status and why."""

    def __init__(self, status: HTTPStatus, why: str):
        super().__init__(why)
        self.status = status


class ModelServer(http.server.ThreadingHTTPServer):
    """Serves `loaded` at (host, port); port 0: a free one. Raises OSError."""

    daemon_threads = True
    request_queue_size = 64

    def __init__(self, host: str, port: int, loaded: Loaded, quiet: bool = False):
        self.loaded, self.quiet = loaded, quiet
        self._answering, self._changed = 0, threading.Condition()
        self.address_family = socket.AF_INET6 if ":" in host else socket.AF_INET
        super().__init__((host, port), _Asked)

    def server_bind(self) -> None:
        """As the standard library's, which also asks a name server for the host's whole name: that takes long where none answers."""
        socketserver.TCPServer.server_bind(self)
        self.server_name, self.server_port = self.server_address[:2]

    def end(self) -> None:
        """Takes no more requests, ends what models are at, and lets answers under way be sent."""
        self.server_close()
        self.loaded.stop()
        with self._changed:
            self._changed.wait_for(lambda: self._answering == 0, END_S)

    def count(self, step: int) -> None:
        with self._changed:
            self._answering += step
            self._changed.notify_all()

    def handle_error(self, request: Any, client_address: Any) -> None:
        fault = sys.exc_info()[1]
        if not isinstance(fault, (ConnectionError, TimeoutError)):
            print(f"warning: {type(fault).__name__}: {fault}", file=sys.stderr, flush=True)


class _Asked(http.server.BaseHTTPRequestHandler):
    """One connection; the requests that come over it."""

    server: ModelServer
    protocol_version = "HTTP/1.1"
    timeout = SILENCE_S

    def do_GET(self) -> None:
        self._answer()

    def do_POST(self) -> None:
        self._answer()

    def _answer(self) -> None:
        self.server.count(1)
        self._began, self._left, self._begun = time.monotonic(), self._length(), False
        try:
            self._answered()
        except Refused as refused:
            self._refuse(refused.status, str(refused))
        except (BadForm, BadPicture) as fault:
            self._refuse(HTTPStatus.BAD_REQUEST, str(fault))
        except NotLoaded as fault:
            self._refuse(HTTPStatus.SERVICE_UNAVAILABLE, str(fault))
        except Stopped:
            self._refuse(HTTPStatus.SERVICE_UNAVAILABLE, "the server is ending")
        except (ConnectionError, TimeoutError):
            self.close_connection = True  # nobody is there any more
        except Exception as fault:  # of a model, a full memory: the next request may go well
            self._refuse(HTTPStatus.INTERNAL_SERVER_ERROR, f"{type(fault).__name__}: {' '.join(str(fault).split())[:300]}")
        finally:
            self.server.count(-1)

    def _answered(self) -> None:
        url = urllib.parse.urlsplit(self.path)
        if url.path not in ROUTES:
            raise Refused(HTTPStatus.NOT_FOUND, f"there is {', '.join(ROUTES)}")
        method, answer = ROUTES[url.path]
        if self.command != method:
            raise Refused(HTTPStatus.METHOD_NOT_ALLOWED, f"{url.path} takes {method}")
        answer(self, urllib.parse.parse_qs(url.query))

    # ---- What is asked ----

    def _health(self, _query: dict[str, list[str]]) -> None:
        self._send(HTTPStatus.OK, self.server.loaded.health)

    def _generate_masks(self, query: dict[str, list[str]]) -> None:
        parts = parts_of(self.headers.get("Content-Type", ""), self._body(MAX_FORM))
        wanted = [part.content.decode("utf-8", "replace") for part in parts if part.name == "format"] or query.get("format", [BOOLEANS])
        if wanted[-1] not in (BOOLEANS, COCO_RLE):
            raise Refused(HTTPStatus.BAD_REQUEST, f"format is {wanted[-1][:40]!r}; it is {BOOLEANS} or {COCO_RLE}")
        pictures = _pictures(parts, 1)
        masks = self.server.loaded.masks(pictures[0])
        if wanted[-1] == COCO_RLE:
            self._send(HTTPStatus.OK, {"masks": [as_json(mask, coco_rle(mask.pixels)) for mask in masks]})
        else:
            self._send_pieces(_with_booleans(masks))

    def _embed_image(self, _query: dict[str, list[str]]) -> None:
        parts = parts_of(self.headers.get("Content-Type", ""), self._body(MAX_FORM))
        vectors = self.server.loaded.picture_vectors(_pictures(parts, MAX_PICTURES))
        self._send(HTTPStatus.OK, {"embeddings": vectors.tolist()})

    def _embed_text(self, _query: dict[str, list[str]]) -> None:
        texts = _texts(self._body(MAX_TEXTS_BODY))
        self._send(HTTPStatus.OK, {"embeddings": self.server.loaded.text_vectors(texts).tolist()})

    # ---- Bytes ----

    def _length(self) -> int | None:
        """Of the body; None: it is not said as it must be."""
        if self.command == "GET" and "Content-Length" not in self.headers and "Transfer-Encoding" not in self.headers:
            return 0
        told = self.headers.get_all("Content-Length", [])
        if len(told) != 1 or not (told[0].isascii() and told[0].isdigit() and len(told[0]) < 16) or "Transfer-Encoding" in self.headers:
            return None
        return int(told[0])

    def _body(self, most: int) -> bytes:
        if self._left is None:
            raise Refused(HTTPStatus.LENGTH_REQUIRED, NO_LENGTH)
        if self._left > most:
            raise Refused(HTTPStatus.REQUEST_ENTITY_TOO_LARGE, _too_large(self._left, most))
        body = self.rfile.read(self._left)
        whole, self._left = len(body) == self._left, 0
        if not whole:
            raise ConnectionError
        return body

    def handle_expect_100(self) -> bool:
        """Before the body of a client that asks first, as curl does: what is too large is not sent at all."""
        length = self._length()
        if length is not None and length <= MAX_FORM:
            return super().handle_expect_100()
        if length is None:
            self.send_error(HTTPStatus.LENGTH_REQUIRED, NO_LENGTH)
        else:
            self.send_error(HTTPStatus.REQUEST_ENTITY_TOO_LARGE, _too_large(length, MAX_FORM))
        return False

    def _refuse(self, status: HTTPStatus, why: str) -> None:
        if self._begun:
            self.close_connection = True  # in the middle of an answer: its end is missing, which says that it failed
            return
        self._read_rest()
        try:
            self._send(status, {"error": why})
        except OSError:
            self.close_connection = True

    def _read_rest(self) -> None:
        """Of a body that nobody wants, within bounds: a client that still sends would not read the answer."""
        if self._left is None or self._left > 2 * MAX_FORM:
            self.close_connection = True
            return
        try:
            while self._left and (piece := self.rfile.read(min(self._left, PIECE))):
                self._left -= len(piece)
        except OSError:
            self.close_connection = True

    def _send(self, status: HTTPStatus, document: dict[str, Any]) -> None:
        content = json.dumps(document, separators=(",", ":")).encode()
        self._head(status, {"Content-Length": str(len(content))})
        self.wfile.write(content)

    def _send_pieces(self, pieces: Iterable[bytes]) -> None:
        """A body of which only a piece is in memory."""
        chunked = self.request_version == "HTTP/1.1"
        if not chunked:
            self.close_connection = True
        self._head(HTTPStatus.OK, {"Transfer-Encoding": "chunked"} if chunked else {})
        for piece in pieces:
            self.wfile.write(b"%x\r\n%b\r\n" % (len(piece), piece) if chunked else piece)
        if chunked:
            self.wfile.write(b"0\r\n\r\n")

    def _head(self, status: HTTPStatus, headers: dict[str, str]) -> None:
        self.send_response(status)
        if status == HTTPStatus.METHOD_NOT_ALLOWED:
            headers["Allow"] = ROUTES[urllib.parse.urlsplit(self.path).path][0]
        if self.close_connection:
            headers["Connection"] = "close"
        for name, value in {"Content-Type": "application/json", **headers}.items():
            self.send_header(name, value)
        self.end_headers()
        self._begun = True

    def send_error(self, code: int, message: str | None = None, explain: str | None = None) -> None:
        """Of what is no HTTP, which the standard library finds."""
        self.close_connection = True
        self._began = time.monotonic()
        self._send(HTTPStatus(code), {"error": message or HTTPStatus(code).phrase})

    def version_string(self) -> str:
        return "marketgen"

    def log_message(self, format: str, *values: Any) -> None:
        pass

    def log_request(self, code: int | str = "-", size: int | str = "-") -> None:
        if not self.server.quiet:
            line = ascii(getattr(self, "requestline", ""))[1:-1][:200]
            print(f"{line} {int(code)} {time.monotonic() - self._began:.3f} s", file=sys.stderr, flush=True)


ROUTES = {
    "/generate_masks": ("POST", _Asked._generate_masks),
    "/embed_image": ("POST", _Asked._embed_image),
    "/embed_text": ("POST", _Asked._embed_text),
    "/health": ("GET", _Asked._health),
}


def _too_large(length: int, most: int) -> str:
    return f"the body has {length:,} bytes; {most:,} are the most"


def _pictures(parts: list[Part], most: int) -> list[Any]:
    sent = [part.content for part in parts if part.name == "image"]
    if not sent:
        there = ", ".join(repr(part.name[:40]) for part in parts[:8]) or "none"
        raise Refused(HTTPStatus.BAD_REQUEST, f"send the picture in the field 'image'; the form has {there}")
    if len(sent) > most:
        raise Refused(HTTPStatus.BAD_REQUEST, f"the form has {len(sent)} pictures; {most} are the most")
    return [picture_of(content) for content in sent]


def _texts(body: bytes) -> list[str]:
    try:
        document = json.loads(body)
    except (ValueError, RecursionError):
        raise Refused(HTTPStatus.BAD_REQUEST, "the body is no JSON") from None
    texts = document.get("texts") if isinstance(document, dict) else None
    if not isinstance(texts, list) or not 1 <= len(texts) <= MAX_TEXTS or not all(isinstance(text, str) for text in texts):
        raise Refused(HTTPStatus.BAD_REQUEST, f'send {{"texts": [...]}}, 1 to {MAX_TEXTS} texts')
    if any(len(text) > MAX_LETTERS for text in texts):
        raise Refused(HTTPStatus.BAD_REQUEST, f"a text has more than {MAX_LETTERS:,} letters")
    if not all(text.isascii() or text.encode("utf-8", "replace").decode() == text for text in texts):
        raise Refused(HTTPStatus.BAD_REQUEST, "a text has half of a surrogate pair")
    return texts


def _with_booleans(masks: list[Mask]) -> Iterator[bytes]:
    """The document mask by mask: rows of true and false, as GenManip's server writes them."""
    yield b'{"masks":['
    for number, mask in enumerate(masks):
        text = json.dumps(as_json(mask, mask.pixels.tolist()), separators=(",", ":"))
        yield b"," * (number > 0) + text.encode()
    yield b"]}"
