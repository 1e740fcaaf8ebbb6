"""A robot learns a task from its state, by PPO of Stable-Baselines3 or SAC of sac.py; how it does it beside chance, and the oracle.

    pip install "marketgen[rl]"       # for CheckoutOneItem alone; the stages need no more than marketgen[gymnasium]
    python examples/ppo_pick.py [STEPS [OUT]] [--task CheckoutOneItem|DriveToProduct|PickFromShelf|PlaceInBasket|OpenCooler] [--seed 1]

Without --task it brings one product to the unloading area; without Stable-Baselines3 it then measures chance and the oracle alone.
Leaves in OUT (out/examples/ppo_pick) curve.json and the policy: of PPO policy.zip and normalize.pkl (the means and spreads that its
observations need), of SAC policy.npz, which sac.load() reads. Kept is the policy that did best on trials between, of seeds that are
not learned from; the 50 trials at the end are of yet other seeds. docs/learning.md shows such curves.
"""

import argparse
import copy
import importlib.util
import json
import math
import os
import pathlib
import time
from dataclasses import dataclass, field

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # NumPy on several cores is slower with networks this small

import gymnasium
import numpy as np
import sac

import marketgen

FIRST_TRIAL, FIRST_FINAL = 1_000_000, 2_000_000  # seeds of trials are none that are learned from
CHANCE_TRIALS, FINAL_TRIALS = 10, 50
SURE = 0.95  # of the trials between, when nothing more is learned
PPO = {
    "n_steps": 256, "batch_size": 256, "n_epochs": 10, "gamma": 0.98, "learning_rate": 5e-4,
    "policy_kwargs": {"net_arch": [128, 128], "log_std_init": -0.5},
}  # fmt: skip


@dataclass(frozen=True)
class Task:
    """How one is learned: by what, in how many steps at most, measured how often."""

    algorithm: str
    steps: int
    between: int
    settings: dict = field(default_factory=dict)
    trials: int = 10  # between; FINAL_TRIALS at the end
    oracle: bool = False


TASKS = {
    "CheckoutOneItem": Task("PPO", 400_000, 25_000, PPO, trials=20, oracle=True),
    "DriveToProduct": Task("SAC", 12_000, 1_000, {"gamma": 0.98}),
    "PickFromShelf": Task("SAC", 12_000, 500),
    "PlaceInBasket": Task("SAC", 12_000, 1_000),
    "OpenCooler": Task("SAC", 12_000, 1_000),
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


class Ppo:
    """Of Stable-Baselines3, eight environments at once."""

    def __init__(self, name, settings, seed):
        import stable_baselines3
        import torch
        from stable_baselines3.common.env_util import make_vec_env
        from stable_baselines3.common.vec_env import VecNormalize

        torch.set_num_threads(1)
        self.envs = VecNormalize(make_vec_env(name, n_envs=8, seed=seed), norm_reward=True, gamma=settings["gamma"])
        self.model = stable_baselines3.PPO("MlpPolicy", self.envs, seed=seed, device="cpu", **settings)

    @property
    def steps(self):
        return self.model.num_timesteps

    def learn(self, steps):
        self.model.learn(steps, reset_num_timesteps=self.steps == 0)

    def act(self, seen):
        return self.model.predict(self.envs.normalize_obs(seen), deterministic=True)[0]

    def policy(self):
        return copy.deepcopy((self.model.get_parameters(), self.envs.obs_rms))

    def take(self, policy):
        self.model.set_parameters(policy[0])
        self.envs.obs_rms = policy[1]

    def save(self, folder):
        self.model.save(folder / "policy.zip")
        self.envs.save(str(folder / "normalize.pkl"))


class Soft:
    """Of sac.py."""

    def __init__(self, name, settings, seed):
        self.env = gymnasium.make(name)
        [seen], [moves] = self.env.observation_space.shape, self.env.action_space.shape
        self.model = sac.Sac(seen, moves, seed=seed, **settings)
        self.act = self.model.act

    @property
    def steps(self):
        return self.model.steps

    def learn(self, steps):
        self.model.learn(self.env, steps)

    def policy(self):
        return self.model.actor.weights.copy()

    def take(self, policy):
        self.model.actor.weights[:] = policy

    def save(self, folder):
        self.model.save(folder / "policy.npz")


def trials_of(trial, act, task):
    """Three times as many where the first all succeed, so that it is no luck."""
    measured = measure(trial, act, task.trials)
    return measure(trial, act, 3 * task.trials) if measured["success"] == 1 else measured


def learn(name, task, steps, seed, report):
    """Learns until 95 % of three times the trials succeed, or for `steps`; `report` gets each measure, and that of the policy that is
    kept. Returns the learner with that policy."""
    learner = (Ppo if task.algorithm == "PPO" else Soft)(name, task.settings, seed)
    trial, best, sure, learning_s = gymnasium.make(name), None, False, 0.0
    while not sure and learner.steps < steps:
        began = time.process_time()
        learner.learn(min(task.between, steps))
        learning_s += time.process_time() - began
        measured = {"learned_steps": learner.steps, "computing_s": round(learning_s, 1)} | trials_of(trial, learner.act, task)
        report("learned", measured)
        sure = measured["trials"] > task.trials and measured["success"] >= SURE
        rank = (measured["within"][0], measured["return"])
        if best is None or rank >= best[0]:
            best = rank, learner.steps, learner.policy()
    learner.take(best[2])
    report("kept", {"learned_steps": best[1]} | measure(trial, learner.act, FINAL_TRIALS, FIRST_FINAL))
    return learner


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

    def report(part, point):
        curve[part] = [*curve["learned"], point] if part == "learned" else point
        asked.out.mkdir(parents=True, exist_ok=True)
        (asked.out / "curve.json").write_text(json.dumps(curve, indent=1) + "\n")
        print(f"{point['learned_steps']:>16,} steps, {part}: {point}", flush=True)

    if task.algorithm == "PPO" and importlib.util.find_spec("stable_baselines3") is None:
        print('learning it needs Stable-Baselines3: pip install "marketgen[rl]"')
        return
    learn(name, task, int(asked.steps or task.steps), asked.seed, report).save(asked.out)
    print(f"curve: {asked.out / 'curve.json'}")


if __name__ == "__main__":
    main()
