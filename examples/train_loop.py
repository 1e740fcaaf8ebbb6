"""The rollouts of a training loop: many baskets at once, a scripted policy, its scores.

    python examples/train_loop.py [STORE [STEPS]]

The policy sways the arm and stops after a while, so that episodes end and others begin; a learner would take its place.
"""

import sys
import time

import numpy as np

import marketgen
from demo_shop import open_or_make

ENVS, PATIENCE = 4, 40  # steps until the policy says that it has done

steps = int(sys.argv[2]) if len(sys.argv) > 2 else 60
envs = marketgen.make_vec(
    "CheckoutUnloading-v1",
    num_envs=ENVS,
    store=open_or_make(*sys.argv[1:2]),
    reward_mode="dense",
    control_mode="pd_ee_delta_pos",
    autoreset_mode="SameStep",
)


def scripted(step, since_reset):
    """Down to the basket and up again, the gripper open; one after the other says that it has done."""
    actions = np.zeros((ENVS, *envs.single_action_space.shape), np.float32)
    actions[:, 2] = -0.3 if step % 20 < 10 else 0.3
    actions[:, -2] = 1
    actions[:, -1] = np.where(since_reset >= PATIENCE + 5 * np.arange(ENVS), 1, -1)
    return actions


observations, infos = envs.reset(seed=1)
print(infos["instruction"][0])
since_reset = np.zeros(ENVS, int)
returns, finished = np.zeros(ENVS), []
started = time.perf_counter()
for step in range(steps):
    observations, rewards, terminated, truncated, infos = envs.step(scripted(step, since_reset))
    returns += rewards
    since_reset += 1
    for i in np.flatnonzero(terminated | truncated):
        finished.append((returns[i] / since_reset[i], infos["final_info"]["goal_fraction"][i]))
        returns[i], since_reset[i] = 0, 0
seconds = time.perf_counter() - started
print(f"{steps * ENVS} steps of {ENVS} environments in {seconds:.1f} s, {steps * ENVS / seconds:.0f} a second, resets included")
if finished:
    mean_reward, goals = np.mean(finished, axis=0)
    print(f"{len(finished)} episodes: mean reward {mean_reward:.3f}, {goals:.0%} of the goals")
