# README's three command lines
mkdir commands
block "$TREE/README.md" sh "-o aisle.png" > commands.sh
test "$(grep -c '^build/release/marketgen ' commands.sh)" = 3
# They are written for the build tree; without one (--no-demo) it is the installed command that does them.
if [ -x "$TREE/build/release/marketgen" ]; then ln -s "$TREE/build" commands/build; else sed -i 's,^build/release/,,' commands.sh; fi
cd commands
bash -euxo pipefail ../commands.sh
test -s shop/scene.bin && test -s aisle.png && test -s shop.xml
