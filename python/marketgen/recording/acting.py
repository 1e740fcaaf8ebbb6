"""One episode, acted out and recorded."""

from __future__ import annotations

import collections
import contextlib
import dataclasses
import json
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any

import numpy as np

from .. import _core
from ..errors import Error
from ..policies import SUBTASKS, ProgramPolicy
from ..policy_process import PolicyFailed, PolicyHere, PolicySource, policy_of_text
from ..stages import Stages
from .drives import DrivePlayer, Drives
from .features import ACTION, DONE, FRAME, REWARD, STATE, SUBTASK, SUCCESS, TIME, Numbers
from .statistics import PictureCounts
from .video import Encoder

FPS = 20  # of control, in every environment of ours
MAX_WAITING = 8  # pictures of a camera that are not encoded yet: 1.6 MB of 256x256


class Stopwatch:
    """Seconds by what the calling thread spent them on: "pictures", "video" (waiting for encoders), "files"."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {}

    @contextlib.contextmanager
    def on(self, what: str) -> Iterator[None]:
        began = time.perf_counter()
        try:
            yield
        finally:
            self.seconds[what] = self.seconds.get(what, 0.0) + time.perf_counter() - began


@dataclasses.dataclass
class Take:
    """An episode as it went. `numbers`: the features of features.acted(), a row a frame."""

    numbers: dict[str, np.ndarray]
    videos: dict[str, bytes]  # by camera
    counts: dict[str, PictureCounts]
    task: str
    result: dict[str, Any]  # market-result/1
    state_hash: str  # of the physics at the end


class Player:
    """Whoever acts in an environment: a policy of the program by its name, or one in Python.

    Raises what the policy does, as Error episode.policy_failed.
    """

    def __init__(self, policy: Any, env: Any, stages: Stages):
        self._env, self._stages = env, stages
        self._of_program = ProgramPolicy(env, policy) if isinstance(policy, str) else None
        self._in_python = policy if isinstance(policy, PolicyHere) else None

    def begin(self, info: dict[str, Any], seen: Any) -> None:
        if self._in_python is not None:
            self._ask("begin", self._stages.task(self._env, info), seen)

    def act(self, seen: Any) -> np.ndarray:
        """In float32, as it is kept: what is executed is what a reader of the dataset has."""
        if self._of_program is not None:
            return self._of_program(seen)
        try:
            return np.asarray(self._ask("act", seen), np.float32)
        except (TypeError, ValueError):
            raise Error("episode.bad_action", "policy", "what it answered is no array of numbers") from None

    def subtask(self) -> int:
        """What the action is for that act() has just answered: its number in SUBTASKS; that of "none" where the policy does not say."""
        said = self._ask("subtask") if self._of_program is None else self._of_program.subtask()
        if said is None:
            return SUBTASKS.index("none")
        if said not in SUBTASKS:
            raise Error("episode.policy_failed", "policy", f"its subtask() answered {said!r}; there are {', '.join(SUBTASKS)}")
        return SUBTASKS.index(said)

    def end(self) -> None:
        """The episode is over."""

    def _ask(self, method: str, *arguments: Any) -> Any:
        assert self._in_python is not None
        try:
            return self._in_python.ask(method, *arguments)
        except PolicyFailed as fault:
            raise Error(fault.code, "policy", fault.message) from fault


def player_of(policy: Any) -> str | PolicyHere | Drives:
    """What Player takes, or logs of drives, of what record() was given: a name, FILE.py:NAME, python:MODULE:NAME, a function, a class, an object with act()."""
    if isinstance(policy, Drives) or (isinstance(policy, str) and ":" not in policy):
        return policy
    found = policy_of_text(policy) if isinstance(policy, str) else policy
    if not (isinstance(found, PolicySource) or callable(getattr(found, "act", None)) or callable(found)):
        raise Error("usage.bad_flag", "policy", f"{policy!r} is no name, has no act() and cannot be called")
    try:
        return PolicyHere(found)
    except Exception as fault:  # of the user's code, which is run here
        raise Error("episode.policy_failed", "policy", f"{type(fault).__name__}: {fault}") from fault


class _Reel:
    """One camera's pictures of the episode that runs: a thread of its own takes them, in their order, while the world goes on.

    add() and finish() raise what the thread did.
    """

    def __init__(self, new_encoder: Callable[[], Encoder]):
        self.counts = PictureCounts()
        self._encoder = new_encoder()
        self._thread = ThreadPoolExecutor(1, thread_name_prefix="video")
        self._waiting: collections.deque[Future[None]] = collections.deque()

    def add(self, rgb: np.ndarray) -> None:
        """(height, width, 3) uint8, which nobody changes afterwards. Waits while MAX_WAITING others have not been taken."""
        if len(self._waiting) == MAX_WAITING:
            self._waiting.popleft().result()
        self._waiting.append(self._thread.submit(self._take, rgb))

    def _take(self, rgb: np.ndarray) -> None:
        self._encoder.add(rgb)
        self.counts.add(rgb)

    def finish(self) -> bytes:
        """The video."""
        while self._waiting:
            self._waiting.popleft().result()
        self._thread.shutdown()
        return self._encoder.finish()

    def close(self) -> None:
        """Without a video."""
        self._thread.shutdown(cancel_futures=True)
        self._encoder.close()


def act_out(
    env: Any,
    episode: str,
    player: Player | DrivePlayer,
    kinds: dict[str, Numbers],
    new_encoder: Callable[[], Encoder],
    watch: Stopwatch,
) -> Take:
    """From reset to its end. Raises Error physics.failed, episode.*; then nothing is kept of it."""
    reels: dict[str, _Reel] = {}
    rows: dict[str, list[Any]] = {name: [] for name in kinds}
    with contextlib.ExitStack() as unfinished:
        for camera in env.cameras:
            reels[camera] = _Reel(new_encoder)
            unfinished.callback(reels[camera].close)
        info = _run(env, episode, player, rows, reels, watch)
        with watch.on("video"):
            videos = {camera: reel.finish() for camera, reel in reels.items()}
        unfinished.pop_all()
    frames = len(rows[ACTION])
    rows[SUCCESS][-1] = info["success"]
    rows[FRAME] = list(range(frames))
    rows[TIME] = [frame / FPS for frame in range(frames)]
    return Take(
        numbers={name: kind.rows(rows[name]) for name, kind in kinds.items()},
        videos=videos,
        counts={camera: reel.counts for camera, reel in reels.items()},
        task=info["instruction"],
        result=info["result"],
        state_hash=env.state_hash(),
    )


def _run(
    env: Any,
    episode: str,
    player: Player | DrivePlayer,
    rows: dict[str, list[Any]],
    reels: dict[str, _Reel],
    watch: Stopwatch,
) -> dict[str, Any]:
    """The `info` of the last step."""
    with _pictures_timed(env, watch):
        seen, info = env.reset(seed=0, options={"episode": episode})
        player.begin(info, seen)
        over = False
        while not over:
            action = player.act(seen)
            rows[ACTION].append(action)
            rows[SUBTASK].append(player.subtask())
            rows[STATE].append(env.robot_numbers())
            with watch.on("video"):
                for camera, reel in reels.items():
                    reel.add(seen["sensor_data"][camera]["rgb"])
            seen, reward, terminated, truncated, info = env.step(action)
            over = terminated or truncated
            rows[REWARD].append(reward)
            rows[DONE].append(over)
            rows[SUCCESS].append(False)
        player.end()
    return info


@contextlib.contextmanager
def _pictures_timed(env: Any, watch: Stopwatch) -> Iterator[None]:
    """What observing takes beyond the simulation is all pictures."""
    observe = env.observation

    def timed() -> Any:
        with watch.on("pictures"):
            return observe()

    env.observation = timed
    try:
        yield
    finally:
        del env.observation


def id_of(episode: str) -> tuple[str, int]:
    """Its id and seed."""
    told = json.loads(episode)
    return told["id"], told["seed"]
