#!/usr/bin/env bash
# schemas/ and docs/fields/ are what the program writes (refresh both with tools/refresh_golden), and outside readers agree with
# it: jsonschema accepts the JSON files of a generated store, flatc reads scene.bin with the committed schema, and so does the
# Python code that flatc makes of it, beside our own package.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/../support/small_shop.bash"

"$program" schemas -o "$scratch"
diff -r "$repository/schemas" "$scratch/schemas"
diff -r "$repository/docs/fields" "$scratch/docs/fields"

"$program" render "$scratch/shop" --camera aisle --size 160x120 --quality fast --quiet -o "$scratch/aisle.png" --annotations "$scratch/shop/seen.json"
"$program" shop "$scratch/shop" "snacks for two" --json > "$scratch/shop/shopping.json"
# --size-prefixed: the file starts with its length.
flatc --json --strict-json --size-prefixed -o "$scratch" "$repository/schemas/market-scene-1.fbs" -- "$scratch/shop/scene.bin"

# Classes for Python, where a user makes them: in the folder from which `import marketgen` must still find our package.
(cd "$scratch" && flatc --python "$repository/schemas/market-scene-1.fbs")

"$python" - "$repository" "$scratch" <<'JUDGE'
import json
import pathlib
import sys

import jsonschema
import numpy

repository, scratch = map(pathlib.Path, sys.argv[1:])


def load(path):
    return json.loads(path.read_text(encoding="utf-8"))


def judge(name):
    schema = load(repository / "schemas" / f"{name}.schema.json")
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


checked = 0
for file, name in [("plan.json", "market-plan-1"), ("layout.json", "market-layout-1"), ("store.json", "market-store-1"), ("report.json", "market-report-1"),
                   ("seen.json", "market-annotations-1"), ("shopping.json", "market-shopping-1")]:
    document, validator = load(scratch / "shop" / file), judge(name)
    validator.validate(document)
    assert not validator.is_valid({**document, "unheard_of": 1}), f"{name} lets an unknown field through"
    assert not validator.is_valid({**document, "schema": "market-else/1"}), f"{name} lets another schema tag through"
    checked += 1
for folder, name in [("data/products", "market-product-1"), ("data", "market-fixture-1")]:
    for path in sorted((repository / folder).glob("*.json" if name == "market-product-1" else "fixtures.json")):
        validator = judge(name)
        for row in load(path):
            validator.validate(row)
            checked += 1
for path in sorted((repository / "data/robots").glob("*.json")):
    judge("market-robot-1").validate(load(path))
    checked += 1

# Files that our reader refuses by their schema are refused by this one too.
for path in sorted((repository / "tests/fixtures/invalid").glob("plan_*.json")):
    if path.stem in {"plan_unknown_field", "plan_misspelt_field", "plan_negative_size", "plan_absurd_size", "plan_wrong_type", "plan_fractional_millimetres",
                     "plan_list_for_object", "plan_missing_shell", "plan_other_schema", "plan_bad_identifier", "plan_unknown_enum_name", "plan_three_children"}:
        assert not judge("market-plan-1").is_valid(load(path)), path
        checked += 1

manifest, scene = load(scratch / "shop/store.json"), load(scratch / "scene.json")
assert len(scene["products"]) == manifest["counts"]["products"], "flatc counts other products"
assert len(scene["fixtures"]) == manifest["counts"]["fixtures"]
assert len(scene["catalog"]) == manifest["counts"]["skus"]
assert sum(facing.get("facings", 0) for facing in scene["facings"]) == manifest["counts"]["facings"]
assert all(product["sku"] < len(scene["catalog"]) for product in scene["products"])

sys.path.insert(0, str(scratch))
import marketgen_scene.Scene  # noqa: E402

assert not (scratch / "marketgen").exists(), "the classes of flatc shadow the package marketgen"
bytes_of_scene = (scratch / "shop/scene.bin").read_bytes()
assert bytes_of_scene[8:12] == b"MGS1"  # behind the length and the root's offset
flat = marketgen_scene.Scene.Scene.GetRootAs(bytes_of_scene, 4)
assert flat.ProductsLength() == len(scene["products"])
assert [flat.Catalog(i).Sku().decode() for i in range(flat.CatalogLength())] == [row["sku"] for row in scene["catalog"]]
row = len(scene["products"]) // 2
assert numpy.allclose(flat.Products(row).PositionM(), scene["products"][row]["position_m"], atol=1e-5)  # flatc rounds
print(f"{checked} documents agree with their schemas; flatc reads {len(scene['products'])} products")
JUDGE
