"""Makes a store, asks it for its dearest goods, and draws an aisle with what each pixel shows.

    python examples/first_store.py [OUT]

OUT is a folder for the store and the picture; a new one in out/examples by itself.
"""

import pathlib
import sys
import time

import marketgen

out = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else f"out/examples/first_store-{time.strftime('%Y%m%d-%H%M%S')}")


def show(done, total, text):
    print(f"\r{text:<10} {done}/{total}", end="", flush=True)


prompt = "a corner shop with cold drinks, snacks and one checkout"
store = marketgen.generate(prompt, out / "shop", seed=5, size="9x7m", progress=show)
products = store.query("products")
print(f"\n{len(products)} products; the dearest:")
for price, name in sorted({(row["price"], row["name"]) for row in products}, reverse=True)[:3]:
    print(f"  {price:6.2f}  {name}")

renderer = store.renderer()
camera = store.camera("aisle", 640, 480)
frame = renderer.render(camera)
frame.save(out / "aisle.png")
things = renderer.annotate(frame, camera)["objects"]
nearest = min((thing for thing in things if thing["kind"] == "product"), key=lambda thing: thing["depth_m"])
print(f"nearest product: {nearest['sku']}, {nearest['depth_m']:.2f} m away, in pixels {nearest['box_px']}")
print(f"picture: {out / 'aisle.png'}")
