"""Jobs: what is to be done, as a value of texts and numbers, and how one process does it.

A job's key is a hash of all that its outcome depends on: what it says, the contents of what it reads, and the version of the
program. So whoever does it twice has the same outcome twice, and an outcome that lies under its key need not be made again.
"""

from __future__ import annotations

import dataclasses
import json
import os
import pathlib
import shutil
import subprocess
from collections.abc import Callable
from typing import Any

from .. import _core
from ..errors import Error
from .parcels import hash_of


@dataclasses.dataclass(frozen=True)
class Job:
    """kind   of KINDS
    name   for people, and of the folder that the outcome becomes, where it is a whole by itself
    told   what its kind wants, as JSON has it
    reads  hash of the parcel that goes with it; "": none
    """

    kind: str
    name: str
    told: dict[str, Any]
    reads: str = ""

    @property
    def key(self) -> str:
        return hash_of(self.kind, json.dumps(self.told, sort_keys=True), self.reads, _core.__version__)


Beat = Callable[[], None]


def perform(job: Job, reads: pathlib.Path, into: pathlib.Path, cpus: int, beat: Beat) -> None:
    """Makes the folder `into`.

    reads  what its parcel has
    cpus   how many cores it may use, which changes no outcome
    beat   called before each episode, where a kind may hang over one

    What is there of an earlier try goes on, where the kind can. Raises Error as the functions that it calls do.
    """
    KINDS[job.kind](job.told, reads, into, cpus, beat)


def _generate(told: dict[str, Any], reads: pathlib.Path, into: pathlib.Path, cpus: int, beat: Beat) -> None:
    from ..store import generate

    shutil.rmtree(into, ignore_errors=True)
    generate(folder=into, **told)


def _draw(told: dict[str, Any], reads: pathlib.Path, into: pathlib.Path, cpus: int, beat: Beat) -> None:
    """By the program, which alone draws files of episodes."""
    into.mkdir(parents=True, exist_ok=True)
    file = into / told["file"]
    # --resume goes on with a draw that was broken off, and begins one that was not begun.
    words = ["episodes", reads, "-o", file, "--threads", cpus, "--quiet", "--resume", *told["flags"]]
    done = subprocess.run([program(), *map(str, words)], capture_output=True, text=True)
    if done.returncode != 0:
        raise _told_by_program(done.stderr)


def _evaluate(told: dict[str, Any], reads: pathlib.Path, into: pathlib.Path, cpus: int, beat: Beat) -> None:
    from ..evaluation import evaluate

    evaluate(reads / told["file"], told["policy"], into, shard=told["shard"], jobs=cpus, resume=True, **told["options"])


def _record(told: dict[str, Any], reads: pathlib.Path, into: pathlib.Path, cpus: int, beat: Beat) -> None:
    from ..recording import record

    def told_of(*_: Any) -> None:
        beat()

    record(reads / told["file"], into, told["policy"], shard=told["shard"], resume=True, progress=told_of, **told["options"])


KINDS = {"generate": _generate, "draw": _draw, "evaluate": _evaluate, "record": _record}


def program() -> str:
    """The program `marketgen`: that of this package, of MARKETGEN_BINARY, or on the PATH. Raises Error usage.unavailable."""
    own = pathlib.Path(__file__).parents[1] / "bin" / "marketgen"
    found = str(own) if own.exists() else os.environ.get("MARKETGEN_BINARY") or shutil.which("marketgen")
    if not found:
        raise Error("usage.unavailable", "marketgen", "the program is not there: install the package, or set MARKETGEN_BINARY to it")
    return found


def _told_by_program(text: str) -> Error:
    """Of 'error[CODE] WHERE: MESSAGE'; anything else is told as it is."""
    last = text.strip().splitlines()[-1] if text.strip() else "it ended without a word"
    head, bracket, rest = last.partition("] ")
    if not (head.startswith("error[") and bracket):
        return Error("usage.unavailable", "marketgen episodes", last)
    where, _, message = rest.partition(": ")
    return Error(head.removeprefix("error["), where, message)
