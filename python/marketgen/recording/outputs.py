"""How what is recorded comes onto the disk: whole or not at all, and a disk that is full is an error that names the file."""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
import pathlib
from collections.abc import Iterator
from typing import Any

from ..errors import Error


@contextlib.contextmanager
def writing(place: pathlib.Path) -> Iterator[None]:
    """What the system says against writing there, as Error io.cannot_write."""
    try:
        yield
    except OSError as fault:
        raise Error("io.cannot_write", str(place), fault.strerror or str(fault)) from fault


def on_disk(path: pathlib.Path) -> None:
    """A file or folder is where a power cut leaves it."""
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def write(path: pathlib.Path, data: bytes) -> None:
    """Beside, then renamed; the folders above are made."""
    part = path.with_name(f".{path.name}~part")
    with writing(path):
        path.parent.mkdir(parents=True, exist_ok=True)
        try:
            part.write_bytes(data)
            on_disk(part)
            part.replace(path)
        finally:
            part.unlink(missing_ok=True)


def write_json(path: pathlib.Path, value: Any) -> None:
    write(path, (json.dumps(value, indent=2, ensure_ascii=False, allow_nan=False) + "\n").encode())


@contextlib.contextmanager
def alone_in(folder: pathlib.Path) -> Iterator[None]:
    """While no other process records there. Raises Error io.in_use; a killed process leaves no lock."""
    with writing(folder):
        lock = os.open(folder / ".lock", os.O_RDWR | os.O_CREAT, 0o666)
    try:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise Error("io.in_use", str(folder), "another process records there: wait for it, or name another folder") from None
        yield
    finally:
        os.close(lock)
