# pip uninstall leaves nothing behind
pip uninstall --yes marketgen
test ! -e "$VENV/bin/marketgen"
test -z "$(find "$VENV" -iname '*marketgen*')"
