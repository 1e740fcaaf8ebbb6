#!/usr/bin/env bash
# "Opens in every glTF viewer": trimesh, pygltflib and three.js, none of them ours, find in a store's GLB as many products as the
# store has, and the same box around them all. And three.js, which knows the extension, finds them in --instanced as well.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/../support/small_shop.bash"

"$program" export "$scratch/shop" --format glb --quiet -o "$scratch/shop.glb"
"$program" export "$scratch/shop" --format glb --instanced --quiet -o "$scratch/instanced.glb"
for name in shop instanced; do
  node "$repository/tools/node/count_glb.mjs" "$scratch/$name.glb" > "$scratch/$name.json"
done

"$python" - "$scratch" <<'JUDGE'
import json
import pathlib
import sys

import numpy
import pygltflib
import trimesh

scratch = pathlib.Path(sys.argv[1])
wanted = json.loads((scratch / "shop/store.json").read_text())["counts"]["products"]

scene = trimesh.load_scene(scratch / "shop.glb")
gltf = pygltflib.GLTF2().load(scratch / "shop.glb")
assert not gltf.extensionsRequired, gltf.extensionsRequired
names = {node.name for node in gltf.nodes if "sku" in (node.extras or {})}
assert len(names) == wanted, f"pygltflib finds {len(names)} products of {wanted}"

# trimesh splits a mesh by its materials; each part hangs in the node of its product or in one below it.
shown = {name for node in scene.graph.nodes_geometry for name in (node, scene.graph.transforms.parents.get(node)) if name in names}
assert len(shown) == wanted, f"trimesh shows {len(shown)} products of {wanted}"

low, high = scene.bounds
for name in ("shop", "instanced"):
    three = json.loads((scratch / f"{name}.json").read_text())
    assert three["products"] == wanted, f"three.js shows {three['products']} products of {wanted} in {name}.glb"
    for ours, theirs in ((low, three["low"]), (high, three["high"])):
        assert numpy.allclose(ours, theirs, atol=2e-3), f"{name}.glb: trimesh has {ours}, three.js {theirs}"
print(f"trimesh, pygltflib and three.js: {wanted} products each, {low.round(3)} to {high.round(3)}")
JUDGE
