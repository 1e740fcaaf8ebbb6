"""Files of episodes that were drawn, chosen or changed in Python."""

from __future__ import annotations

import json
import os
import pathlib
from collections.abc import Iterable, Mapping
from typing import Any

from . import arguments
from .arguments import PathLike
from .errors import Error


def write_episodes(file: PathLike, episodes: Iterable[Mapping[str, Any]], like: PathLike = "pool/checkout") -> None:
    """A file of market-episode/1 documents, as `marketgen episodes` writes them: for evaluate() and record().

    episodes  as env.unwrapped.episode has them; of the stores of `like`
    like      a file of episodes, or a set that comes with the program, whose stores and rows the new file has

    What is wrong with an episode is said by who reads the file. Raises Error usage.bad_flag, input.*, io.cannot_write.
    """
    rows = arguments.documents("episodes", episodes)
    if not rows:
        raise Error("usage.bad_flag", "episodes", "there is none")
    path = pathlib.Path(os.path.abspath(arguments.a_path("file", file)))
    with open(arguments.episodes_path("like", like), encoding="utf-8") as other:
        header = json.loads(other.readline()) | {"episodes": len(rows)}
    beside = path.with_name(path.name + ".part")
    try:
        beside.write_text("".join(json.dumps(line) + "\n" for line in (header, *rows)), encoding="utf-8")
        os.replace(beside, path)
    except OSError as fault:
        beside.unlink(missing_ok=True)
        raise Error("io.cannot_write", str(path), str(fault.strerror)) from None
