# damaged caches: the same answers, the files named
export MARKETGEN_CACHE="$WORK/damaged-cache"
can=beverages-cola-original-330ml
rates() { marketgen grasps "$can" --tool panda-hand --tries 1 --quiet --json | python -c 'import json, sys; print(json.load(sys.stdin)["rates"])'; }
store=$(a_store)
view() { marketgen render "$store" --camera entrance --size 160x90 --quality fast --quiet -o "$1"; }
rates > fresh.txt
view fresh.png
find "$MARKETGEN_CACHE" -type f -exec truncate -s 100 {} +
rates > healed.txt 2> named.txt
view healed.png 2>> named.txt
cmp fresh.txt healed.txt
cmp fresh.png healed.png
grep -q grasps.sqlite named.txt
grep -q labels/ named.txt
