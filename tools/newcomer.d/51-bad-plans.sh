# a floor of glass, a changed file, a long list
marketgen generate "corner shop" --size 8x6m --no-previews -o plain --quiet
python - <<'PYTHON'
import json

plan = json.load(open("plain/plan.json"))
plan["look"]["floor"] = "glass-clear"
json.dump(plan, open("glass.json", "w"))
open("list.json", "w").write("[" + ",".join(["{}"] * 300000) + "]")
PYTHON
marketgen check glass.json
marketgen generate --plan glass.json --no-previews -o glass --quiet
marketgen export glass --format glb -o glass.glb --check --quiet
printf x | dd of=glass/scene.bin bs=1 seek=5000 conv=notrunc 2> /dev/null
if marketgen query glass zones; then fail "a changed scene.bin was read"; fi
status=0
timeout 10 marketgen check list.json || status=$?
test "$status" = 2
