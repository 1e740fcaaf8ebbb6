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
import json
import pathlib

import gymnasium
import numpy as np

import marketgen

SKU, LIMIT_S = "canned-luncheon-meat-200g", 15.0  # the oracle moves with care: it takes nine seconds
MIDDLE_M, SPREAD = (-0.14, -0.54), 0.35  # of where the tin is drawn, as the episodes have it; how much of that is kept
CAMERA, SIZE, CHUNK, EXECUTED = "scene_camera", (64, 64), 8, 4
FIRST_TRIAL = 1_000_000  # seeds of trials are none of demonstrations
BATCH, RATE = 8, 5e-4
READS = [*(f"tcp_pose.tool_{axis}" for axis in "xyz"), "qpos.tool_opening"]
TOOL_STEP_M, BESIDE_M = 0.02, 0.01  # the longest way of one action; how far beside the demonstrated way it learns to come back
OPEN, SHUT = 1.0, -1.0


def draw(file, first_seed, count, spread=1.0):
    """Writes so many episodes of the task; `spread` is how much is kept of where the tin stands and how it faces."""
    env = gymnasium.make("MarketGen/CheckoutOneItem-v1").unwrapped
    episodes, seed = [], first_seed
    while len(episodes) < count:
        env.reset(seed=seed)
        if env.episode["items"][0]["sku"] == SKU:
            items = [nearer(env.episode["items"][0], spread)] if spread < 1 else env.episode["items"]
            episodes.append(env.episode | {"limit_s": LIMIT_S, "items": items})
        seed += 1
    marketgen.write_episodes(file, episodes, like="pool/checkout")


def nearer(item, spread):
    """An item as drawn, with so much of its way from the middle, and of its turn."""
    place = [middle + spread * (at - middle) for middle, at in zip(MIDDLE_M, item["position_m"][:2], strict=True)]
    turn = spread * np.arctan2(item["rotation_wxyz"][3], item["rotation_wxyz"][0])
    return item | {"position_m": [*place, item["position_m"][2]], "rotation_wxyz": [np.cos(turn), 0.0, 0.0, np.sin(turn)]}


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


def columns_of(dataset, names):
    """Places of numbers in the state."""
    known = json.loads((dataset / "meta/info.json").read_text())["features"]["observation.state"]["names"]
    return [known.index(name) for name in names]


def tool_moves(tool, fingers, start, ahead, after):
    """As actions of pd_ee_delta_pos: where the tool goes from `start` on over `after`, what the fingers are told at `ahead`, and that it
    has not done. (frames, steps, 5)"""
    ways_m = np.diff(tool[after], axis=1, prepend=start[:, None])
    told = fingers[ahead][:, :, None]
    return np.concatenate([np.clip(ways_m / TOOL_STEP_M, -1, 1), told, np.full_like(told, -1)], axis=2).astype(np.float32)


def scales_of(rows, used=None):
    """Means and spreads, by which LeRobot makes numbers alike; a number that is not used is spread so far that nothing is left of it."""
    spread = rows.std(axis=0) + 1e-3
    if used is not None:
        spread[np.setdiff1d(np.arange(rows.shape[1]), used)] = 1e9
    return {"mean": rows.mean(axis=0).astype(np.float32), "std": spread.astype(np.float32)}


def policy_of(picture, state, action, stats):
    """A small ACT of LeRobot, from nothing, and its processors."""
    from lerobot.configs.types import FeatureType, PolicyFeature
    from lerobot.policies.act.configuration_act import ACTConfig
    from lerobot.policies.act.modeling_act import ACTPolicy
    from lerobot.policies.factory import make_pre_post_processors

    config = ACTConfig(
        input_features={
            "observation.state": PolicyFeature(FeatureType.STATE, (state,)),
            picture: PolicyFeature(FeatureType.VISUAL, (3, *SIZE)),
        },
        output_features={"action": PolicyFeature(FeatureType.ACTION, (action,))},
        chunk_size=CHUNK, n_action_steps=EXECUTED, pretrained_backbone_weights=None, device="cpu",
        dim_model=128, n_heads=4, dim_feedforward=256, n_encoder_layers=2, use_vae=False, dropout=0.0,
    )
    return ACTPolicy(config), make_pre_post_processors(config, dataset_stats=stats)


def batches(dataset):
    """What to learn from, without end: states a little beside the demonstrated way, pictures, and the moves that lead back to it. First
    of all the means and spreads."""
    states, actions, pictures, last = frames_of(dataset)
    [(picture, shown)] = pictures.items()
    fingers = np.where(actions[:, -2] > 0, OPEN, SHUT)
    place, used = columns_of(dataset, READS[:3]), columns_of(dataset, READS)
    tool, every = states[:, place], np.arange(len(states))
    draws = np.random.default_rng(1)

    def moves(frames, start, steps=CHUNK):
        ahead = np.minimum(frames[:, None] + np.arange(steps), last[frames, None])
        return tool_moves(tool, fingers, start, ahead, np.minimum(ahead + 1, last[frames, None]))

    colors = scales_of(shown[:: max(1, len(shown) // 1000)].reshape(-1, 3) / 255)
    yield {
        "observation.state": scales_of(states, used),
        "action": scales_of(moves(every, tool, 1)[:, 0]),
        picture: {name: value.reshape(3, 1, 1) for name, value in colors.items()},
    }
    while True:
        frames = draws.integers(len(states), size=BATCH)
        beside = states[frames]
        beside[:, place] += draws.normal(scale=BESIDE_M, size=(BATCH, 3)) * draws.random((BATCH, 1))
        yield {
            "observation.state": beside,
            "action": moves(frames, beside[:, place]),
            "action_is_pad": np.zeros((BATCH, CHUNK), bool),
            picture: shown[frames].transpose(0, 3, 1, 2).astype(np.float32) / 255,
        }


def train(dataset, checkpoint, steps):
    """Behaviour cloning, on one core."""
    import torch

    torch.set_num_threads(1)
    torch.manual_seed(1)
    drawn = batches(dataset)
    stats = next(drawn)
    picture = next(name for name in stats if "images" in name)
    policy, (before, after) = policy_of(picture, len(stats["observation.state"]["mean"]), len(stats["action"]["mean"]), stats)
    optimizer = torch.optim.AdamW(policy.parameters(), lr=RATE, weight_decay=1e-4, fused=True)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimizer, RATE, total_steps=steps, pct_start=0.1)
    policy.train()
    for step in range(steps):
        loss, _ = policy.forward(before({name: torch.from_numpy(rows) for name, rows in next(drawn).items()}))
        optimizer.zero_grad()
        loss.backward()
        torch.nn.utils.clip_grad_norm_(policy.parameters(), 10.0)
        optimizer.step()
        schedule.step()
        if step % 100 == 0:
            print(f"{step:>8} of {steps} steps: loss {loss.item():.3f}", flush=True)
    for part in (policy, before, after):
        part.save_pretrained(checkpoint)


def adapter():
    """The row that says what the policy sees and what its numbers mean (docs/remote.md); JSON is YAML."""
    seen = {"observation.state": {"numbers": "all"}, f"observation.images.{CAMERA}": {"picture": CAMERA}, "task": {"words": "instruction"}}
    row = {"about": "examples/imitate.py", "observation": seen, "pictures": {"size": SIZE, "layout": "chw", "values": "shares"}}
    return json.dumps({"imitate": row | {"action": {"keys": ["actions"], "space": "tool_moves", "numbers": "all"}}}, indent=1)


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
            draw(file, first, count, SPREAD)
    made = marketgen.record(shown, dataset, "oracle", cameras=[CAMERA], size=SIZE, success_only=True, resume=True)
    print(f"{made.episodes} demonstrations, {made.frames:,} frames", flush=True)
    policies, options = {given.out / "random": "random"}, {}
    if learns:
        if not checkpoint.exists():
            train(dataset, checkpoint, given.steps)
        (given.out / "adapter.yaml").write_text(adapter())
        policies[given.out / "results"] = f"lerobot:{checkpoint}"
        options[given.out / "results"] = {"adapter": str(given.out / "adapter.yaml")}
    else:
        print("training needs LeRobot: pip install lerobot")
    measure(trials, policies, options)


if __name__ == "__main__":
    main()
