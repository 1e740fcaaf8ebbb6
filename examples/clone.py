"""Record, train, evaluate, on two cores in minutes: a tiny network copies the oracle and is measured beside chance.

    pip install "marketgen[lerobot]"
    python examples/clone.py --demonstrations 40 --steps 10000 --trials 40 --out out/clone
    python examples/clone.py                    # the same way in a minute, too short to learn anything

The task: one tin, on a counter, is to be brought onto the unloading area; where it stands and how it faces is drawn. It learns from the
dataset alone where the oracle's tool goes, and acts on what a robot has: its tool, its fingers, and the first picture of the camera over
the counter. Leaves in the folder the two files of episodes, the dataset, policy.npz, results/ and random/ (scores). What is there already
is not made again. docs/learning.md says what was measured. imitate.py goes the same way with a policy of LeRobot.
"""

import argparse
import itertools
import pathlib

import numpy as np
from imitate import draw, frames_of, measure, names_of

import marketgen

CAMERA, SIZE = "scene_camera", (128, 128)
FIRST_TRIAL = 1_000_000  # seeds of trials are none of demonstrations
TOOL_STEP_M = 0.02  # what 1 of an action is, in pd_ee_delta_pos
SEES = {"obs_mode": "rgbd", "control_mode": "pd_ee_delta_pos", "cameras": [CAMERA], "width": SIZE[0], "height": SIZE[1]}
CHUNK, HIDDEN, BATCH, RATE = 8, 96, 256, 2e-3  # a chunk: so many actions are said at a time
BESIDE_M = 0.01
OPEN, SHUT = 1.0, -1.0
FAINT = 24  # of 255: what differs less from the empty counter is no thing


def thing(picture, empty):
    """Where something stands that the empty counter does not show: its middle and how it spreads, as shares of the picture."""
    weight = np.abs(picture.astype(float) - empty).max(axis=2)
    weight[weight < FAINT] = 0
    v, u = np.mgrid[0 : weight.shape[0], 0 : weight.shape[1]] / weight.shape[0] - 0.5
    weight = weight / max(weight.sum(), 1.0)
    u0, v0 = (weight * u).sum(), (weight * v).sum()
    spread = [(weight * a * b).sum() for a, b in (((u - u0), (u - u0)), ((v - v0), (v - v0)), ((u - u0), (v - v0)))]
    return np.array([1.0, u0, v0, u0 * u0, u0 * v0, v0 * v0, *(10 * np.array(spread))])


class Net:
    """Three layers; Adam."""

    def __init__(self, sizes, rng):
        self.parts = [p for i, o in itertools.pairwise(sizes) for p in (rng.normal(size=(i, o)) / np.sqrt(i), np.zeros(o))]
        self.moments = [(np.zeros_like(p), np.zeros_like(p)) for p in self.parts]
        self.steps = 0

    def layers(self, x):
        out = [x]
        for i in range(0, len(self.parts), 2):
            x = x @ self.parts[i] + self.parts[i + 1]
            out.append(x if i + 2 == len(self.parts) else np.tanh(x))
            x = out[-1]
        return out

    def learn(self, x, wanted, rate):
        """One step towards `wanted`; the mean of the squared errors before it."""
        out = self.layers(x)
        off = out[-1] - wanted
        slope, gradients = 2 * off / off.size, []
        for layer in range(len(self.parts) // 2 - 1, -1, -1):
            gradients = [out[layer].T @ slope, slope.sum(axis=0), *gradients]
            slope = (slope @ self.parts[2 * layer].T) * (1 - out[layer] ** 2)
        self.steps += 1
        for part, (first, second), gradient in zip(self.parts, self.moments, gradients, strict=True):
            first += 0.1 * (gradient - first)
            second += 0.001 * (gradient**2 - second)
            part -= rate * first / (1 - 0.9**self.steps) / (np.sqrt(second / (1 - 0.999**self.steps)) + 1e-8)
        return float((off**2).mean())


class Clone:
    """Acts as the network says: at the begin it looks where the tin stands, and then goes by its tool and fingers alone."""

    def __init__(self, learned):
        self.learned = learned
        self.net = Net([0], None)
        self.net.parts = [learned[f"part{i}"] for i in range(6)]

    def begin(self, task, observation):
        self.grasp = thing(observation["sensor_data"][CAMERA]["rgb"], self.learned["empty"]) @ self.learned["where"]
        self.ahead, self.told = [], OPEN

    def act(self, observation):
        if not self.ahead:
            self.ahead = self.next_actions(np.array([*observation["extra"]["tcp_pose"][:3], self.told], float))
        action = self.ahead.pop(0)
        self.told = action[3]
        return action

    def next_actions(self, read):
        x = (inputs(read[None], self.grasp[None]) - self.learned["middle"]) / self.learned["scale"]
        said = (self.net.layers(x)[-1] * self.learned["spread"] + self.learned["mean"]).reshape(CHUNK, 4)
        steps = np.clip(np.diff(said[:, :3], axis=0, prepend=np.zeros((1, 3))) / TOOL_STEP_M, -1, 1)
        fingers = np.where(said[:, 3:] > 0, OPEN, SHUT)
        return list(np.concatenate([steps, fingers, np.full((CHUNK, 1), -1.0)], axis=1))  # -1: it does not say that it has done


class Served:
    """The same for servers (serve_policy.py), who are told nothing of episodes: where the tool begins, with open fingers, it looks."""

    steps, camera, size, action = CHUNK, CAMERA, SIZE, {"space": "tool_moves", "unit_m": TOOL_STEP_M}

    def __init__(self, learned):
        self.learned = learned
        self.columns, self.start, self.numbers = learned["columns"], learned["start"], int(learned["numbers"])
        self.clone = Clone(learned)
        self.clone.told, self.looked = OPEN, False

    def session(self):
        return Served(self.learned)

    def actions(self, seen):
        """(CHUNK, 5), of all that the robot reads of itself and the picture (height, width, 3)."""
        tool = np.asarray(seen["observation.state"], float)[self.columns]
        if not self.looked or np.linalg.norm(tool - self.start) < BESIDE_M:
            self.looked = True
            self.clone.begin(None, {"sensor_data": {CAMERA: {"rgb": seen[f"observation.images.{CAMERA}"]}}})
        chunk = self.clone.next_actions(np.append(tool, self.clone.told))
        self.clone.told = chunk[-1][3]
        return np.stack(chunk)


def inputs(read, grasp):
    """Tool, what the fingers were told last, and how far the tool is from where the tin is taken."""
    return np.concatenate([read, grasp, grasp - read[:, :3]], axis=1)


def ways(places, told, read):
    """What is said of a frame: where the tool is in the next ones, from where it is, and what the fingers are told."""
    return np.concatenate([places - read[:, None, :3], told[:, :, None]], axis=2).reshape(len(read), -1)


def tool_columns(dataset):
    """Where the tool's place stands in the state, and how many numbers that has."""
    names = names_of(dataset)
    return [names.index(f"tcp_pose.tool_{axis}") for axis in "xyz"], len(names)


def demonstrated(dataset):
    """Of each frame: where the tool is and what the fingers were told last; where it is in the next ones, and what they are told; its
    episode. Of each episode its first picture and where the fingers began to close."""
    states, actions, pictures, last = frames_of(dataset)
    tool = states[:, tool_columns(dataset)[0]].astype(float)
    fingers, ends = np.where(actions[:, -2] > 0, OPEN, SHUT), np.unique(last)
    firsts = np.concatenate([[0], ends[:-1] + 1])
    before = np.roll(fingers, 1)
    before[firsts] = OPEN
    closes = [first + np.flatnonzero(fingers[first : end + 1] < 0)[0] for first, end in zip(firsts, ends, strict=True)]
    ahead = np.arange(len(tool))[:, None] + np.arange(CHUNK)
    places, told = tool[np.minimum(ahead + 1, last[:, None])], fingers[np.minimum(ahead, last[:, None])]
    shown = pictures[f"observation.images.{CAMERA}"][firsts]
    return np.c_[tool, before], places, told, np.searchsorted(ends, np.arange(len(tool))), shown, tool[closes]


def train(dataset, steps):
    """What Clone goes by, of a dataset alone."""
    read, places, told, episode, shown, grasps = demonstrated(dataset)
    empty = np.median(shown, axis=0)
    things = np.stack([thing(picture, empty) for picture in shown])
    where = np.linalg.solve(things.T @ things + 1e-6 * np.eye(things.shape[1]), things.T @ grasps)
    print(f"where the tin is taken: {1000 * np.abs(things @ where - grasps).mean():.1f} mm off in the mean", flush=True)
    columns, numbers = tool_columns(dataset)
    begins = np.unique(episode, return_index=True)[1]
    grasp, y = grasps[episode], ways(places, told, read)
    x = inputs(read, grasp)
    kept = {"empty": empty, "where": where, "middle": x.mean(axis=0), "scale": x.std(axis=0) + 1e-3}
    kept |= {"mean": y.mean(axis=0), "spread": y.std(axis=0) + 1e-3}
    kept |= {"columns": np.array(columns), "numbers": numbers, "start": read[begins, :3].mean(axis=0)}
    rng = np.random.default_rng(1)
    net = Net((x.shape[1], HIDDEN, HIDDEN, y.shape[1]), rng)
    for step in range(steps):
        rows = rng.integers(len(x), size=BATCH)
        off = read[rows]  # a little beside the demonstrated way, the same places lead back to it
        off[:, :3] += rng.normal(scale=BESIDE_M, size=(BATCH, 3)) * rng.random((BATCH, 1))
        wanted = (ways(places[rows], told[rows], off) - kept["mean"]) / kept["spread"]
        loss = net.learn((inputs(off, grasp[rows]) - kept["middle"]) / kept["scale"], wanted, RATE * (1 - step / steps))
        if step % 1000 == 0:
            print(f"{step:>8} of {steps} steps: loss {loss:.4f}", flush=True)
    return kept | {f"part{i}": part for i, part in enumerate(net.parts)}


def asked_for():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/examples/clone"))
    parser.add_argument("--demonstrations", type=int, default=2)
    parser.add_argument("--steps", type=int, default=500)
    parser.add_argument("--trials", type=int, default=2)
    return parser.parse_args()


def main():
    given = asked_for()
    given.out.mkdir(parents=True, exist_ok=True)
    shown, trials, dataset, policy = (given.out / name for name in ("shown.jsonl", "trials.jsonl", "dataset", "policy.npz"))
    for file, first, count in ((shown, 0, given.demonstrations), (trials, FIRST_TRIAL, given.trials)):
        if not file.exists():
            draw(file, first, count)
    made = marketgen.record(shown, dataset, "oracle", cameras=[CAMERA], size=SIZE, success_only=True, resume=True)
    print(f"{made.episodes} demonstrations, {made.frames:,} frames", flush=True)
    if not policy.exists():
        np.savez(policy, **train(dataset, given.steps))
    measure(trials, {given.out / "random": "random", given.out / "results": Clone(dict(np.load(policy)))}, {given.out / "results": SEES})


if __name__ == "__main__":
    main()
