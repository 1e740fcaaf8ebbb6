#!/usr/bin/env bash
# tools/newcomer reports what happened: a line a step, its summary, its status; a failure keeps its log, one of a needed step ends the run.
# (The real steps build everything anew: they are run by hand.)
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { printf 'newcomer_test: FAIL: %s\n' "$1"; exit 1; }

for step in "$repository"/tools/newcomer.d/*.sh; do
  bash -n "$step" || fail "$step does not parse"
  head -n 1 "$step" | grep -q '^# .' || fail "$step has no title in its first line"
done
listed=$("$repository/tools/newcomer" --list | wc -l)
[ "$listed" = "$(find "$repository/tools/newcomer.d" -name '[0-9]*.sh' | wc -l)" ] || fail "--list has $listed steps"
! "$repository/tools/newcomer" --list --no-demo | grep -q demo || fail "--no-demo has the demo"

# The blocks of a document, by what is in them.
# shellcheck source=/dev/null
source "$repository/tools/newcomer.d/lib.bash"
[ "$(block "$repository/README.md" sh 'make demo' | tail -n 1)" = "make demo" ] || fail "README's block of make demo was not found"
! (block "$repository/README.md" python 'no such text') 2> /dev/null || fail "a block that is not there was found"

mkdir -p "$scratch/tools/newcomer.d"
cp "$repository/tools/newcomer" "$scratch/tools/"
cp "$repository/tools/newcomer.d/lib.bash" "$scratch/tools/newcomer.d/"
cd "$scratch/tools/newcomer.d"
printf '# works !\n[ "$PWD" = "$WORK" ]\n' > 10-works.sh
printf '# fails\necho the reason >&2\nfalse\ntrue\n' > 20-fails.sh
printf '# works all the same\n[ -z "${PYTHONPATH:-}" ]\n' > 30-works.sh
status=0
said=$(TMPDIR=$scratch PYTHONPATH=/nowhere ../newcomer) || status=$?
[ "$status" = 1 ] || fail "a failed step gave status $status: $said"
[ "$(grep -cE '^ok +[0-9]+\.[0-9]  works' <<< "$said")" = 2 ] || fail "two steps work: $said"
[ "$(tail -n 1 <<< "$said")" = "newcomer: 3 steps, 1 failures" ] || fail "the summary: $said"
log=$(sed -n 's/^FAIL .*  fails (status 1, log: \(.*\))$/\1/p' <<< "$said")
grep -q '^the reason$' "$log" || fail "the log of the failed step: $said"

rm 20-fails.sh
said=$(TMPDIR=$scratch ../newcomer) || fail "nothing failed: $said"
printf '# is needed !\nfalse\n' > 20-needed.sh
! said=$(TMPDIR=$scratch ../newcomer) || fail "a needed step failed: $said"
[ "$(tail -n 1 <<< "$said")" = "newcomer: 2 steps, 1 failures" ] || fail "it went on without what was needed: $said"
printf 'newcomer_test: passed\n'
