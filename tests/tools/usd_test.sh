#!/usr/bin/env bash
# A USD export is what it says, judged by others: OpenUSD's own validators and NVIDIA's find nothing in it, every item stands where
# the store has it, with its mass, friction and labels; doors have their limits in degrees. And goods that are free behave as ours do:
# MuJoCo, told of them by the USD file alone, settles them as our own world does, and as it does from our MJCF.
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=${MARKETGEN_BINARY:-$repository/build/release/marketgen}
python=$repository/.venv/bin/python
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$program" generate "a kiosk with cold drinks and snacks" --size 6x5m --seed 3 --no-previews --quiet -o "$scratch/shop" > /dev/null
region=${MARKETGEN_USD_REGION:-4.2,0.6,6,4.4} # 607 of its goods
cd "$scratch"
mkdir out
"$program" export shop --format usd --free-region "$region" -o out/shop.usda --check --json > summary.json
"$program" export shop --format mjcf --primitives --still-fixtures --free-region "$region" --quiet -o shop.xml
"$program" export shop --format glb --quiet -o shop.glb
mv out moved # the two parts may be moved together

"$python" "$repository/tests/tools/usd_judge.py" moved/shop.usda shop shop.glb shop.xml summary.json
PYTHONPATH=$(dirname "$program")/python "$python" "$repository/tests/tools/usd_physics.py" moved/shop.usda shop.xml shop "$region"
"$repository/.venv/bin/nvidia_usd_validate" moved/shop.usda > nvidia.txt 2>&1 || { tail -40 nvidia.txt; exit 1; }
grep -q "No issues found" nvidia.txt || { tail -40 nvidia.txt; exit 1; }
echo "NVIDIA's validator: no failure, no warning"
