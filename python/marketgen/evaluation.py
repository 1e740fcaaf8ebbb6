"""Scores of policies on episodes: the program's own policies and Python's, behind one interface."""

from __future__ import annotations

import contextlib
import copy
import dataclasses
import importlib.util
import json
import os
import pathlib
import shutil
import sys
import tempfile
import time
import warnings
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from . import _core, arguments, confinement
from .arguments import PathLike, Progress
from .errors import Error, IsolationWarning
from .outside import policy_named
from .outside.acting import ModelPlayer
from .outside.addresses import ServerPolicy
from .policy_process import PolicyFailed, PolicyHere, PolicyProcess, PolicySource
from .policy_sight import sight
from .stages import Stages

if TYPE_CHECKING:
    from typing import Unpack  # since Python 3.11

    from .environments.task_setup import TaskOptions

MAX_JOBS, MAX_LIMIT_S, MAX_REPETITIONS = 1000, 1e6, 1000
NOT_ISOLATED = "none"


class Policy(Protocol):
    """What evaluate() asks. Observations and actions are those of the environments (docs/python.md)."""

    def begin(self, task: dict[str, Any], observation: dict[str, Any]) -> None:
        """Once an episode. `task` is a market-task/1 (track, instruction, limit_s, goals, robot, ...) with action_names and
        catalogue, all products' rows; in the aisles also map, categories. May be left out."""

    def act(self, observation: dict[str, Any]) -> np.ndarray:
        """The action until the next control step, 50 ms later."""
        ...

    def failure(self) -> str:
        """Once, at the end: what kept it from its goals, a failure code (docs/episodes.md). May be left out."""
        ...


@dataclasses.dataclass(frozen=True)
class Evaluation:
    """results: a market-result/1 for each episode, in their order; summary: shares with 95 % intervals.

    The same as results.jsonl and summary.json in `folder`.
    """

    results: list[dict[str, Any]]
    summary: dict[str, Any]
    folder: str


def evaluate(
    episodes: PathLike,
    policy: str | Policy | type[Policy] | Any = "oracle",
    folder: PathLike = "results",
    *,
    jobs: int = 0,
    resume: bool = False,
    act_limit_s: float = 120.0,
    hang_limit_s: float = 1200.0,
    start_limit_s: float = 120.0,
    shard: str = "",
    repetition: int = 1,
    realism: PathLike = "ideal",
    record_motion: bool = False,
    record_decisions: bool = False,
    policy_files: Sequence[PathLike] = (),
    adapter: str | None = None,
    name: str = "",
    progress: Progress | None = None,
    **options: Unpack[TaskOptions],
) -> Evaluation:
    """Runs the episodes of a file with a policy; `marketgen eval` from Python.

    policy       "oracle", "classical" (or "classical+target": docs/episodes.md, what each module costs), "vlm(openai:gpt-4o)" (docs/vlm.md), "hybrid(masks=http://…)" (docs/hybrid.md), or one that knows
                 nothing ("highest", "random", "stop"); or an object
                 with act(), a class of such, or a function that acts; or "FILE.py:NAME", "python:MODULE:NAME", one of these that
                 only the policy's own process loads; or a model of others (docs/remote.md): "openpi://HOST:PORT",
                 "groot://HOST:PORT", "lerobot:FOLDER"
    folder       gets results.jsonl, a line as each episode finishes, and summary.json
    jobs         episodes at a time; 0: as many as there are cores
    resume       go on with a run that was broken off
    act_limit_s  processor time for one answer; one that takes more ends its episode with PolicyError, on a busy machine as
                 on a quiet one. The policy then acts in a process of its own, and what is counted is that process, all its
                 threads, and children that it has waited for. One written in Python travels there as code, also out of a
                 notebook's cell or a script, and must not hold what cannot travel (open files, locks). 0: no limit, all in
                 this process
    hang_limit_s  wall time after which a policy in its own process that has not answered is taken to hang (PolicyError,
                 too): one that waits uses no processor time. 0: never
    start_limit_s  processor time until that process is ready, beside hang_limit_s of wall time; a policy that takes more over
                 its imports ends the run. For a server: wall time until it answers
    shard        "2/4": the second of four parts of the file; merge() joins their results
    repetition   which run of the episodes this is: from 2 on what the policy and a realism draw is drawn anew; leaderboard() sums
                 repetitions up
    realism      what stands between the world and the robot (docs/episodes.md): "ideal" (nothing), "standard", "hard", "crowded", "randomized", or a
                 file of your own that ends with .json. Rankings are meant to use "standard"
    record_motion  also keep what moved, in motion/ID.bin.gz of the folder (read_motion()); of the program's own policies
    record_decisions  also keep what "classical", "vlm" or "hybrid" decided and which of its modules was first wrong, in decisions/ID.json.gz
                 and ID.html of the folder (docs/episodes.md)
    policy_files  files and folders that a policy written in Python reads and writes, as weights and logs. Its process opens
                 these, Python's own files and the folders of its code (sys.path), but no episodes and no stores, and looks
                 into no other process. Where that cannot be had (no Landlock in the kernel, act_limit_s=0) it is an
                 IsolationWarning, and `isolation` of the results is "none"
    adapter      of a model of others: which row says what it sees and says, "ROW" of the program's own, "FILE.yaml:ROW" of yours
    name         under which the results have a policy that is not the program's own; else what it is called
    progress     called as progress(done, total, text) in this thread as episodes finish; what it raises ends the run, and
                 what was finished is kept
    options      of a policy written in Python, as of the environments: obs_mode, control_mode, cameras, width, height, quality

    A policy that raises, hangs, crashes its process or gives what is no action has failed in that episode (PolicyError, with
    the reason in `detail`), and the next one follows. An episode that cannot be run is a result with `error`; it counts in no
    share. Ctrl-C keeps what was finished. Raises Error store.exists, io.in_use, episode.*, usage.bad_flag.
    """
    path = arguments.episodes_path("episodes", episodes)
    into = os.path.abspath(arguments.a_path("folder", folder))
    run = _Run(
        into=into,
        resume=arguments.a_truth("resume", resume),
        jobs=arguments.a_whole("jobs", jobs, 0, MAX_JOBS),
        limits_s=(
            arguments.a_number("act_limit_s", act_limit_s, 0, MAX_LIMIT_S),
            arguments.a_number("hang_limit_s", hang_limit_s, 0, MAX_LIMIT_S),
            arguments.a_number("start_limit_s", start_limit_s, 0, MAX_LIMIT_S),
        ),
        shard=arguments.a_text("shard", shard),
        repetition=arguments.a_whole("repetition", repetition, 1, MAX_REPETITIONS),
        realism=arguments.a_path("realism", realism),
        record_motion=arguments.a_truth("record_motion", record_motion),
        record_decisions=arguments.a_truth("record_decisions", record_decisions),
        policy_files=tuple(arguments.existing("policy_files", file) for file in arguments.paths("policy_files", policy_files)),
        name=arguments.a_text("name", name),
        truth=(path, into, _core.cache_folder(), *_episode_folders()),
        progress=arguments.a_progress(progress),
    )
    with _read_once(path) as readable:
        if isinstance(policy, str):
            policy = policy_named(policy, adapter)
        elif adapter is not None:
            raise Error("usage.bad_flag", "adapter", "rows of adapters are for models of others, which a text names")
        if isinstance(policy, str):
            _evaluate_named(readable, policy, run, options)
        else:
            _evaluate_python(readable, policy, run, options)
    return evaluation_in(into)


def evaluation_in(folder: str) -> Evaluation:
    lines = (pathlib.Path(folder) / "results.jsonl").read_text(encoding="utf-8").splitlines()
    summary = json.loads((pathlib.Path(folder) / "summary.json").read_text(encoding="utf-8"))
    return Evaluation([json.loads(line) for line in lines], summary, folder)


def _episode_folders() -> list[str]:
    """Of the sets that come with the program: data/benchmark has others too, of rows."""
    return [os.path.dirname(file) for file in _core.episode_sets().values()]


@contextlib.contextmanager
def _read_once(path: str) -> Iterator[str]:
    """The file itself; what can be read but once, as a pipe, as a file."""
    if os.path.isfile(path) or not os.path.exists(path):
        yield path
        return
    with tempfile.TemporaryDirectory(prefix="marketgen-") as folder:
        copy_of_it = os.path.join(folder, os.path.basename(path))
        with open(path, "rb") as told, open(copy_of_it, "wb") as kept:
            shutil.copyfileobj(told, kept)
        yield copy_of_it


@dataclasses.dataclass(frozen=True)
class _Run:
    """How the episodes are run and where their results go, whoever acts; checked."""

    into: str
    resume: bool
    jobs: int
    limits_s: tuple[float, float, float]  # of computing for one answer, until it is taken to hang, until it is ready
    shard: str  # "" or "2/4"
    repetition: int
    realism: str  # a row's name or a file
    record_motion: bool
    record_decisions: bool
    policy_files: tuple[str, ...]
    name: str  # in results; "": what the policy is called
    truth: tuple[str, ...]  # files and folders that no policy may open, wherever they lie
    progress: Progress | None

    @property
    def acts_apart(self) -> bool:
        """In a process of its own: what has a limit can be ended."""
        return self.limits_s[0] > 0


def _evaluate_named(path: str, policy: str, run: _Run, options: dict[str, Any]) -> None:
    if run.policy_files:
        raise Error("usage.bad_flag", "policy_files", f"the program's own policy {policy!r} reads no files")
    if run.name:
        raise Error("usage.bad_flag", "name", f"the program's own policy is called {policy!r}")
    if options:
        raise Error("usage.bad_flag", ", ".join(options), f"the program's own policy {policy!r} takes no such options")
    worker = _worker_command(policy, run.jobs) if run.acts_apart else []
    _core.evaluate(
        path, policy, run.realism, run.into, run.resume, run.jobs, run.shard, run.repetition, run.record_motion,
        run.record_decisions, worker, run.limits_s, run.progress
    )


def _worker_command(policy: str, jobs: int) -> list[str]:
    """This Python once more, with this package."""
    threads = max(1, _core.thread_count() // (jobs or _core.thread_count()))
    package = str(pathlib.Path(__file__).parents[1])
    program = (
        "import sys; sys.path.insert(0, sys.argv[1]); from marketgen import _core; "
        "_core.serve_episodes(sys.argv[2], int(sys.argv[3]))"
    )
    return [sys.executable, "-c", program, package, policy, str(threads)]


def _evaluate_python(path: str, policy: Any, run: _Run, options: dict[str, Any]) -> None:
    acts = isinstance(policy, (PolicySource, ServerPolicy)) or callable(getattr(policy, "act", None)) or callable(policy)
    if not acts:
        raise Error("usage.bad_flag", "policy", f"{policy!r} is no name, has no act() and cannot be called")
    if importlib.util.find_spec("gymnasium") is None:
        raise Error("usage.unavailable", "policy", "policies in Python need Gymnasium: pip install gymnasium")
    _complete(options, policy, run)
    name = run.name or getattr(policy, "name", None) or getattr(policy, "__name__", None) or type(policy).__name__
    isolation = _isolation(policy, run)
    new_player = _server_player(policy, run) if isinstance(policy, ServerPolicy) else _python_player(policy, run, isolation)
    stages = Stages(path, {**options, "realism": run.realism})

    def make_runner():
        return _Runner(str(name), isolation, new_player(), stages)

    _core.evaluate_with(
        path, str(name), run.realism, run.into, run.resume, run.jobs, run.shard, run.repetition, make_runner, run.progress
    )


def _complete(options: dict[str, Any], policy: Any, run: _Run) -> None:
    """What its row of adapters and evaluation want. Raises Error usage.bad_flag for what neither allows."""
    if run.record_motion:
        raise Error("usage.bad_flag", "record_motion", "motion is recorded of the program's own policies alone: leave it out")
    if run.record_decisions:
        raise Error("usage.bad_flag", "record_decisions", "decisions are told by classical, vlm and hybrid alone: leave it out")
    wanted = policy.adapter.options() if hasattr(policy, "adapter") else {}
    for option in options.keys() & wanted.keys():
        raise Error("usage.bad_flag", option, f"the adapter {policy.adapter.name} says it: {wanted[option]!r}; leave it out")
    options |= wanted
    if options.get("segmentation"):
        raise Error("usage.bad_flag", "segmentation", "object numbers are the truth: they are refused in evaluation")
    if options.setdefault("obs_mode", "state_robot") == "state":
        raise Error(
            "usage.bad_flag",
            "obs_mode",
            "'state' is the truth: it is refused in evaluation; take 'state_robot', 'rgbd' or 'pointcloud'",
        )


def _server_player(policy: ServerPolicy, run: _Run) -> Callable[[], ModelPlayer]:
    """What makes the player of a thread."""
    if run.policy_files:
        raise Error("usage.bad_flag", "policy_files", "what a server reads is its own affair: leave it out")
    _, hang_limit_s, start_limit_s = run.limits_s
    policy.check_there(start_limit_s, hang_limit_s)
    return lambda: ModelPlayer(policy.acting(start_limit_s, hang_limit_s))


def _python_player(policy: Any, run: _Run, isolation: str) -> Callable[[], PolicyHere | PolicyProcess]:
    if not run.acts_apart:
        return lambda: PolicyHere(copy.deepcopy(policy))
    PolicyProcess(policy, *run.limits_s)  # said here, once, if it cannot be sent
    code = policy.folders() if isinstance(policy, PolicySource) else []
    seen = None if isolation == NOT_ISOLATED else sight(run.truth, code=code, files=run.policy_files)
    return lambda: PolicyProcess(policy, *run.limits_s, seen)


def _why_not_isolated(policy: Any, run: _Run) -> str:
    """Empty: it is."""
    if isinstance(policy, ServerPolicy):
        return "whoever runs its server says what that may read"
    if not run.acts_apart:
        return "act_limit_s=0 runs it in this process"
    return "" if confinement.version() > 0 else "this kernel has no Landlock"


def _isolation(policy: Any, run: _Run) -> str:
    """What will stand in the results; warns when it is nothing."""
    why = _why_not_isolated(policy, run)
    if not why:
        return "landlock"
    warnings.warn(
        f'the policy is not isolated ({why}): it could read the truth of its episodes. Results say isolation: "none"',
        IsolationWarning,
        stacklevel=4,  # of who called evaluate()
    )
    return NOT_ISOLATED


class _Runner:
    """Runs episodes one after another in one thread."""

    def __init__(self, name: str, isolation: str, player: PolicyHere | PolicyProcess | ModelPlayer, stages: Stages):
        self._name, self._isolation, self._player = name, isolation, player
        self._stages, self._environments = stages, {}

    def __del__(self):
        self._player.close()

    def __call__(self, text: str) -> str:
        began = time.monotonic()
        episode = json.loads(text)
        place = episode["track"], episode.get("station")
        if place not in self._environments:
            self._environments[place] = self._stages.environment(*place)
        env = self._environments[place]
        seen, info = env.reset(seed=0, options={"episode": text})
        broken: list[str] = []
        told, by_policy = "None", False
        try:
            self._act_out(env, seen, self._stages.task(env, info))
            told = str(self._player.ask("failure") or "None")
        except PolicyFailed as fault:
            broken, by_policy = [fault.code, "policy", fault.message], True
        except Error as error:
            if error.code != "physics.failed":
                raise
            broken = [error.code, error.where, error.message]
        wall_s = time.monotonic() - began
        return env.environment.judged(self._name, self._isolation, told, broken, by_policy, wall_s)

    def _act_out(self, env, seen, task) -> None:
        self._player.ask("begin", task, seen)
        over = False
        while not over:
            _core.check_interrupt()
            action = self._player.ask("act", seen)
            try:
                seen, _, terminated, truncated, _ = env.step(action)
            except Error as error:
                if error.code != "episode.bad_action":
                    raise
                raise PolicyFailed(error.code, error.message) from error
            over = terminated or truncated
