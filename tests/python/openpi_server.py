"""A server of openpi's protocol for tests, and what may be wrong with one.

    python openpi_server.py PORT_FILE FAULT [MARK]

Writes its port into PORT_FILE. Its policy stands still, and says with the last step of its four that it has done. FAULT is what it does at the
first question of all ("nothing": it is sound); MARK is a file that says that it was done, so that the next connection is sound.
"""

import os
import sys
import time

import msgpack
import numpy as np
import websockets.sync.server

CHUNK, NUMBERS = 4, 9


def packed(value):
    """As msgpack_numpy.py of openpi-client has it."""

    def of_array(array):
        return {b"__ndarray__": True, b"data": array.tobytes(), b"dtype": array.dtype.str, b"shape": array.shape}

    return msgpack.packb(value, default=of_array)


def array_of(value):
    if b"__ndarray__" not in value:
        return value
    return np.ndarray(buffer=value[b"data"], dtype=np.dtype(value[b"dtype"]), shape=value[b"shape"])


def chunk(seen):
    """Where the joints are, the fingers open, and at the last step: done."""
    actions = np.zeros((CHUNK, NUMBERS))
    actions[:, :7] = seen["observation.state"][:7]
    actions[:, 7] = 1
    actions[:, 8] = np.linspace(-1, 1, CHUNK)
    return actions


def faulty(fault, connection, actions):
    """What is sent in place of `actions`."""
    if fault == "hangs":
        time.sleep(1000)
    if fault == "late":
        time.sleep(4)
    if fault == "dies":
        os._exit(3)
    if fault == "closes":
        connection.close()
    if fault == "raises":
        return "Traceback (most recent call last):\n  ...\nValueError: no such prompt"
    if fault == "babbles":
        return b"\xc1 no msgpack"
    if fault == "objects":
        return msgpack.packb({"actions": {b"__ndarray__": True, b"data": b"12345678", b"dtype": "|O", b"shape": (1,)}})
    if fault == "nan":
        actions[2, 3] = np.nan
    answers = {
        "narrow": {"actions": actions[:, :7]},
        "short": {"actions": actions[:0]},
        "deep": {"actions": np.zeros((2, 2, 2, 9))},
        "words": {"actions": "left"},
        "unnamed": {"action": actions},
        "list": [1, 2, 3],
    }
    return packed(answers.get(fault, {"actions": actions}))


def serve(fault, mark):
    def handle(connection):
        connection.send(packed(["no", "metadata"] if fault == "protocol" else {"model": "stands still"}))
        for message in connection:
            seen = msgpack.unpackb(message, object_hook=array_of)
            answer = packed({"actions": chunk(seen)})
            if mark is None or not os.path.exists(mark):
                if mark is not None:
                    open(mark, "w").close()
                answer = faulty(fault, connection, chunk(seen))
            connection.send(answer)

    return websockets.sync.server.serve(handle, "localhost", 0, compression=None, max_size=None)


if __name__ == "__main__":
    port_file, fault, *mark = sys.argv[1:]
    with serve(fault, mark[0] if mark else None) as server:
        with open(port_file + ".part", "w") as out:
            out.write(str(server.socket.getsockname()[1]))
        os.rename(port_file + ".part", port_file)
        server.serve_forever()
