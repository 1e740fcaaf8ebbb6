"""ONNX files: what they take and give, and running them, one run at a time."""

from __future__ import annotations

import dataclasses
import hashlib
import mmap
import os
import pathlib
import re
import threading
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..arguments import PathLike, a_path
from ..errors import Error

PROVIDERS = ("CUDAExecutionProvider", "CPUExecutionProvider")  # the first that is there; the package onnxruntime-gpu has both
SILENT = 4  # ONNX Runtime also raises what it would print
TYPES = {
    "tensor(float)": np.float32,
    "tensor(float16)": np.float16,
    "tensor(double)": np.float64,
    "tensor(uint8)": np.uint8,
    "tensor(int32)": np.int32,
    "tensor(int64)": np.int64,
    "tensor(bool)": np.bool_,
}
LOCATION = re.compile(rb"\x0a\x08location\x12([\x01-\x7f])")  # of weights beside a file: the field, and its value's length


class Stopped(Exception):
    """The server ends; nothing is run any more."""


@dataclasses.dataclass(frozen=True)
class Port:
    """An input or output of a model: `shape` has a number, or None where a file leaves it open."""

    name: str
    shape: tuple[int | None, ...]
    dtype: Any

    def __str__(self) -> str:
        sides = " x ".join("?" if side is None else str(side) for side in self.shape)
        return f"{self.name} ({sides or 'one'}, {np.dtype(self.dtype).name})"


class OnnxModel:
    """One ONNX file, ready to run.

    Raises Error input.not_found, usage.unavailable (no ONNX Runtime), model.bad_file.
    """

    def __init__(self, flag: str, file: PathLike, threads: int = 0):
        self.flag, self.file = flag, a_path(flag, file)
        if not os.path.isfile(self.file):
            raise Error("input.not_found", self.file, f"{flag} names it, and it is no file")
        self._session = _session(self.file, threads)
        self._alone, self._stopping, self._run = threading.Lock(), False, None
        self.inputs = {port.name: port for port in map(self._port, self._session.get_inputs())}
        self.outputs = {port.name: port for port in map(self._port, self._session.get_outputs())}

    def _port(self, told: Any) -> Port:
        if told.type not in TYPES:
            raise Error("model.bad_file", self.file, f"{told.name} is {told.type}; it would have to be one of {', '.join(TYPES)}")
        shape = tuple(side if isinstance(side, int) and side > 0 else None for side in told.shape)
        return Port(told.name, shape, TYPES[told.type])

    @property
    def providers(self) -> list[str]:
        """Where ONNX Runtime runs it, the preferred first."""
        return list(self._session.get_providers())

    def run(self, feeds: Mapping[str, np.ndarray], outputs: Sequence[str]) -> list[np.ndarray]:
        """`outputs` by name. Others wait. Raises Stopped, and what ONNX Runtime raises."""
        import onnxruntime

        typed = {name: np.ascontiguousarray(value, dtype=self.inputs[name].dtype) for name, value in feeds.items()}
        with self._alone:
            options = self._run = onnxruntime.RunOptions()
            options.log_severity_level = SILENT
            options.only_execute_path_to_fetches = True  # SAM's decoder would also enlarge its masks
            if self._stopping:
                raise Stopped
            try:
                return self._session.run(list(outputs), typed, options)
            except Exception:
                if self._stopping:
                    raise Stopped from None
                raise

    def stop(self) -> None:
        """Ends the run under way, and all that wait; comes back when none is left."""
        self._stopping = True
        while not self._alone.acquire(timeout=0.1):
            if self._run is not None:
                self._run.terminate = True
        self._alone.release()

    def __str__(self) -> str:
        def told(ports):
            return ", ".join(map(str, ports.values())) or "nothing"

        return f"{self.file} takes {told(self.inputs)} and gives {told(self.outputs)}"

    def files(self) -> list[dict[str, Any]]:
        """{"file", "bytes", "sha256"} of it and of the weights that lie beside it."""
        home = pathlib.Path(self.file)
        beside = sorted({home.parent / name for name in _weights_beside(home)})
        return [hashed(path) for path in [home, *(path for path in beside if path.is_file())]]

    def mentions(self, text: bytes) -> bool:
        """Whether the file's bytes have `text`, as in the names of its nodes."""
        with _mapped(self.file) as content:
            return content.find(text) >= 0


def _session(file: str, threads: int) -> Any:
    try:
        import onnxruntime
    except ImportError:
        raise Error("usage.unavailable", "onnxruntime", "models need it: pip install 'marketgen[models]'") from None
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = threads  # 0: as many as there are cores
    options.log_severity_level = SILENT
    there = onnxruntime.get_available_providers()
    try:
        return onnxruntime.InferenceSession(file, options, providers=[name for name in PROVIDERS if name in there])
    except Exception as fault:  # of many kinds, none of them public
        told = " ".join(str(fault).split())[:300]
        raise Error("model.bad_file", file, f"ONNX Runtime {onnxruntime.__version__} cannot load it: {told}") from None


def _mapped(file: PathLike) -> mmap.mmap:
    with open(file, "rb") as opened:
        return mmap.mmap(opened.fileno(), 0, access=mmap.ACCESS_READ)


def _weights_beside(file: pathlib.Path) -> list[str]:
    """Names of files that hold what is too large for the model's own: a model's file is 2 GB at most."""
    with _mapped(file) as content:
        found = [(match.end(), match[1][0]) for match in LOCATION.finditer(content)]
        return [content[at : at + length].decode("utf-8", "replace") for at, length in found]


def hashed(path: pathlib.Path) -> dict[str, Any]:
    """{"file": its name, "bytes", "sha256"}."""
    digest = hashlib.sha256()
    with path.open("rb") as opened:
        while piece := opened.read(1 << 20):
            digest.update(piece)
    return {"file": path.name, "bytes": path.stat().st_size, "sha256": digest.hexdigest()}
