"""Shows an episode of a store's file, and steps it as often as each line of the standard input says."""

import json
import sys

import gymnasium
import numpy as np

import marketgen  # noqa: F401  registers the environments

store, episodes = sys.argv[1:]
env = gymnasium.make("MarketGen/InAisleCollection-v1", episodes=episodes, control_mode="pd_joint_delta_pos").unwrapped
env.reset(seed=0)
with env.show(store=store) as view:
    print(view.address, flush=True)
    action = np.zeros(env.action_space.shape, np.float32)
    action[-1] = -1
    action[env.action_names.index("drive")] = 1
    for line in sys.stdin:
        for _ in range(int(line)):
            env.step(action)
        print(json.dumps(env.environment.time_s()), flush=True)
