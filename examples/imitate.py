"""Record, train, evaluate: a policy of LeRobot learns one task from the oracle's demonstrations, and is measured beside chance.

    pip install "marketgen[lerobot]" lerobot
    python examples/imitate.py [--out FOLDER] [--demonstrations 100] [--steps 2000] [--trials 40]

Without LeRobot it records a few demonstrations and measures chance alone.

The task: one tin, on a counter, is to be brought onto the unloading area; where it stands and how it faces is drawn. The policy is LeRobot's
ACT: of where the tool is, how far its fingers are open, and a picture of the camera over the counter it says where the tool goes and what the
fingers do. Leaves in FOLDER (out/examples/imitate) the two files of episodes, the dataset, the checkpoint (policy/) with the row that says what
it sees and says (policy.yaml), results/ and random/ (scores). What is there already is not made again, so that it may be run stage by stage.
docs/learning.md says what was measured.
"""

import argparse
import importlib.util
import json
import pathlib

import gymnasium
import numpy as np

import marketgen

SKU, LIMIT_S = "canned-luncheon-meat-200g", 15.0  # the oracle moves with care: it takes nine seconds
CAMERA, SIZE = "scene_camera", (128, 128)
TINS = (48, 61, 32, 32)  # of a picture, where tins stand at first: top, left, height, width; a network this small learns from that alone
READS = ("tcp_pose.tool_x", "tcp_pose.tool_y", "tcp_pose.tool_z", "qpos.tool_opening")
SAYS = ("tool_x", "tool_y", "tool_z", "tool_opening")
CHUNK, EXECUTED = 50, 10  # steps that are said and done before it looks again; the whole way to the tin is in what it must say
AHEAD = 3  # the tool is told where the oracle's was so many steps later than the next: what is said always leads on
BESIDE_M = 0.02  # it also learns from a tool that is beside the way: what it is to do is seen, not read off where it is
APPROACHES = 0.6  # of what is learned from: frames before the fingers close, in which the picture counts
FIRST_TRIAL = 1_000_000  # seeds of trials are none of demonstrations
BATCH, RATE = 32, 5e-4
OPEN, SHUT = 1.0, -1.0


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


def names_of(dataset):
    """What the numbers of observation.state are."""
    return json.loads((dataset / "meta/info.json").read_text())["features"]["observation.state"]["names"]


class Demonstrations:
    """Of each frame: what the policy reads, where the tool is to go and what the fingers are told, the picture, and which frame is its
    episode's last; and which are before the fingers close. Arrays by frame."""

    def __init__(self, dataset):
        states, actions, pictures, self.last = frames_of(dataset)
        self.read = states[:, [names_of(dataset).index(name) for name in READS]].astype(np.float32)
        places = self.read[np.minimum(np.arange(len(states)) + 1 + AHEAD, self.last), :3]
        told = np.where(actions[:, -2] > 0, OPEN, SHUT)  # as wide as they go: the oracle leaves five millimetres to either side
        self.said = np.c_[places, told].astype(np.float32)
        [(self.picture, self.pictures)] = pictures.items()
        ends = np.unique(self.last)
        self.firsts = np.append(0, ends[:-1] + 1)
        before = np.roll(told, 1)
        before[self.firsts] = OPEN
        self.read[before > 0, 3] = self.read[:, 3].max()  # and so they will be read
        shut = [first + np.flatnonzero(self.said[first : end + 1, 3] < 0)[0] for first, end in zip(self.firsts, ends, strict=True)]
        self.approaches = np.concatenate([np.arange(*way) for way in zip(self.firsts, shut, strict=True)])

    def tins(self, frames):
        """(frames, 3, height, width), shares of full light."""
        import torch

        top, left, height, width = TINS
        seen = self.pictures[frames, top : top + height, left : left + width]
        return torch.from_numpy(seen).permute(0, 3, 1, 2).float() / 255

    def stats(self):
        """By which LeRobot's processors scale. Of pictures not a colour is subtracted but a picture: that of the empty counter."""
        firsts = self.tins(self.firsts)
        empty = firsts.median(dim=0).values
        spread = np.full((3, 1, 1), 2 * (firsts - empty).square().mean().sqrt(), np.float32)
        numbers = {"observation.state": self.read, "action": self.said}
        scales = {name: {"mean": values.mean(axis=0), "std": values.std(axis=0)} for name, values in numbers.items()}
        return scales | {self.picture: {"mean": empty.numpy(), "std": spread}}

    def batch(self, draws):
        import torch

        early = draws.random(BATCH) < APPROACHES
        frames = np.where(early, draws.choice(self.approaches, BATCH), draws.integers(len(self.read), size=BATCH))
        read = self.read[frames]
        read[:, :2] += draws.normal(scale=BESIDE_M, size=(BATCH, 2)) * draws.random((BATCH, 1))
        ahead = frames[:, None] + np.arange(CHUNK)
        return {
            "observation.state": torch.from_numpy(read),
            self.picture: self.tins(frames),
            "action": torch.from_numpy(self.said[np.minimum(ahead, self.last[frames, None])]),
            "action_is_pad": torch.from_numpy(ahead > self.last[frames, None]),
        }


def policy_of(shown):
    """A small ACT that has learned nothing yet, and its processors."""
    import torch
    from lerobot.configs.types import FeatureType, PolicyFeature
    from lerobot.policies.act.configuration_act import ACTConfig
    from lerobot.policies.act.modeling_act import ACTPolicy
    from lerobot.policies.factory import make_pre_post_processors
    from torchvision.ops.misc import FrozenBatchNorm2d

    config = ACTConfig(
        input_features={
            "observation.state": PolicyFeature(FeatureType.STATE, (len(READS),)),
            shown.picture: PolicyFeature(FeatureType.VISUAL, (3, *SIZE)),
        },
        output_features={"action": PolicyFeature(FeatureType.ACTION, (len(SAYS),))},
        chunk_size=CHUNK, n_action_steps=EXECUTED, pretrained_backbone_weights=None, device="cpu",
        dim_model=128, n_heads=4, dim_feedforward=256, n_encoder_layers=1, use_vae=False, dropout=0.0,
    )
    policy, (before, after) = ACTPolicy(config), make_pre_post_processors(config, dataset_stats=shown.stats())

    def sees(norm, inputs):
        norm.running_mean, norm.running_var = inputs[0].mean((0, 2, 3)), inputs[0].var((0, 2, 3))

    # ACT's norms are frozen as weights from elsewhere want them: without such weights they do nothing. Here they are those of the first batch.
    norms = [part.register_forward_pre_hook(sees) for part in policy.modules() if isinstance(part, FrozenBatchNorm2d)]
    with torch.no_grad():
        policy.model.backbone(before(shown.batch(np.random.default_rng(0)))[shown.picture])
    for norm in norms:
        norm.remove()
    return policy, before, after


def train(dataset, checkpoint, steps):
    """Behaviour cloning, from nothing, on one core."""
    import torch
    from lerobot.processor import ImageCropResizeProcessorStep

    torch.set_num_threads(1)
    torch.manual_seed(1)
    shown, draws = Demonstrations(dataset), np.random.default_rng(1)
    policy, before, after = policy_of(shown)
    optimizer = torch.optim.AdamW(policy.parameters(), lr=RATE, weight_decay=1e-4, fused=True)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimizer, RATE, total_steps=steps, pct_start=0.1)
    policy.train()
    for step in range(steps):
        loss, _ = policy.forward(before(shown.batch(draws)))
        optimizer.zero_grad(set_to_none=False)
        loss.backward()
        optimizer.step()
        schedule.step()
        if step % 100 == 0:
            print(f"{step:>8} of {steps} steps: loss {loss.item():.3f}", flush=True)
    before.steps.insert(0, ImageCropResizeProcessorStep(crop_params_dict={shown.picture: TINS}))  # it will be shown whole pictures
    for part in (policy, before, after):
        part.save_pretrained(checkpoint)


def row_of(picture):
    """Of an adapter (docs/remote.md): what the checkpoint sees and says. JSON is YAML."""
    seen = {"observation.state": {"numbers": list(READS)}, picture: {"picture": picture.removeprefix("observation.images.")}}
    pictures = {"size": list(SIZE), "layout": "chw", "values": "shares"}
    says = {"keys": ["actions"], "space": "tool_targets", "numbers": list(SAYS)}
    row = {"about": "examples/imitate.py", "observation": seen | {"task": {"words": "instruction"}}, "pictures": pictures, "action": says}
    return json.dumps({"imitate": row}, indent=1)


def measure(trials, policies, options=None):
    """Policies, by the folders of their results, on episodes that are in no demonstration; the paired test is the leaderboard's.
    `options`: of evaluate(), by the same folders."""
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
    parser.add_argument("--steps", type=int, default=2000)
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
    policies, options = {given.out / "random": "random"}, {}
    if learns:
        row = checkpoint.with_suffix(".yaml")
        if not checkpoint.exists():
            train(dataset, checkpoint, given.steps)
            row.write_text(row_of(f"observation.images.{CAMERA}"))
        policies[given.out / "results"] = f"lerobot:{checkpoint}"
        options[given.out / "results"] = {"adapter": str(row)}
    else:
        print("training needs LeRobot: pip install lerobot")
    measure(trials, policies, options)


if __name__ == "__main__":
    main()
