"""record(): episodes acted out one after another, and a dataset of them."""

from __future__ import annotations

import dataclasses
import functools
import hashlib
import importlib.util
import json
import math
import os
import pathlib
import shutil
import time
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from .. import _core, arguments
from ..arguments import PathLike, Progress
from ..errors import Error
from ..policies import SUBTASKS
from .acting import FPS, Player, Stopwatch, act_out, player_of
from .card import write_card
from .dataset import About, counted_in, settings_in, write_dataset
from .drives import Drives, write_episodes_file
from .features import acted
from .outputs import alone_in, writing
from .parts import Part, Unfinished
from .staging import documents_of, episodes_of, place_of, stages_of
from .video import CODECS, Encoder

if TYPE_CHECKING:
    from ..environments.task_setup import ControlMode

MAX_COUNT, MIN_SIDE_PX = 10**9, 16
NEEDS = {"pyarrow": "pyarrow", "av": "av", "gymnasium": "gymnasium"}  # by module, as pip knows them


@dataclasses.dataclass(frozen=True)
class Recording:
    """What record() has done.

    folder     of the dataset
    episodes   that are in it; `succeeded` of them reached all goals
    tried      that were acted out, in this run or before it was broken off
    frames     20 a second
    seconds    of wall time in this run: "all", and of that on "pictures", "video" (waiting for encoders, which have threads of
               their own) and "files"
    acted_now  how many of the tried were acted out in this run
    """

    folder: str
    episodes: int
    succeeded: int
    tried: int
    frames: int
    seconds: dict[str, float]
    acted_now: int

    @property
    def episodes_an_hour(self) -> float:
        """Of those that were acted out in this run."""
        return self.acted_now / self.seconds["all"] * 3600 if self.acted_now else 0.0

    @property
    def times_as_long(self) -> float:
        """As the same episodes take without pictures, videos and files; not a number where this run acted none out."""
        if not self.acted_now:
            return math.nan
        rest = self.seconds["all"] - sum(value for name, value in self.seconds.items() if name != "all")
        return self.seconds["all"] / rest


def record(
    episodes: PathLike,
    folder: PathLike,
    policy: Any = "oracle",
    *,
    cameras: Sequence[str] | None = None,
    size: tuple[int, int] = (256, 256),
    quality: str = "fast",
    control_mode: ControlMode = "pd_joint_pos",
    realism: PathLike = "ideal",
    codec: str = "h264",
    success_only: bool = False,
    count: int = 0,
    shard: str = "",
    resume: bool = False,
    progress: Progress | None = None,
) -> Recording:
    """Acts the episodes of a file out and writes what happened as a LeRobot dataset v3.0.

    episodes      a file of `marketgen episodes`, or a set that comes with the program ("pool/checkout"); of one robot and tools
    folder        becomes the dataset; until then FOLDER.unfinished has what is done
    policy        "oracle", "classical" or another of the program's own; a function from observation to action, an object with
                  act() or a class of such, or "FILE.py:NAME", as evaluate() takes them (docs/python.md). It acts in this process
    cameras       whose pictures are kept (by themselves both at the counter, the head's in the aisles; none: numbers alone)
    size          (width, height) of the pictures, even numbers
    quality       of the pictures: "fast", "balanced" or "best"
    control_mode  what an action is; the program's own policies need "pd_joint_pos" or "pd_joint_delta_pos"
    realism       what stands between the world and the robot: "ideal", "standard", "hard", "crowded", "randomized" or a file
    codec         "h264", which keeps every pixel's colour, or "av1", which keeps one for four, as browsers want it
    success_only  leave out episodes that did not reach all their goals
    count         stop when so many are in the dataset; 0: act out all
    shard         "2/4": the second of four parts of the file, each a dataset of its own
    resume        go on with a recording that was broken off
    progress      called as progress(done, total, text) before each episode; what it raises ends the call, and what is finished
                  is kept

    An episode that physics cannot simulate to its end is left out, and the dataset's README.md counts it. What the policy raises
    is raised (Error episode.policy_failed). Raises Error store.exists, io.in_use, io.cannot_write, usage.unavailable,
    usage.bad_flag, episode.*.
    """
    check_installed()
    path = arguments.episodes_path("episodes", episodes)
    into = pathlib.Path(os.path.abspath(arguments.a_path("folder", folder)))
    wanted = arguments.a_size("size", size)
    if any(side % 2 or side < MIN_SIDE_PX for side in wanted):
        raise arguments.bad("size", size, f"even numbers of pixels from {MIN_SIDE_PX} on, as encoders of videos want them")
    run = _Run(
        path=path,
        folder=into,
        policy=player_of(policy),
        name=policy if isinstance(policy, str) else getattr(policy, "name", None) or getattr(policy, "__name__", None) or type(policy).__name__,
        size=wanted,
        codec=arguments.a_name("codec", codec, tuple(CODECS)),
        success_only=arguments.a_truth("success_only", success_only),
        count=arguments.a_whole("count", count, 0, MAX_COUNT),
        shard=_core.read_shard(shard) if arguments.a_text("shard", shard) else (1, 1),
        progress=arguments.a_progress(progress),
        options={
            "cameras": None if cameras is None else tuple(arguments.texts("cameras", cameras, "a list of names")),
            "quality": quality,
            "control_mode": control_mode,
            "realism": arguments.a_path("realism", realism),
        },
    )
    return run.whole(resume=arguments.a_truth("resume", resume))


def record_drives(logs: Sequence[PathLike], folder: PathLike, **options: Any) -> Recording:
    """What people drove in the page of `marketgen view`, as a dataset of record().

    logs     files of it (`drives/*.drive.jsonl.gz`), each of another episode; a log that breaks off ends with a stop
    options  as of record(), but for policy, control_mode and realism, which are the logs'

    FOLDER.episodes.jsonl gets the episodes of all logs: what replay_check() of the dataset needs. Raises Error
    episode.not_repeated where a log's actions do not lead to its state; those of record().
    """
    drives = Drives(logs)
    path = write_episodes_file(drives, arguments.a_path("folder", folder))
    return record(path, folder, drives, control_mode=drives.control_mode, realism=drives.realism, **options)


def check_installed() -> None:
    """Raises Error usage.unavailable, which says what to install."""
    missing = [package for module, package in NEEDS.items() if importlib.util.find_spec(module) is None]
    if missing:
        raise Error("usage.unavailable", ", ".join(missing), "recording needs it: pip install 'marketgen[lerobot]'")


def contents_hash(path: str) -> str:
    """SHA-256 of a file."""
    try:
        return hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest()
    except OSError as fault:
        raise Error("input.not_found", path, str(fault.strerror)) from None


def told_realism(realism: str) -> str:
    """As datasets name it: a file by its name and contents."""
    return f"{os.path.basename(realism)} (sha256 {contents_hash(realism)})" if realism.endswith(".json") else realism


@dataclasses.dataclass(frozen=True)
class _Run:
    """What record() was asked for; checked as far as it can be without a world."""

    path: str
    folder: pathlib.Path
    policy: Any  # of player_of()
    name: str
    size: tuple[int, int]
    codec: str
    success_only: bool
    count: int
    shard: tuple[int, int]
    progress: Progress | None
    options: dict[str, Any]

    def whole(self, *, resume: bool) -> Recording:
        began, watch = time.perf_counter(), Stopwatch()
        there = self.folder.exists() and (not self.folder.is_dir() or any(self.folder.iterdir()))
        if there and not resume:
            raise Error("store.exists", str(self.folder), "it is there already: remove it, or name another folder")
        stage = _Stage(self)
        beside = self.folder.with_name(self.folder.name + ".unfinished")
        if there:
            made = self._made_before(stage)
            shutil.rmtree(beside, ignore_errors=True)  # of one that was killed between the last two steps below
            return made
        with writing(beside):
            beside.mkdir(parents=True, exist_ok=True)
        with alone_in(beside):
            unfinished = Unfinished(beside, stage.settings, resume=resume)
            try:
                parts, now = self._act(stage, unfinished, watch)
                kept = [part for part in parts if part.kept]
                if not kept:
                    raise Error("episode.impossible", self.path, f"of {len(parts)} episodes none is to be kept: {_why(parts)}")
                with watch.on("files"):
                    self._make(stage, kept, parts)
            except BaseException:
                unfinished.remove_if_empty()
                raise
            unfinished.remove()
        watch.seconds["all"] = time.perf_counter() - began
        return Recording(
            folder=str(self.folder),
            episodes=len(kept),
            succeeded=sum(part.told["success"] for part in kept),
            tried=len(parts),
            frames=sum(part.told["frames"] for part in kept),
            seconds=watch.seconds,
            acted_now=now,
        )

    def _made_before(self, stage: _Stage) -> Recording:
        """What a recording that is to go on finds done. Raises Error store.exists for another dataset, or anything else."""
        settings = settings_in(self.folder)
        if settings is None or settings != self._told(stage, settings["tried"]):
            message = "it is there already, and not of this recording: remove it, or name another folder"
            raise Error("store.exists", str(self.folder), message)
        episodes, succeeded, frames = counted_in(self.folder)
        return Recording(str(self.folder), episodes, succeeded, settings["tried"], frames, {"all": 0.0}, acted_now=0)

    def _told(self, stage: _Stage, tried: int) -> dict[str, Any]:
        """What the dataset says of how it was recorded."""
        return {**stage.settings, "count": self.count, "tried": tried}

    def _act(self, stage: _Stage, unfinished: Unfinished, watch: Stopwatch) -> tuple[list[Part], int]:
        """All that were acted out, and how many of them just now."""
        parts: list[Part] = []
        now, kept = 0, 0
        for done, (number, text) in enumerate(stage.episodes):
            if self.count and kept == self.count:
                break
            if self.progress is not None:
                self.progress(done, len(stage.episodes), json.loads(text)["instruction"])
            part = unfinished.part(number)
            if part is None:
                part, now = self._act_one(stage, unfinished, number, text, watch), now + 1
            parts.append(part)
            kept += part.kept
        if self.progress is not None:
            self.progress(len(stage.episodes), len(stage.episodes), "the dataset")
        return parts, now

    def _act_one(self, stage: _Stage, unfinished: Unfinished, number: int, text: str, watch: Stopwatch) -> Part:
        episode = json.loads(text)
        told: dict[str, Any] = {"id": episode["id"], "seed": episode["seed"], "kept": False}
        try:
            take = act_out(stage.env, text, stage.player, stage.kinds, stage.new_encoder, watch)
        except Error as error:
            if error.code != "physics.failed":
                raise
            take, told = None, {**told, "error": str(error)}
        else:
            told |= {
                "kept": take.result["success_strict"] or not self.success_only,
                "task": take.task,
                "frames": len(take.numbers["action"]),
                "success": take.result["success_strict"],
                "goal_fraction": take.result["success_partial"],
                "failure": take.result["failure"],
                "state_hash": take.state_hash,
                "pictures": {camera: counts.to_json() for camera, counts in take.counts.items()},
            }
        with watch.on("files"):
            return unfinished.keep(number, told, take if told["kept"] else None, stage.kinds)

    def _make(self, stage: _Stage, kept: list[Part], parts: list[Part]) -> None:
        card: Callable[[pathlib.Path], None] = functools.partial(
            write_card, name=self.folder.name, kept=kept, tried=parts, about=stage.about, settings=stage.settings
        )
        write_dataset(self.folder, kept, stage.about, self._told(stage, len(parts)), card)


def _why(parts: list[Part]) -> str:
    reasons = [part.told.get("error") or part.told["failure"] for part in parts]
    return "; ".join(f"{reason} ({reasons.count(reason)})" for reason in dict.fromkeys(reasons)) or "the file has none"


class _Stage:
    """Where episodes are acted out and by whom. Raises Error usage.bad_flag, episode.* for what does not go together."""

    def __init__(self, run: _Run):
        part, of = run.shard
        self.episodes = list(enumerate(episodes_of(run.path)))[part - 1 :: of]
        place = place_of(documents_of([text for _, text in self.episodes]), run.path)
        stages = stages_of(run.path, place, run.size, run.options)
        self.env = stages.environment(place["track"], place["station"])
        self.player = run.policy.player(self.env) if isinstance(run.policy, Drives) else Player(run.policy, self.env, stages)
        self.kinds = acted(self.env.robot_names, self.env.action_names)
        self.about = About(place["robot"], self.kinds, tuple(self.env.cameras), run.codec, run.size)
        self.new_encoder = functools.partial(Encoder, run.codec, run.size, FPS)
        self.settings = {
            "program": f"marketgen {_core.__version__}",
            "episodes": os.path.basename(run.path),
            "episodes_sha256": contents_hash(run.path),
            "shard": f"{part}/{of}",
            **place,
            "policy": run.name,
            "control_mode": run.options["control_mode"],
            "cameras": list(self.env.cameras),
            "size": list(run.size),
            "quality": run.options["quality"],
            "codec": run.codec,
            "realism": told_realism(run.options["realism"]),
            "success_only": run.success_only,
            "subtasks": list(SUBTASKS),
        }
