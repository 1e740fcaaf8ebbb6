"""Segmenters that two ONNX files are, an encoder and a decoder: which family, pictures in, logits of masks out.

SAM        the decoder of facebookresearch/segment-anything's export; the encoder gives one array
MobileSAM  the same decoder, another encoder
SAM 2      the encoder also gives features of higher resolution, which the decoder takes

What a picture becomes is said by the encoder's input. Its place in the encoder's square: SAM scales the longer side to the square's and
pads the rest at the right and below; SAM 2 stretches both sides. Values: an input with channels first (N, 3, H, W) of floats takes
them less the mean and by the deviation that all three were trained with; one with channels last ((H, W, 3), (N, H, W, 3)), or of
bytes, takes 0 to 255 as they are, since such exports have that step inside.
"""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from ..arguments import PathLike
from ..errors import Error
from . import pictures, sampling
from .sampling import Sampling
from .sessions import OnnxModel, Port, Stopped

SIDE = 1024  # of the encoder's square where its file leaves it open
MEAN, DEVIATION = np.array([123.675, 116.28, 103.53], np.float32), np.array([58.395, 57.12, 57.375], np.float32)
HIGH = ("high_res_feats_0", "high_res_feats_1")
PROMPT = ("point_coords", "point_labels", "mask_input", "has_mask_input")
SAM_TAKES, SAM2_TAKES = ("image_embeddings", *PROMPT, "orig_im_size"), ("image_embed", *HIGH, *PROMPT)
NEEDED = (
    f"SAM and MobileSAM: an encoder that takes a picture and gives image_embeddings, a decoder that takes {', '.join(SAM_TAKES)} and gives "
    f"low_res_masks, iou_predictions. SAM 2: an encoder that gives image_embed, {', '.join(HIGH)}, a decoder that takes "
    f"{', '.join(SAM2_TAKES)} and gives masks, iou_predictions"
)
MOBILE_MARK = b"local_conv"  # a layer of MobileSAM's encoder, TinyViT; exports keep the names of layers
FOREGROUND, PADDING = 1.0, -1.0  # labels of points
ALIKE = 1e-2  # of logits of one point alone and beside others


@dataclasses.dataclass(frozen=True)
class Encoded:
    """A picture as the decoder takes it."""

    features: dict[str, np.ndarray]
    size: tuple[int, int]
    scale: tuple[float, float]  # from the picture's pixels to those of the encoder's square: x, y
    sampling: Sampling


class Segmenter:
    """A SAM, MobileSAM or SAM 2.

    family  "sam", "mobile_sam" or "sam2"

    Raises Error as OnnxModel, and model.bad_file: the files are none of these, or do not fit together.
    """

    def __init__(self, encoder: PathLike, decoder: PathLike, threads: int = 0):
        pictures.checked()
        self.encoder = OnnxModel("--sam-encoder", encoder, threads)
        self.decoder = OnnxModel("--sam-decoder", decoder, threads)
        self.family = _family(self.encoder, self.decoder)
        self._sam2 = self.family == "sam2"
        self._input = next(iter(self.encoder.inputs.values()))
        self._layout = _Layout.of(self.encoder, self._input)
        self._logits = "masks" if self._sam2 else "low_res_masks"
        # Of the decoder's inputs the encoder's outputs.
        self._features = {name: name for name in ("image_embed", *HIGH)} if self._sam2 else {"image_embeddings": _embedding(self.encoder)}
        self.many_points = False
        self._try()

    def stop(self) -> None:
        self.encoder.stop()
        self.decoder.stop()

    def files(self) -> list[dict[str, Any]]:
        return [*self.encoder.files(), *self.decoder.files()]

    def encode(self, picture: np.ndarray) -> Encoded:
        """Of colours (height, width, 3), bytes."""
        height, width = picture.shape[:2]
        side = self._layout.side
        scaled = (side, side) if self._sam2 else _longest(height, width, side)
        value = self._layout.value(pictures.resized(picture, *scaled), fixed=self._input)
        arrays = self.encoder.run({self._input.name: value}, list(self._features.values()))
        features = dict(zip(self._features, arrays, strict=True))
        decoded = self._decoded(features)
        back = sampling.stretched(height, width, decoded) if self._sam2 else sampling.padded(height, width, scaled, side, decoded)
        return Encoded(features, (height, width), (scaled[1] / width, scaled[0] / height), back)

    def _decoded(self, features: dict[str, np.ndarray]) -> tuple[int, int]:
        """Height and width of the decoder's masks: four times the embedding's, in all three families."""
        height, width = next(iter(features.values())).shape[-2:]
        return 4 * height, 4 * width

    def decode(self, encoded: Encoded, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Of points (n, 2), x and y in the picture's pixels, each alone: logits (n, masks, height, width) and predicted IoU (n, masks).

        A mask for the whole, a part and a part of it each; a decoder that was exported to give one gives one.
        """
        groups = [points] if self.many_points else np.split(points, len(points))
        made = [self._decode(encoded, group) for group in groups]
        logits, quality = (np.concatenate(arrays) for arrays in zip(*made, strict=True))
        # The first of four is meant for prompts of several points; of one point the others are better (the paper's section 3).
        return (logits[:, 1:], quality[:, 1:]) if logits.shape[1] == 4 else (logits, quality)

    def _decode(self, encoded: Encoded, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        count = len(points)
        at = (points * np.asarray(encoded.scale))[:, None, :]
        labels = np.full((count, 1), FOREGROUND)
        feeds = dict(encoded.features)
        if not self._sam2:  # its export leaves to the caller what SAM 2's does itself: a point that is none stands for "no box"
            at, labels = np.pad(at, ((0, 0), (0, 1), (0, 0))), np.pad(labels, ((0, 0), (0, 1)), constant_values=PADDING)
            feeds["orig_im_size"] = np.array(encoded.size)
        masks = count if _takes_many(self.decoder.inputs["mask_input"]) else 1
        feeds |= {"point_coords": at, "point_labels": labels, "has_mask_input": np.zeros(1)}
        feeds["mask_input"] = np.zeros((masks, 1, *self._decoded(encoded.features)))
        logits, quality = self.decoder.run(feeds, [self._logits, "iou_predictions"])
        return logits, quality

    def _try(self) -> None:
        """Once with a picture of two colours: the two files fit together, and whether the decoder takes several points at a time."""
        picture, points = np.full((16, 16, 3), 32, np.uint8), np.array([[4.0, 8.0], [12.0, 8.0]])
        picture[:, 8:] = 224
        try:
            encoded = self.encode(picture)
            alone, quality = self.decode(encoded, points)
        except Stopped:
            raise
        except Exception as fault:
            told = " ".join(str(fault).split())[:300]
            raise Error("model.bad_file", self.decoder.file, f"it does not run with {self.encoder.file}: {told}") from None
        decoded = encoded.sampling.rows.shape[1], encoded.sampling.columns.shape[1]
        if alone.ndim != 4 or alone.shape[-2:] != decoded or quality.shape != alone.shape[:2]:
            found = f"{self._logits} of {_times(alone.shape)}, iou_predictions of {_times(quality.shape)}"
            raise Error("model.bad_file", self.decoder.file, f"it gives {found}; expected masks of {_times(decoded)} and a number for each")
        if _takes_many(self.decoder.inputs["point_coords"]):
            self.many_points = self._many_alike(encoded, points, alone, quality)

    def _many_alike(self, encoded: Encoded, points: np.ndarray, alone: np.ndarray, quality: np.ndarray) -> bool:
        """Whether two points at a time give what they give alone: some exports say that they take many, and mix or refuse them."""
        self.many_points = True
        try:
            together, both = self.decode(encoded, points)
        except Stopped:
            raise
        except Exception:  # of many kinds, none of them public
            return False
        finally:
            self.many_points = False
        same_shape = together.shape == alone.shape and both.shape == quality.shape
        return same_shape and np.allclose(together, alone, atol=ALIKE, rtol=ALIKE) and np.allclose(both, quality, atol=ALIKE)


@dataclasses.dataclass(frozen=True)
class _Layout:
    """How an encoder takes a picture."""

    side: int
    channels_last: bool
    raw: bool
    batch: bool

    @staticmethod
    def of(encoder: OnnxModel, port: Port) -> _Layout:
        shape = port.shape
        last = len(shape) in (3, 4) and shape[-1] == 3
        first = len(shape) == 4 and shape[1] in (3, None) and not last
        if not (last or first) or np.issubdtype(port.dtype, np.signedinteger):
            expected = "a picture as (N, 3, H, W), (N, H, W, 3) or (H, W, 3), floats or bytes"
            raise Error("model.bad_file", encoder.file, f"it takes {port}; an encoder takes {expected}")
        height, width = shape[-3:-1] if last else shape[-2:]
        if (height or width or SIDE) != (width or height or SIDE):
            raise Error("model.bad_file", encoder.file, f"it takes {port}; its sides would have to be the same")
        return _Layout(height or width or SIDE, last, last or port.dtype == np.uint8, len(shape) == 4)

    def value(self, scaled: np.ndarray, fixed: Port) -> np.ndarray:
        """Of colours (height, width, 3) at the size that they have in the encoder's square."""
        made = scaled.astype(np.float32)
        if not self.raw:
            made = (made - MEAN) / DEVIATION
        rest = self.side - made.shape[0], self.side - made.shape[1]
        open_sides = self.channels_last and None in fixed.shape[-3:-1]  # it pads by itself
        if any(rest) and not open_sides:
            square = np.zeros((self.side, self.side, 3), np.float32)
            if self.raw:
                square += np.round(MEAN)  # what becomes 0 inside, as the padding of the others is
            square[: made.shape[0], : made.shape[1]] = made
            made = square
        made = made if self.channels_last else made.transpose(2, 0, 1)
        return made[None] if self.batch else made


def _longest(height: int, width: int, side: int) -> tuple[int, int]:
    """Height and width with the longer one at `side`."""
    scale = side / max(height, width)
    return max(1, int(height * scale + 0.5)), max(1, int(width * scale + 0.5))


def _takes_many(port: Port) -> bool:
    return port.shape[:1] == (None,)


def _times(shape: tuple[int, ...]) -> str:
    return " x ".join(map(str, shape))


def _family(encoder: OnnxModel, decoder: OnnxModel) -> str:
    takes, gives = set(decoder.inputs), set(decoder.outputs)
    fits_sam2 = takes == set(SAM2_TAKES) and {"masks", "iou_predictions"} <= gives and {"image_embed", *HIGH} <= set(encoder.outputs)
    fits_sam = takes == set(SAM_TAKES) and {"low_res_masks", "iou_predictions"} <= gives and _embedding(encoder) is not None
    if len(encoder.inputs) == 1 and fits_sam2:
        return "sam2"
    if len(encoder.inputs) == 1 and fits_sam:
        return "mobile_sam" if encoder.mentions(MOBILE_MARK) else "sam"
    raise Error("model.bad_file", encoder.file, f"no segmenter that is known here. Found: {encoder}; {decoder}. Needed: {NEEDED}")


def _embedding(encoder: OnnxModel) -> str | None:
    """The name of the array that a decoder of SAM takes as image_embeddings; exports call it by several."""
    if "image_embeddings" in encoder.outputs:
        return "image_embeddings"
    names = [name for name, port in encoder.outputs.items() if len(port.shape) == 4]
    return names[0] if len(names) == 1 and len(encoder.outputs) == 1 else None
