"""Pictures of stores: cameras, planes, annotations, many cameras at once."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from typing import Any, Literal

import numpy as np

from . import _core, arguments
from .arguments import MAX_SEED, Progress, bad
from ._core import Camera, Frame

Mode = Literal["sensor", "path"]
Quality = Literal["fast", "balanced", "best"]
MAX_SAMPLES, MAX_TIME_S, MAX_STOPS, MAX_ROW, MAX_PEOPLE = 2**31 - 1, 1e9, 100, 2**32 - 1, 200


def camera_from_dict(camera: Mapping[str, Any]) -> Camera:
    """A camera in any pose with its lens from market-camera/1 (docs/cameras.md): position_m, rotation_wxyz, fx, ..."""
    try:
        text = json.dumps({"schema": "market-camera/1", **camera})
    except (TypeError, ValueError) as fault:
        raise bad("camera", camera, f"a market-camera/1 document ({fault})") from None
    return Camera._from_json(text)


def camera_to_dict(camera: Camera) -> dict[str, Any]:
    """The camera as market-camera/1."""
    return json.loads(a_camera(camera)._to_json())


def a_camera(camera: Any) -> Camera:
    if not isinstance(camera, Camera):
        raise bad("camera", camera, "a Camera: of Store.camera(), Camera.look_at() or camera_from_dict()")
    return camera


def a_frame(frame: Any) -> Frame:
    if not isinstance(frame, Frame):
        raise bad("frame", frame, "a Frame: what Renderer.render() returned")
    return frame


class Renderer:
    """Draws one store. One thread at a time; every picture uses all cores.

    Several environments may share one: set_robots() and move() say how the world stands before each picture, and cost
    microseconds to a millisecond, whereas a second renderer costs a second and its own memory.
    """

    def __init__(self, handle: _core.Renderer):
        self._handle = handle

    def render(
        self,
        camera: Camera,
        *,
        mode: Mode = "sensor",
        quality: Quality = "balanced",
        samples: int = 0,
        time_s: float = 0,
        denoise: Literal["auto", "own", "neural", "none"] = "auto",
        exposure_stops: float = 0,
        progress: Progress | None = None,
    ) -> Frame:
        """One picture with all its planes.

        mode            "sensor": no noise, tens of milliseconds; "path": full light transport, seconds
        samples         path mode: paths a pixel; 0: what the quality says
        time_s          path mode: stop after this long; then not reproducible
        exposure_stops  path mode: brighter or darker than the store asks
        progress        as of generate()

        Raises Error camera.* for cameras that cannot see.
        """
        return self._handle._render(
            a_camera(camera),
            arguments.a_text("mode", mode),
            arguments.a_text("quality", quality),
            arguments.a_whole("samples", samples, 0, MAX_SAMPLES),
            arguments.a_number("time_s", time_s, 0, MAX_TIME_S),
            arguments.a_text("denoise", denoise),
            arguments.a_number("exposure_stops", exposure_stops, -MAX_STOPS, MAX_STOPS),
            arguments.a_progress(progress),
        )

    def with_noise(self, frame: Frame, camera: Camera, *, seed: int = 1, number: int = 0) -> Frame:
        """What a RealSense D435 would record of it: depth with noise and holes, colour with grain (docs/cameras.md).

        `number` of the picture in its sequence; equal seed and number, equal noise.
        """
        seed, number = arguments.a_whole("seed", seed, 0, MAX_SEED), arguments.a_whole("number", number, 0, MAX_SEED)
        return self._handle._noisy(a_frame(frame), a_camera(camera), seed, number)

    def annotate(self, frame: Frame, camera: Camera) -> dict[str, Any]:
        """What `frame`, taken by `camera`, shows: market-annotations/1 with boxes, COCO masks, SKUs and 6-D poses in the
        camera's frame."""
        return json.loads(self._handle._annotations(a_frame(frame), a_camera(camera)))

    def set_robots(self, robots: Sequence[str]) -> None:
        """The robots that stand in the pictures from now on, each as "realman-rm65@4.2,3.1,90,posture=stow,lift=0.3":
        row, x, y, heading in degrees, settings (docs/robots.md). Raises Error robot.*, and nothing has changed."""
        self._handle._set_robots(arguments.texts("robots", robots, 'a list of texts like "realman-rm65@4.2,3.1,90"'))

    def set_people(self, count: int, time_s: float = 0) -> None:
        """So many shoppers and staff stand and walk in the pictures from now on, as they are `time_s` seconds after they began
        their rounds (docs/people.md); 0: none. The same people for the same store. Raises Error people.no_room, and nothing
        has changed."""
        count, time_s = arguments.a_whole("count", count, 0, MAX_PEOPLE), arguments.a_number("time_s", time_s, 0, MAX_TIME_S)
        self._handle._set_people(count, time_s)

    def move(
        self,
        products: Mapping[int, Sequence[float]] | None = None,
        joints: Mapping[int, float] | None = None,
    ) -> None:
        """Where products and fixtures' joints stand from now on; all others stand as the store has them.

        products  row -> (x, y, z, qw, qx, qy, qz) in the store's frame, metres
        joints    row -> radians or metres

        Raises Error render.bad_move, and nothing has moved.
        """
        products, joints = _rows("products", products), _rows("joints", joints)
        poses = [arguments.numbers("products", pose, 7) for pose in products.values()]
        positions = [arguments.a_number("joints", position, -math.inf, math.inf) for position in joints.values()]
        self._handle._move(
            np.fromiter(products.keys(), np.uint32, len(products)),
            np.asarray(poses, np.float64).reshape(len(products), 7),
            np.fromiter(joints.keys(), np.uint32, len(joints)),
            np.asarray(positions, np.float64),
        )


def _rows(name: str, moved: Mapping[int, Any] | None) -> dict[int, Any]:
    if not isinstance(moved or {}, Mapping):
        raise bad(name, moved, "a dict: where each row stands")
    return {arguments.a_whole(name, row, 0, MAX_ROW): value for row, value in (moved or {}).items()}


def _memory(name: str, array: Any, dtype: type) -> np.ndarray | None:
    """An array to be written into; whether it has the right size is found by the library."""
    if array is None:
        return None
    fits = isinstance(array, np.ndarray) and array.dtype == dtype
    if not (fits and array.flags.c_contiguous and array.flags.writeable):
        shown = f"{array.dtype} {array.shape}" if isinstance(array, np.ndarray) else array
        raise bad(name, shown, f"None, or a C-contiguous array of {np.dtype(dtype).name} that can be written")
    return array


def render_batch(
    shots: Sequence[tuple[Renderer, Camera]],
    *,
    quality: Quality = "fast",
    rgb: np.ndarray | None = None,
    depth: np.ndarray | None = None,
    instance: np.ndarray | None = None,
) -> None:
    """Many cameras of any renderers side by side, into your arrays; all cameras have one size.

    rgb       (n, height, width, 3) uint8
    depth     (n, height, width) float32, metres
    instance  (n, height, width) uint32

    C-contiguous; None: not wanted. Pixels are those of Renderer.render().
    """
    try:
        pairs = [(renderer._handle, a_camera(camera)) for renderer, camera in shots]
    except (TypeError, ValueError, AttributeError):
        raise bad("shots", shots, "a list of (Renderer, Camera)") from None
    if not pairs:
        raise bad("shots", shots, "at least one (Renderer, Camera)")
    _core.render_batch(
        [handle for handle, _ in pairs],
        [camera for _, camera in pairs],
        arguments.a_text("quality", quality),
        _memory("rgb", rgb, np.uint8),
        _memory("depth", depth, np.float32),
        _memory("instance", instance, np.uint32),
    )
