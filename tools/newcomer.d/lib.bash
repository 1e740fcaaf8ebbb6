# What the steps of tools/newcomer share. Read by each step before its own lines.

fail() { printf 'FAIL: %s\n' "$*" >&2; exit 1; }

# block FILE LANGUAGE TEXT: the first fenced block of a document, in that language, that has the text in it.
block() {
  awk -v language="$2" -v text="$3" '
    !inside && $0 == "```" language { inside = 1; body = ""; next }
    inside && $0 == "```" { inside = 0; if (index(body, text)) { printf "%s", body; found = 1; exit } next }
    inside { body = body $0 "\n" }
    END { exit !found }' "$1" || fail "no $2 block with '$3' in $1"
}

# a_store: a folder with a small store; made once.
a_store() {
  [ -d "$WORK/corner" ] ||
    marketgen generate "a corner shop with cold drinks, snacks, canned food and one checkout" --size 9x7m --no-previews -o "$WORK/corner" > /dev/null
  printf '%s\n' "$WORK/corner"
}
