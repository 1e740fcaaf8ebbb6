"""Steps a second that PPO of Stable-Baselines3 learns from state, all its computing counted: one JSON line a figure.

    PYTHONPATH=build/release/python PYTHON bench/python_ppo.py [STEPS]

PYTHON has stable-baselines3 (pip install "marketgen[rl]"). One core: eight environments one after another, networks on one thread;
processor time of the process, so that other work on the machine does not count.
"""

import json
import os
import sys
import time

import torch
from stable_baselines3 import PPO
from stable_baselines3.common.env_util import make_vec_env

import marketgen  # noqa: F401  registers the environments

NAME, ENVS, ROLLOUT = "MarketGen/CheckoutOneItem-v1", 8, 256
steps = int(sys.argv[1]) if len(sys.argv) > 1 else 5 * ENVS * ROLLOUT

torch.set_num_threads(1)
model = PPO("MlpPolicy", make_vec_env(NAME, n_envs=ENVS, seed=1), n_steps=ROLLOUT, batch_size=512, n_epochs=8, seed=1, device="cpu")
model.learn(ENVS * ROLLOUT)  # warms up
began = time.process_time()
model.learn(steps)
rate = steps / (time.process_time() - began)
line = {"name": "python_ppo_steps", "value": rate, "unit": "steps/s", "n": steps, "machine": f"{os.cpu_count()} cores"}
print(json.dumps(line), flush=True)
