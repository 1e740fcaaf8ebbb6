"""Pictures as videos: one an episode while it is recorded, then as many as fit in one file, copied without loss.

Frame n of a video is shown at exactly n / fps. No frame depends on a later one, and every second can be begun at, so that a reader
that jumps about decodes two at most. One thread encodes: the bytes do not depend on how many cores there are.
"""

from __future__ import annotations

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
PIX_FMT = "yuv420p"  # what every player and browser shows
RESAMPLING = "AREA"  # of colours, which are kept for four pixels together
# By the name that users give; what each decodes as, its encoder, and settings that keep 38 dB of our pictures, shelf labels and all.
CODECS: dict[str, tuple[str, dict[str, str]]] = {
    "h264": ("libx264", {"crf": "14", "preset": "veryfast", "bf": "0", "threads": "1"}),
    "av1": ("libsvtav1", {"crf": "14", "preset": "10", "svtav1-params": "lp=1"}),
}


def _stream_of(container: av.container.OutputContainer, codec: str, size: tuple[int, int], fps: int) -> Any:
    encoder, options = CODECS[codec]
    stream = container.add_stream(encoder, rate=fps, options={**options, "g": str(KEY_EVERY)})
    stream.width, stream.height, stream.pix_fmt = *size, PIX_FMT
    stream.time_base = fractions.Fraction(1, fps)
    return stream


class Encoder:
    """One camera's video of one episode, in memory: an episode of three minutes is some 30 MB."""

    def __init__(self, codec: str, size: tuple[int, int], fps: int):
        import av

        self._frame_of = av.VideoFrame.from_ndarray
        self._bytes = io.BytesIO()
        self._container = av.open(self._bytes, "w", format="mp4")
        self._stream = _stream_of(self._container, codec, size, fps)
        self._step, self._count = fractions.Fraction(1, fps), 0

    def add(self, rgb: np.ndarray) -> None:
        """(height, width, 3) uint8."""
        frame = self._frame_of(rgb, format="rgb24").reformat(format=PIX_FMT, interpolation=RESAMPLING)
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
    _, options = CODECS[codec]
    return {
        "video.height": height,
        "video.width": width,
        "video.codec": codec,
        "video.pix_fmt": PIX_FMT,
        "video.fps": fps,
        "video.channels": 3,
        "video.g": KEY_EVERY,
        "video.crf": int(options["crf"]),
        "is_depth_map": False,
        "has_audio": False,
    }
