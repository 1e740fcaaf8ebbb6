#!/usr/bin/env bash
# An SDF export, judged by Gazebo's own parser (libsdformat): no error, no warning, and as many models, links, joints, visuals and
# collisions as the file has; the meshes that it names are there.
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=${MARKETGEN_BINARY:-$repository/build/release/marketgen}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
read -ra libraries <<< "$(pkg-config --cflags --libs sdformat12)"
g++ -std=c++17 "$repository/tests/tools/sdf_judge.cpp" -o judge "${libraries[@]}"
"$program" generate "a kiosk with cold drinks and snacks" --size 6x5m --seed 3 --no-previews --quiet -o shop > /dev/null

judge() {
  ./judge "$1" > found.txt 2> warnings.txt || { head -c 2000 warnings.txt; exit 1; }
  [ ! -s warnings.txt ] || { head -c 2000 warnings.txt; exit 1; }
  local wanted=""
  for element in model link joint visual collision; do
    wanted+="$({ grep -o "<$element name=" "$1" || true; } | wc -l) "  # there may be none
  done
  [ "$wanted$2" = "$(cat found.txt)" ] || { echo "$1 has $wanted$2, libsdformat finds $(cat found.txt)"; exit 1; }
  grep -oP '(?<=<uri>)[^<]+' "$1" | sort -u | while read -r mesh; do
    [ -s "$mesh" ] || { echo "there is no $mesh"; exit 1; }
  done
}

"$program" export shop --format sdf -o still.sdf --still-fixtures --check > /dev/null
judge still.sdf 0
free=$("$program" export shop --format sdf -o shop.sdf --free-region 0,3,6,5 --check --json | grep -oP '"free_bodies": *\K[0-9]+')
[ "$free" -gt 0 ] || { echo "nothing is free"; exit 1; }
judge shop.sdf "$free"
echo "libsdformat: $(cat found.txt) models, links, joints, visuals, collisions, free; no warning"
