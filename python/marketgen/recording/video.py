"""Pictures as videos: one an episode while it is recorded, then as many as fit in one file, copied without loss.

Frame n of a video is shown at exactly n / fps. No frame depends on a later one, and every second can be begun at, so that a reader
that jumps about decodes two at most. One thread encodes a video: the bytes do not depend on how many cores there are.
"""

from __future__ import annotations

import dataclasses
import fractions
import io
import pathlib
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import Error
from .outputs import writing

if TYPE_CHECKING:
    import av

KEY_EVERY = 2  # frames, as LeRobot has it
RESAMPLING = "AREA"  # of colours that are kept for four pixels together


@dataclasses.dataclass(frozen=True)
class Codec:
    """An encoder of FFmpeg and its settings."""

    encoder: str
    pix_fmt: str
    options: dict[str, str]


# By the names that users give, as what each decodes as. Of shelves full of labels yuv420p, colours for four pixels together, keeps no
# more than 34 to 37 dB however many bits it has; it is what LeRobot writes and browsers show, and SVT-AV1 has nothing else.
# yuv444p with these settings keeps at least 38 dB from 64x64 on (docs/figures.md).
CODECS = {
    "h264": Codec("libx264", "yuv444p", {"crf": "12", "preset": "ultrafast", "tune": "psnr", "bf": "0", "threads": "1"}),
    "av1": Codec("libsvtav1", "yuv420p", {"crf": "14", "preset": "10", "svtav1-params": "lp=1"}),
}


def _stream_of(container: av.container.OutputContainer, codec: Codec, size: tuple[int, int], fps: int) -> Any:
    stream = container.add_stream(codec.encoder, rate=fps, options={**codec.options, "g": str(KEY_EVERY)})
    stream.width, stream.height, stream.pix_fmt = *size, codec.pix_fmt
    stream.time_base = fractions.Fraction(1, fps)
    return stream


class Encoder:
    """One camera's video of one episode, in memory: an episode of three minutes is some 30 MB."""

    def __init__(self, codec: str, size: tuple[int, int], fps: int):
        import av

        self._frame_of = av.VideoFrame.from_ndarray
        self._converted = av.video.reformatter.VideoReformatter().reformat  # a new one for each frame costs as much as encoding it
        self._bytes = io.BytesIO()
        self._container = av.open(self._bytes, "w", format="mp4")
        self._codec = CODECS[codec]
        self._stream = _stream_of(self._container, self._codec, size, fps)
        self._step, self._count = fractions.Fraction(1, fps), 0

    def add(self, rgb: np.ndarray) -> None:
        """(height, width, 3) uint8."""
        frame = self._converted(self._frame_of(rgb, format="rgb24"), format=self._codec.pix_fmt, interpolation=RESAMPLING)
        frame.pts, frame.time_base = self._count, self._step
        self._count += 1
        self._container.mux(self._stream.encode(frame))

    def finish(self) -> bytes:
        self._container.mux(self._stream.encode())
        self._container.close()
        return self._bytes.getvalue()

    def close(self) -> None:
        """Without a video."""
        self._container.close()


def join(videos: Sequence[pathlib.Path], path: pathlib.Path, fps: int) -> None:
    """One file of videos of the same camera and codec, frame by frame as they are, one after another."""
    import av

    with writing(path):
        path.parent.mkdir(parents=True, exist_ok=True)
        with av.open(str(path), "w", format="mp4", options={"movflags": "+faststart"}) as joined:
            stream, frames = None, 0
            for video in videos:
                with av.open(str(video)) as one:
                    [source] = one.streams.video
                    if stream is None:
                        stream = joined.add_stream_from_template(source)
                        stream.time_base = source.time_base
                    begin = frames / (fps * source.time_base)
                    for packet in one.demux(source):
                        if packet.dts is None:  # the end
                            continue
                        packet.pts, packet.dts = packet.pts + int(begin), packet.dts + int(begin)
                        packet.stream = stream
                        joined.mux(packet)
                        frames += 1


def about_video(codec: str, size: tuple[int, int], fps: int) -> dict[str, Any]:
    """What info.json says of a camera's videos."""
    width, height = size
    made = CODECS[codec]
    return {
        "video.height": height,
        "video.width": width,
        "video.codec": codec,
        "video.pix_fmt": made.pix_fmt,
        "video.fps": fps,
        "video.channels": 3,
        "video.g": KEY_EVERY,
        "video.crf": int(made.options["crf"]),
        "is_depth_map": False,
        "has_audio": False,
    }
