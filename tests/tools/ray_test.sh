#!/usr/bin/env bash
# What is made over a Ray cluster of two nodes on this machine, and by the examples for Slurm and Kubernetes, is what one process makes, byte
# for byte, also when workers are killed, a node is lost, or the run is broken off; and what is wrong with a cluster is said. Ray lies in an
# environment of its own, build/ray-venv, made the first time.
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
venv=$repository/build/ray-venv
wanted=$repository/tools/requirements-ray.txt
if ! cmp -s "$wanted" "$venv/installed.txt"; then
  rm -rf "$venv"
  "$repository/.venv/bin/python" -m venv "$venv"
  # Beside these packages those of .venv.
  "$repository/.venv/bin/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))' > "$("$venv/bin/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')/beside.pth"
  "$venv/bin/python" -m pip install --quiet --disable-pip-version-check --no-deps -r "$wanted"
  cp "$wanted" "$venv/installed.txt"
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export PYTHONPATH=${PYTHONPATH:-$repository/build/release/python} MARKETGEN_BINARY=${MARKETGEN_BINARY:-$repository/build/release/marketgen}
export RAY_worker_niceness=0  # as the process that they are compared with, so that a busy machine does not starve them
cd "$scratch"
"$venv/bin/python" -m pytest -q -p no:cacheprovider --basetemp "$scratch/tests" "$repository"/tests/tools/{batch_shards,ray_cluster,ray_faults,ray_ends}.py
