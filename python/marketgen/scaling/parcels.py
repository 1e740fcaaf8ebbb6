"""Files and folders as bytes, for machines that share no disk. Equal files make equal bytes."""

from __future__ import annotations

import gzip
import hashlib
import io
import json
import os
import pathlib
import shutil
import tarfile
from collections.abc import Iterable

from ..recording.outputs import writing


def packed(root: pathlib.Path, files: Iterable[pathlib.Path] | None = None) -> bytes:
    """`files` below `root`, or all that is there; their names, contents and whether they may be executed, nothing else."""
    chosen = sorted(root.rglob("*")) if files is None else sorted(files)
    parcel = io.BytesIO()
    with tarfile.open(fileobj=parcel, mode="w", format=tarfile.PAX_FORMAT) as tar:
        for file in chosen:
            if not file.is_file():
                continue
            entry = tarfile.TarInfo(file.relative_to(root).as_posix())
            entry.size, entry.mode = file.stat().st_size, 0o755 if os.access(file, os.X_OK) else 0o644
            with open(file, "rb") as told:
                tar.addfile(entry, told)
    return parcel.getvalue()


def unpacked(parcel: bytes, into: pathlib.Path) -> pathlib.Path:
    """`into`, which appears whole, by a rename; where it is already it stays as it is. Raises Error io.cannot_write."""
    if into.exists():
        return into
    beside = into.with_name(f".{into.name}~part-{os.getpid()}")
    shutil.rmtree(beside, ignore_errors=True)
    with writing(into):
        beside.mkdir(parents=True)
        with tarfile.open(fileobj=io.BytesIO(parcel)) as tar:
            tar.extractall(beside, filter="data")
        beside.replace(into)
    return into


def episodes_parcel(path: str) -> tuple[bytes, int]:
    """A file of episodes with the scenes that its header names, and how many episodes it has. The file was found."""
    file = pathlib.Path(path)
    opened = gzip.open if file.suffix == ".gz" else open
    with opened(file, "rt", encoding="utf-8") as lines:
        header = json.loads(lines.readline())
        count = sum(1 for line in lines if line.strip())
    scenes = [(store.get("scene") or {}).get("file") for store in header.get("stores", [])]
    return packed(file.parent, [file, *(file.parent / scene for scene in scenes if scene)]), count


def hash_of(*things: bytes | str) -> str:
    """Of the contents, 16 hexadecimal digits."""
    digest = hashlib.sha256()
    for thing in things:
        data = thing.encode() if isinstance(thing, str) else thing
        digest.update(len(data).to_bytes(8, "little") + data)
    return digest.hexdigest()[:16]

