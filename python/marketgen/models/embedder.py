"""Vectors of pictures and texts that can be compared: a model of CLIP's kind, as two ONNX files.

Pictures are prepared as CLIP's are: the shorter side to the model's, the middle of the longer one, its mean and deviation.
"""

from __future__ import annotations

import pathlib
from collections.abc import Sequence
from typing import Any

import numpy as np

from ..arguments import PathLike, a_path, existing
from ..errors import Error
from . import pictures
from .sessions import OnnxModel, Port, hashed

SIDE, MAX_TOKENS = 224, 77  # of CLIP, where a file leaves them open
MEAN = np.array([0.48145466, 0.4578275, 0.40821073], np.float32)
DEVIATION = np.array([0.26862954, 0.26130258, 0.27577711], np.float32)
END = "<|endoftext|>"  # of CLIP; what fills up is the same
IDS, ATTENTION = "input_ids", "attention_mask"


class ImageEmbedder:
    """--clip-image: takes (N, 3, H, W), gives image_embeds or one array (N, D). Raises Error as OnnxModel."""

    def __init__(self, file: PathLike, threads: int = 0):
        pictures.checked()
        self.model = OnnxModel("--clip-image", file, threads)
        self._input = next(iter(self.model.inputs.values()))
        self._output = _vectors(self.model, "image_embeds")
        shape = self._input.shape
        if len(self.model.inputs) != 1 or len(shape) != 4 or shape[1] not in (3, None) or not np.issubdtype(self._input.dtype, np.floating):
            raise _unknown(self.model, "one picture (N, 3, H, W) of floats, as pixel_values is")
        if (shape[2] or SIDE) != (shape[3] or SIDE):
            raise _unknown(self.model, "a square picture")
        self._side = shape[2] or SIDE
        self.width = self.vectors([np.zeros((8, 8, 3), np.uint8)]).shape[1]

    def files(self) -> list[dict[str, Any]]:
        return self.model.files()

    def vectors(self, shown: Sequence[np.ndarray]) -> np.ndarray:
        """(n, width), of length 1, of colours (height, width, 3), bytes. Raises Stopped."""
        values = np.stack([_prepared(picture, self._side) for picture in shown])
        return _run(self.model, {self._input.name: values}, self._output, self._input)


class TextEmbedder:
    """--clip-text with --tokenizer, a tokenizer.json: takes input_ids (and attention_mask), gives text_embeds or one array (N, D).

    Raises Error as OnnxModel, and usage.unavailable without the package tokenizers.
    """

    def __init__(self, file: PathLike, tokenizer: PathLike, threads: int = 0):
        self.model = OnnxModel("--clip-text", file, threads)
        self._output = _vectors(self.model, "text_embeds")
        names = set(self.model.inputs)
        if IDS not in names or names - {IDS, ATTENTION} or len(self.model.inputs[IDS].shape) != 2:
            raise _unknown(self.model, f"{IDS} (N, L), and {ATTENTION} at most")
        self._input = self.model.inputs[IDS]
        self._tokenizer = pathlib.Path(existing("--tokenizer", a_path("--tokenizer", tokenizer)))
        self._words = _tokenizer(self._tokenizer, self._input.shape[1])
        self.width = self.vectors(["a"]).shape[1]

    def files(self) -> list[dict[str, Any]]:
        return [*self.model.files(), hashed(self._tokenizer)]

    def vectors(self, texts: Sequence[str]) -> np.ndarray:
        """(n, width), of length 1. Of a text longer than the model takes its beginning. Raises Stopped."""
        read = self._words.encode_batch(list(texts))
        feeds = {IDS: np.array([text.ids for text in read]), ATTENTION: np.array([text.attention_mask for text in read])}
        return _run(self.model, {name: feeds[name] for name in self.model.inputs}, self._output, self._input)


def fit(image: ImageEmbedder | None, text: TextEmbedder | None) -> None:
    """Raises Error model.bad_file where the two cannot be compared."""
    if image and text and image.width != text.width:
        told = f"its vectors have {text.width} numbers, those of {image.model.file} {image.width}: they are of different models"
        raise Error("model.bad_file", text.model.file, told)


def _unknown(model: OnnxModel, expected: str) -> Error:
    return Error("model.bad_file", model.file, f"{model.flag} takes {expected}; found: {model}")


def _vectors(model: OnnxModel, name: str) -> str:
    flat = [port.name for port in model.outputs.values() if len(port.shape) == 2]
    if name in flat:
        return name
    if len(flat) == 1:
        return flat[0]
    raise Error("model.bad_file", model.file, f"{model.flag} gives {name}, or one array of two dimensions; found: {model}")


def _prepared(picture: np.ndarray, side: int) -> np.ndarray:
    height, width = picture.shape[:2]
    scale = side / min(height, width)
    if max(height, width) * scale > 16 * side:  # a thread of a picture: only its middle would be seen, and what is beside it costs
        keep = 16 * min(height, width)
        top, left = max(0, height - keep) // 2, max(0, width - keep) // 2
        picture = picture[top : top + keep, left : left + keep]
        height, width = picture.shape[:2]
    scaled = pictures.resized(picture, max(side, round(height * scale)), max(side, round(width * scale)), smooth=True)
    top, left = (scaled.shape[0] - side) // 2, (scaled.shape[1] - side) // 2
    middle = scaled[top : top + side, left : left + side].astype(np.float32)
    return ((middle / 255 - MEAN) / DEVIATION).transpose(2, 0, 1)


def _run(model: OnnxModel, feeds: dict[str, np.ndarray], output: str, first: Port) -> np.ndarray:
    """All at once where the file leaves their number open, else one by one."""
    count = len(next(iter(feeds.values())))
    step = count if first.shape[0] is None else 1
    parts = [model.run({name: value[i : i + step] for name, value in feeds.items()}, [output])[0] for i in range(0, count, step)]
    made = np.concatenate(parts).astype(np.float64)
    return made / np.maximum(np.linalg.norm(made, axis=1, keepdims=True), 1e-12)


def _tokenizer(file: pathlib.Path, length: int | None) -> Any:
    try:
        import tokenizers
    except ImportError:
        raise Error("usage.unavailable", "tokenizers", "--clip-text needs it: pip install 'marketgen[models]'") from None
    try:
        made = tokenizers.Tokenizer.from_file(str(file))
    except Exception as fault:  # the package raises Exception itself
        raise Error("model.bad_file", str(file), f"no tokenizer.json: {' '.join(str(fault).split())[:200]}") from None
    most = length or MAX_TOKENS
    filled = made.padding or {"pad_token": END, "pad_id": made.token_to_id(END) or 0}
    made.enable_truncation(max_length=most)
    made.enable_padding(length=length, pad_token=filled["pad_token"], pad_id=filled["pad_id"])
    return made
