"""Checkpoints of LeRobot (PreTrainedPolicy.save_pretrained), in the policy's own process.

What one sees stands in its config.json: pictures by camera, the robot's numbers; so one that was trained on what
`python -m marketgen.record` wrote needs no row of adapters. Its own queue says how many steps of a chunk are executed.
"""

from __future__ import annotations

import dataclasses
import importlib.util
import json
import os
import pathlib
from typing import Any, ClassVar

import numpy as np

from .. import arguments
from ..errors import Error
from ..policy_process import PolicySource
from .acting import ModelActs
from .adapters import ALL, ActionRow, Adapter, Numbers, Picture, Words
from .fields import Fields, a_count, a_text, wrong_type

CONFIG, WEIGHTS = "config.json", "model.safetensors"
STATE, PICTURE, ACTION, TASK = "observation.state", "observation.images.", "action", "task"
KEY = "actions"  # of Checkpoint's answers
MAX_NUMBERS, MAX_SIDE_PX = 10_000, 4096


@dataclasses.dataclass(frozen=True)
class LerobotPolicy(PolicySource):
    """A checkpoint's folder."""

    folder: str
    adapter: Adapter
    name: str

    PREFIX: ClassVar[str] = "lerobot:"

    @classmethod
    def of_text(cls, text: str, adapter: Adapter | None) -> LerobotPolicy:
        """ "lerobot:FOLDER". Raises Error input.not_found, json.*, usage.unavailable."""
        folder = arguments.existing("policy", text.removeprefix(cls.PREFIX))
        made = adapter_of(folder)
        for module, package in (("torch", "torch"), ("lerobot", "lerobot")):
            if importlib.util.find_spec(module) is None:
                raise Error("usage.unavailable", package, "checkpoints of LeRobot need it: pip install lerobot")
        return cls(folder, adapter or made, f"lerobot({os.path.basename(folder)})")

    def folders(self) -> list[str]:
        return [self.folder]

    def load(self) -> ModelActs:
        return ModelActs(self.adapter, Checkpoint(self.folder))


def adapter_of(folder: str) -> Adapter:
    """The row that a checkpoint's own configuration makes. Raises Error input.not_found, json.*."""
    arguments.existing("policy", os.path.join(folder, WEIGHTS))
    file = arguments.existing("policy", os.path.join(folder, CONFIG))
    try:
        document = json.loads(pathlib.Path(file).read_text(encoding="utf-8"))
    except (UnicodeDecodeError, ValueError, RecursionError) as fault:
        raise Error("json.syntax", file, f"it is no checkpoint's configuration: {fault}") from None
    fields = Fields(document, f"{file}:")
    fields.take("type", a_text)
    seen = fields.take("input_features", _shapes)
    said = fields.take("output_features", _shapes)
    if ACTION not in said:
        raise Error("json.missing_field", f"{file}:/output_features", f'"{ACTION}" is missing: it is no policy that acts')
    observation, sizes = _observation(seen, f"{file}:/input_features")
    if len(sizes) > 1:
        raise Error("json.out_of_range", f"{file}:/input_features", f"pictures of sizes {sorted(sizes)}: all must be of one")
    action = ActionRow((KEY,), "joint_targets", ALL, 1.0, 1.0, -1.0, 1.0, 1, 1)
    return Adapter("checkpoint", file, {**observation, TASK: Words()}, next(iter(sizes), (0, 0)), "chw", "shares", action)


def _shapes(document: Any, where: str) -> dict[str, tuple[int, ...]]:
    if not isinstance(document, dict) or not document:
        raise wrong_type(where, document, "features by their names")
    return {name: Fields(feature, f"{where}/{name}").take("shape", _shape) for name, feature in document.items()}


def _shape(value: Any, where: str) -> tuple[int, ...]:
    if not isinstance(value, list):
        raise wrong_type(where, value, "a list of whole numbers")
    return tuple(a_count(MAX_NUMBERS)(side, f"{where}/{place}") for place, side in enumerate(value))


def _observation(shapes: dict[str, tuple[int, ...]], where: str) -> tuple[dict[str, Any], set[tuple[int, int]]]:
    """Leaves by name, and the sizes (width, height) of pictures."""
    leaves: dict[str, Any] = {}
    sizes = set()
    for name, shape in shapes.items():
        if name == STATE:
            leaves[name] = Numbers(ALL)
        elif name.startswith(PICTURE) and len(shape) == 3 and shape[0] == 3:
            leaves[name] = Picture(name.removeprefix(PICTURE))
            sizes.add((shape[2], shape[1]))
        else:
            raise Error("json.unknown_name", f"{where}/{name}", f"shape {shape}: expected {STATE}, or {PICTURE}CAMERA of 3 planes")
    return leaves, sizes


class Checkpoint:
    """A Model (acting.py): a policy of LeRobot with its processors, on the CPU, in one thread."""

    def __init__(self, folder: str):
        os.environ.update(HF_HUB_OFFLINE="1", TRANSFORMERS_OFFLINE="1")
        import torch
        from lerobot.configs.policies import PreTrainedConfig
        from lerobot.policies.factory import get_policy_class, make_pre_post_processors

        torch.set_num_threads(1)
        config = PreTrainedConfig.from_pretrained(folder)
        config.device = "cpu"
        self._torch = torch
        self._policy = get_policy_class(config.type).from_pretrained(folder, config=config)
        self._policy.eval()
        self._before, self._after = make_pre_post_processors(config, pretrained_path=folder)

    def begin(self) -> None:
        self._policy.reset()

    def infer(self, told: dict[str, Any]) -> dict[str, np.ndarray]:
        """One step: what remains of a chunk waits in the policy."""
        with self._torch.no_grad():
            action = self._policy.select_action(self._before({name: self._tensor(value) for name, value in told.items()}))
            return {KEY: self._after(action).cpu().numpy().reshape(1, -1)}

    def _tensor(self, value: Any) -> Any:
        return self._torch.from_numpy(np.ascontiguousarray(value)[None]) if isinstance(value, np.ndarray) else [value]

    def close(self) -> None:
        pass
