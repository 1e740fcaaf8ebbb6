# files open elsewhere: GLB in trimesh, MJCF in MuJoCo, pictures, tables, a report, own products
store=$(a_store)
pip install --quiet trimesh mujoco
marketgen export "$store" --format glb -o shop.glb --check --quiet
python - "$store" <<'PYTHON'
import json, sys

import trimesh

scene = trimesh.load_scene("shop.glb")
products = json.load(open(sys.argv[1] + "/store.json"))["counts"]["products"]
assert len(scene.graph.nodes_geometry) >= products, (len(scene.graph.nodes_geometry), products)
PYTHON
marketgen export "$store" --format mjcf -o shop.xml --check --quiet
python -c 'import mujoco; mujoco.MjModel.from_xml_path("shop.xml")'
marketgen render "$store" --size 320x200 -o x.jpg --quiet
python -c 'assert open("x.jpg", "rb").read(3) == b"\xff\xd8\xff"'
if marketgen render "$store" -o x.gif; then fail "x.gif was written"; fi
if marketgen query "$store" products --where "price<abc"; then fail "price<abc passed"; fi
marketgen report "$store" -o report.html --quiet > /dev/null
grep -q '<svg' report.html
printf 'sku,ean,name,category,subcategory,archetype,size_mm,mass_kg\nown-cola,2999999999991,Lemonade,beverages,soft drinks,can,66x66x115,0.35\n' > own.csv
marketgen generate "a kiosk with cold drinks" --size 8x7m --catalog own.csv --no-previews -o own --quiet
marketgen query own products --where sku=own-cola | grep -q own-cola
