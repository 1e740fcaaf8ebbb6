"""What datasets say of their numbers and pictures: least, most, mean, deviation and quantiles, all exact.

Numbers count once a frame. Pictures are counted by how often each of the 256 values stands in a channel, over all pixels, and told
from 0 to 1.
"""

from __future__ import annotations

import numpy as np

QUANTILES = {"q01": 0.01, "q10": 0.10, "q50": 0.50, "q90": 0.90, "q99": 0.99}
VALUES, CHANNELS = 256, 3  # of a picture

Statistics = dict[str, np.ndarray]


def of_numbers(rows: np.ndarray) -> Statistics:
    """(frames,) or (frames, numbers); of each number, in float64."""
    columns = [_of_column(column.astype(np.float64)) for column in rows.reshape(len(rows), -1).T]  # one by one: rows are many
    return {key: np.array([column[key] for column in columns]) for key in columns[0]} | {"count": np.array([len(rows)])}


def _of_column(values: np.ndarray) -> dict[str, float]:
    made = {"min": values.min(), "max": values.max(), "mean": values.mean(), "std": values.std()}
    return made | dict(zip(QUANTILES, np.quantile(values, list(QUANTILES.values())), strict=True))


class PictureCounts:
    """How often each value stands in each channel."""

    def __init__(self) -> None:
        self.frames, self.counts = 0, np.zeros((CHANNELS, VALUES), np.int64)

    def add(self, rgb: np.ndarray) -> None:
        """(height, width, 3) uint8."""
        self.frames += 1
        for channel in range(CHANNELS):
            self.counts[channel] += np.bincount(rgb[..., channel].ravel(), minlength=VALUES)

    def add_all(self, other: PictureCounts) -> None:
        self.frames += other.frames
        self.counts += other.counts

    def to_json(self) -> dict:
        return {"frames": self.frames, "counts": self.counts.tolist()}

    @classmethod
    def from_json(cls, told: dict) -> PictureCounts:
        made = cls()
        made.frames, made.counts = told["frames"], np.array(told["counts"], np.int64)
        return made

    def statistics(self) -> Statistics:
        """Each (3, 1, 1); `count` is that of frames."""
        values = np.arange(VALUES) / (VALUES - 1)
        total = self.counts.sum(1)
        mean = self.counts @ values / total
        variance = (self.counts * (values - mean[:, None]) ** 2).sum(1) / total
        seen = [values[counts > 0] for counts in self.counts]
        made = {
            "min": np.array([of_channel[0] for of_channel in seen]),
            "max": np.array([of_channel[-1] for of_channel in seen]),
            "mean": mean,
            "std": np.sqrt(variance),
        }
        made |= {name: np.array([_quantile(counts, q) for counts in self.counts]) for name, q in QUANTILES.items()}
        return {name: value.reshape(CHANNELS, 1, 1) for name, value in made.items()} | {"count": np.array([self.frames])}


def _quantile(counts: np.ndarray, q: float) -> float:
    """Between the two values in whose ranks it lies, as numpy.quantile has it."""
    until = counts.cumsum()
    rank = q * (until[-1] - 1)
    below, above = (int(np.searchsorted(until, at, side="right")) for at in (np.floor(rank), np.ceil(rank)))
    return (below + (above - below) * (rank - np.floor(rank))) / (VALUES - 1)
