"""Serves a policy the way openpi's servers do, so that it acts in marketgen.evaluate from another process or machine.

    pip install websockets msgpack
    python examples/serve_policy.py out/clone/policy.npz --port 8000      # of clone.py; a folder: a checkpoint of LeRobot (imitate.py)
    python -m marketgen.evaluate --episodes out/clone/trials.jsonl --policy openpi://localhost:8000 \\
        --adapter out/clone/policy.yaml -o served

Take it as the pattern for a server of your own: first a message about the model, then for every observation the next actions, all by
msgpack with arrays as openpi-client packs them. A checkpoint must go by one observation (ACT, pi0, SmolVLA). Beside the policy it
leaves the row that says what is sent and what the answers mean (docs/remote.md), unless one lies there, as imitate.py leaves it.
Without a policy it says what it wants and ends.
"""

import argparse
import json
import pathlib
import traceback

import numpy as np


def packed(value):
    """As msgpack_numpy.py of openpi-client has it."""
    import msgpack

    def of_array(array):
        return {b"__ndarray__": True, b"data": array.tobytes(), b"dtype": array.dtype.str, b"shape": array.shape}

    return msgpack.packb(value, default=of_array)


def unpacked(message):
    import msgpack

    def array_of(value):
        if b"__ndarray__" not in value:
            return value
        return np.ndarray(buffer=value[b"data"], dtype=np.dtype(value[b"dtype"]), shape=value[b"shape"])

    return msgpack.unpackb(message, object_hook=array_of)


class Checkpoint:
    """A checkpoint with its processors, on the CPU."""

    action = {"space": "joint_targets"}

    def __init__(self, folder):
        import torch
        from lerobot.configs.policies import PreTrainedConfig
        from lerobot.policies.factory import get_policy_class, make_pre_post_processors

        torch.set_num_threads(1)
        config = PreTrainedConfig.from_pretrained(folder)
        config.device = "cpu"
        self.torch, self.steps, self.numbers = torch, config.n_action_steps, config.input_features["observation.state"].shape[0]
        [(picture, feature)] = config.image_features.items()
        self.camera, self.size = picture.removeprefix("observation.images."), feature.shape[:0:-1]
        self.policy = get_policy_class(config.type).from_pretrained(folder, config=config).eval()
        self.before, self.after = make_pre_post_processors(config, pretrained_path=str(folder))

    def session(self):
        return self  # nothing is remembered from one observation to the next

    def actions(self, seen):
        """(steps, numbers), of one observation by the checkpoint's own names, pictures of bytes (height, width, 3), or as it takes them."""
        batch = {name: self.tensor(value) for name, value in seen.items()}
        with self.torch.no_grad():
            chunk = self.policy.predict_action_chunk(self.before(batch))[0, : self.steps]
            return np.stack([self.after(step[None])[0].cpu().numpy() for step in chunk])

    def tensor(self, value):
        if not isinstance(value, np.ndarray):
            return [value]
        if value.dtype == np.uint8:  # to the last bit as `lerobot:FOLDER` has it
            value = value.transpose(2, 0, 1).astype(np.float32) / np.float32(255)
        return self.torch.from_numpy(np.array(value, np.float32, order="C")[None])


def policy_of(path):
    """What answers: session() is one episode's at a time, with actions(seen); steps of an answer, numbers of a state, camera, size of its
    pictures, and what an adapter's row says of its actions."""
    if path.suffix == ".npz":
        import clone

        return clone.Served(dict(np.load(path)))
    return Checkpoint(path)


def row_of(policy):
    """Of an adapter, docs/remote.md. JSON is YAML."""
    seen = {"observation.state": {"numbers": "all"}, f"observation.images.{policy.camera}": {"picture": policy.camera}}
    row = {"about": "examples/serve_policy.py", "observation": seen | {"task": {"words": "instruction"}}, "pictures": {"size": policy.size}}
    return json.dumps({"served": row | {"action": {"keys": ["actions"], "numbers": "all"} | policy.action}}, indent=1)


def serve(policy, host, port, name):
    """Each connection has a session of its own, since one that remembers is in one episode at a time."""
    import websockets.sync.server

    def answer(connection):
        session = policy.session()
        connection.send(packed({"model": name}))
        for message in connection:
            try:
                connection.send(packed({"actions": session.actions(unpacked(message))}))
            except Exception:  # the client tells its last line
                connection.send(traceback.format_exc())

    with websockets.sync.server.serve(answer, host, port, compression=None, max_size=None) as server:
        print(f"serving {name} at openpi://{host}:{server.socket.getsockname()[1]}", flush=True)
        server.serve_forever()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("policy", nargs="?", type=pathlib.Path, default=pathlib.Path("out/clone/policy.npz"))
    parser.add_argument("--host", default="localhost")
    parser.add_argument("--port", type=int, default=8000, help="0: any that is free")
    given = parser.parse_args()
    if not given.policy.exists():
        print(f"there is no policy at {given.policy}: examples/clone.py trains one in minutes")
        return
    policy, row = policy_of(given.policy), given.policy.with_suffix(".yaml")
    if not row.exists():
        row.write_text(row_of(policy))
    serve(policy, given.host, given.port, given.policy.stem)


if __name__ == "__main__":
    main()
