#!/usr/bin/env bash
# tools/lint checks what changed, never the same content twice, says what it had no time for, and fails on a finding.
# clang-tidy and CMake are stand-ins: the first finds the word BAD in a file or in the header beside it.
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
cases=0
failures=0

mkdir "$tree/bin"
cat > "$tree/bin/clang-tidy-16" <<'TIDY'
#!/usr/bin/env bash
if [ "$1" = --version ]; then echo "stand-in ${TIDY_VERSION:-1}"; exit; fi
file=${*: -1}
echo "$file" >> "$TIDY_LOG"
if [ -n "${TIDY_SLEEP_S:-}" ]; then exec sleep "$TIDY_SLEEP_S"; fi
found=$(grep -Hs BAD "$file" "${file%.cpp}.h" || true)
if [ -n "$found" ]; then echo "$found"; exit 1; fi
TIDY
cat > "$tree/bin/cmake" <<'CMAKE'
#!/usr/bin/env bash
mkdir -p build/lint
for file in $(find src -name '*.cpp'); do
  printf '{"directory": "%s", "command": "c++ -I%s/src -c %s", "file": "%s/%s"}\n' "$PWD" "$PWD" "$file" "$PWD" "$file"
done | sed '$!s/$/,/; 1s/^/[/; $s/$/]/' > build/lint/compile_commands.json
CMAKE
chmod +x "$tree"/bin/*
export PATH="$tree/bin:$PATH" TIDY_LOG="$tree/checked"
export GIT_AUTHOR_NAME=test GIT_AUTHOR_EMAIL=test@example.org GIT_COMMITTER_NAME=test GIT_COMMITTER_EMAIL=test@example.org

# commit <date>: everything as it lies there.
commit() {
  git add -A
  GIT_AUTHOR_DATE="$1" GIT_COMMITTER_DATE="$1" git commit -q -m "$1"
}

# A repository of one branch: three files, two of them over one header, the last commit but one two days old.
make_repository() {
  rm -rf "$tree/house" "$tree/cache"
  export MARKETGEN_CACHE="$tree/cache"
  mkdir -p "$tree/house/src/a" "$tree/house/tools"
  cd "$tree/house"
  git init -q -b trunk .
  cp "$repository/tools/lint" tools/lint
  echo 'Checks: x' > .clang-tidy
  echo '/build/' > .gitignore
  echo 'int one();' > src/a/one.h
  printf '#include "a/one.h"\nint one() { return 1; }\n' > src/a/one.cpp
  printf '#include "a/one.h"\nint two() { return one() + 1; }\n' > src/a/two.cpp
  echo 'int three() { return 3; }' > src/a/three.cpp
  commit 2026-01-01T12:00:00Z
  echo 'read me' > README
  commit 2026-01-03T12:00:00Z
}

# expect <status> <files checked, in order> <text the output must hold> <what this case proves> [arguments of tools/lint]
expect() {
  local output status=0 checked
  cases=$((cases + 1))
  : > "$TIDY_LOG"
  output=$(tools/lint --jobs=1 "${@:5}" 2>&1) || status=$?
  checked=$(tr '\n' ' ' < "$TIDY_LOG")
  if [ "$status" = "$1" ] && [ "$checked" = "$2" ] && grep -qF -- "$3" <<< "$output"; then return; fi
  printf 'FAIL: %s\n  expected exit %s, checked "%s" and: %s\n  got exit %s, checked "%s" and: %s\n' \
    "$4" "$1" "$2" "$3" "$status" "$checked" "$output"
  failures=$((failures + 1))
}

make_repository
expect 0 "src/a/one.cpp src/a/three.cpp src/a/two.cpp " "lint: clean" "without arguments every file is checked"
expect 0 "" "3 of them known as clean" "what was clean is not checked again"
echo 'int one(), uno();' > src/a/one.h
expect 0 "src/a/one.cpp src/a/two.cpp " "lint: clean" "a header's content is part of what includes it"
echo 'Checks: y' > .clang-tidy
expect 0 "src/a/three.cpp " "lint: clean" "other rules are another check" src/a/three.cpp
TIDY_VERSION=2 expect 0 "src/a/three.cpp " "lint: clean" "another clang-tidy is another check" src/a/three.cpp
echo '// BAD' >> src/a/three.cpp
expect 1 "src/a/three.cpp " "src/a/three.cpp:// BAD" "a finding is shown and fails" src/a/three.cpp
expect 1 "src/a/three.cpp " "findings in 1 files" "a file with findings is checked again" src/a/three.cpp
expect 2 "" "src/a/four.cpp is not compiled" "a file without a compile command is an error, not a pass" src/a/four.cpp

make_repository
expect 0 "" "0 files changed" "in a clone of one branch, a commit a day older than the last is the base" --changed
echo 'int three() { return 4; }' > src/a/three.cpp
commit 2026-01-03T12:00:01Z
echo 'int two() { return 2; }' > src/a/two.cpp
expect 0 "src/a/two.cpp src/a/three.cpp " "2 files changed" "what changed is checked, the newest first" --changed
git checkout -q src
git branch main HEAD~1
git checkout -q -b work
echo 'int one(), uno();' > src/a/one.h
expect 0 "src/a/one.cpp " "2 files changed" "on a branch the base is where it leaves main; a header is checked with its own file" --changed

make_repository
mkdir src/b
git mv src/a/one.h src/a/one.cpp src/b/
sed -i 's,a/one.h,b/one.h,' src/b/one.cpp src/a/two.cpp
expect 0 "" "0 files changed" "what moved, and what includes what moved, is unchanged" --changed

make_repository
TIDY_SLEEP_S=20 expect 0 "src/a/one.cpp " "2 files were left unchecked when the 2 s were over" "what there was no time for is named" \
  --budget=2 src/a/one.cpp src/a/two.cpp
expect 0 "src/a/one.cpp src/a/two.cpp " "lint: clean" "what was left unchecked is not known as clean" src/a/one.cpp src/a/two.cpp

cd "$repository"
printf 'lint_test: %d of %d cases passed\n' $((cases - failures)) "$cases"
[ "$failures" = 0 ]
