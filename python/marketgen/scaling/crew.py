"""Who does which job: actors of a Ray cluster, one job at a time each, until all are done.

An actor keeps what it was sent for its next jobs. When its process or node dies, the job it had is given to another; an outcome is
kept once, whoever brings it. Nothing here knows what jobs are about.
"""

from __future__ import annotations

import collections
import contextlib
import os
import pathlib
import shutil
import tempfile
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from ..arguments import Progress
from ..errors import Error
from .jobs import Job, perform
from .parcels import packed, unpacked

MAX_DEATHS = 3  # of workers over one job: then the job is taken to be what kills them
SCRATCH = "marketgen-ray-"


def ray_module() -> Any:
    """Raises Error usage.unavailable, which says what to install."""
    try:
        import ray
    except ImportError:
        raise Error("usage.unavailable", "ray", "it is not installed: pip install 'marketgen[ray]'") from None
    return ray


class Worker:
    """What each actor is; its disk is its own."""

    def __init__(self) -> None:
        _remove_scratch_of_the_dead()
        self._scratch = pathlib.Path(tempfile.mkdtemp(prefix=f"{SCRATCH}{os.getpid()}-"))

    def pid(self) -> int:
        return os.getpid()

    def do(self, job: Job, cpus: int, parcel: bytes | None) -> tuple[bytes | None, tuple[str, str, str] | None]:
        """The outcome as a parcel, or what Error says against it."""
        into = self._scratch / "outcomes" / job.key
        try:
            reads = unpacked(parcel, self._scratch / job.reads) if parcel is not None else self._scratch
            into.parent.mkdir(exist_ok=True)
            perform(job, reads, into, cpus)
            return packed(into), None
        except Error as error:
            return None, (error.code, error.where, error.message)
        finally:
            shutil.rmtree(into, ignore_errors=True)


def _remove_scratch_of_the_dead() -> None:
    for folder in pathlib.Path(tempfile.gettempdir()).glob(f"{SCRATCH}*"):
        pid = folder.name.removeprefix(SCRATCH).partition("-")[0]
        if pid.isdecimal() and not pathlib.Path("/proc", pid).exists():
            shutil.rmtree(folder, ignore_errors=True)


class Crew:
    """Actors, begun when there is work for them. Where `ray.init` was not called it is, without more: the cluster that runs on
    this machine or that RAY_ADDRESS names, else one of this machine's cores.

    workers  actors at most; 0: as many as the cluster has cores for
    cpus     cores of each
    """

    def __init__(self, workers: int, cpus: int):
        self._ray = ray_module()
        if not self._ray.is_initialized():
            self._ray.init(log_to_driver=False)
        self._cpus = cpus
        self._workers = workers or max(1, int(self._ray.cluster_resources().get("CPU", 1)) // cpus)
        self._kind = self._ray.remote(num_cpus=cpus, max_restarts=0)(Worker)
        self._idle: list[Any] = []
        self._busy: dict[Any, tuple[Any, Job]] = {}  # by what will be the outcome
        self._deaths: collections.Counter[str] = collections.Counter()

    def work(self, jobs: Sequence[Job], parcels: Mapping[str, bytes], keep: Callable[[Job, bytes], None], progress: Progress | None) -> None:
        """Gives each outcome to `keep`, in whatever order they come. Raises the Error of the first job that cannot be done."""
        sent = {name: self._ray.put(parcel) for name, parcel in parcels.items()}
        waiting = collections.deque(jobs)
        done = 0
        try:
            while waiting or self._busy:
                self._give_out(waiting, sent)
                for job, parcel in self._come_in(waiting):
                    keep(job, parcel)
                    done += 1
                    if progress is not None:
                        progress(done, len(jobs), job.name)
        finally:
            for actor in [*self._idle, *(actor for actor, _ in self._busy.values())]:
                self._end(actor)
            self._idle, self._busy = [], {}

    def _give_out(self, waiting: collections.deque[Job], sent: Mapping[str, Any]) -> None:
        while waiting and len(self._busy) < self._workers:
            job = waiting.popleft()
            actor = self._idle.pop() if self._idle else self._kind.remote()
            outcome = actor.do.remote(job, self._cpus, sent.get(job.reads))
            self._busy[outcome] = actor, job
        while self._idle:  # its cores may be what an actor that has a job waits for
            self._end(self._idle.pop())

    def _come_in(self, waiting: collections.deque[Job]) -> list[tuple[Job, bytes]]:
        """Outcomes that are there; jobs whose worker died wait again."""
        ready, _ = self._ray.wait(list(self._busy), num_returns=1)
        came = []
        for outcome in ready:
            actor, job = self._busy.pop(outcome)
            try:
                parcel, fault = self._ray.get(outcome)
            except self._ray.exceptions.RayTaskError:
                raise  # a fault of the code: trying again would not mend it
            except self._ray.exceptions.RayError as death:
                self._end(actor)
                self._died(job, death)
                waiting.appendleft(job)
                continue
            if fault is not None:
                self._end(actor)
                raise Error(*fault)
            self._idle.append(actor)
            came.append((job, parcel))
        return came

    def _died(self, job: Job, death: Exception) -> None:
        self._deaths[job.key] += 1
        if self._deaths[job.key] >= MAX_DEATHS:
            why = " ".join(str(death).split())[:300]
            message = f"{MAX_DEATHS} workers died over it: give each more memory, or make parts smaller. The last: {why}"
            raise Error("program.failed", job.name, message)

    def _end(self, actor: Any) -> None:
        with contextlib.suppress(self._ray.exceptions.RayError):
            self._ray.kill(actor)
