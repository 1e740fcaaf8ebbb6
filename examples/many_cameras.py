"""RGB-D from 64 cameras on the spot of the aisle's view, drawn in one call into one array each.

    python examples/many_cameras.py [STORE [OUT.npz]]
"""

import math
import sys
import time

import numpy as np

import marketgen
from demo_shop import FOLDER, open_or_make

COUNT, SIDE = 64, 128

store = open_or_make(*sys.argv[1:2])
out = sys.argv[2] if len(sys.argv) > 2 else FOLDER / "many_cameras.npz"
renderer = store.renderer()
eye = store.camera("aisle").cam2world_gl[:3, 3]
cameras = [
    marketgen.Camera.look_at(
        eye, eye + (math.cos(angle), math.sin(angle), -0.3), fov_deg=60, width=SIDE, height=SIDE
    )
    for angle in np.linspace(0, 2 * math.pi, COUNT, endpoint=False)
]
rgb = np.empty((COUNT, SIDE, SIDE, 3), np.uint8)
depth = np.empty((COUNT, SIDE, SIDE), np.float32)
started = time.perf_counter()
marketgen.render_batch([(renderer, camera) for camera in cameras], rgb=rgb, depth=depth)
print(f"{COUNT} pictures of {SIDE} x {SIDE} in {time.perf_counter() - started:.2f} s")
np.savez_compressed(out, rgb=rgb, depth=depth)
print(f"pictures: {out}")
