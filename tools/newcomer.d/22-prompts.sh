# first prompts: sizes, nonsense, impossible wishes, numbers out of range
marketgen generate "a kiosk of 40 m2 with snacks and cold drinks" -o kiosk --no-previews --quiet
python - <<'PYTHON'
import json

shell = json.load(open("kiosk/plan.json"))["shell"]
area = shell["width_mm"] * shell["depth_mm"] / 1e6
assert 38 < area < 42, area
PYTHON
marketgen generate "5 x 38 m supermarket" -o narrow --no-previews > narrow.txt
grep -q 'rules       0 hard' narrow.txt
marketgen generate "asdf qwerty" -o nonsense --no-previews > nonsense.txt 2>&1
grep -q 'nothing of the prompt was understood' nonsense.txt
if marketgen generate "asdf qwerty" --strict -o strict --no-previews --quiet; then fail "nonsense passed --strict"; fi
if marketgen generate "a shop" --seed 18446744073709551616 -o seed; then fail "a seed above 2^64 passed"; fi
if marketgen grasps --sample=-1; then fail "--sample -1 passed"; fi
marketgen generate "drugstore, 0.3 m wide aisles" -o drug --no-previews --quiet
marketgen check drug/plan.json
timeout 20 marketgen generate "10000 exits" -o exits --no-previews > exits.txt
grep -q 'not met   "10000 exits"' exits.txt
