# For checks in tests/tools/ that let outside programs judge a store: sets `repository`, `program`, `python` and `scratch`, a folder
# that is taken away at the end and has a small store in it, "$scratch/shop".
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=${MARKETGEN_BINARY:-$repository/build/release/marketgen}
python=$repository/.venv/bin/python
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$program" generate "a small shop with dairy and two checkouts" --size 12x9m --seed 3 --no-previews --quiet -o "$scratch/shop" > /dev/null
