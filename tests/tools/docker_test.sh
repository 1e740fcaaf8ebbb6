#!/usr/bin/env bash
# The Dockerfile: hadolint finds nothing in it, what it names is there, nothing that Git ignores goes into the build, and the program
# does not run as root. Where Docker runs (MARKETGEN_DOCKER=OFF: not even there), it is built, and makes a store. Its build is that of
# tools/wheels, which tools/newcomer does in a clean clone and tools/try_wheel tries in a bare root.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
fail() { printf 'docker_test: FAIL: %s\n' "$1"; exit 1; }

.venv/bin/hadolint Dockerfile || fail "hadolint"

for path in $(grep '^RUN' Dockerfile | grep -o 'tools/[a-z_]*'); do
  [ -x "$path" ] || fail "$path is not there"
done
grep -q bookworm tools/setup && ! grep '^FROM' Dockerfile | grep -v '^FROM debian:12-slim' || fail "not Debian 12, for which tools/setup is"
last_user=$(sed -n 's/^USER //p' Dockerfile | tail -n 1)
[ -n "$last_user" ] && [ "$last_user" != root ] && [ "$last_user" != 0 ] || fail "the program runs as root"

# What Git ignores, Docker does: the same names, in the words of each.
ignored=$(sed 's/^\/\(.*\)\/$/\1/; t; s/\/$//; s/^/**\//' .gitignore | sort)
[ "$ignored" = "$(grep -v '^#' .dockerignore | sort)" ] || fail ".dockerignore is not .gitignore: $ignored"

if [ "${MARKETGEN_DOCKER:-ON}" = OFF ] || ! docker info > /dev/null 2>&1; then
  printf 'docker_test: no Docker here: the image was not built\ndocker_test: passed\n'
  exit 0
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
docker build --quiet -t marketgen:test . > /dev/null || fail "docker build"
docker run --rm -v "$scratch:/work" --user "$(id -u):$(id -g)" marketgen:test generate "a kiosk with cold drinks" --size 6x5m -o shop ||
  fail "docker run … generate"
[ -f "$scratch/shop/scene.bin" ] || fail "no store was made"
[ "$(docker run --rm --entrypoint id marketgen:test -u)" = "$last_user" ] || fail "another user than the Dockerfile's"
printf 'docker_test: passed, with the image\n'
