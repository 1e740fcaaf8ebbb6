"""Who does which job: actors of a Ray cluster, one job at a time each, until all are done.

An actor keeps what it was sent for its next jobs. When its process or node dies, the job it had is given to another; an outcome is
kept once, whoever brings it. Nothing here knows what jobs are about.
"""

from __future__ import annotations

import collections
import contextlib
import dataclasses
import errno
import os
import pathlib
import queue
import shutil
import socket
import tempfile
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from .. import _core
from ..arguments import Progress, bad
from ..errors import Error
from ..recording.outputs import writing
from .jobs import Beat, Job, perform
from .parcels import packed, unpacked

MAX_DEATHS = 3  # of workers over one job: then the job is taken to be what kills them
MAX_WORDS = 600  # letters of what Ray says of a death
SCRATCH = "marketgen-ray-"


def ray_module() -> Any:
    """Raises Error usage.unavailable, which says what to install."""
    try:
        import ray
    except ImportError:
        raise Error("usage.unavailable", "ray", "it is not installed: pip install 'marketgen[ray]'") from None
    return ray


@dataclasses.dataclass(frozen=True)
class Terms:
    """What holds for every job of a call, and changes no outcome.

    cpus             cores of each worker
    episode_limit_s  wall time that a job may take over one episode, where its kind counts them; 0: none
    version          that the package must have where a job is done
    """

    cpus: int
    episode_limit_s: float = 0.0
    version: str = _core.__version__


Fault = tuple[str, str, str]  # what an Error says


class Worker:
    """What each actor is; its disk is its own."""

    def __init__(self) -> None:
        _remove_scratch_of_the_dead()
        self._scratch: pathlib.Path | None = None

    def do(self, job: Job, terms: Terms, parcel: bytes | None) -> tuple[bytes | None, Fault | None]:
        """The outcome as a parcel, or what Error says against it, and of which job and machine that is."""
        try:
            return self._done(job, terms, parcel), None
        except Error as error:
            return None, (error.code, error.where, f"{error.message} ({job.name}, on {socket.gethostname()})")

    def _done(self, job: Job, terms: Terms, parcel: bytes | None) -> bytes:
        if terms.version != _core.__version__:
            told = f"version {_core.__version__} is installed there, {terms.version} where it was called from: install the same"
            raise Error("usage.unavailable", "marketgen", told)
        outcomes = self._folder() / "outcomes"
        into = outcomes / job.name  # datasets name their folder
        try:
            reads = unpacked(parcel, self._folder() / job.reads) if parcel is not None else self._folder()
            in_time(lambda beat: perform(job, reads, into, terms.cpus, beat), terms.episode_limit_s)
            return packed(into)
        except OSError as fault:
            if fault.errno not in (errno.ENOSPC, errno.EDQUOT):
                raise
            raise Error("io.cannot_write", str(fault.filename or self._folder()), str(fault.strerror)) from fault
        finally:
            shutil.rmtree(outcomes, ignore_errors=True)  # with what a broken one has left beside

    def _folder(self) -> pathlib.Path:
        """Made for the first job: what the disk says against it is that job's Error."""
        if self._scratch is None:
            try:
                base = pathlib.Path(tempfile.gettempdir())
            except FileNotFoundError as fault:  # it writes a probe into each that may be one
                raise Error("io.cannot_write", "TMPDIR", f"no folder for temporary files can be written: {fault}") from None
            with writing(base):
                self._scratch = pathlib.Path(tempfile.mkdtemp(prefix=f"{SCRATCH}{os.getpid()}-"))
        return self._scratch


def in_time(does: Callable[[Beat], None], limit_s: float) -> None:
    """Does it, and raises Error episode.policy_hung after `limit_s` of wall time in which it did not call what it is given; 0: no limit.

    What hangs is left to its thread, which ends with the process.
    """
    if not limit_s:
        return does(lambda: None)
    ended: queue.SimpleQueue[BaseException | None] = queue.SimpleQueue()
    last_s = [time.monotonic()]

    def beat() -> None:
        last_s[0] = time.monotonic()

    def run() -> None:
        try:
            does(beat)
            ended.put(None)
        except BaseException as fault:  # raised below, in the thread that waits
            ended.put(fault)

    threading.Thread(target=run, daemon=True).start()
    while True:
        try:
            fault = ended.get(timeout=max(0.0, last_s[0] + limit_s - time.monotonic()))
            break
        except queue.Empty:
            if time.monotonic() >= last_s[0] + limit_s:
                raise Error("episode.policy_hung", "policy", f"an episode took more than {limit_s:g} s of wall time (episode_limit_s)") from None
    if fault is not None:
        raise fault


def _remove_scratch_of_the_dead() -> None:
    try:
        base = pathlib.Path(tempfile.gettempdir())
    except FileNotFoundError:  # none can be written: the first job says so
        return
    for folder in base.glob(f"{SCRATCH}*"):
        pid = folder.name.removeprefix(SCRATCH).partition("-")[0]
        if pid.isdecimal() and not pathlib.Path("/proc", pid).exists():
            shutil.rmtree(folder, ignore_errors=True)


class Crew:
    """Actors, begun when there is work for them. Where `ray.init` was not called it is, without more: the cluster that runs on
    this machine or that RAY_ADDRESS names, else one of this machine's cores.

    workers  actors at most; 0: as many as the cluster has cores for

    Raises Error usage.bad_flag when no node has the cores of one.
    """

    def __init__(self, workers: int, terms: Terms):
        self._ray = ray_module()
        if not self._ray.is_initialized():
            self._ray.init(log_to_driver=False)
        cores = [int(node["Resources"].get("CPU", 0)) for node in self._ray.nodes() if node["Alive"]]
        if terms.cpus > max(cores, default=0):  # Ray would wait for one that has
            raise bad("cpus", terms.cpus, f"at most {max(cores, default=0)}, the cores of the cluster's largest node")
        self._terms = terms
        self._workers = workers or sum(count // terms.cpus for count in cores)
        self._kind = self._ray.remote(num_cpus=terms.cpus, max_restarts=0)(Worker)
        self._idle: list[Any] = []
        self._busy: dict[Any, tuple[Any, Job]] = {}  # by what will be the outcome
        self._deaths: collections.Counter[str] = collections.Counter()

    def work(self, jobs: Sequence[Job], parcels: Mapping[str, bytes], keep: Callable[[Job, bytes], None], progress: Progress | None) -> None:
        """Gives each outcome to `keep`, in whatever order they come. Raises the Error of the first job that cannot be done; what
        others have finished until then is kept, too."""
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
        except BaseException:
            self._keep_what_is_there(keep)
            raise
        finally:
            for actor in [*self._idle, *(actor for actor, _ in self._busy.values())]:
                self._end(actor)
            self._idle, self._busy = [], {}

    def _give_out(self, waiting: collections.deque[Job], sent: Mapping[str, Any]) -> None:
        while waiting and len(self._busy) < self._workers:
            job = waiting.popleft()
            actor = self._idle.pop() if self._idle else self._kind.remote()
            outcome = actor.do.remote(job, self._terms, sent.get(job.reads))
            self._busy[outcome] = actor, job
        while self._idle:  # its cores may be what an actor that has a job waits for
            self._end(self._idle.pop())

    def _come_in(self, waiting: collections.deque[Job]) -> list[tuple[Job, bytes]]:
        """Outcomes that are there; jobs whose worker died wait again."""
        ready, _ = self._ray.wait(list(self._busy), num_returns=1)
        came = []
        for outcome in ready:
            actor, job = self._busy[outcome]
            try:
                parcel, fault = self._ray.get(outcome)
            except self._ray.exceptions.RayTaskError:
                raise  # a fault of the code: trying again would not mend it
            except self._ray.exceptions.RayError as death:
                del self._busy[outcome]
                self._end(actor)
                self._died(job, death)
                waiting.appendleft(job)
                continue
            del self._busy[outcome]
            if fault is not None:
                self._end(actor)
                raise Error(*fault)
            self._idle.append(actor)
            came.append((job, parcel))
        return came

    def _died(self, job: Job, death: Exception) -> None:
        why = " ".join(str(death).split())[:MAX_WORDS]
        if getattr(death, "actor_init_failed", False):
            raise Error("usage.unavailable", "marketgen", f"a worker does not start: install the same version on every node ({why})")
        self._deaths[job.key] += 1
        if self._deaths[job.key] >= MAX_DEATHS:
            message = f"{MAX_DEATHS} workers died over it: give each more memory, or make parts smaller. The last: {why}"
            raise Error("program.failed", job.name, message)

    def _keep_what_is_there(self, keep: Callable[[Job, bytes], None]) -> None:
        """Outcomes that nobody has asked for yet. What is wrong with one is not told: something else ends the call."""
        ready: list[Any] = []
        with contextlib.suppress(Exception):  # Ray itself may be gone
            ready, _ = self._ray.wait(list(self._busy), num_returns=len(self._busy), timeout=0) if self._busy else ([], [])
        for outcome in ready:
            with contextlib.suppress(Exception):
                parcel, fault = self._ray.get(outcome)
                if fault is None:
                    keep(self._busy[outcome][1], parcel)

    def _end(self, actor: Any) -> None:
        with contextlib.suppress(self._ray.exceptions.RayError):
            self._ray.kill(actor)
