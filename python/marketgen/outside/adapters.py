"""Rows of adapters: what a model of others sees and says, in terms of an environment's observations and actions.

The program's own rows are data/policy_adapters.yaml; docs/remote.md has the fields.
"""

from __future__ import annotations

import dataclasses
import os
import pathlib
from collections.abc import Iterator
from typing import Any

from .. import _core, arguments
from ..errors import Error
from .fields import Fields, a_count, a_number, a_text, above_zero, one_of, texts, wrong_type

OWN_ROWS = "policy_adapters.yaml"
# What the numbers of a model's action are, and the control mode in which an environment executes them.
SPACES = {
    "joint_targets": "pd_joint_pos",
    "joint_deltas": "pd_joint_delta_pos",
    "tool_deltas": "pd_ee_delta_pose",
    "tool_moves": "pd_ee_delta_pos",
    "tool_targets": "pd_ee_delta_pos",  # places, to which Adaptation leads the tool by such steps
}
LAYOUTS, VALUES = ("hwc", "chw"), ("bytes", "shares")
ALL = ("all",)
MAX_SIDE_PX, MAX_CHUNK, MAX_BYTES = 4096, 10_000, 1 << 20


@dataclasses.dataclass(frozen=True)
class Picture:
    """A camera's colours."""

    camera: str


@dataclasses.dataclass(frozen=True)
class Numbers:
    """What the robot reads of itself, by name, times `scale` plus `offset`; ALL: everything, as datasets have it."""

    names: tuple[str, ...]
    scale: float = 1.0
    offset: float = 0.0


@dataclasses.dataclass(frozen=True)
class Words:
    """The episode's instruction."""


Leaf = Picture | Numbers | Words


@dataclasses.dataclass(frozen=True)
class ActionRow:
    """What the model answers.

    keys      of the arrays of its answer; side by side they are one step's numbers
    space     one of SPACES
    numbers   what these are, by the environment's names; "-": nothing; ALL: all of the environment's; none: all but "stop"
    unit_m, unit_rad  what 1 of the model stands for
    closed, open      the model's numbers for a tool's opening
    length    steps that an answer must have; None: any
    execute   how many of them are executed before the model is asked again; None: all
    """

    keys: tuple[str, ...]
    space: str
    numbers: tuple[str, ...]
    unit_m: float
    unit_rad: float
    closed: float
    open: float
    length: int | None
    execute: int | None


@dataclasses.dataclass(frozen=True)
class Adapter:
    """One row. `observation`: leaves by the model's names, nested as the model has them."""

    name: str
    about: str
    observation: dict[str, Any]
    size: tuple[int, int]
    layout: str
    values: str
    action: ActionRow

    def leaves(self) -> Iterator[Leaf]:
        return _leaves(self.observation)

    def options(self) -> dict[str, Any]:
        """Of the environments in which such a model acts (TaskOptions)."""
        cameras = tuple(dict.fromkeys(leaf.camera for leaf in self.leaves() if isinstance(leaf, Picture)))
        options: dict[str, Any] = {"control_mode": SPACES[self.action.space], "obs_mode": "rgbd" if cameras else "state_robot"}
        if cameras:
            options |= {"cameras": cameras, "width": self.size[0], "height": self.size[1]}
        return options


def _leaves(tree: dict[str, Any]) -> Iterator[Leaf]:
    for part in tree.values():
        if isinstance(part, dict):
            yield from _leaves(part)
        else:
            yield part


def adapter_named(text: str) -> Adapter:
    """ "ROW" of the program's own, "FILE.yaml:ROW", or "FILE.yaml" where it has one row.

    Raises Error usage.bad_flag, usage.unavailable, input.*, yaml.syntax, json.*.
    """
    file, colon, row = arguments.a_text("adapter", text).rpartition(":")
    if not colon and text.endswith((".yaml", ".yml")):
        file, row = text, ""
    elif not colon:
        file, row = os.path.join(_core.data_folder(), OWN_ROWS), text
    rows = read_rows(file)
    if not row and len(rows) == 1:
        return next(iter(rows.values()))
    return rows[arguments.a_name("adapter", row, tuple(rows))]


def read_rows(file: str) -> dict[str, Adapter]:
    """All rows of a file, checked."""
    document = _parsed(file)
    if not isinstance(document, dict) or not document:
        raise wrong_type(file, document, "rows with names")
    return {str(name): _row(str(name), row, f"{file}:/{name}") for name, row in document.items()}


def _parsed(file: str) -> Any:
    try:
        import yaml
    except ImportError:
        raise Error("usage.unavailable", "adapter", "rows of adapters need PyYAML: pip install 'marketgen[remote]'") from None
    path = pathlib.Path(arguments.existing("adapter", file))
    try:
        if path.stat().st_size > MAX_BYTES:
            raise Error("input.too_large", str(path), f"rows of adapters have at most {MAX_BYTES:,} bytes")
        text = path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise Error("input.not_utf8", str(path), "write it as UTF-8") from None
    except OSError as fault:
        raise Error("input.not_found", str(path), str(fault.strerror)) from None
    try:
        return yaml.load(text, _loader(yaml))
    except yaml.YAMLError as fault:
        mark = getattr(fault, "problem_mark", None)
        line = f":{mark.line + 1}" if mark else ""
        raise Error("yaml.syntax", f"{path}{line}", str(getattr(fault, "problem", None) or fault)) from None
    except RecursionError:
        raise Error("json.too_deep", str(path), "rows of adapters nest a few levels deep") from None


def _loader(yaml: Any) -> Any:
    """YAML's safe loader, to which a name that stands twice is an error, and so are aliases: a few lines of them are gigabytes."""

    class Loader(yaml.SafeLoader):
        def compose_node(self, parent: Any, index: Any) -> Any:
            if self.check_event(yaml.events.AliasEvent):
                raise yaml.composer.ComposerError(None, None, "aliases (*name) are not read here", self.peek_event().start_mark)
            return super().compose_node(parent, index)

        def construct_mapping(self, node: Any, deep: bool = False) -> Any:
            names = [key.value for key, _ in node.value]
            for number, (key, _) in enumerate(node.value):
                if key.value in names[:number]:
                    raise yaml.constructor.ConstructorError(None, None, f"{key.value!r} stands there twice", key.start_mark)
            return super().construct_mapping(node, deep)

    return Loader


def _row(name: str, document: Any, where: str) -> Adapter:
    fields = Fields(document, where)
    about = fields.take("about", a_text)
    observation = fields.take("observation", _tree)
    size, layout, values = fields.take("pictures", _pictures, ((0, 0), LAYOUTS[0], VALUES[0]))
    adapter = Adapter(name, about, observation, size, layout, values, fields.take("action", _action))
    fields.done()
    if any(isinstance(leaf, Picture) for leaf in adapter.leaves()) and not size[0]:
        raise Error("json.missing_field", where, '"pictures" is missing: how large they are')
    return adapter


def _tree(document: Any, where: str) -> dict[str, Any]:
    if not isinstance(document, dict) or not document:
        raise wrong_type(where, document, "fields with names")
    return {str(name): _branch(part, f"{where}/{name}") for name, part in document.items()}


def _branch(document: Any, where: str) -> Any:
    fields = Fields(document, where)
    leaf: Leaf
    if "picture" in fields:
        leaf = Picture(fields.take("picture", a_text))
    elif "numbers" in fields:
        leaf = Numbers(
            fields.take("numbers", _names), fields.take("scale", a_number, 1.0), fields.take("offset", a_number, 0.0)
        )
    elif "words" in fields:
        fields.take("words", one_of(("instruction",)))
        leaf = Words()
    else:
        return _tree(document, where)
    fields.done()
    return leaf


def _names(value: Any, where: str) -> tuple[str, ...]:
    return ALL if value == ALL[0] else texts(value, where)


def _pictures(document: Any, where: str) -> tuple[tuple[int, int], str, str]:
    fields = Fields(document, where)
    size = fields.take("size", _size)
    layout = fields.take("layout", one_of(LAYOUTS), LAYOUTS[0])
    values = fields.take("values", one_of(VALUES), VALUES[0])
    fields.done()
    return size, layout, values


def _size(value: Any, where: str) -> tuple[int, int]:
    if not isinstance(value, list) or len(value) != 2:
        raise wrong_type(where, value, "[width, height] in pixels")
    side = a_count(MAX_SIDE_PX)
    return side(value[0], f"{where}/0"), side(value[1], f"{where}/1")


def _action(document: Any, where: str) -> ActionRow:
    fields = Fields(document, where)
    closed, opened = fields.take("gripper", _gripper, (-1.0, 1.0))
    row = ActionRow(
        keys=fields.take("keys", texts),
        space=fields.take("space", one_of(tuple(SPACES))),
        numbers=fields.take("numbers", _names, ()),
        unit_m=fields.take("unit_m", above_zero, 1.0),
        unit_rad=fields.take("unit_rad", above_zero, 1.0),
        closed=closed,
        open=opened,
        length=fields.take("length", a_count(MAX_CHUNK), None),
        execute=fields.take("execute", a_count(MAX_CHUNK), None),
    )
    fields.done()
    if row.length is not None and row.execute is not None and row.execute > row.length:
        raise Error("json.out_of_range", f"{where}/execute", f"{row.execute} of {row.length} steps")
    return row


def _gripper(document: Any, where: str) -> tuple[float, float]:
    fields = Fields(document, where)
    closed, opened = fields.take("closed", a_number), fields.take("open", a_number)
    fields.done()
    if closed == opened:
        raise Error("json.out_of_range", where, f"closed and open are both {closed:g}")
    return closed, opened
