"""Photos of shops: what they say of materials, light, aisles and shelves."""

from __future__ import annotations

import json
from typing import Any

from . import _core, arguments
from .arguments import PathLike


def read_photo(path: PathLike) -> dict[str, Any]:
    """What a photo of a shop says, as a row of photos.json has it (docs/photos.md).

    path  PNG or JPEG of at least 64 x 64 pixels

    `subject` says whether it is a "room", a "drawing" or something "other", with `subject_confidence`; `attributes` has the value of
    "floor", "lamps", "aisle" and so on with its `confidence`: from 0.5 on generate() relies on it. `palette` has its colours.
    Raises Error input.not_found, image.bad_file, image.too_small, input.too_large.
    """
    return json.loads(_core.read_photo(arguments.a_path("path", path)))
