"""A server that plays a script: `mock_http_server.py SCRIPT LOG PORT_FILE`.

SCRIPT is a JSON list of steps, one a request; the last one is repeated. Requests that come in any order are answered by steps with
`for`: the first of them whose text stands in the request's body is the answer, as often as it fits; the others stay in their order. A step:
    for       a text in the body of the requests that it answers
    status    of the answer (200)
    headers   of the answer, by name
    body      of the answer: a text, or JSON that is sent as such
    base64    of the answer, instead of body
    size      of the answer, instead of body: that many letters
    length    false: no Content-Length, the body ends with the connection
    delay_s   before the answer
    drop      true: the connection is closed without an answer
    expect    what the request must be: method, path, headers (those named; null: must be absent), json.
              When it is not, the answer is 418 with the difference.

LOG receives one JSON line a request. PORT_FILE receives the port, which the system chooses.
Ends on SIGINT, SIGTERM, or when its parent has gone.
"""

import base64
import json
import os
import signal
import sys
import threading
import time
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

STEPS = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
LOG = Path(sys.argv[2])
PORT_FILE = Path(sys.argv[3])
GUARD = threading.Lock()
SERVED = [0]


ORDERED = [step for step in STEPS if "for" not in step]


def next_step(body):
    for step in STEPS:
        if "for" in step and step["for"] in body:
            return step
    with GUARD:
        step = ORDERED[min(SERVED[0], len(ORDERED) - 1)]
        SERVED[0] += 1
    return step


def difference(expected, found, place=""):
    """The first place where two JSON values differ, or None."""
    if isinstance(expected, dict) and isinstance(found, dict):
        for key in sorted(expected.keys() | found.keys()):
            if key not in expected:
                return f"{place}/{key} was not expected"
            if key not in found:
                return f"{place}/{key} is missing"
            if inner := difference(expected[key], found[key], f"{place}/{key}"):
                return inner
        return None
    if isinstance(expected, list) and isinstance(found, list) and len(expected) == len(found):
        for index, pair in enumerate(zip(expected, found)):
            if inner := difference(*pair, f"{place}/{index}"):
                return inner
        return None
    same = type(expected) is type(found) and expected == found
    return None if same else f"{place}: expected {expected!r}, found {found!r}"


def fault(expect, handler, body):
    for name, value in (("method", handler.command), ("path", handler.path)):
        if name in expect and expect[name] != value:
            return f"{name}: expected {expect[name]!r}, found {value!r}"
    for name, value in expect.get("headers", {}).items():
        if handler.headers.get(name) != value:
            return f"header {name}: expected {value!r}, found {handler.headers.get(name)!r}"
    if "json" in expect:
        return difference(expect["json"], json.loads(body))
    return None


class Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def log_message(self, *_):
        pass

    def answer(self):
        body = self.rfile.read(int(self.headers.get("Content-Length", 0)))
        step = next_step(body.decode("utf-8", "replace"))
        with GUARD, LOG.open("a", encoding="utf-8") as log:
            row = {"method": self.command, "path": self.path, "headers": dict(self.headers.items()),
                   "body": body.decode("utf-8", "replace"), "time": time.monotonic()}
            log.write(json.dumps(row) + "\n")
        time.sleep(step.get("delay_s", 0))
        self.close_connection = True
        if step.get("drop"):
            return
        status, content = step.get("status", 200), step.get("body", "")
        if not isinstance(content, str):
            content = json.dumps(content)
        content = content.encode()
        if "base64" in step:
            content = base64.b64decode(step["base64"])
        if "size" in step:
            content = b"x" * step["size"]
        if wrong := fault(step.get("expect", {}), self, body):
            status, content = 418, json.dumps({"error": {"message": wrong}}).encode()
        self.send_response(status)
        for name, value in step.get("headers", {}).items():
            self.send_header(name, value)
        if step.get("length", True):
            self.send_header("Content-Length", str(len(content)))
        self.send_header("Connection", "close")
        self.end_headers()
        try:
            self.wfile.write(content)
        except OSError:
            pass  # the client has heard enough

    do_GET = do_POST = answer


def leave_with_parent():
    parent = os.getppid()
    while os.getppid() == parent:
        time.sleep(0.2)
    os._exit(0)


signal.signal(signal.SIGINT, lambda *_: os._exit(0))
signal.signal(signal.SIGTERM, lambda *_: os._exit(0))
threading.Thread(target=leave_with_parent, daemon=True).start()
server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
server.daemon_threads = True
draft = PORT_FILE.with_suffix(".draft")
draft.write_text(str(server.server_port), encoding="utf-8")
draft.rename(PORT_FILE)
server.serve_forever()
