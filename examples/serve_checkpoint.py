"""Serves a checkpoint of LeRobot the way openpi's servers do, so that it acts in marketgen.evaluate from another process or machine.

    pip install lerobot websockets msgpack
    python examples/serve_checkpoint.py out/examples/imitate/policy --port 8000
    python -m marketgen.evaluate --episodes out/examples/imitate/trials.jsonl --policy openpi://localhost:8000 \\
        --adapter out/examples/imitate/adapter.yaml -o served

Take it as the pattern for a server of your own: a message with names of the model (metadata), then for every observation the next actions,
all by msgpack with arrays as openpi-client packs them. Needs a policy that goes by one observation (ACT, pi0, SmolVLA).
Without a checkpoint it says what it would serve and ends.
"""

import argparse
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


class Policy:
    """A checkpoint with its processors, on the CPU."""

    def __init__(self, folder):
        import torch
        from lerobot.configs.policies import PreTrainedConfig
        from lerobot.policies.factory import get_policy_class, make_pre_post_processors

        torch.set_num_threads(1)
        config = PreTrainedConfig.from_pretrained(folder)
        config.device = "cpu"
        self.torch, self.steps, self.numbers = torch, config.n_action_steps, config.input_features["observation.state"].shape[0]
        self.policy = get_policy_class(config.type).from_pretrained(folder, config=config).eval()
        self.before, self.after = make_pre_post_processors(config, pretrained_path=str(folder))

    def actions(self, seen):
        """(steps, numbers), of one observation by the checkpoint's own names."""
        batch = {name: self.tensor(value) for name, value in seen.items()}
        with self.torch.no_grad():
            chunk = self.policy.predict_action_chunk(self.before(batch))[0, : self.steps]
            return np.stack([self.after(step[None])[0].cpu().numpy() for step in chunk])

    def tensor(self, value):
        return self.torch.from_numpy(np.array(value, np.float32)[None]) if isinstance(value, np.ndarray) else [value]


def serve(policy, host, port, name):
    import websockets.sync.server

    def answer(connection):
        connection.send(packed({"model": name}))
        for message in connection:
            try:
                connection.send(packed({"actions": policy.actions(unpacked(message))}))
            except Exception:  # the client tells its last line
                connection.send(traceback.format_exc())

    with websockets.sync.server.serve(answer, host, port, compression=None, max_size=None) as server:
        print(f"serving {name} at openpi://{host}:{server.socket.getsockname()[1]}", flush=True)
        server.serve_forever()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("checkpoint", nargs="?", type=pathlib.Path, default=pathlib.Path("out/examples/imitate/policy"))
    parser.add_argument("--host", default="localhost")
    parser.add_argument("--port", type=int, default=8000, help="0: any that is free")
    given = parser.parse_args()
    if not (given.checkpoint / "config.json").exists():
        print(f"there is no checkpoint at {given.checkpoint}: examples/imitate.py trains one where LeRobot is installed")
        return
    serve(Policy(given.checkpoint), given.host, given.port, given.checkpoint.name)


if __name__ == "__main__":
    main()
