#!/usr/bin/env bash
# tools/freeze_benchmark draws each set from ten stores of its own kind, leaves sets that are there as they are, and sums all files.
# The program is a stand-in: it writes down what it is asked for, and makes files of those names.
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failures=0

cat > "$tree/marketgen" <<'PROGRAM'
#!/usr/bin/env bash
echo "$*" >> "$ASKED"
while [ $# -gt 0 ]; do
  case "$1" in generate|episodes) verb=$1 ;; -o) output=$2 ;; esac
  shift
done
if [ "$verb" = generate ]; then
  mkdir -p "$output" && echo {} > "$output/store.json"
else
  mkdir -p "$(dirname "$output")/scenes"
  echo episodes > "$output"
  echo scene > "$(dirname "$output")/scenes/$(basename "$output")"
fi
PROGRAM
chmod +x "$tree/marketgen"
export MARKETGEN_BINARY="$tree/marketgen" ASKED="$tree/asked"

# expect <what> <command...>: the command succeeds.
expect() {
  if ! "${@:2}"; then
    echo "FAILED: $1"
    failures=$((failures + 1))
  fi
}

freeze() {
  : > "$ASKED"
  "$repository/tools/freeze_benchmark" "$tree/set" "$@"
}

freeze 40 3 aisle-suction aisle-doors
expect 'each kind has ten stores' [ "$(grep -c '^generate' "$ASKED")" = 20 ]
expect 'the first store of each has the seed' [ "$(grep -c -- '--seed 40 --strict' "$ASKED")" = 2 ]
expect 'stores of the doors have them' [ "$(grep '^generate' "$ASKED" | grep -c 'glass-door coolers of ')" = 10 ]
expect 'the cup is asked for' grep -q -- '^episodes .*--track aisle --tools suction --count 30 --seed 40 --frozen' "$ASKED"
expect 'doors are asked for' grep -q -- '^episodes .*--track aisle --doors --count 30 --seed 40 --frozen' "$ASKED"
expect 'nothing else lies there' [ ! -e "$tree/set/.stores" ]
expect 'the sums are right' bash -c "cd '$tree/set' && sha256sum --quiet -c SHA256SUMS"
expect 'all files are summed' [ "$(wc -l < "$tree/set/SHA256SUMS")" = 4 ]

echo 'drawn long ago' > "$tree/set/aisle-doors.jsonl.gz"
freeze 41 3 aisle-doors checkout-hard checkout-stock
expect 'a set that is there stays' grep -q 'drawn long ago' "$tree/set/aisle-doors.jsonl.gz"
expect 'no store is made: those of another set are there' [ "$(grep -c '^generate' "$ASKED")" = 0 ]
expect 'the other one is drawn in them' grep -q -- '^episodes .*/aisle-suction.jsonl.gz --track checkout --difficulty hard --skip-impossible --count 30' "$ASKED"
expect 'the hand that one can buy is asked for' grep -q -- '^episodes .*--track checkout --station checkout-stock --count 30' "$ASKED"
expect 'a set that nobody knows is refused' bash -c "! '$repository/tools/freeze_benchmark' '$tree/set' 1 1 aisle-drawers 2> /dev/null"

[ "$failures" = 0 ] && echo 'freeze_benchmark: all is well'
exit "$failures"
