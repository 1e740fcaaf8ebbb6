"""A server of GR00T's protocol for tests, and what may be wrong with one.

    python groot_server.py PORT_FILE FAULT [MARK]

As openpi_server.py: its policy stands still and says with the last of four steps that it has done; FAULT is done once, where MARK is.
"""

import io
import os
import sys
import time

import msgpack
import numpy as np
import zmq

CHUNK = 4


def packed(value):
    """As MsgSerializer of server_client.py in Isaac-GR00T has it."""

    def of_array(array):
        written = io.BytesIO()
        np.save(written, array, allow_pickle=False)
        return {"__ndarray_class__": True, "as_npy": written.getvalue()}

    return msgpack.packb(value, default=of_array)


def array_of(value):
    return np.load(io.BytesIO(value["as_npy"]), allow_pickle=False) if "__ndarray_class__" in value else value


def actions(observation, options):
    state = observation["state"]
    assert options is None and state["joints"].shape == (1, 1, 7) and observation["language"]["task"][0][0]
    joints = np.repeat(state["joints"], CHUNK, axis=1)
    return [{"joints": joints, "rest": np.stack([np.ones(CHUNK), np.linspace(-1, 1, CHUNK)], axis=1)[None].astype(np.float32)}, {}]


def faulty(fault, answer):
    if fault == "hangs":
        time.sleep(1000)
    if fault == "late":
        time.sleep(6)
    if fault == "dies":
        os._exit(3)
    if fault == "babbles":
        return b"\xc1 no msgpack"
    if fault == "pickles":
        return msgpack.packb([{"joints": {"__ndarray_class__": True, "as_npy": b"\x80\x04N."}}, {}])
    parts = answer[0]
    if fault == "nan":
        parts["joints"][0, 2, 3] = np.nan
    answers = {
        "raises": {"error": "no such embodiment"},
        "bare": parts,
        "batch": [{name: np.repeat(part, 2, axis=0) for name, part in parts.items()}, {}],
        "narrow": [parts | {"joints": parts["joints"][..., :6]}, {}],
        "short": [{name: part[:, :0] for name, part in parts.items()}, {}],
        "uneven": [parts | {"rest": parts["rest"][:, :3]}, {}],
        "unnamed": [{"joints": parts["joints"]}, {}],
        "words": [parts | {"rest": "left"}, {}],
    }
    return packed(answers.get(fault, answer))


def main():
    port_file, fault, *mark = sys.argv[1:]
    socket = zmq.Context.instance().socket(zmq.REP)
    port = socket.bind_to_random_port("tcp://127.0.0.1")
    with open(port_file + ".part", "w") as out:
        out.write(str(port))
    os.rename(port_file + ".part", port_file)
    endpoints = {"ping": lambda: {"status": "ok", "message": "Server is running"}, "reset": lambda options: {}, "get_action": actions}
    if fault == "version":  # N1.5 has no such endpoint
        del endpoints["reset"]
    while True:
        request = msgpack.unpackb(socket.recv(), object_hook=array_of)
        if request["endpoint"] not in endpoints:
            socket.send(packed({"error": f"Unknown endpoint: {request['endpoint']}"}))
            continue
        answer = endpoints[request["endpoint"]](**request.get("data", {}))
        if request["endpoint"] == "get_action" and mark and not os.path.exists(mark[0]):
            open(mark[0], "w").close()
            socket.send(faulty(fault, answer))
        else:
            socket.send(packed(answer))


if __name__ == "__main__":
    main()
