"""A product carried through an aisle: the store stands still, one can moves from picture to picture.

    python examples/moving_product.py [STORE [OUT_FOLDER]]
"""

import pathlib
import sys

import numpy as np

from demo_shop import FOLDER, open_or_make

store = open_or_make(*sys.argv[1:2])
out = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else FOLDER / "moving_product")
out.mkdir(parents=True, exist_ok=True)
camera = store.camera("aisle", 320, 240)
eye, back, up = camera.cam2world_gl[:3, 3], camera.cam2world_gl[:3, 2], np.array([0, 0, 1])
across = np.cross(up, back)
renderer = store.renderer()
product = store.query("products")[0]["id"]
for i, share in enumerate(np.linspace(-0.4, 0.4, 5)):
    place = eye - 1.2 * back + share * across - 0.1 * up
    renderer.move({0: (*place, 1, 0, 0, 0)})
    frame = renderer.render(camera, quality="fast")
    frame.save(out / f"{i}.png")
    thing = next(thing for thing in renderer.annotate(frame, camera)["objects"] if thing["name"] == product)
    print(f"{i}.png: {thing['sku']} covers {thing['pixels']} pixels around {thing['box_px']}")
