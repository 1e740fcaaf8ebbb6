#!/usr/bin/env bash
# The examples run as their headers say, and each without arguments, from any folder, leaving what they make in out/examples.
set -euo pipefail
cd "$(dirname "$0")/../.."
repository=$PWD
python=$repository/.venv/bin/python
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "examples: FAIL: $1"; exit 1; }

export PYTHONPATH=$repository/build/release/python
cd "$folder"
for example in "$repository"/examples/[!d]*.py; do  # demo_shop.py is theirs
  name=$(basename "$example" .py)
  status=0
  PATH="$repository/build/release:$PATH" timeout 300 "$python" "$example" > "$name.txt" 2>&1 || status=$?
  [ "$status" = 0 ] || { cat "$name.txt"; fail "$name.py without arguments ended with status $status"; }
  [ -s "$name.txt" ] || fail "$name.py said nothing"
done
[ "$(wc -l < cheapest.txt)" -ge 4 ] || { cat cheapest.txt; fail "cheapest.py printed fewer than 4 lines"; }
grep -q "episodes: mean reward" train_loop.txt || { cat train_loop.txt; fail "train_loop.py finished no episode"; }
grep -q "oracle: {'success': 1" ppo_pick.txt || { cat ppo_pick.txt; fail "ppo_pick.py: the oracle failed at the easy task"; }
grep -q "random: 0 of 2" imitate.txt || { cat imitate.txt; fail "imitate.py did not measure chance"; }
grep -q "random: 0 of 2" clone.txt || { cat clone.txt; fail "clone.py did not measure chance"; }
grep -q "Clone: [0-2] of 2" clone.txt || { cat clone.txt; fail "clone.py did not measure what it learned"; }
for made in many_cameras.npz moving_product/4.png imitate/dataset/meta/info.json imitate/random/summary.json \
    clone/dataset/meta/info.json clone/policy.npz clone/results/summary.json; do
  [ -s "out/examples/$made" ] || fail "nothing at out/examples/$made"
done

# The same with a store and places of one's own.
"$python" "$repository/examples/first_store.py" first > first.txt
"$python" "$repository/examples/many_cameras.py" first/shop many.npz
"$python" "$repository/examples/moving_product.py" first/shop moving
"$python" "$repository/examples/train_loop.py" first/shop 3 > train.txt
python3 "$repository/examples/cheapest.py" first/shop "$repository/build/release/marketgen" > cheapest.txt
for made in first/aisle.png many.npz moving/4.png train.txt cheapest.txt; do
  [ -s "$made" ] || fail "nothing at $made"
done
echo "examples: ok"
