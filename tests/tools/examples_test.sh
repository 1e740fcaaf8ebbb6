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
echo "examples: ok"
