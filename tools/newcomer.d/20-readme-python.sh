# README's Python block
block "$TREE/README.md" python "import marketgen" > readme.py
printf 'assert frame.rgb.std() > 5 and frame.depth.max() > 0\n' >> readme.py
python readme.py
marketgen check shop
