"""A model server of vla-eval that knows a dataset of `python -m marketgen.record` by heart; run by tools/check_vla_eval.

To each frame of an episode it answers the action that was recorded there, if the state that it is sent is the recorded one bit for
bit; else it fails.
"""

import pathlib
import sys

import numpy as np
import pyarrow.parquet
from vla_eval.model_servers.predict import PredictModelServer
from vla_eval.model_servers.serve import run_server
from vla_eval.specs import IMAGE_RGB, LANGUAGE, DimSpec


class Recalls(PredictModelServer):
    def __init__(self, dataset: str):
        super().__init__()
        root = pathlib.Path(dataset)
        table = pyarrow.parquet.ParquetDataset(root / "data").read()
        self._states, self._actions = (np.stack(table[name].to_numpy()).astype(np.float32) for name in ("observation.state", "action"))
        rows = pyarrow.parquet.ParquetDataset(root / "meta/episodes").read().to_pylist()
        self._begins = {row["episode_id"]: row["dataset_from_index"] for row in rows}
        self._frame = 0  # the next one

    async def on_episode_start(self, config, ctx):
        await super().on_episode_start(config, ctx)
        self._frame = self._begins[config["task"]["name"]]

    def get_action_spec(self):
        return {"action": DimSpec("action", self._actions.shape[1], "pd_joint_pos")}

    def get_observation_spec(self):
        return {"wrist_camera": IMAGE_RGB, "state": DimSpec("state", self._states.shape[1], "marketgen_state"), "language": LANGUAGE}

    def predict(self, obs, ctx):
        picture = obs["images"]["wrist_camera"]
        if picture.shape != (64, 64, 3) or picture.dtype != np.uint8 or picture.std() < 1 or not obs["task_description"]:
            raise ValueError(f"it was sent no picture or no words: {picture.shape} {picture.dtype} {obs['task_description']!r}")
        frame, self._frame = self._frame, self._frame + 1
        if obs["state"].tobytes() != self._states[frame].tobytes():
            raise ValueError(f"frame {frame}: it was sent another state than the recorded one")
        return {"actions": self._actions[frame]}


if __name__ == "__main__":
    sys.exit(run_server(Recalls))
