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
from .sampling import EDGE, Part

POINTS_AT_ONCE = 64
MIN_PREDICTED_IOU = {"sam": 0.88, "mobile_sam": 0.88, "sam2": 0.8}  # what the models' own generators take
MAX_POINTS_PER_SIDE = 64


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
    """A mask as it came from the decoder."""

    part: Part
    predicted_iou: float


def masks_of(segmenter: Segmenter, picture: np.ndarray, rules: Rules) -> list[Mask]:
    """Of colours (height, width, 3), bytes: those the decoder is surest of first. Raises Stopped."""
    encoded = segmenter.encode(picture)
    points = grid(rules.points_per_side) * (picture.shape[1], picture.shape[0])
    found: list[_Found] = []
    for start in range(0, len(points), POINTS_AT_ONCE):
        found += _at(segmenter, encoded, points[start : start + POINTS_AT_ONCE], rules)
    found.sort(key=lambda one: -one.predicted_iou)  # a stable order: of equals the earlier point
    return _cleaned(_once_each(found, picture.shape[:2], rules), rules)


def grid(per_side: int) -> np.ndarray:
    """(per_side ** 2, 2): x and y in shares of the picture, in the middles of as many equal fields."""
    places = (np.arange(per_side) + 0.5) / per_side
    return np.stack(np.meshgrid(places, places), axis=-1).reshape(-1, 2)


def _at(segmenter: Segmenter, encoded: Encoded, points: np.ndarray, rules: Rules) -> Iterator[_Found]:
    logits, quality = segmenter.decode(encoded, points)
    for point, mask in zip(*np.nonzero(quality > rules.min_predicted_iou), strict=True):
        part = encoded.sampling.part(logits[point, mask])
        if part is not None:
            yield _Found(part, float(quality[point, mask]))


def _once_each(found: list[_Found], size: tuple[int, int], rules: Rules) -> list[Mask]:
    """Those of `found`, best first, whose edges are sure and that no better one stands for.

    A mask that goes anyway is never brought to the picture's size: that takes longer than all else, and a third of a picture's
    points may lie on the same wall.
    """
    made = []
    boxes = _Boxes(rules.max_box_iou)
    for one in found:
        box = one.part.box()
        if box is None or boxes.overlap(box):
            continue
        values = one.part.values()
        stability = _stability(values)
        if stability >= rules.min_stability:
            boxes.add(box)
            pixels = np.zeros(size, dtype=bool)
            pixels[one.part.rows, one.part.columns] = values > 0
            made.append(Mask(pixels, int(np.count_nonzero(pixels)), box, one.predicted_iou, stability))
    return made


def _stability(values: np.ndarray) -> float:
    """The larger mask contains the smaller one, so that their IoU is one count by the other."""
    larger = np.count_nonzero(values > -EDGE)
    return float(np.count_nonzero(values > EDGE) / larger) if larger else 0.0


def _cleaned(masks: list[Mask], rules: Rules) -> list[Mask]:
    """Without small regions. Where two are the same by that, one goes that was changed."""
    made = [_without_small_regions(mask, rules.min_region_px) for mask in masks]
    order = sorted(range(len(made)), key=lambda i: made[i] is not masks[i])
    boxes = _Boxes(rules.max_box_iou)
    return [made[i] for i in sorted(i for i in order if boxes.add_new(made[i].box))]


def _without_small_regions(mask: Mask, min_region_px: int) -> Mask:
    pixels = without_small_regions(mask.pixels, min_region_px)
    if np.array_equal(pixels, mask.pixels):
        return mask
    return dataclasses.replace(mask, pixels=pixels, area=int(np.count_nonzero(pixels)), box=box_of(pixels))


def box_of(pixels: np.ndarray) -> tuple[int, int, int, int]:
    """x, y, width and height of what is on; something must be."""
    rows, columns = np.flatnonzero(pixels.any(axis=1)), np.flatnonzero(pixels.any(axis=0))
    x, y = int(columns[0]), int(rows[0])
    return x, y, int(columns[-1]) - x + 1, int(rows[-1]) - y + 1


class _Boxes:
    """Boxes (x, y, width, height) that are kept, none of which overlaps another by more than `max_iou`."""

    def __init__(self, max_iou: float):
        self._max_iou, self._kept = max_iou, np.zeros((0, 4))

    def overlap(self, box: tuple[int, int, int, int]) -> bool:
        one, kept = np.array(box, dtype=float), self._kept
        shared = np.minimum(kept[:, :2] + kept[:, 2:], one[:2] + one[2:]) - np.maximum(kept[:, :2], one[:2])
        both = np.prod(np.maximum(shared, 0), axis=1)
        either = np.prod(kept[:, 2:], axis=1) + np.prod(one[2:]) - both
        return bool((both > self._max_iou * either).any())

    def add(self, box: tuple[int, int, int, int]) -> None:
        self._kept = np.vstack([self._kept, box])

    def add_new(self, box: tuple[int, int, int, int]) -> bool:
        """Whether it is kept."""
        new = not self.overlap(box)
        if new:
            self.add(box)
        return new


def as_json(mask: Mask, segmentation: Any) -> dict[str, Any]:
    """As the models' own generators describe one; `segmentation`: its pixels, however they are written."""
    return {
        "segmentation": segmentation,
        "area": mask.area,
        "bbox": list(mask.box),
        "predicted_iou": round(mask.predicted_iou, 6),
        "stability_score": round(mask.stability_score, 6),
    }


