#!/usr/bin/env bash
# `pip install .` gives `import marketgen` and the `marketgen` command, away from the source tree. What the release build compiled
# is found by ccache.
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

werror=$(sed -n 's/^MARKETGEN_WERROR:BOOL=//p' "$repository/build/release/CMakeCache.txt")
export CXX=c++  # by the name that the release build calls it, for ccache
# Without isolation: the tools of the build lie in .venv, at the versions that pyproject.toml names.
"$repository/.venv/bin/pip" install --quiet --disable-pip-version-check --no-build-isolation --no-deps --no-index \
  -Cbuild-dir="$repository/build/wheel" -Ccmake.define.MARKETGEN_WERROR="$werror" --target "$scratch/site" "$repository"
cd "$scratch"
export PYTHONPATH="$scratch/site" MARKETGEN_CACHE="$scratch/cache"
"$repository/.venv/bin/python" - <<'PYTHON'
import pathlib

import marketgen

assert pathlib.Path(marketgen.__file__).is_relative_to(pathlib.Path.cwd()), marketgen.__file__
store = marketgen.generate("a kiosk with snacks and cold drinks", "kiosk", size="6x5m")
frame = store.renderer().render(store.camera("aisle", 64, 48), quality="fast")
assert frame.rgb.std() > 5
PYTHON
"$scratch/site/bin/marketgen" check kiosk > /dev/null
echo "wheel: ok"
