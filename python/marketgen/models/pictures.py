"""Pictures as somebody sends them, as arrays."""

from __future__ import annotations

import io
import warnings

import numpy as np

from ..errors import Error

MAX_PIXELS, FORMATS = 1 << 24, ("PNG", "JPEG")


class BadPicture(Exception):
    """What was sent is no picture that can be used; the text says why."""


def checked() -> None:
    """Raises Error usage.unavailable where Pillow is not there."""
    try:
        import PIL  # noqa: F401
    except ImportError:
        raise Error("usage.unavailable", "pillow", "models need it: pip install 'marketgen[models]'") from None


def picture_of(content: bytes) -> np.ndarray:
    """Colours (height, width, 3), bytes, of a PNG or JPEG; what is transparent stands on black. Raises BadPicture."""
    from PIL import Image, ImageOps

    if not content:
        raise BadPicture("the picture is empty")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of sizes, which are limited below
            opened = Image.open(io.BytesIO(content), formats=FORMATS)
            width, height = opened.size
            if width * height > MAX_PIXELS:
                raise BadPicture(f"the picture has {width} x {height} pixels; {MAX_PIXELS:,} are the most")
            return _colours(ImageOps.exif_transpose(opened))
    except BadPicture:
        raise
    except Image.UnidentifiedImageError:
        raise BadPicture("it is neither a PNG nor a JPEG picture") from None
    except Exception as fault:  # a broken file: OSError, SyntaxError, ValueError, struct.error, ...
        raise BadPicture(f"the picture is broken: {' '.join(str(fault).split())[:200]}") from None


def _colours(picture) -> np.ndarray:
    from PIL import Image

    if picture.mode in ("I;16", "I;16B", "I"):  # 16 bits of grey, which Pillow would clip
        picture = Image.fromarray((np.asarray(picture).astype(np.uint32) >> 8).astype(np.uint8))
    if "A" in picture.getbands() or "transparency" in picture.info:
        seen = picture.convert("RGBA")
        black = Image.new("RGBA", seen.size, (0, 0, 0, 255))
        picture = Image.alpha_composite(black, seen)
    return np.asarray(picture.convert("RGB"))


def resized(picture: np.ndarray, height: int, width: int, smooth: bool = False) -> np.ndarray:
    """`picture` (h, w, 3), bytes, at another size: bilinear over all the pixels that become one; `smooth`: bicubic."""
    from PIL import Image

    if picture.shape[:2] == (height, width):
        return picture
    how = Image.Resampling.BICUBIC if smooth else Image.Resampling.BILINEAR
    return np.asarray(Image.fromarray(picture).resize((width, height), how))
