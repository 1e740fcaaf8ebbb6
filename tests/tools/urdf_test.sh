#!/usr/bin/env bash
# A URDF export, judged by ROS's own parser (check_urdf of liburdfdom-tools): no warning, and as many links as the file has.
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=${MARKETGEN_BINARY:-$repository/build/release/marketgen}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
"$program" generate "a kiosk with cold drinks and snacks" --size 6x5m --seed 3 --no-previews --quiet -o shop > /dev/null
"$program" export shop --format urdf -o shop.urdf --check > /dev/null
check_urdf shop.urdf > tree.txt 2> warnings.txt || { cat warnings.txt; exit 1; }
[ ! -s warnings.txt ] || { head warnings.txt; exit 1; }
links=$(grep -c '<link name=' shop.urdf)
found=$(grep -cE '^ *(root Link: |child\()' tree.txt)
[ "$links" = "$found" ] || { echo "check_urdf finds $found of $links links"; exit 1; }
echo "check_urdf: $found links, no warning"
