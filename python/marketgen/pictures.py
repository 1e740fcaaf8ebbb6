"""Pictures of stores: cameras, planes, annotations, many cameras at once."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any, Literal

import numpy as np

from . import _core
from ._core import Camera, Frame

Mode = Literal["sensor", "path"]
Quality = Literal["fast", "balanced", "best"]


def camera_from_dict(camera: Mapping[str, Any]) -> Camera:
    """A camera in any pose with its lens from market-camera/1 (docs/cameras.md): position_m, rotation_wxyz, fx, ..."""
    return Camera._from_json(json.dumps({"schema": "market-camera/1", **camera}))


def camera_to_dict(camera: Camera) -> dict[str, Any]:
    """The camera as market-camera/1."""
    return json.loads(camera._to_json())


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
    ) -> Frame:
        """One picture with all its planes.

        mode            "sensor": no noise, tens of milliseconds; "path": full light transport, seconds
        samples         path mode: paths a pixel; 0: what the quality says
        time_s          path mode: stop after this long; then not reproducible
        exposure_stops  path mode: brighter or darker than the store asks

        Raises Error camera.* for cameras that cannot see.
        """
        return self._handle._render(camera, mode, quality, samples, time_s, denoise, exposure_stops)

    def with_noise(self, frame: Frame, camera: Camera, *, seed: int = 1, number: int = 0) -> Frame:
        """What a RealSense D435 would record of it: depth with noise and holes, colour with grain (docs/cameras.md).

        `number` of the picture in its sequence; equal seed and number, equal noise.
        """
        return self._handle._noisy(frame, camera, seed, number)

    def annotate(self, frame: Frame, camera: Camera) -> dict[str, Any]:
        """What `frame`, taken by `camera`, shows: market-annotations/1 with boxes, COCO masks, SKUs and 6-D poses in the
        camera's frame."""
        return json.loads(self._handle._annotations(frame, camera))

    def set_robots(self, robots: Sequence[str]) -> None:
        """The robots that stand in the pictures from now on, each as "realman-rm65@4.2,3.1,90,posture=stow,lift=0.3":
        row, x, y, heading in degrees, settings (docs/robots.md). Raises Error robot.*, and nothing has changed."""
        self._handle._set_robots(list(robots))

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
        products, joints = products or {}, joints or {}
        self._handle._move(
            np.fromiter(products.keys(), np.uint32, len(products)),
            np.asarray(list(products.values()), np.float64).reshape(len(products), 7),
            np.fromiter(joints.keys(), np.uint32, len(joints)),
            np.fromiter(joints.values(), np.float64, len(joints)),
        )


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
    _core.render_batch(
        [renderer._handle for renderer, _ in shots],
        [camera for _, camera in shots],
        quality,
        rgb,
        depth,
        instance,
    )
