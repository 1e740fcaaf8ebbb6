#!/usr/bin/env bash
# An MJCF export opens in MuJoCo's own Python package, wherever its two parts are put: as many products as the store has, each with
# a mesh and a picture, and a robot that holds where it was put.
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=${MARKETGEN_BINARY:-$repository/build/release/marketgen}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$program" generate "a kiosk with cold drinks and snacks" --size 8x7m --seed 3 --no-previews --quiet -o "$scratch/shop" > /dev/null
place=$("$program" query "$scratch/shop" products --format json | "$repository/.venv/bin/python" -c 'import json,sys; print(len(json.load(sys.stdin)))')
cd "$scratch"
mkdir out
robot=
for at in 4,1.2 2,1.2 6,1.2 4,2.5 3,3.5; do  # the first clear place
  if "$program" export shop --format mjcf -o out/shop.xml --robot "panda-on-stand@$at,90" --check --quiet > check.txt 2> refused.txt; then robot=$at; break; fi
  grep -q robot.blocked refused.txt || { cat refused.txt; exit 1; }
done
[ -n "$robot" ] || { echo "no clear place for the robot"; exit 1; }
mv out moved

"$repository/.venv/bin/python" - "$place" <<'JUDGE'
import sys

import mujoco

model = mujoco.MjModel.from_xml_path("moved/shop.xml")
meshes = [i for i in range(model.ngeom) if model.geom_type[i] == mujoco.mjtGeom.mjGEOM_MESH and model.geom_matid[i] >= 0]
assert len(meshes) == int(sys.argv[1]), f"{len(meshes)} meshes for {sys.argv[1]} products"
assert all(model.mat_texid[model.geom_matid[i]].max() >= 0 for i in meshes), "a mesh without a picture"
data = mujoco.MjData(model)
mujoco.mj_resetDataKeyframe(model, data, model.key("start").id)
joint = next(model.jnt_qposadr[i] for i in range(model.njnt) if model.joint(i).name.startswith("panda-on-stand/") and "joint4" in model.joint(i).name)
before = data.qpos[joint]
mujoco.mj_step(model, data, 200)
assert abs(data.qpos[joint] - before) < 0.02, (before, data.qpos[joint])
print(f"MuJoCo {mujoco.__version__}: {len(meshes)} products with mesh and picture, a robot that stands")
JUDGE
