#!/usr/bin/env bash
# What runs the tutorials: every file saved, every command run in order in an empty folder, what is printed compared; and it says so
# when one does not do what it says. The tutorials themselves: tools/check_tutorials.
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
run_page=("$repository/.venv/bin/python" "$repository/tools/run_page")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { printf 'tutorials_test: FAIL: %s\n' "$1" >&2; exit 1; }

# What the runner takes, and what it refuses.
page() { cat > "$scratch/page.md"; "${run_page[@]}" "$@" "$scratch/page.md" > "$scratch/said.txt" 2>&1; }
says() { grep -qF "$1" "$scratch/said.txt" || { cat "$scratch/said.txt" >&2; fail "it does not say '$1'"; }; }

page --quick <<'PAGE' || { cat "$scratch/said.txt" >&2; fail "a sound page"; }
```python title="deep/count.py"
import os
print("counted", os.environ["STEPS"], "of 10", flush=True)
```
<!-- quick: STEPS=3 -->
```sh
STEPS=${STEPS:-10} python deep/count.py
sleep 1000 &
```
```text
counted 10 of 10
```
<!-- needs: no_such_module -->
```sh
exit 1
```
<!-- not run: it is an example -->
```sh
exit 1
```
```sh
[ "$(jobs | wc -l)" = 1 ] && echo "still here"
```
```text
still here
```
PAGE
says 'page.md: 1 files, 2 run, 2 compared, 2 left out'
says 'needs no_such_module'

refuses() { ! page --quick || { cat "$scratch/said.txt" >&2; fail "it takes a page that is wrong: $1"; }; says "$1"; }
printf 'words\n\n```sh\ntrue\nfalse\ntrue\n```\n' | refuses 'page.md:4: ended with status 1'
printf '```sh\necho one\necho two\n```\n```text\ntwo\none\n```\n' | refuses 'it does not print: one'
printf '<!-- quick: STEPS=3 -->\n```sh\ntrue\n```\n' | refuses 'which the block does not name'
printf '```python\nprint(1)\n```\n' | refuses 'a block of python without a title'

# Numbers that have changed are put in their places.
printf '```sh\necho "took 12.5 s"\n```\n```text\ntook 3 s\n```\n' | page --write || fail "a page with other numbers"
grep -q '^took 12.5 s$' "$scratch/page.md" || fail "--write has not written"

printf 'tutorials_test: passed\n'
