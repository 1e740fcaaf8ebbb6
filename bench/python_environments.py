"""Environment steps a second from Python, state only: one JSON line a figure, as `marketgen bench` has them.

    PYTHONPATH=build/release/python .venv/bin/python bench/python_environments.py STORE

The last line counts processor seconds, not the clock's: what a learner has on a busy machine, too.

On the store of bench/sample_store.cpp (24 x 15 m, seed 7) the basket and the actions are those of `marketgen bench environment`,
whose bare mj_step is then the rival.
"""

import json
import os
import statistics
import sys
import time

import gymnasium
import numpy as np

import marketgen

ROUNDS, STEPS, SEED, SWAY = 9, 20, 1, 0.1
NAME = "MarketGen/CheckoutUnloading-v1"


def action_of(space, step, number):
    action = np.zeros(space.shape, np.float32)
    action[..., :7] = SWAY if (step + number) % 8 < 4 else -SWAY
    action[..., -1] = -1
    return action


def rate(env, count):
    """Median control steps a second over the rounds."""
    rates = []
    for number in range(ROUNDS):
        started = time.perf_counter()
        for step in range(STEPS):
            env.step(action_of(env.action_space, step, number))
        rates.append(STEPS * count / (time.perf_counter() - started))
    return statistics.median(rates)


def say(name, value, unit="steps/s"):
    line = {"name": name, "value": value, "unit": unit, "n": ROUNDS, "machine": f"{os.cpu_count()} cores"}
    print(json.dumps(line), flush=True)


store = marketgen.open_store(sys.argv[1])
alone = gymnasium.make(NAME, store=store, disable_env_checker=True)
[text] = alone.unwrapped.setup.draw([SEED])
alone.reset(options={"episode": text})
say("python_checkout_steps", rate(alone, 1))
many = gymnasium.make_vec(NAME, num_envs=2 * os.cpu_count(), store=store)
many.reset(options={"episode": text})
say(f"python_checkout_steps_of_{many.num_envs}", rate(many, many.num_envs))

# What a learner steps: one row of numbers in, another out; random actions, and a reset at each end.
learner = gymnasium.make("MarketGen/CheckoutOneItem-v1", disable_env_checker=True)
learner.action_space.seed(SEED)
learner.reset(seed=SEED)
rates = []
for _ in range(ROUNDS):
    started = time.process_time()
    for _ in range(10 * STEPS):
        _, _, terminated, truncated, _ = learner.step(learner.action_space.sample())
        if terminated or truncated:
            learner.reset()
    rates.append(10 * STEPS / (time.process_time() - started))
say("python_one_item_steps_a_second_of_computing", statistics.median(rates))
