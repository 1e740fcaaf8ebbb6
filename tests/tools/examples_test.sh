#!/usr/bin/env bash
# The examples run as their headers say.
set -euo pipefail
cd "$(dirname "$0")/../.."
program=build/release/marketgen
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$program" generate --plan examples/corner-shop.json -o "$folder/shop" --no-previews --quiet --strict
lines=$(python3 examples/cheapest.py "$folder/shop" "$program" | tee "$folder/cheapest.txt" | wc -l)
[ "$lines" -ge 4 ] || { echo "cheapest.py printed $lines lines; at least 4 were expected"; cat "$folder/cheapest.txt"; exit 1; }
export PYTHONPATH=build/release/python
"$PWD/.venv/bin/python" examples/first_store.py "$folder/first"
"$PWD/.venv/bin/python" examples/many_cameras.py "$folder/shop" "$folder/many.npz"
"$PWD/.venv/bin/python" examples/moving_product.py "$folder/shop" "$folder/moving"
"$PWD/.venv/bin/python" examples/train_loop.py "$folder/shop" > "$folder/train.txt"
grep -q "episodes: mean reward" "$folder/train.txt" || { echo "train_loop.py finished no episode"; cat "$folder/train.txt"; exit 1; }
for made in first/aisle.png many.npz moving/4.png; do
  [ -s "$folder/$made" ] || { echo "examples left no $made"; exit 1; }
done
echo "examples: ok"
