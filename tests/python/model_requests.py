"""A running model server, and requests of all kinds for it."""

import http.client
import io
import json
import re
import signal
import socket
import subprocess
import sys

import numpy as np
from PIL import Image

from masks_test import BLUE, RED, disc, picture_with, rectangle

PROGRAM = [sys.executable, "-m", "marketgen.model_server"]
BOUNDARY = "9d3b69bb7a7a06192cd351b2e1d039f9"
H, W = 240, 320


def png(picture, **options):
    written = io.BytesIO()
    Image.fromarray(picture).save(written, options.pop("format", "PNG"), **options)
    return written.getvalue()


THINGS = [rectangle(H, W, 24, 40, 128, 64), disc(H, W, 230, 150, 50)]
PICTURE = picture_with(H, W, (RED, THINGS[0]), (BLUE, THINGS[1]))[0]
PNG = png(PICTURE)


def form(*fields):
    """Fields (name, file's name or None, content) as `requests.post(url, files=..., data=...)` writes them, to the byte."""
    body = b""
    for name, file, content in fields:
        told = f'form-data; name="{name}"' + (f'; filename="{file}"' if file else "")
        body += f"--{BOUNDARY}\r\nContent-Disposition: {told}\r\n\r\n".encode() + content + b"\r\n"
    return body + f"--{BOUNDARY}--\r\n".encode()


FORM = {"Content-Type": f"multipart/form-data; boundary={BOUNDARY}"}
IMAGE = ("image", "image", PNG)
RLE = ("format", None, b"coco_rle")


class Served:
    """A server that runs; `ask` gives the status and the document."""

    def __init__(self, *flags):
        self.process = subprocess.Popen([*PROGRAM, *map(str, flags), "--port", "0"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.said = []
        for line in self.process.stdout:
            self.said.append(line.rstrip())
            if found := re.match(r"serving at http://127\.0\.0\.1:(\d+); Ctrl-C ends it", line):
                self.port = int(found[1])
                return
        raise AssertionError(self.process.communicate()[1])

    def ask(self, method, path, body=None, headers=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=120)
        try:
            connection.request(method, path, body, headers or {})
            answer = connection.getresponse()
            return answer.status, json.loads(answer.read())
        finally:
            connection.close()

    def post(self, path, *fields):
        return self.ask("POST", path, form(*fields), FORM)

    def raw(self, sent):
        """What comes for bytes as they are, until the server closes or has answered."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=60) as connection:
            connection.sendall(sent)
            connection.shutdown(socket.SHUT_WR)
            received = b""
            try:
                while piece := connection.recv(1 << 16):
                    received += piece
            except ConnectionError:
                pass
            return received

    def end(self, number=signal.SIGINT):
        self.process.send_signal(number)
        out, err = self.process.communicate(timeout=60)
        return self.process.returncode, out, err


def malformed():
    """Requests that nothing can be made of, as bytes."""
    body = form(IMAGE)
    head = b"POST /generate_masks HTTP/1.1\r\nHost: x\r\n"
    kind = f"Content-Type: {FORM['Content-Type']}\r\n".encode()

    def with_length(body, kind=kind):
        return head + kind + b"Content-Length: %d\r\n\r\n" % len(body) + body

    yield from (b"\r\n\r\n", b"GET\r\n\r\n", b"nonsense\r\n\r\n", b"\x16\x03\x01\x02\x00\x01", b"GET /health HTTP/9.9\r\n\r\n", b"GET /health HTTP/x\r\n\r\n", b"GET /" + b"a" * 70_000 + b" HTTP/1.1\r\n\r\n")
    yield b"GET /health HTTP/1.1\r\n" + b"A: b\r\n" * 200 + b"\r\n"
    yield b"GET /health HTTP/1.1\r\nA: " + b"b" * 70_000 + b"\r\n\r\n"
    for length in (b"-1", b"1e3", b"0x10", b"9" * 30, b"", b"+5", "٣".encode(), b"5, 5"):
        yield head + kind + b"Content-Length: " + length + b"\r\n\r\n" + body
    yield head + kind + b"\r\n" + body
    yield head + kind + b"Content-Length: 5\r\nContent-Length: 6\r\n\r\n" + body
    yield head + kind + b"Transfer-Encoding: chunked\r\n\r\n5\r\nhello\r\n0\r\n\r\n"
    yield head + kind + b"Transfer-Encoding: chunked\r\nContent-Length: %d\r\n\r\n" % len(body) + body
    yield head + kind + b"Content-Length: %d\r\n\r\n" % (len(body) + 10) + body  # less than was said
    for other in (b"", b"application/json", b"multipart/form-data", b"multipart/form-data; boundary=", b"multipart/form-data; boundary=other", b"multipart/mixed; boundary=" + BOUNDARY.encode(), b'multipart/form-data; boundary="', b"multipart/form-data; boundary=" + b"x" * 300, b"image/png", b"\xff\xfe"):
        yield with_length(body, b"Content-Type: " + other + b"\r\n")
    for cut in (1, 20, 60, 90, 130, 200, len(body) // 2, len(body) - 2 - len(BOUNDARY), len(body) - 4):
        yield with_length(body[:cut])
    mark = b"--" + BOUNDARY.encode()
    for wrong in (b"", mark, mark + b"--", mark * 3, mark + b"\r\n" + mark + b"--", mark + b"\r\n\r\n\r\n" + mark + b"--", mark + b"\r\nA: b\r\n\r\nc\r\n" + mark + b"--", (mark + b'\r\nContent-Disposition: form-data; name="x"\r\n\r\n\r\n') * 300 + mark + b"--"):
        yield with_length(wrong)
    for disposition in (b"form-data", b"attachment; name=image", b"form-data; name*=utf-8''image", b'form-data; name="im\x00age"', b"form-data; name=" + b"n" * 9000):
        yield with_length(mark + b"\r\nContent-Disposition: " + disposition + b"\r\n\r\n" + PNG + b"\r\n" + mark + b"--\r\n")
    random = np.random.default_rng(7)
    for _ in range(8):  # one picture with its bytes mixed up after the signature
        broken = bytearray(PNG)
        for at in random.integers(8, len(PNG), 40):
            broken[at] = random.integers(256)
        yield with_length(form(("image", "p", bytes(broken))))
