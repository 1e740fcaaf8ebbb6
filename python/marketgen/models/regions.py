"""Small islands and holes of masks, after the paper's appendix B: a decoder leaves specks that nobody wants to grasp."""

from __future__ import annotations

import numpy as np


def without_small_regions(mask: np.ndarray, min_region_px: int) -> np.ndarray:
    """`mask` (height, width) with holes of fewer pixels filled and islands of fewer dropped; the largest island always stays.

    Pixels that touch by a corner belong together, those of holes as well.
    """
    if min_region_px <= 1 or not mask.any():
        return mask
    filled = mask | _where(~mask, lambda areas: areas < min_region_px)
    return _where(filled, lambda areas: (areas >= min_region_px) | (areas == areas.max()))


def _where(mask: np.ndarray, wanted) -> np.ndarray:
    """The regions of `mask` for whose areas `wanted` holds, a truth value each."""
    rows, starts, ends = _runs(mask)
    made = np.zeros(mask.shape, dtype=bool)
    if rows.size == 0:
        return made
    labels = _labels(rows, starts, ends, mask.shape[1])
    areas = np.bincount(labels, weights=ends - starts).astype(int)
    chosen = wanted(areas)[labels]
    edges = np.zeros((mask.shape[0], mask.shape[1] + 1), dtype=np.int8)
    edges[rows[chosen], starts[chosen]] = 1
    edges[rows[chosen], ends[chosen]] -= 1
    return np.cumsum(edges[:, :-1], axis=1, dtype=np.int8).astype(bool)


def _runs(mask: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Row, first column and the column after the last of each run within a row, in reading order."""
    edged = np.pad(mask, ((0, 0), (1, 1)))
    rows, columns = np.nonzero(edged[:, 1:] != edged[:, :-1])
    return rows[::2], columns[::2], columns[1::2]


def _labels(rows: np.ndarray, starts: np.ndarray, ends: np.ndarray, width: int) -> np.ndarray:
    """A number from 0 for each run; runs that touch, over however many others, have the same."""
    stride = width + 2  # a run's place as one number: no run reaches into the next row
    first = np.searchsorted(rows * stride + ends, (rows - 1) * stride + starts, side="left")
    last = np.searchsorted(rows * stride + starts, (rows - 1) * stride + ends, side="right")
    above = np.maximum(last - first, 0)
    here = np.repeat(np.arange(rows.size), above)
    there = np.arange(here.size) - np.repeat(np.cumsum(above) - above, above) + first[here]
    labels = np.arange(rows.size)
    while here.size:
        lower = np.minimum(labels[here], labels[there])
        before = labels.copy()
        np.minimum.at(labels, labels[here], lower)
        np.minimum.at(labels, labels[there], lower)
        labels = labels[labels]
        if np.array_equal(labels, before):
            break
    return np.unique(labels, return_inverse=True)[1]
