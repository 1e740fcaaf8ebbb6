"""The models of one server: each loaded or not, one request at a time in each, and what is told of them."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from typing import Any, TypeVar

import numpy as np

from .embedder import ImageEmbedder, TextEmbedder
from .families import Segmenter
from .masks import Mask, Rules, masks_of
from .sessions import OnnxModel

Model, Answer = TypeVar("Model"), TypeVar("Answer")


class NotLoaded(Exception):
    """A part that was asked for is not there; the text says which flag loads it."""


class Loaded:
    """What a server answers with. `masks`, `images`, `texts`: None where the server was started without them."""

    def __init__(self, masks: Segmenter | None, rules: Rules, images: ImageEmbedder | None, texts: TextEmbedder | None):
        self._masks, self._rules, self._images, self._texts = masks, rules, images, texts
        self._alone = {part: threading.Lock() for part in ("masks", "images", "texts")}
        self.health = self._told()

    def masks(self, picture: np.ndarray) -> list[Mask]:
        """Of colours (height, width, 3), bytes. Raises NotLoaded, Stopped."""
        return self._one_at_a_time("masks", self._masks, "--sam-encoder and --sam-decoder", lambda model: masks_of(model, picture, self._rules))

    def picture_vectors(self, pictures: Sequence[np.ndarray]) -> np.ndarray:
        """(n, width), of length 1. Raises NotLoaded, Stopped."""
        return self._one_at_a_time("images", self._images, "--clip-image", lambda model: model.vectors(pictures))

    def text_vectors(self, texts: Sequence[str]) -> np.ndarray:
        """(n, width), of length 1. Raises NotLoaded, Stopped."""
        return self._one_at_a_time("texts", self._texts, "--clip-text and --tokenizer", lambda model: model.vectors(texts))

    def _one_at_a_time(self, part: str, model: Model | None, flags: str, ask: Callable[[Model], Answer]) -> Answer:
        if model is None:
            raise NotLoaded(f"this server has no model for it: start it with {flags}")
        with self._alone[part]:
            return ask(model)

    def stop(self) -> None:
        """Ends what runs; comes back when nothing does."""
        for model in self._models():
            model.stop()

    def _models(self) -> list[OnnxModel]:
        segmenter = [self._masks.encoder, self._masks.decoder] if self._masks else []
        return [*segmenter, *(part.model for part in (self._images, self._texts) if part)]

    def _told(self) -> dict[str, Any]:
        masks, embed = None, None
        if self._masks:
            masks = {"family": self._masks.family, "files": self._masks.files(), "points_at_once": self._masks.many_points}
            masks |= {"rules": vars(self._rules), "runs_on": self._masks.encoder.providers}
        parts = {"image": self._images, "text": self._texts}
        if any(parts.values()):
            embed = {name: part and {"files": part.files(), "runs_on": part.model.providers} for name, part in parts.items()}
            embed["width"] = next(part.width for part in parts.values() if part)
        return {"ok": True, "masks": masks, "embed": embed}
