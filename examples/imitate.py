"""Record, train, evaluate: a policy of LeRobot learns one task from the oracle's demonstrations, and is measured beside chance.

    pip install "marketgen[lerobot]" lerobot
    python examples/imitate.py [--out FOLDER] [--demonstrations 100] [--steps 6000] [--trials 40]

Without LeRobot it records a few demonstrations and measures chance alone.

The task: one tin, on a counter, is to be brought onto the unloading area; where it stands and how it faces is drawn. Leaves in FOLDER
(out/examples/imitate) the two files of episodes, the dataset, the checkpoint (policy/), results/ and random/ (scores). What is there already is
not made again, so that it may be run stage by stage. docs/remote.md says what was measured.
"""

import argparse
import importlib.util
import pathlib

import gymnasium
import numpy as np

import marketgen

SKU, LIMIT_S = "canned-luncheon-meat-200g", 15.0  # the oracle moves with care: it takes nine seconds
CAMERA, SIZE, CHUNK, EXECUTED = "wrist_camera", (64, 64), 20, 10  # that of the hand sees the tin from the first moment on
FIRST_TRIAL = 1_000_000  # seeds of trials are none of demonstrations
BATCH, RATE = 8, 3e-4


def draw(file, first_seed, count):
    """Writes so many episodes of the task."""
    env = gymnasium.make("MarketGen/CheckoutOneItem-v1").unwrapped
    episodes, seed = [], first_seed
    while len(episodes) < count:
        env.reset(seed=seed)
        if env.episode["items"][0]["sku"] == SKU:
            episodes.append(env.episode | {"limit_s": LIMIT_S})
        seed += 1
    marketgen.write_episodes(file, episodes, like="pool/checkout")


def frames_of(dataset):
    """All of a dataset, in memory: states, actions, pictures by feature, and of each frame the last one of its episode."""
    import av
    import pyarrow.parquet

    table = pyarrow.parquet.ParquetDataset(dataset / "data").read()
    states, actions = (np.stack(table[name].to_numpy()) for name in ("observation.state", "action"))
    episodes = table["episode_index"].to_numpy()
    last = np.array([np.flatnonzero(episodes == episode)[-1] for episode in range(episodes.max() + 1)])[episodes]
    pictures = {}
    for folder in sorted((dataset / "videos").iterdir()):
        shown = []
        for file in sorted(folder.rglob("*.mp4")):
            with av.open(str(file)) as video:
                shown += [frame.to_ndarray(format="rgb24") for frame in video.decode(video=0)]
        pictures[folder.name] = np.stack(shown)
    return states, actions, pictures, last


def train(dataset, checkpoint, steps):
    """Behaviour cloning: a small ACT, from nothing, on one core."""
    import torch
    from lerobot.configs.types import FeatureType, PolicyFeature
    from lerobot.datasets.lerobot_dataset import LeRobotDatasetMetadata
    from lerobot.policies.act.configuration_act import ACTConfig
    from lerobot.policies.act.modeling_act import ACTPolicy
    from lerobot.policies.factory import make_pre_post_processors

    torch.set_num_threads(1)
    torch.manual_seed(1)
    draws = np.random.default_rng(1)
    states, actions, pictures, last = frames_of(dataset)
    config = ACTConfig(
        input_features={
            "observation.state": PolicyFeature(FeatureType.STATE, states.shape[1:]),
            **{name: PolicyFeature(FeatureType.VISUAL, (3, *SIZE)) for name in pictures},
        },
        output_features={"action": PolicyFeature(FeatureType.ACTION, actions.shape[1:])},
        chunk_size=CHUNK, n_action_steps=EXECUTED, pretrained_backbone_weights=None, device="cpu",
        dim_model=128, n_heads=4, dim_feedforward=256, n_encoder_layers=2, use_vae=False, dropout=0.0,
    )
    stats = LeRobotDatasetMetadata("marketgen/imitate", root=dataset).stats
    policy, (before, after) = ACTPolicy(config), make_pre_post_processors(config, dataset_stats=stats)
    optimizer = torch.optim.AdamW(policy.parameters(), lr=RATE, weight_decay=1e-4)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimizer, RATE, total_steps=steps, pct_start=0.1)
    policy.train()
    for step in range(steps):
        frames = draws.integers(len(states), size=BATCH)
        ahead = frames[:, None] + np.arange(CHUNK)
        batch = {
            "observation.state": torch.from_numpy(states[frames]),
            "action": torch.from_numpy(actions[np.minimum(ahead, last[frames, None])]),
            "action_is_pad": torch.from_numpy(ahead > last[frames, None]),
            **{name: torch.from_numpy(shown[frames]).permute(0, 3, 1, 2).float() / 255 for name, shown in pictures.items()},
        }
        loss, _ = policy.forward(before(batch))
        optimizer.zero_grad()
        loss.backward()
        optimizer.step()
        schedule.step()
        if step % 100 == 0:
            print(f"{step:>8} of {steps} steps: loss {loss.item():.3f}", flush=True)
    for part in (policy, before, after):
        part.save_pretrained(checkpoint)


def measure(trials, policies, options=None):
    """Policies, by the folders of their results, on episodes that are in no demonstration; the paired test is the leaderboard's.
    `options`: of their environments, by the same folders."""
    for folder, policy in policies.items():
        marketgen.evaluate(trials, policy, folder, resume=True, **(options or {}).get(folder, {}))
    [track] = marketgen.leaderboard(list(policies))["tracks"]
    for entry in track["entries"]:
        share, beside = entry["strict"], entry.get("to_best")
        p = f", p = {beside['p_strict']:.2g} beside the best" if beside else ""
        print(f"{entry['policy']:>16}: {share['number']} of {share['of']}{p}")


def asked_for():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    learns = importlib.util.find_spec("lerobot") is not None
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/examples/imitate"))
    parser.add_argument("--demonstrations", type=int, default=100 if learns else 2)
    parser.add_argument("--steps", type=int, default=6000)
    parser.add_argument("--trials", type=int, default=40 if learns else 2)
    return parser.parse_args(), learns


def main():
    given, learns = asked_for()
    given.out.mkdir(parents=True, exist_ok=True)
    shown, trials, dataset, checkpoint = (given.out / name for name in ("shown.jsonl", "trials.jsonl", "dataset", "policy"))
    for file, first, count in ((shown, 0, given.demonstrations), (trials, FIRST_TRIAL, given.trials)):
        if not file.exists():
            draw(file, first, count)
    made = marketgen.record(shown, dataset, "oracle", cameras=[CAMERA], size=SIZE, success_only=True, resume=True)
    print(f"{made.episodes} demonstrations, {made.frames:,} frames", flush=True)
    policies = {given.out / "random": "random"}
    if learns:
        if not checkpoint.exists():
            train(dataset, checkpoint, given.steps)
        policies[given.out / "results"] = f"lerobot:{checkpoint}"
    else:
        print("training needs LeRobot: pip install lerobot")
    measure(trials, policies)


if __name__ == "__main__":
    main()
