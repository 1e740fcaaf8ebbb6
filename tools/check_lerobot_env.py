"""What LeRobot's make_env() makes of a dataset's episodes, beside the dataset; run by tools/check_lerobot in LeRobot's environment.

    python tools/check_lerobot_env.py DATASET EPISODES TRIALS EVAL_INFO RESULTS

The features that a policy is given are those of the dataset; the recorded actions lead to the recorded states, rewards and success.
EVAL_INFO of lerobot-eval has the successes that RESULTS of marketgen.evaluate have of the same checkpoint in TRIALS.
"""

import json
import pathlib
import sys
import warnings

import gymnasium.utils.env_checker
import marketgen.lerobot
import numpy as np
import pyarrow.parquet
from lerobot.datasets.lerobot_dataset import LeRobotDatasetMetadata
from lerobot.envs.factory import make_env
from lerobot.envs.utils import env_to_policy_features, preprocess_observation

try:
    from lerobot.datasets.utils import dataset_to_policy_features
except ImportError:  # LeRobot from 0.5 on
    from lerobot.utils.feature_utils import dataset_to_policy_features


def config_of(root, episodes):
    """The options that the dataset says it was recorded with."""
    told = json.loads((root / "meta/marketgen.json").read_text())
    width, height = told["size"]
    return marketgen.lerobot.MarketGenEnv(
        task=episodes,
        cameras=",".join(told["cameras"]) or "none",
        observation_width=width,
        observation_height=height,
        quality=told["quality"],
        control_mode=told["control_mode"],
        realism=told["realism"],
    )


def check_features(config, root):
    meta = LeRobotDatasetMetadata("marketgen/check", root=root)
    shown, recorded = env_to_policy_features(config), dataset_to_policy_features(meta.features)
    wanted = {name: (feature.type, tuple(feature.shape)) for name, feature in recorded.items()}
    assert {name: (feature.type, tuple(feature.shape)) for name, feature in shown.items()} == wanted, (shown, recorded)
    assert config.fps == meta.fps


def ids_of(episodes):
    return [json.loads(line)["id"] for line in pathlib.Path(episodes).read_text().splitlines()[1:]]


def check_replay(config, root, episodes):
    """Returns how many frames were the same."""
    [[env]] = [list(suite.values()) for suite in make_env(config, n_envs=1).values()]
    rows = pyarrow.parquet.ParquetDataset(root / "meta/episodes").read().to_pylist()
    table = pyarrow.parquet.ParquetDataset(root / "data").read()
    frames = {name: np.stack(table[name].to_numpy()) for name in ("observation.state", "action")}
    for row in rows:
        seen, _ = env.reset(seed=[ids_of(episodes).index(row["episode_id"])])
        assert env.call("task_description")[0] in row["tasks"], row["episode_id"]
        for frame in range(row["dataset_from_index"], row["dataset_to_index"]):
            told = preprocess_observation(seen)
            state = told["observation.state"].numpy()[0]
            assert state.tobytes() == frames["observation.state"][frame].tobytes(), (row["episode_id"], frame)
            seen, _, terminated, truncated, info = env.step(frames["action"][frame][None])
            over = bool(terminated[0] or truncated[0])
            assert over == (frame + 1 == row["dataset_to_index"]), (row["episode_id"], frame)
        assert bool(info["final_info"]["is_success"][0]) == row["success"], row["episode_id"]
    assert any(row["success"] for row in rows), "no recorded episode succeeded: it shows nothing"
    env.close()
    return table.num_rows


def check_scores(trials, eval_info, results):
    [task] = json.loads(pathlib.Path(eval_info).read_text())["per_task"]
    rows = map(json.loads, (pathlib.Path(results) / "results.jsonl").read_text().splitlines())
    by_episode = {row["episode"]: row["success_strict"] for row in rows}
    assert task["metrics"]["successes"] == [by_episode[episode] for episode in ids_of(trials)], (task, by_episode)


def main():
    root, episodes = pathlib.Path(sys.argv[1]), sys.argv[2]
    config = config_of(root, episodes)
    check_features(config, root)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of the bounds of observations, which datasets do not have
        gymnasium.utils.env_checker.check_env(gymnasium.make(config.gym_id, **config.gym_kwargs).unwrapped)
    frames = check_replay(config, root, episodes)
    print(f"LeRobot's environment shows the features of the dataset, and {frames} frames of it again, bit for bit")
    check_scores(*sys.argv[3:])
    print("lerobot-eval and marketgen.evaluate find the same successes")


if __name__ == "__main__":
    main()
