"""PPO or SAC of Stable-Baselines3 learns a task from its state; how it does it beside chance, and where there is one, the oracle.

    pip install "marketgen[rl]"
    python examples/ppo_pick.py [STEPS [OUT]] [--task CheckoutOneItem|DriveToProduct|PickFromShelf|PlaceInBasket|OpenCooler] [--seed 1]

Without --task it brings one product to the unloading area. Without Stable-Baselines3 it measures chance and the oracle alone. Leaves
in OUT (out/examples/ppo_pick) curve.json, policy.zip and, of PPO, normalize.pkl (the means and spreads that the policy's observations
need); docs/learning.md shows such curves.
"""

import argparse
import importlib.util
import json
import math
import pathlib
import time
from dataclasses import dataclass, field

import gymnasium
import numpy as np

import marketgen

FIRST_TRIAL, FIRST_FINAL = 1_000_000, 2_000_000  # seeds of trials are none that are learned from
CHANCE_TRIALS, FINAL_TRIALS = 20, 50
PPO = {
    "n_steps": 256, "batch_size": 256, "n_epochs": 10, "gamma": 0.98, "learning_rate": 5e-4,
    "policy_kwargs": {"net_arch": [128, 128], "log_std_init": -0.5},
}  # fmt: skip
SAC = {
    "learning_starts": 500, "ent_coef": "auto_0.01", "batch_size": 256, "gamma": 0.98, "learning_rate": 7e-4, "tau": 0.01,
    "train_freq": 1, "gradient_steps": 8,
    "policy_kwargs": {"net_arch": [128, 128]},
}  # fmt: skip
DOOR = SAC | {
    "learning_starts": 1000, "ent_coef": "auto_0.1", "gradient_steps": 4, "policy_kwargs": {"net_arch": [256, 256]},
}  # fmt: skip


@dataclass(frozen=True)
class Task:
    """How one is learned: by what, in how many steps, measured how often."""

    algorithm: str
    steps: int
    between: int
    settings: dict = field(default_factory=dict)
    trials: int = 10  # between; FINAL_TRIALS at the end
    envs: int = 8
    oracle: bool = False
    times: float = 1  # the reward, to learn from; measures are of the environment's own


TASKS = {
    "CheckoutOneItem": Task("PPO", 400_000, 25_000, PPO, trials=20, oracle=True),
    "DriveToProduct": Task("SAC", 6_000, 1_500, SAC),
    "PickFromShelf": Task("SAC", 8_000, 2_000, SAC),
    "PlaceInBasket": Task("SAC", 6_000, 1_000, SAC),
    "OpenCooler": Task("SAC", 12_000, 2_000, DOOR, envs=4, times=10),
}


def within(successes, trials, z=1.96):
    """Wilson's interval of a share, 95 %."""
    share, more = successes / trials, z * z / trials
    middle = (share + more / 2) / (1 + more)
    half = z / (1 + more) * math.sqrt(share * (1 - share) / trials + more / (4 * trials))
    return [round(max(0.0, middle - half), 3), round(min(1.0, middle + half), 3)]


def measure(env, policy, trials=CHANCE_TRIALS, first=FIRST_TRIAL, limit_s=None):
    """Of so many episodes: the share that succeed, its interval, their mean return and steps. `limit_s`: another than the task's."""
    done = []
    for trial in range(trials):
        seen, _ = env.reset(seed=first + trial)
        if limit_s is not None:
            seen, _ = env.reset(options={"episode": env.unwrapped.episode | {"limit_s": limit_s}})
        total, steps, over = 0.0, 0, False
        while not over:
            seen, reward, terminated, truncated, info = env.step(policy(seen))
            total, steps, over = total + reward, steps + 1, terminated or truncated
        done.append((info["is_success"], total, steps))
    success, total, steps = np.mean(done, axis=0)
    figures = {"success": round(float(success), 3), "within": within(round(float(success) * trials), trials), "trials": trials}
    return figures | {"return": round(float(total), 2), "steps": round(float(steps), 1)}


def rivals(name, task):
    """Chance, and the oracle, which moves by joints and so carefully that it gets a minute."""
    env = gymnasium.make(name)
    env.action_space.seed(1)
    found = {"chance": measure(env, lambda seen: env.action_space.sample())}
    if task.oracle:
        shown = gymnasium.make(name, control_mode="pd_joint_pos")
        found["oracle"] = measure(shown, marketgen.policies.oracle(shown), trials=5, limit_s=60)
    return found


class Times(gymnasium.RewardWrapper):
    """A reward that networks can tell from their first noise."""

    def __init__(self, env, factor):
        super().__init__(env)
        self.factor = factor

    def reward(self, reward):
        return self.factor * reward


def learner(name, task, seed):
    """The model, and what it sees of an observation."""
    import stable_baselines3
    import torch
    from stable_baselines3.common.env_util import make_vec_env
    from stable_baselines3.common.vec_env import VecNormalize

    torch.set_num_threads(1)
    envs = make_vec_env(name, n_envs=task.envs, seed=seed, wrapper_class=Times, wrapper_kwargs={"factor": task.times})
    if task.algorithm == "PPO":
        envs = VecNormalize(envs, norm_reward=True, gamma=task.settings["gamma"])
    make = getattr(stable_baselines3, task.algorithm)
    model = make("MlpPolicy", envs, seed=seed, device="cpu", **task.settings)
    return model, getattr(envs, "normalize_obs", lambda seen: seen)


def learn(name, task, steps, seed, report):
    """Trains, and measures the deterministic policy every so often; `report` gets each measure. Returns the model."""
    model, shown = learner(name, task, seed)
    trial = gymnasium.make(name)

    def policy(seen):
        return model.predict(shown(seen), deterministic=True)[0]

    learning_s = 0.0
    parts = max(1, steps // task.between)
    for part in range(parts):
        began = time.process_time()
        model.learn(task.between, reset_num_timesteps=part == 0)
        learning_s += time.process_time() - began
        last = part == parts - 1
        measured = measure(trial, policy, FINAL_TRIALS, FIRST_FINAL) if last else measure(trial, policy, task.trials)
        report({"learned_steps": model.num_timesteps, "computing_s": round(learning_s, 1)} | measured)
    return model


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("steps", nargs="?", type=float, help="those of the task when absent")
    parser.add_argument("out", nargs="?", type=pathlib.Path, default=pathlib.Path("out/examples/ppo_pick"))
    parser.add_argument("--task", choices=TASKS, default="CheckoutOneItem")
    parser.add_argument("--seed", type=int, default=1, help="of what is learned")
    return parser.parse_args()


def main():
    asked = arguments()
    name, task = f"MarketGen/{asked.task}-v1", TASKS[asked.task]
    curve = {"task": name, "algorithm": task.algorithm, "seed": asked.seed, "marketgen": marketgen.__version__}
    curve |= rivals(name, task) | {"learned": []}
    for rival in ("chance", "oracle"):
        if rival in curve:
            print(f"{rival:>24}: {curve[rival]}", flush=True)

    def report(point):
        curve["learned"].append(point)
        asked.out.mkdir(parents=True, exist_ok=True)
        (asked.out / "curve.json").write_text(json.dumps(curve, indent=1) + "\n")
        rate = point["learned_steps"] / point["computing_s"]
        print(f"{point['learned_steps']:>16,} steps: {point} ({rate:,.0f} steps a second of computing)", flush=True)

    if importlib.util.find_spec("stable_baselines3") is None:
        print('learning needs Stable-Baselines3: pip install "marketgen[rl]"')
        return
    model = learn(name, task, int(asked.steps or task.steps), asked.seed, report)
    model.save(asked.out / "policy.zip")
    if (normalized := model.get_vec_normalize_env()) is not None:
        normalized.save(str(asked.out / "normalize.pkl"))  # what its observations are divided by
    print(f"curve: {asked.out / 'curve.json'}")


if __name__ == "__main__":
    main()
