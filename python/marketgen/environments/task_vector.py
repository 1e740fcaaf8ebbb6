"""Many environments of either task, stepped in one call on all cores."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Literal

import gymnasium
import numpy as np
from gymnasium.vector import AutoresetMode
from gymnasium.vector.utils import batch_space

from .. import _core
from .task_env import FILM_CAMERA, RENDER_SIZE, TaskEnv, numbers_of_action
from .task_setup import StoreLike, TaskOptions, TaskSetup

if TYPE_CHECKING:
    from typing import Unpack  # since Python 3.11


class TaskVectorEnv(gymnasium.vector.VectorEnv):
    """Base of CheckoutUnloadingVector and InAisleCollectionVector.

    store, options   as those of the single environment
    autoreset_mode   NEXT_STEP, SAME_STEP or DISABLED, as https://farama.org/Vector-Autoreset-Mode has them; with DISABLED,
                     reset(options={"reset_mask": mask}) begins those anew that have ended
    copy             False: observations of numbers are the same memory at each step

    Each does just what it would do alone, bit for bit, pictures included.
    """

    single: ClassVar[type[TaskEnv]]

    def __init__(
        self,
        num_envs: int = 1,
        store: StoreLike | None = None,
        *,
        autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP,
        copy: bool = True,
        render_mode: Literal["rgb_array"] | None = None,
        setup: TaskSetup | None = None,
        render_size: tuple[int, int] = RENDER_SIZE,
        render_camera: str = FILM_CAMERA,
        **options: Unpack[TaskOptions],
    ):
        self.setup = self.single.new_setup(store, options) if setup is None else setup
        self.autoreset_mode = AutoresetMode(autoreset_mode)
        self.metadata = {**self.single.metadata, "autoreset_mode": self.autoreset_mode}
        rendering = {"render_mode": render_mode, "render_size": render_size, "render_camera": render_camera}
        self.envs = [self.single(setup=self.setup, **rendering) for _ in range(num_envs)]
        self.num_envs, self.copy, self.render_mode = num_envs, copy, render_mode
        self.single_action_space, self.single_observation_space = (
            self.setup.action_space,
            self.setup.observation_space,
        )
        self.action_space = batch_space(self.single_action_space, num_envs)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self._rows = np.zeros((num_envs, self.setup.row_length), np.float32)
        self._pictures: list[dict[str, Any]] = [{} for _ in range(num_envs)]
        self._ended = np.zeros(num_envs, bool)

    @property
    def np_random_seed(self) -> tuple[int, ...]:
        return tuple(env.np_random_seed for env in self.envs)

    @property
    def np_random(self) -> tuple[np.random.Generator, ...]:
        return tuple(env.np_random for env in self.envs)

    def reset(
        self,
        *,
        seed: int | Sequence[int | None] | None = None,
        options: dict[str, Any] | None = None,
    ):
        """`seed`: of the first, seed + 1 of the second and so on, or one each."""
        count = self.num_envs
        seeds = [seed] * count if seed is None else [seed + i for i in range(count)] if isinstance(seed, int) else seed
        if len(seeds) != count:
            raise ValueError(f"{len(seeds)} seeds for {count} environments")
        options = dict(options or {})
        mask = options.pop("reset_mask", None)
        chosen = np.arange(count) if mask is None else np.flatnonzero(self._checked_mask(mask))
        infos: dict[str, Any] = {}
        for i, info in self._reset(chosen, [seeds[i] for i in chosen], options).items():
            infos = self._add_info(infos, info, i)
        return self._seen(), infos

    def _checked_mask(self, mask: Any) -> np.ndarray:
        fits = isinstance(mask, np.ndarray) and mask.dtype == np.bool_ and mask.shape == (self.num_envs,)
        if not fits or not mask.any():
            raise ValueError(f"reset_mask: expected an array of {self.num_envs} bools, at least one of them True")
        return mask

    def _reset(self, chosen: np.ndarray, seeds: Sequence[int | None], options: dict[str, Any] | None) -> dict[int, Any]:
        """Begins these anew, side by side; their infos."""
        wanted = [self.envs[i].next_episode(seed, options) for i, seed in zip(chosen, seeds, strict=True)]
        progress = (options or {}).get("progress")
        drawn = iter(self.setup.draw([seed for text, seed in wanted if text is None], progress))
        texts = [next(drawn) if text is None else text for text, _ in wanted]
        rows = np.empty((len(chosen), self.setup.row_length), np.float32)
        _core.reset_environments([self.envs[i].environment for i in chosen], texts, rows)
        self._rows[chosen] = rows
        self._ended[chosen] = False
        self._look(chosen)
        return {i: self.envs[i].info_of_reset(text) for i, text in zip(chosen, texts, strict=True)}

    def step(self, actions):
        numbers = numbers_of_action(actions, self.action_space.shape)
        if self.autoreset_mode == AutoresetMode.DISABLED and self._ended.any():
            ended = np.flatnonzero(self._ended).tolist()
            raise _core.Error("episode.bad_action", "step", f"the episodes of {ended} are over: reset them first")
        rewards = np.zeros(self.num_envs)
        terminated, truncated = np.zeros(self.num_envs, bool), np.zeros(self.num_envs, bool)
        anew = np.flatnonzero(self._ended)  # only with NEXT_STEP
        running = np.flatnonzero(~self._ended)
        self._step(running, numbers, rewards, terminated, truncated)
        infos_of = {
            i: self.envs[i].info_of_step(terminated=bool(terminated[i]), truncated=bool(truncated[i])) for i in running
        }
        if len(anew):
            infos_of |= self._reset(anew, [None] * len(anew), None)
        infos: dict[str, Any] = {}
        self._ended[running] = (terminated | truncated)[running]
        if self.autoreset_mode == AutoresetMode.SAME_STEP and self._ended.any():
            infos, fresh = self._reset_at_once(infos_of)
            infos_of |= fresh
        for i in range(self.num_envs):
            infos = self._add_info(infos, infos_of[i], i)
        return self._seen(), rewards, terminated, truncated, infos

    def _step(self, running, numbers, rewards, terminated, truncated) -> None:
        part_rows = np.empty((len(running), self.setup.row_length), np.float32)
        part = np.zeros(len(running)), np.zeros(len(running), bool), np.zeros(len(running), bool)
        environments = [self.envs[i].environment for i in running]
        _core.step_environments(environments, np.ascontiguousarray(numbers[running]), part_rows, *part)
        self._rows[running] = part_rows
        rewards[running], terminated[running], truncated[running] = part
        self._look(running)

    def _reset_at_once(self, infos_of: dict[int, Any]) -> tuple[dict[str, Any], dict[int, Any]]:
        """Begins those anew that have just ended; how they ended stands in final_obs and final_info."""
        infos: dict[str, Any] = {}
        ended = np.flatnonzero(self._ended)
        for i in ended:
            numbers = self.setup.observations.numbers_of(self._rows[i].copy())
            last = numbers if self.setup.observations.flat else {**numbers, **self._pictures[i]}
            infos = self._add_info(infos, {"final_obs": last, "final_info": infos_of[i]}, i)
        return infos, self._reset(ended, [None] * len(ended), None)

    def _look(self, chosen: np.ndarray) -> None:
        for i in chosen:
            self._pictures[i] = self.setup.observations.pictures_of(self.envs[i].environment, self._rows[i])

    def _seen(self) -> Any:
        seen: Any = self.setup.observations.numbers_of(self._rows.copy() if self.copy else self._rows)
        if not self.setup.observations.flat:
            seen |= _stacked(self._pictures)
        return seen

    def get_state(self) -> list[bytes]:
        """Of each, see TaskEnv.get_state()."""
        return [env.get_state() for env in self.envs]

    def set_state(self, states: Sequence[bytes]) -> Any:
        """All of them; returns their observations. Raises the errors of TaskEnv.set_state(); those before are set then."""
        if len(states) != self.num_envs:
            raise _core.Error("physics.bad_command", "state", f"{len(states)} states for {self.num_envs} environments")
        for i, (env, state) in enumerate(zip(self.envs, states, strict=True)):
            env.set_state(state)
            self._rows[i] = env._row
            self._ended[i] = bool(env.environment.result())
        self._look(np.arange(self.num_envs))
        return self._seen()

    def __reduce__(self):
        """copy and pickle: environments made anew of the same options, set to the same states."""
        begun = all(env.episode for env in self.envs)
        options = {"autoreset_mode": self.autoreset_mode, "copy": self.copy, **self.envs[0]._rendering_options()}
        states = self.get_state() if begun else []
        return _vector_again, (type(self), self.num_envs, self.setup, options, states, self.spec)

    def render(self):
        return tuple(env.render() for env in self.envs)

    def call(self, name: str, *args: Any, **kwargs: Any) -> tuple[Any, ...]:
        found = [getattr(env, name) for env in self.envs]
        return tuple(each(*args, **kwargs) if callable(each) else each for each in found)

    def get_attr(self, name: str) -> tuple[Any, ...]:
        return self.call(name)


def _stacked(parts: Sequence[Any]) -> Any:
    """Dicts of arrays as one dict of stacked arrays."""
    if isinstance(parts[0], dict):
        return {key: _stacked([part[key] for part in parts]) for key in parts[0]}
    return np.stack(parts)


def _vector_again(
    kind: type[TaskVectorEnv],
    count: int,
    setup: TaskSetup,
    options: dict[str, Any],
    states: list[bytes],
    spec: Any,
) -> TaskVectorEnv:
    many = kind(count, setup=setup, **options)
    many.spec = spec
    if states:
        many.set_state(states)
    return many
