"""Masks of everything in a picture: a decoder is asked at a grid of points, and what it is not sure of or says twice goes.

The algorithm of Kirillov et al., Segment Anything, 2023, appendix B, without crops of the picture.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from typing import Any

import numpy as np

from .families import Encoded, Segmenter
from .regions import without_small_regions
from .sampling import EDGE

POINTS_AT_ONCE = 64
MIN_PREDICTED_IOU = {"sam": 0.88, "mobile_sam": 0.88, "sam2": 0.8}  # what the models' own generators take
MAX_POINTS_PER_SIDE = 128


@dataclasses.dataclass(frozen=True)
class Rules:
    """How masks are asked for and which are kept.

    points_per_side    of the grid
    min_predicted_iou  what the decoder thinks of its mask
    min_stability      IoU of the masks at logits above EDGE and above -EDGE
    max_box_iou        of two masks' boxes; with more the one that the decoder thinks less of goes
    min_region_px      smaller islands and holes go
    """

    points_per_side: int = 32
    min_predicted_iou: float = 0.88
    min_stability: float = 0.95
    max_box_iou: float = 0.7
    min_region_px: int = 100


@dataclasses.dataclass(frozen=True)
class Mask:
    """pixels (height, width), truth values; box: x, y, width, height of what is on."""

    pixels: np.ndarray
    area: int
    box: tuple[int, int, int, int]
    predicted_iou: float
    stability_score: float


@dataclasses.dataclass(frozen=True)
class _Found:
    """A mask as it came from the decoder: `part` is what `rows` and `columns` of the picture show."""

    rows: slice
    columns: slice
    part: np.ndarray
    predicted_iou: float
    stability_score: float


def masks_of(segmenter: Segmenter, picture: np.ndarray, rules: Rules) -> list[Mask]:
    """Of colours (height, width, 3), bytes: those the decoder is surest of first. Raises Stopped."""
    encoded = segmenter.encode(picture)
    points = grid(rules.points_per_side) * (picture.shape[1], picture.shape[0])
    found = [one for start in range(0, len(points), POINTS_AT_ONCE) for one in _at(segmenter, encoded, points[start : start + POINTS_AT_ONCE], rules)]
    found.sort(key=lambda one: -one.predicted_iou)  # a stable order: of equals the earlier point
    boxes = np.array([_box(one.part, one.rows.start, one.columns.start) for one in found]).reshape(-1, 4)
    first = [found[i] for i in kept_boxes(boxes, rules.max_box_iou)]
    return _cleaned(first, picture.shape[:2], rules)


def grid(per_side: int) -> np.ndarray:
    """(per_side ** 2, 2): x and y in shares of the picture, in the middles of as many equal fields."""
    places = (np.arange(per_side) + 0.5) / per_side
    return np.stack(np.meshgrid(places, places), axis=-1).reshape(-1, 2)


def _at(segmenter: Segmenter, encoded: Encoded, points: np.ndarray, rules: Rules) -> Iterator[_Found]:
    logits, quality = segmenter.decode(encoded, points)
    for point, mask in zip(*np.nonzero(quality > rules.min_predicted_iou), strict=True):
        placed = encoded.sampling.part(logits[point, mask])
        if placed is None:
            continue
        rows, columns, values = placed
        stability = _stability(values)
        part = values > 0
        if stability >= rules.min_stability and part.any():
            yield _Found(rows, columns, part, float(quality[point, mask]), stability)


def _stability(values: np.ndarray) -> float:
    """The larger mask contains the smaller one, so that their IoU is one count by the other."""
    larger = np.count_nonzero(values > -EDGE)
    return np.count_nonzero(values > EDGE) / larger if larger else 0.0


def _cleaned(found: list[_Found], size: tuple[int, int], rules: Rules) -> list[Mask]:
    """Without small regions; what is twice there by that goes, those first that were changed."""
    made, changed = [], []
    for one in found:
        pixels = np.zeros(size, dtype=bool)
        pixels[one.rows, one.columns] = one.part
        clean = without_small_regions(pixels, rules.min_region_px)
        box = _box(clean, 0, 0)
        made.append(Mask(clean, int(np.count_nonzero(clean)), box, one.predicted_iou, one.stability_score))
        changed.append(not np.array_equal(clean, pixels))
    order = sorted(range(len(made)), key=lambda i: changed[i])
    boxes = np.array([made[i].box for i in order]).reshape(-1, 4)
    kept = sorted(order[i] for i in kept_boxes(boxes, rules.max_box_iou))
    return [made[i] for i in kept]


def _box(part: np.ndarray, top: int, left: int) -> tuple[int, int, int, int]:
    """x, y, width and height of what is on in `part`, whose corner lies at (left, top)."""
    rows, columns = np.flatnonzero(part.any(axis=1)), np.flatnonzero(part.any(axis=0))
    x, y = int(columns[0]), int(rows[0])
    return left + x, top + y, int(columns[-1]) - x + 1, int(rows[-1]) - y + 1


def kept_boxes(boxes: np.ndarray, max_iou: float) -> list[int]:
    """Numbers of those of `boxes` (n, 4: x, y, width, height), best first, that overlap none before them by more than `max_iou`."""
    kept: list[int] = []
    lows, highs = boxes[:, :2].astype(float), boxes[:, :2] + boxes[:, 2:].astype(float)
    areas = np.prod(highs - lows, axis=1)
    left = np.ones(len(boxes), dtype=bool)
    for number in range(len(boxes)):
        if not left[number]:
            continue
        kept.append(number)
        shared = np.minimum(highs, highs[number]) - np.maximum(lows, lows[number])
        overlap = np.prod(np.maximum(shared, 0), axis=1)
        left &= ~(overlap > max_iou * (areas + areas[number] - overlap))
    return kept


def as_json(mask: Mask, segmentation: Any) -> dict[str, Any]:
    """As the models' own generators describe one; `segmentation`: its pixels, however they are written."""
    return {
        "segmentation": segmentation,
        "area": mask.area,
        "bbox": list(mask.box),
        "predicted_iou": round(mask.predicted_iou, 6),
        "stability_score": round(mask.stability_score, 6),
    }


