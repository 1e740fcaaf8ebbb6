"""PPO or SAC of Stable-Baselines3 learns a task from its state; how it does it beside chance, and where there is one, the oracle.

    pip install "marketgen[rl]"
    python examples/ppo_pick.py [STEPS [OUT]] [--task CheckoutOneItem|DriveToProduct|PickFromShelf|PlaceInBasket|OpenCooler] [--seed 1]

Without --task it brings one product to the unloading area. Without Stable-Baselines3 it measures chance and the oracle alone. Leaves
in OUT (out/examples/ppo_pick) curve.json, policy.zip and, of PPO, normalize.pkl (the means and spreads that the policy's observations
need). The policy kept is that which did best between, on seeds that are not learned from; the 50 episodes at the end are of yet other
seeds. docs/learning.md shows such curves.
"""

import argparse
import copy
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
    "learning_starts": 300, "ent_coef": "auto_0.1", "batch_size": 256, "gamma": 0.95, "learning_rate": 5e-4, "tau": 0.01,
    "policy_kwargs": {"net_arch": [128, 128], "optimizer_kwargs": {"fused": True}},
}  # fmt: skip


@dataclass(frozen=True)
class Task:
    """How one is learned: by what, in how many steps, measured how often."""

    algorithm: str
    steps: int
    between: int
    settings: dict = field(default_factory=dict)
    trials: int = 20  # between; FINAL_TRIALS at the end
    envs: int = 1
    oracle: bool = False
    times: float = 1  # the reward, to learn from; measures are of the environment's own


TASKS = {
    "CheckoutOneItem": Task("PPO", 400_000, 25_000, PPO, envs=8, oracle=True),
    "DriveToProduct": Task("SAC", 12_000, 1_000, SAC | {"gamma": 0.98}, times=10),
    "PickFromShelf": Task("SAC", 10_000, 1_000, SAC, times=10),
    "PlaceInBasket": Task("SAC", 10_000, 1_000, SAC, times=10),
    "OpenCooler": Task("SAC", 10_000, 1_000, SAC, times=10),
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


def steady_policy():
    """SAC's policy with layers of its critics normalized: what they say of actions not tried yet stays small."""
    import torch
    from stable_baselines3.sac.policies import SACPolicy

    class Steady(SACPolicy):
        def make_critic(self, features_extractor=None):
            critic = super().make_critic(features_extractor)
            for number, plain in enumerate(critic.q_networks):
                layers = []
                for layer in plain:
                    wide = isinstance(layer, torch.nn.Linear) and layer.out_features > 1
                    layers += [layer, torch.nn.LayerNorm(layer.out_features)] if wide else [layer]
                critic.q_networks[number] = torch.nn.Sequential(*layers).to(critic.device)
                setattr(critic, f"qf{number}", critic.q_networks[number])
            return critic

    return Steady


def learner(name, task, seed):
    """The model."""
    import stable_baselines3
    import torch
    from stable_baselines3.common.env_util import make_vec_env
    from stable_baselines3.common.vec_env import VecNormalize

    torch.set_num_threads(1)
    envs = make_vec_env(name, n_envs=task.envs, seed=seed, wrapper_class=Times, wrapper_kwargs={"factor": task.times})
    if task.algorithm == "PPO":
        envs = VecNormalize(envs, norm_reward=True, gamma=task.settings["gamma"])
    policy = "MlpPolicy" if task.algorithm == "PPO" else steady_policy()
    return getattr(stable_baselines3, task.algorithm)(policy, envs, seed=seed, device="cpu", **task.settings)


class Kept:
    """The best policy so far, and what its observations are divided by."""

    def __init__(self, model):
        self.model, self.rank, self.steps = model, (-1.0, 0.0), 0

    def offer(self, measured):
        if (rank := (measured["success"], measured["return"])) > self.rank:
            self.rank, self.steps = rank, self.model.num_timesteps
            self.weights = copy.deepcopy(self.model.get_parameters())
            self.spread = copy.deepcopy(getattr(self.model.get_vec_normalize_env(), "obs_rms", None))

    def take(self):
        self.model.set_parameters(self.weights)
        if self.spread is not None:
            self.model.get_vec_normalize_env().obs_rms = self.spread


def learn(name, task, steps, seed, report):
    """Trains until every trial between succeeds, or for `steps`; `report` gets each measure of the deterministic policy, and that of
    the best one at the end. Returns the model as it did best."""
    model = learner(name, task, seed)
    trial, kept = gymnasium.make(name), Kept(model)
    shown = getattr(model.get_vec_normalize_env(), "normalize_obs", lambda seen: seen)

    def policy(seen):
        return model.predict(shown(seen), deterministic=True)[0]

    learning_s, measured = 0.0, {"success": 0.0}
    while measured["success"] < 1 and model.num_timesteps < steps:
        began = time.process_time()
        model.learn(min(task.between, steps), reset_num_timesteps=model.num_timesteps == 0)
        learning_s += time.process_time() - began
        measured = measure(trial, policy, task.trials)
        kept.offer(measured)
        report("learned", {"learned_steps": model.num_timesteps, "computing_s": round(learning_s, 1)} | measured)
    kept.take()
    report("kept", {"learned_steps": kept.steps} | measure(trial, policy, FINAL_TRIALS, FIRST_FINAL))
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

    def report(part, point):
        curve[part] = [*curve["learned"], point] if part == "learned" else point
        asked.out.mkdir(parents=True, exist_ok=True)
        (asked.out / "curve.json").write_text(json.dumps(curve, indent=1) + "\n")
        print(f"{point['learned_steps']:>16,} steps, {part}: {point}", flush=True)

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
