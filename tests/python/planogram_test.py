"""Planograms, written by export, changed with csv, brought back; strangers in front counted again from the table of items."""

import collections
import csv
import json
import math
import statistics
import subprocess

import pytest
from conftest import PROGRAM, ROOT, run

PROMPT = "a supermarket with bakery, dairy, produce, snacks, frozen and two checkouts"


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """`tidy`, in which all stands as planned, and `untidy`, the same store with faults; the planogram of both."""
    made = tmp_path_factory.mktemp("planogram")
    run("generate", PROMPT, "--size", "16x12m", "--seed", 5, "-o", made / "shop", "--no-previews", "--quiet")
    zones = [zone["id"] for zone in json.loads((made / "shop/plan.json").read_text())["zones"]]
    for name, faults in {
        "tidy": {"out_of_stock": 0},
        "untidy": {"out_of_stock": 0.1, "misplaced": 0.1, "price_tags": {"missing": 0.1, "wrong_price": 0.1}},
    }.items():
        patches = [{"set_stock": {"zone": zone, **faults}} for zone in zones]
        (made / "patch.json").write_text(json.dumps({"schema": "market-patch/1", "patches": patches}))
        run("edit", made / "shop", "--patch", made / "patch.json", "-o", made / name, "--no-previews", "--quiet")
    run("export", made / "tidy", "--format", "planogram", "-o", made / "planogram.csv", "--quiet")
    return made


def rows_of(file):
    with open(file, newline="", encoding="utf-8") as opened:
        return list(csv.DictReader(opened))


def write(file, rows, delimiter=",", encoding="utf-8"):
    with open(file, "w", newline="", encoding=encoding) as opened:
        writer = csv.DictWriter(opened, rows[0], delimiter=delimiter)
        writer.writeheader()
        writer.writerows(rows)


def compliance(store, planogram):
    return json.loads(run("check", store, "--planogram", planogram, "--json"))["compliance"]


def edit(store, planogram, out):
    return json.loads(run("edit", store, "--planogram", planogram, "-o", out, "--no-previews", "--json", "--quiet"))


def hash_of(store):
    return json.loads((store / "store.json").read_text())["scene_hash"]


def test_a_stores_own_planogram_changes_nothing(folder):
    done = edit(folder / "tidy", folder / "planogram.csv", folder / "same")
    assert done["folder"] == "" and done["patches"] == []
    assert "shelves of" in done["so_already"][0]
    assert not (folder / "same").exists()


def test_own_planogram_of_a_tidy_store_is_met(folder):
    measured = compliance(folder / "tidy", folder / "planogram.csv")
    facings = sum(int(row["facings_wide"]) for row in rows_of(folder / "planogram.csv"))
    assert measured["score"] == 1 and measured["tag_score"] == 1
    assert measured["facings"]["planned"] == measured["facings"]["met"] == facings
    assert measured["extra"] == 0 and measured["unmet"] == []


def columns_of(items, facing_deg, width_m):
    """(towards the front, item) of each column of a block, from where its packs stand alone; a column's packs lie within half a pack."""
    turn = math.radians(facing_deg)  # 0 faces south
    front, along = (math.sin(turn), -math.cos(turn)), (math.cos(turn), math.sin(turn))
    columns, last = [], -math.inf
    for item in sorted(items, key=lambda item: item["x_m"] * along[0] + item["y_m"] * along[1]):
        at = item["x_m"] * along[0] + item["y_m"] * along[1]
        if at - last > width_m / 2:
            columns.append([])
        columns[-1].append((item["x_m"] * front[0] + item["y_m"] * front[1], item))
        last = at
    return columns


def sizes_of_catalogue():
    """Width and depth in metres by SKU."""
    rows = [row for file in sorted((ROOT / "data/products").glob("*.json")) for row in json.loads(file.read_text())]
    return {row["sku"]: (row["size_mm"][0] / 1000, row["size_mm"][1] / 1000) for row in rows}


def test_strangers_in_front_are_those_that_the_table_of_items_has(folder):
    planned = {row["sku"]: (int(row["width_mm"]) / 1000, int(row["depth_mm"]) / 1000) for row in rows_of(folder / "planogram.csv")}
    size = sizes_of_catalogue() | planned
    blocks = collections.defaultdict(list)
    for item in json.loads(run("query", folder / "untidy", "products", "--format", "json")):
        if item["fixture"]:
            blocks[item["id"].rsplit("/item-", 1)[0]].append(item)
    strangers = []
    for items in blocks.values():
        own = [item for item in items if not item["misplaced"]] or items
        facing = 90 * statistics.mode(round(item["yaw_deg"] / 90) % 4 for item in own)  # 180 and -180 are one; strangers lie as they were put
        for column in columns_of(items, facing, size[own[0]["sku"]][0]):
            foremost = max(at for at, _ in column)
            stack = [item for at, item in column if at > foremost - size[item["sku"]][1] / 2]
            strangers += [item["sku"] for item in stack if item["misplaced"]][:1]
    measured = compliance(folder / "untidy", folder / "planogram.csv")["facings"]
    assert len(strangers) > 100
    assert measured["misplaced"] == sum(sku in planned for sku in strangers)
    assert measured["wrong_product"] == sum(sku not in planned for sku in strangers)


def test_a_changed_planogram_comes_back_as_it_was_written(folder):
    rows = rows_of(folder / "planogram.csv")
    shelves = collections.defaultdict(list)
    for row in rows:
        if row["merchandising"] == "unit":
            shelves[row["fixture"], row["side"], row["shelf"]].append(row)
    changed = []
    for place, on_shelf in list(shelves.items())[::7]:
        on_shelf = [dict(row, x_mm="", facings_high="", facings_deep="") for row in reversed(on_shelf)][1:]
        if not on_shelf:
            continue
        for number, row in enumerate(on_shelf):
            row["position"] = str(number + 1)
            row["facings_wide"] = "1"
        changed += on_shelf
    assert len(changed) > 10
    write(folder / "changed.csv", changed, delimiter=";", encoding="utf-8-sig")  # as Excel does in Germany
    edit(folder / "tidy", folder / "changed.csv", folder / "as-planned")
    run("check", folder / "as-planned")
    assert compliance(folder / "as-planned", folder / "changed.csv")["score"] == 1
    run("export", folder / "as-planned", "--format", "planogram", "-o", folder / "after.csv", "--check", "--quiet")
    named = {(row["fixture"], row["side"], row["shelf"]) for row in changed}
    said = lambda rows, columns, ours: sorted(
        tuple(row[c] for c in columns)
        for row in rows
        if ((row["fixture"], row["side"], row["shelf"]) in named) == ours
    )
    after = rows_of(folder / "after.csv")
    ordered = ["fixture", "side", "shelf", "position", "sku", "facings_wide"]
    assert said(after, ordered, True) == said(changed, ordered, True)
    whole = [column for column in rows[0] if column != "store"]
    assert said(after, whole, False) == said(rows, whole, False)
    before = hash_of(folder / "as-planned")
    seed = json.loads((folder / "as-planned/store.json").read_text())["seed"]
    run("generate", "--plan", folder / "as-planned/plan.json", "--seed", seed, "-o", folder / "again", "--no-previews", "--quiet")
    assert hash_of(folder / "again") == before


def test_refused_rows_are_all_named_and_nothing_is_written(folder):
    rows = rows_of(folder / "planogram.csv")[:3]
    rows[0]["sku"], rows[0]["gtin"] = "no-such-thing", ""
    rows[2]["facings_wide"] = "150"
    write(folder / "wrong.csv", rows)
    done = subprocess.run(
        [PROGRAM, "edit", folder / "tidy", "--planogram", folder / "wrong.csv", "-o", folder / "none"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2
    assert "wrong.csv:2:/sku" in done.stderr and "wrong.csv:4:/facings_wide" in done.stderr
    assert not (folder / "none").exists()


def test_in_python(folder):
    import marketgen

    store = marketgen.open_store(folder / "tidy")
    assert store.compliance(folder / "planogram.csv")["score"] == 1
    assert store.edit(planogram=folder / "planogram.csv") is store
    row = dict(rows_of(folder / "planogram.csv")[0], sku="", gtin="", facings_wide="")
    write(folder / "empty.csv", [row])
    emptied = store.edit(planogram=folder / "empty.csv", folder=folder / "emptied")
    where = f"fixture={row['fixture']},level={int(row['shelf']) - 1}"
    assert store.query("planogram", where) and not emptied.query("planogram", where + ",side=0")
    with pytest.raises(marketgen.Error, match="no-such-thing") as caught:
        write(folder / "unknown.csv", [dict(row, sku="no-such-thing", facings_wide="1")])
        store.edit(planogram=folder / "unknown.csv")
    assert caught.value.code == "catalog.unknown_sku"


def test_two_blocks_trade_places_by_a_patch(folder):
    rows = rows_of(folder / "planogram.csv")

    def place(row):
        return {"fixture": row["fixture"], "side": row["side"], "shelf": int(row["shelf"]), "position": int(row["position"]), "sku": row["sku"]}

    a, b = next((a, b) for a, b in zip(rows, rows[1:]) if all(a[key] == b[key] for key in ("fixture", "side", "shelf")) and a["sku"] != b["sku"])
    swap = folder / "swap.json"
    swap.write_text(json.dumps({"schema": "market-patch/1", "patches": [{"swap_blocks": {"a": place(a), "b": place(b)}}]}))
    run("edit", folder / "tidy", "--patch", swap, "-o", folder / "swapped", "--no-previews", "--quiet")
    run("export", folder / "swapped", "--format", "planogram", "-o", folder / "swapped.csv", "--quiet")
    wanted = {tuple(place(row).values())[:4]: (row["sku"], row["facings_wide"]) for row in rows}
    at, to = (tuple(place(row).values())[:4] for row in (a, b))
    wanted[at], wanted[to] = wanted[to], wanted[at]
    assert {tuple(place(row).values())[:4]: (row["sku"], row["facings_wide"]) for row in rows_of(folder / "swapped.csv")} == wanted
    swap.write_text(json.dumps({"schema": "market-patch/1", "patches": [{"swap_blocks": {"a": {**place(a), "sku": b["sku"]}, "b": {**place(b), "sku": a["sku"]}}}]}))
    run("edit", folder / "swapped", "--patch", swap, "-o", folder / "swapped-back", "--no-previews", "--quiet")
    assert hash_of(folder / "swapped-back") == hash_of(folder / "tidy")
