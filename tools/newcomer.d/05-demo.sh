# make demo
make -C "$TREE" demo
test -s "$TREE/out/demo/scene.bin"
test -s "$TREE/out/demo-aisle.png"
test -s "$TREE/out/demo-aisle.mp4"
