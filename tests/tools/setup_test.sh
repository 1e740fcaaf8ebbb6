#!/usr/bin/env bash
# What tools/setup promises without installing anything: its sets nest, it refuses what it does not know, and on a
# machine that is ready it changes nothing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

fail() { printf 'setup_test: FAIL: %s\n' "$1"; exit 1; }

for script in tools/setup tools/test tools/format .ci/run; do
  bash -n "$script" || fail "$script does not parse"
done

# runtime is within build, build within test; no package is named twice.
for pair in "runtime build" "build test"; do
  read -r inner outer <<< "$pair"
  [ -z "$(comm -23 <(tools/setup --list "$inner" | sort) <(tools/setup --list "$outer" | sort))" ] ||
    fail "a package of $inner is not in $outer"
done
[ -z "$(tools/setup --list all | sort | uniq -d)" ] || fail "a package is named twice"

status=0
message=$(tools/setup everything 2>&1) || status=$?
[ "$status" = 2 ] || fail "an unknown set should exit 2, not $status"
[[ "$message" == *"expected runtime, build, test or all"* ]] || fail "an unknown set should be told the sets: $message"

again=$(tools/setup all)
! grep -q installing <<< "$again" || fail "a second run installed something: $again"

printf 'setup_test: passed\n'
