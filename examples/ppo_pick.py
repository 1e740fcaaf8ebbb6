"""PPO of Stable-Baselines3 learns to bring one product to the unloading area; how it does it beside chance and the oracle.

    pip install "marketgen[rl]"
    python examples/ppo_pick.py [STEPS [OUT]]

Without Stable-Baselines3 it measures chance and the oracle alone. Leaves in OUT (out/examples/ppo_pick) curve.json, policy.zip
and normalize.pkl (the means and spreads that the policy's observations need); docs/learning.md shows such a curve.
"""

import importlib.util
import json
import pathlib
import sys
import time

import gymnasium
import numpy as np

import marketgen

NAME = "MarketGen/CheckoutOneItem-v1"
STEPS = int(float(sys.argv[1])) if len(sys.argv) > 1 else 400_000
OUT = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else "out/examples/ppo_pick")
ENVS, BETWEEN, TRIALS, FIRST_TRIAL = 8, 25_000, 20, 1_000_000  # seeds of trials are none that PPO learns from


def measure(env, policy, trials=TRIALS, limit_s=None):
    """Of so many episodes: the share that succeed, their mean return and steps. `limit_s`: another than the task's."""
    done = []
    for trial in range(trials):
        seen, _ = env.reset(seed=FIRST_TRIAL + trial)
        if limit_s is not None:
            seen, _ = env.reset(options={"episode": env.unwrapped.episode | {"limit_s": limit_s}})
        total, steps, over = 0.0, 0, False
        while not over:
            seen, reward, terminated, truncated, info = env.step(policy(seen))
            total, steps, over = total + reward, steps + 1, terminated or truncated
        done.append((info["is_success"], total, steps))
    success, total, steps = np.mean(done, axis=0)
    return {"success": round(float(success), 3), "return": round(float(total), 2), "steps": round(float(steps), 1)}


def rivals():
    """Chance, and the oracle, which moves by joints and so carefully that it gets a minute."""
    env = gymnasium.make(NAME)
    env.action_space.seed(1)
    found = {"chance": measure(env, lambda seen: env.action_space.sample())}
    shown = gymnasium.make(NAME, control_mode="pd_joint_pos")
    return found | {"oracle": measure(shown, marketgen.policies.oracle(shown), trials=5, limit_s=60)}


def learn(report):
    """Trains, and measures the deterministic policy every so often; `report` gets each measure."""
    import torch
    from stable_baselines3 import PPO
    from stable_baselines3.common.env_util import make_vec_env
    from stable_baselines3.common.vec_env import VecNormalize

    torch.set_num_threads(1)
    envs = VecNormalize(make_vec_env(NAME, n_envs=ENVS, seed=1), norm_reward=True, gamma=0.98)
    model = PPO(
        "MlpPolicy", envs, n_steps=256, batch_size=256, n_epochs=10, gamma=0.98, learning_rate=5e-4, seed=1, device="cpu",
        policy_kwargs={"net_arch": [128, 128], "log_std_init": -0.5},
    )
    trial = gymnasium.make(NAME)
    learning_s = 0.0
    for part in range(max(1, STEPS // BETWEEN)):
        began = time.process_time()
        model.learn(BETWEEN, reset_num_timesteps=part == 0)
        learning_s += time.process_time() - began
        measured = measure(trial, lambda seen: model.predict(envs.normalize_obs(seen), deterministic=True)[0])
        report({"learned_steps": model.num_timesteps, "computing_s": round(learning_s, 1)} | measured)
    OUT.mkdir(parents=True, exist_ok=True)
    model.save(OUT / "policy.zip")
    envs.save(str(OUT / "normalize.pkl"))  # what its observations are divided by


def main():
    curve = {"task": NAME, "trials": TRIALS, "marketgen": marketgen.__version__, **rivals(), "ppo": []}
    for name in ("chance", "oracle"):
        print(f"{name:>24}: {curve[name]}", flush=True)

    def report(point):
        curve["ppo"].append(point)
        OUT.mkdir(parents=True, exist_ok=True)
        (OUT / "curve.json").write_text(json.dumps(curve, indent=1) + "\n")
        rate = point["learned_steps"] / point["computing_s"]
        print(f"{point['learned_steps']:>16,} steps: {point} ({rate:,.0f} steps a second of computing)", flush=True)

    if importlib.util.find_spec("stable_baselines3") is None:
        print('PPO needs Stable-Baselines3: pip install "marketgen[rl]"')
        return
    learn(report)
    print(f"curve: {OUT / 'curve.json'}")


if __name__ == "__main__":
    main()
