# pip install . !
cd "$TREE"
pip install .
cd /
test "$(command -v marketgen)" = "$VENV/bin/marketgen"
