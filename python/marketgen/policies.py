"""The program's oracle, acting in environments: demonstrations, and what can be reached at best.

    env = gymnasium.make("MarketGen/CheckoutUnloading-v1", store="shop", control_mode="pd_joint_pos")
    policy = marketgen.policies.oracle(env)
    observation, info = env.reset(seed=3)
    over = False
    while not over:
        observation, reward, terminated, truncated, info = env.step(policy(observation))
        over = terminated or truncated
"""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _core
from .errors import Error

CONTROL_MODES = ("pd_joint_pos", "pd_joint_delta_pos")
SUBTASKS = tuple(_core.subtasks())  # docs/demonstrations.md


class ProgramPolicy:
    """A policy of the program: called with an observation, which it does not need, it returns the next action.

    Begins anew after each reset of its environment. Of a vector environment it returns all actions, thought out side by side;
    a row of zeros where the episode has ended. What it does is a function of its environment's state and its own, bit for bit.
    """

    def __init__(self, env: Any, name: str):
        inner = getattr(env, "unwrapped", env)
        if not hasattr(inner, "setup"):
            raise Error("usage.bad_flag", "env", f"{env!r} is no environment of MarketGen")
        if inner.setup.control_mode not in CONTROL_MODES:
            raise Error(
                "usage.bad_flag",
                "env",
                f"it is of control_mode={inner.setup.control_mode!r}, in which joints cannot be said: make it with "
                f"control_mode={CONTROL_MODES[0]!r} or {CONTROL_MODES[1]!r}",
            )
        self.env, self.name, self._many = inner, name, hasattr(inner, "envs")
        members = inner.envs if self._many else [inner]
        self._environments = [member.environment for member in members]
        self._policies = [_core.program_policy(environment, name) for environment in self._environments]
        self._shape = len(members), inner.setup.action_space.shape[0]

    def __call__(self, observation: Any = None) -> np.ndarray:
        """The next action. Raises Error episode.bad_action when no episode runs."""
        if not any(environment.running() for environment in self._environments):
            raise Error("episode.bad_action", "env", "the episode is over, or has not begun: reset the environment first")
        actions = np.zeros(self._shape)
        _core.act(self._policies, self._environments, actions)
        made = np.clip(actions, *self._bounds()).astype(np.float32)
        return made if self._many else made[0]

    def _bounds(self) -> tuple[np.ndarray, np.ndarray]:
        space = self.env.setup.action_space
        return space.low, space.high

    def failure(self) -> str | tuple[str, ...]:
        """What kept it from its goals, a failure code (docs/episodes.md); "None" while nothing does."""
        codes = tuple(policy.failure() for policy in self._policies)
        return codes if self._many else codes[0]

    def subtask(self) -> str | tuple[str, ...]:
        """What its last action was for: "reach", "grasp" or another of SUBTASKS."""
        names = tuple(policy.subtask() for policy in self._policies)
        return names if self._many else names[0]


def oracle(env: Any) -> ProgramPolicy:
    """The oracle of the environment's track: knows where everything is, and plans with it.

    In control_mode="pd_joint_pos" it moves just as in `marketgen eval --policy oracle`; in "pd_joint_delta_pos" where a joint
    is to move farther in a step than an action can say, it follows a little later. Actions have no force for the grippers,
    so all are closed with that of the environment (20 N), where the oracle by itself presses as the product needs. The modes
    of the tool (pd_ee_*) cannot say how an arm is bent, and are refused.
    """
    return ProgramPolicy(env, "oracle")
