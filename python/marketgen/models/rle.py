"""Masks as COCO writes them: lengths of runs column by column, packed into a text (https://cocodataset.org/#format-data)."""

from __future__ import annotations

import numpy as np

BITS, MORE, SIGN, FIRST = 5, 0x20, 0x10, 48  # of a letter: bits it holds, "another follows", their sign; the letter of 0


def coco_rle(mask: np.ndarray) -> dict[str, object]:
    """{"size": [height, width], "counts": text} of `mask` (height, width), truth values: what pycocotools' encode() gives."""
    return {"size": [int(side) for side in mask.shape], "counts": _packed(_runs(mask))}


def _runs(mask: np.ndarray) -> list[int]:
    """Lengths of what is off, on, off, ... down each column, one column after the other; the first may be 0."""
    pixels = np.asarray(mask, dtype=bool).ravel(order="F")
    changes = np.flatnonzero(pixels[1:] != pixels[:-1]) + 1
    bounds = np.concatenate([[0], changes, [pixels.size]])
    runs = np.diff(bounds).tolist()
    return [0, *runs] if pixels[0] else runs


def _packed(runs: list[int]) -> str:
    """From the fourth on as the difference to the run two before, which is small where neighbouring columns are alike."""
    letters = bytearray()
    for number, run in enumerate(runs):
        rest = run - runs[number - 2] if number > 2 else run
        more = True
        while more:
            low = rest & (MORE - 1)
            rest >>= BITS
            more = rest != (-1 if low & SIGN else 0)
            letters.append(FIRST + low + (MORE if more else 0))
    return letters.decode("ascii")
