#!/usr/bin/env bash
# `pip install` of an sdist as a user does it: its sources, an empty environment, a build of its own. Then the sources are gone, and what
# README and docs promise is done with what was installed: the steps of tools/newcomer. With its libraries inside, the same wheel
# works in a bare root. What the release build compiled is found by ccache, for which the copy's build folder lies as deep in it.
# (`pip install .` of a clean clone: tools/newcomer. Wheels for the other versions of Python: tools/wheels --check.)
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_REQUIRE_VIRTUALENV=1 MARKETGEN_CACHE=$scratch/cache
unset PYTHONPATH MARKETGEN_DATA MARKETGEN_PYTHON VIRTUAL_ENV

mkdir "$scratch/tree" "$scratch/work" "$scratch/docs"
cd "$repository"
began=$SECONDS
.venv/bin/python -c 'import sys; from scikit_build_core import build; build.build_sdist(sys.argv[1])' "$scratch" > "$scratch/log" 2>&1 ||
  { cat "$scratch/log"; printf 'wheel: FAIL: sdist\n'; exit 1; }
tar -xzf "$scratch"/marketgen-*.tar.gz --strip-components=1 -C "$scratch/tree"
# It has what Git has, and what pip adds.
if git rev-parse --git-dir > /dev/null 2>&1; then
  git ls-files --cached --others --exclude-standard | (while read -r file; do [ ! -f "$file" ] || printf '%s\n' "$file"; done; echo PKG-INFO) | sort > "$scratch/known"
  (cd "$scratch/tree" && find . -type f | sed 's/^\.\///' | sort) | diff "$scratch/known" - || { printf 'wheel: FAIL: the sdist has other files\n'; exit 1; }
fi
printf 'wheel: sdist, %d MB, %d s\n' $(($(stat -c %s "$scratch"/marketgen-*.tar.gz) / 1000000)) $((SECONDS - began))

werror=$(sed -n 's/^MARKETGEN_WERROR:BOOL=//p' "$repository/build/release/CMakeCache.txt")
"$repository/.venv/bin/python" -m venv "$scratch/venv"
began=$SECONDS
# The first half of `pip install .`, in an environment of its own; the second takes the wheel.
"$scratch/venv/bin/pip" wheel --quiet --no-deps -w "$scratch" --config-settings=cmake.define.MARKETGEN_WERROR="${werror:-OFF}" "$scratch/tree"
wheel=$(ls "$scratch"/*.whl)
"$scratch/venv/bin/pip" install --quiet "$wheel[gymnasium]"
printf 'wheel: built and installed, %d s\n' $((SECONDS - began))
cp "$scratch/tree/README.md" "$scratch/docs/"
rm -r "$scratch/tree"

export TREE=$scratch/docs VENV=$scratch/venv WORK=$scratch/work
PATH=$VENV/bin:$PATH
for step in doctor manual readme-python check-env eval evaluate uninstall; do
  began=$SECONDS
  (cd "$WORK" && bash -euo pipefail -c '. "$1"; . "$2"' wheel_test "$repository/tools/newcomer.d/lib.bash" \
    "$repository"/tools/newcomer.d/[0-9]*-"$step".sh) > "$scratch/log" 2>&1 < /dev/null ||
    { cat "$scratch/log"; printf 'wheel: FAIL: %s\n' "$step"; exit 1; }
  printf 'wheel: %s, %d s\n' "$step" $((SECONDS - began))
done

began=$SECONDS
mkdir "$scratch/repaired"
tools/try_wheel "$(tools/wheels -o "$scratch/repaired" --repair "$wheel" 2> "$scratch/log")" "$repository/.venv/bin/python" ||
  { cat "$scratch/log"; printf 'wheel: FAIL: a bare root\n'; exit 1; }
printf 'wheel: a bare root, %d s\n' $((SECONDS - began))
printf 'wheel: ok\n'
