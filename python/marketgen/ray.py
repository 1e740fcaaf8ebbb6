"""Stores, episodes, scores and demonstrations over a Ray cluster (docs/cluster.md).

    import ray, marketgen.ray

    ray.init("auto")                                                   # left out: this machine's cores
    marketgen.ray.generate([{"prompt": "a kiosk", "seed": seed} for seed in range(100)], "stores")
    marketgen.ray.draw(sorted(pathlib.Path("stores").iterdir()), "tasks", count=10)
    marketgen.ray.evaluate("tasks.jsonl", "oracle", "results")

What comes out is what one process makes, to the byte (wall times apart). Workers share no disk with this process: what they read
and make travels through Ray. A worker or a node that dies loses the job it had, which another does anew. What is finished lies in
FOLDER.unfinished under a hash of what it depends on; resume=True goes on with it. All raise marketgen.Error, of a job that cannot be
done at once. Python of the workers needs the same version of this package.
"""

from __future__ import annotations

import contextlib
import json
import os
import pathlib
import shutil
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from . import _core, arguments
from .arguments import MAX_SEED, PathLike, Progress
from .errors import Error
from .evaluation import MAX_LIMIT_S, Evaluation, evaluation_in
from .recording.outputs import alone_in, writing
from .scaling.crew import Crew, Terms, ray_module
from .scaling.jobs import Job
from .scaling.parcels import episodes_parcel, hash_of, packed, unpacked

MAX_WORKERS, MAX_CPUS, MAX_PART, MAX_COUNT = 100_000, 1_000, 1_000_000, 10**9
STORE_FIELDS = ("prompt", "seed", "size", "profile", "style", "country", "time", "previews", "strict")
EVALUATE_OPTIONS = ("realism", "act_limit_s", "hang_limit_s", "start_limit_s", "adapter", "name", "obs_mode", "control_mode")
RECORD_OPTIONS = ("realism", "cameras", "size", "quality", "control_mode", "codec", "success_only")


def generate(
    stores: Sequence[Mapping[str, Any]],
    folder: PathLike,
    *,
    workers: int = 0,
    cpus: int = 1,
    resume: bool = False,
    progress: Progress | None = None,
) -> list[str]:
    """Makes a store of each of `stores`, arguments of marketgen.generate() (prompt, seed, size, profile, style, country, time, previews, strict).

    folder    gets them as store-00000, store-00001, ... Returns these folders
    workers   actors at most; 0: as many as the cluster has cores for. `cpus`: cores of each
    progress  as of marketgen.generate(), by jobs

    Raises Error store.exists, io.in_use, usage.*, and what marketgen.generate() raises.
    """
    specs = arguments.documents("stores", stores)
    for spec in specs:
        _known("stores", spec, STORE_FIELDS)
    jobs = [Job("generate", f"store-{number:05}", {"prompt": "", **spec}) for number, spec in enumerate(specs)]
    into = _new_folder(folder, resume)
    return _made_folders(into, jobs, {}, _crew(workers, cpus), progress)


def draw(
    stores: Sequence[PathLike],
    folder: PathLike,
    *,
    count: int = 10,
    seed: int = 1,
    track: str = "checkout",
    split: str = "planned",
    workers: int = 0,
    cpus: int = 1,
    resume: bool = False,
    progress: Progress | None = None,
) -> list[str]:
    """Draws `count` episodes of each store, as `marketgen episodes STORE` does, into a file for each store.

    folder  gets store-00000/episodes.jsonl, ... in the order of `stores`. Returns these files

    Raises Error store.exists, io.in_use, input.not_found, usage.*, episode.*.
    """
    flags = [
        *("--count", arguments.a_whole("count", count, 1, MAX_COUNT)),
        *("--seed", arguments.a_whole("seed", seed, 0, MAX_SEED)),
        *("--track", arguments.a_name("track", track, ("checkout", "aisle"))),
        *("--split", arguments.a_name("split", split, ("planned", "certified", "paper", "all"))),
    ]
    parcels, jobs = {}, []
    for number, store in enumerate(arguments.paths("stores", stores)):
        parcel = packed(pathlib.Path(arguments.existing("stores", store)))
        name = hash_of(parcel)
        parcels[name] = parcel
        jobs.append(Job("draw", f"store-{number:05}", {"file": "episodes.jsonl", "flags": flags}, name))
    into = _new_folder(folder, resume)
    made = _made_folders(into, jobs, parcels, _crew(workers, cpus), progress)
    return [os.path.join(place, "episodes.jsonl") for place in made]


def evaluate(
    episodes: PathLike,
    policy: str = "oracle",
    folder: PathLike = "results",
    *,
    part: int = 10,
    workers: int = 0,
    cpus: int = 1,
    resume: bool = False,
    progress: Progress | None = None,
    **options: Any,
) -> Evaluation:
    """marketgen.evaluate() of the whole file, in shards of about `part` episodes; the same results and summary.

    policy   a text, as marketgen.evaluate() takes it; FILE.py:NAME must be there on every node
    part     episodes of a job: what is lost at most with a worker. Going on needs the same
    options  of marketgen.evaluate(): realism, act_limit_s, hang_limit_s, start_limit_s, adapter, name, obs_mode, control_mode

    Raises Error store.exists, io.in_use, usage.*, episode.*, results.*.
    """
    _known("options", options, EVALUATE_OPTIONS)
    jobs, parcels = _shards("evaluate", episodes, policy, part, options)
    of_set = _core.set_of_episodes(arguments.episodes_path("episodes", episodes))  # workers have a copy of it
    into = _new_folder(folder, resume)
    beside = _beside(into)
    with _kept_in(beside):
        _work(_crew(workers, cpus), jobs, parcels, beside, progress)
        _core.merge([str(beside / job.key) for job in jobs], str(into), of_set)
        return evaluation_in(str(into))


def record(
    episodes: PathLike,
    folder: PathLike,
    policy: str = "oracle",
    *,
    part: int = 10,
    workers: int = 0,
    cpus: int = 1,
    episode_limit_s: float = 3600.0,
    resume: bool = False,
    progress: Progress | None = None,
    **options: Any,
) -> list[str]:
    """marketgen.record() in shards of about `part` episodes, each a dataset of its own: FOLDER/shard-00000, ...

    episode_limit_s  wall time of one episode, after which its policy, which acts in the worker itself, is taken to hang: Error
                     episode.policy_hung. 0: none
    options          of marketgen.record(): realism, cameras, size, quality, control_mode, codec, success_only

    Returns their folders; LeRobot's `lerobot-edit-dataset` joins them. Raises as marketgen.record() does; a shard none of whose
    episodes is to be kept is an Error, too (episode.impossible): make parts larger.
    """
    _known("options", options, RECORD_OPTIONS)
    jobs, parcels = _shards("record", episodes, policy, part, options)
    into = _new_folder(folder, resume)
    return _made_folders(into, jobs, parcels, _crew(workers, cpus, episode_limit_s), progress)


def _crew(workers: int, cpus: int, episode_limit_s: float = 0.0) -> Crew:
    limit_s = arguments.a_number("episode_limit_s", episode_limit_s, 0, MAX_LIMIT_S)
    return Crew(arguments.a_whole("workers", workers, 0, MAX_WORKERS), Terms(arguments.a_whole("cpus", cpus, 1, MAX_CPUS), limit_s))


def _known(name: str, given: Mapping[str, Any], fields: Sequence[str]) -> None:
    for field in given:
        arguments.a_name(name, field, fields)


def _shards(kind: str, episodes: PathLike, policy: str, part: int, options: Mapping[str, Any]) -> tuple[list[Job], dict[str, bytes]]:
    path = arguments.existing("episodes", arguments.episodes_path("episodes", episodes))
    parcel, count = episodes_parcel(path)
    name = hash_of(parcel)
    of = max(1, -(-count // arguments.a_whole("part", part, 1, MAX_PART)))
    [told] = arguments.documents("options", [options])
    about = {"file": os.path.basename(path), "policy": arguments.a_text("policy", policy), "options": told}
    about["code"] = _hashes_of_files([policy.rpartition(":")[0], str(options.get("realism", ""))])
    jobs = [Job(kind, f"shard-{number - 1:05}", {**about, "shard": f"{number}/{of}"}, name) for number in range(1, of + 1)]
    return jobs, {name: parcel}


def _hashes_of_files(names: Sequence[str]) -> list[str]:
    """Of those that are files: an outcome depends on what stands in them."""
    return [hash_of(pathlib.Path(name).read_bytes()) for name in names if os.path.isfile(name)]


def _new_folder(folder: PathLike, resume: bool) -> pathlib.Path:
    """Raises Error store.exists when it is there already, or was begun and is not to go on."""
    into = pathlib.Path(os.path.abspath(arguments.a_path("folder", folder)))
    ray_module()
    if into.exists() and (not into.is_dir() or any(into.iterdir())):
        raise Error("store.exists", str(into), "it is there already: remove it, or name another folder")
    if _beside(into).exists() and not arguments.a_truth("resume", resume):
        raise Error("store.exists", str(_beside(into)), "work was broken off there: go on with resume=True, or remove it")
    return into


def _beside(into: pathlib.Path) -> pathlib.Path:
    return into.with_name(into.name + ".unfinished")


@contextlib.contextmanager
def _kept_in(beside: pathlib.Path) -> Iterator[None]:
    """What is finished lies there until all is; where nothing is, nothing stays. Raises Error io.in_use, io.cannot_write."""
    with writing(beside):
        beside.mkdir(parents=True, exist_ok=True)
    with alone_in(beside):
        try:
            yield
        except BaseException:
            if not _finished_in(beside):
                shutil.rmtree(beside, ignore_errors=True)
            raise
    shutil.rmtree(beside)


def _finished_in(beside: pathlib.Path) -> set[str]:
    """Keys of jobs."""
    return {place.name for place in beside.iterdir() if not place.name.startswith(".")}


def _work(crew: Crew, jobs: Sequence[Job], parcels: Mapping[str, bytes], beside: pathlib.Path, progress: Progress | None) -> None:
    """Every job's outcome lies in `beside`, under its key."""
    finished = _finished_in(beside)
    new = list({job.key: job for job in jobs if job.key not in finished}.values())
    wanted = {job.reads for job in new}
    crew.work(
        new,
        {name: parcel for name, parcel in parcels.items() if name in wanted},
        lambda job, parcel: unpacked(parcel, beside / job.key),
        progress,
    )


def _made_folders(
    into: pathlib.Path, jobs: Sequence[Job], parcels: Mapping[str, bytes], crew: Crew, progress: Progress | None
) -> list[str]:
    """Outcomes that are wholes by themselves, below `into` under their names; what two jobs share is copied."""
    beside = _beside(into)
    with _kept_in(beside):
        _work(crew, jobs, parcels, beside, progress)
        whole = beside / ".whole"
        shutil.rmtree(whole, ignore_errors=True)
        with writing(into):
            whole.mkdir()
            for job in jobs:
                shutil.copytree(beside / job.key, whole / job.name, copy_function=os.link)
            (whole / "jobs.json").write_text(json.dumps({job.name: job.key for job in jobs}, indent=2) + "\n", encoding="utf-8")
            whole.replace(into)
    return [str(into / job.name) for job in jobs]
