"""Logits of a decoder, 256 x 256 or so, at a picture's own pixels: bilinear, as the models' own code does it.

Both steps of SAM's way back (up to the encoder's input, without its padding, then to the picture) and the one step of SAM 2's are
linear and take rows and columns apart. So a mask at full size is `rows @ logits @ columns.T`, and of a small mask only its part.
"""

from __future__ import annotations

import dataclasses

import numpy as np

LINES = 4  # at a time: the first few mostly have something
EDGE = 1.0  # what is below -EDGE is outside, whichever threshold is asked about


def bilinear(size: int, of: int) -> np.ndarray:
    """(size, of): the shares with which `of` pixels in a row make `size`, pixels being areas and the ends repeated."""
    places = np.maximum((np.arange(size) + 0.5) * of / size - 0.5, 0.0)
    left = np.minimum(places.astype(int), of - 1)
    right = np.minimum(left + 1, of - 1)
    share = places - left
    made = np.zeros((size, of), dtype=np.float32)
    np.add.at(made, (np.arange(size), left), 1.0 - share)
    np.add.at(made, (np.arange(size), right), share)
    return made


@dataclasses.dataclass(frozen=True)
class Sampling:
    """rows (height, decoder's height) and columns (width, decoder's width) of a picture."""

    rows: np.ndarray
    columns: np.ndarray

    @property
    def size(self) -> tuple[int, int]:
        """Height and width of the picture."""
        return self.rows.shape[0], self.columns.shape[0]

    def part(self, logits: np.ndarray) -> Part | None:
        """What of the picture `logits` may be above -EDGE in; None: nothing."""
        above = logits > -EDGE
        inner_rows, inner_columns = np.flatnonzero(above.any(axis=1)), np.flatnonzero(above.any(axis=0))
        if inner_rows.size == 0:
            return None
        of_rows, rows = _reached(self.rows, inner_rows[0], inner_rows[-1])
        of_columns, columns = _reached(self.columns, inner_columns[0], inner_columns[-1])
        if rows.start == rows.stop or columns.start == columns.stop:
            return None  # in the padding alone
        taken = logits[of_rows, of_columns].astype(np.float32)  # a copy: the whole is let go
        return Part(rows, columns, self.rows[rows, of_rows], taken, self.columns[columns, of_columns])


@dataclasses.dataclass(frozen=True)
class Part:
    """A mask's logits not yet at the picture's pixels `rows` and `columns`; beyond these it is below -EDGE."""

    rows: slice
    columns: slice
    row_shares: np.ndarray
    taken: np.ndarray
    column_shares: np.ndarray

    def values(self) -> np.ndarray:
        """At the picture's pixels."""
        return self.row_shares @ self.taken @ self.column_shares.T

    def box(self) -> tuple[int, int, int, int] | None:
        """x, y, width and height of what is above 0, without most of the values; None: nothing is."""
        top = _first_on(self.row_shares, self.taken, self.column_shares)
        if top is None:
            return None
        below = _first_on(self.row_shares[::-1], self.taken, self.column_shares)
        left = _first_on(self.column_shares, self.taken.T, self.row_shares)
        right = _first_on(self.column_shares[::-1], self.taken.T, self.row_shares)
        height, width = len(self.row_shares) - top - below, len(self.column_shares) - left - right
        return int(self.columns.start) + left, int(self.rows.start) + top, width, height


def _first_on(across: np.ndarray, taken: np.ndarray, along: np.ndarray) -> int | None:
    """The first line across with anything above 0, found a few lines at a time."""
    for start in range(0, len(across), LINES):
        on = ((across[start : start + LINES] @ taken @ along.T) > 0).any(axis=1)
        if on.any():
            return start + int(on.argmax())
    return None


def _reached(shares: np.ndarray, low: int, high: int) -> tuple[slice, slice]:
    """The decoder's pixels that count for the picture's pixels that take from low..high, and these."""
    pixels = np.flatnonzero(shares[:, low : high + 1].any(axis=1))
    within = slice(pixels[0], pixels[-1] + 1) if pixels.size else slice(0, 0)
    taken = np.flatnonzero(shares[within].any(axis=0))
    return (slice(taken[0], taken[-1] + 1) if taken.size else slice(0, 0)), within


def padded(height: int, width: int, scaled: tuple[int, int], side: int, decoded: tuple[int, int]) -> Sampling:
    """Of SAM: the picture lies `scaled` (height, width) at the upper left of the encoder's square of `side`, the rest is padding."""
    sizes = zip((height, width), scaled, decoded, strict=True)
    rows, columns = (bilinear(size, inner) @ bilinear(side, coarse)[:inner] for size, inner, coarse in sizes)
    return Sampling(rows, columns)


def stretched(height: int, width: int, decoded: tuple[int, int]) -> Sampling:
    """Of SAM 2: the picture fills the encoder's square, whatever its shape."""
    return Sampling(bilinear(height, decoded[0]), bilinear(width, decoded[1]))
