#!/usr/bin/env python3
"""How much of drawings of zones the stores that are made from them keep.

    tests/zone_drawings/measure_stores.py build/release/marketgen FOLDER     # of make_zone_drawings.py

IoU: squares of the floor on which a zone of the store and the drawn zone that it is paired with agree, over squares of either;
pairs are those with the largest overlap, each zone once. What is written on zones is not judged here.
"""

import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

COLUMNS, ROWS = 240, 160
TILLS = {"Checkout", "Checkouts", "Tills", "收银", "收银台"}


def rectangles(plan):
    """Of each zone, as fractions of the floor."""
    nodes = {node["id"]: node for node in plan["nodes"]}
    width, depth = plan["shell"]["width_mm"], plan["shell"]["depth_mm"]
    found = {}

    def cut(name, x0, y0, x1, y1):
        node = nodes[name]
        if node.get("zone"):
            found[node["zone"]] = (x0 / width, y0 / depth, x1 / width, y1 / depth)
            return
        gap, ratio = node.get("gap_mm", 0), node.get("ratio", 0.5)
        first, second = node["children"]
        if node["split"] == "x":
            middle = x0 + int(ratio * (x1 - x0 - gap) + 0.5)
            cut(first, x0, y0, middle, y1)
            cut(second, middle + gap, y0, x1, y1)
        else:
            middle = y0 + int(ratio * (y1 - y0 - gap) + 0.5)
            cut(first, x0, y0, x1, middle)
            cut(second, x0, middle + gap, x1, y1)

    cut(plan["nodes"][0]["id"], 0, 0, width, depth)
    return found


def squares(box):
    x0, y0, x1, y1 = box
    return {
        (column, row)
        for column in range(COLUMNS)
        if x0 <= (column + 0.5) / COLUMNS < x1
        for row in range(ROWS)
        if y0 <= (row + 0.5) / ROWS < y1
    }


def agreement(truth, plan):
    width, depth = truth["width"], truth["depth"]
    drawn = [
        squares((z["x"] / width, z["y"] / depth, (z["x"] + z["w"]) / width, (z["y"] + z["d"]) / depth)) for z in truth["zones"]
    ]
    built = [squares(box) for box in rectangles(plan).values()]
    overlaps = sorted(((len(a & b), i, j) for i, a in enumerate(drawn) for j, b in enumerate(built)), reverse=True)
    used_drawn, used_built, shared = set(), set(), 0
    for overlap, i, j in overlaps:
        if i not in used_drawn and j not in used_built:
            used_drawn.add(i)
            used_built.add(j)
            shared += overlap
    either = sum(map(len, drawn)) + sum(map(len, built)) - shared
    return shared / either


def count_runs(truth, plan, shelves):
    """Of drawn zones with shelves: how many have a plan's zone with as many runs (or the same axis), each of which pairs by overlap."""
    boxes = rectangles(plan)
    width, depth = truth["width"], truth["depth"]
    for z in truth["zones"]:
        if "runs" not in z:
            continue
        drawn = squares((z["x"] / width, z["y"] / depth, (z["x"] + z["w"]) / width, (z["y"] + z["d"]) / depth))
        best = max(boxes, key=lambda name: len(squares(boxes[name]) & drawn))
        fixture = next(zone["fixture"] for zone in plan["zones"] if zone["id"] == best)
        shelves["drawn"] += 1
        shelves["axis"] += fixture.get("axis") == z["runs"][1]
        shelves["count"] += fixture.get("axis") == z["runs"][1] and fixture.get("runs") == z["runs"][0]


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    rows, shelves = [], {"drawn": 0, "count": 0, "axis": 0}
    for truth in json.loads((folder / "truth.json").read_text()):
        with tempfile.TemporaryDirectory() as scratch:
            shop = pathlib.Path(scratch) / "shop"
            made = subprocess.run(
                [program, "generate", "--image", folder / truth["file"], "-o", shop, "--no-previews", "--quiet", "--json"],
                capture_output=True,
                text=True,
                check=False,
            )
            if made.returncode != 0:
                print(truth["file"], "not made:", made.stderr.strip().splitlines()[-1])
                rows.append((truth, 0.0, 0, 1.0, 0.0))
                continue
            report = json.loads(made.stdout)["report"]
            plan = json.loads((shop / "plan.json").read_text())
            iou = agreement(truth, plan)
            count_runs(truth, plan, shelves)
        hard = sum(rule["severity"] == "hard" for rule in report["rules"])
        planning = sum(s["seconds"] for s in report["timing_s"] if s["stage"] == "plan")
        rows.append((truth, iou, hard, report["metrics"]["NAV"], planning))
        print(f"{truth['file']} {truth['style']:<8} IoU {iou:.3f}  hard {hard}  NAV {report['metrics']['NAV']:.4f}  plan {planning:.2f} s")
    with_tills = [row[1] for row in rows if any(zone["words"] in TILLS for zone in row[0]["zones"])]
    ious = [row[1] for row in rows]
    print(
        f"{len(rows)} drawings: IoU median {statistics.median(ious):.3f}, worst {min(ious):.3f}; of {len(with_tills)} with tills "
        f"drawn {statistics.median(with_tills) if with_tills else 0:.3f}; hard rules broken {sum(row[2] for row in rows)}; "
        f"NAV worst {min(row[3] for row in rows):.4f}"
    )
    if shelves["drawn"]:
        print(f"of {shelves['drawn']} zones with shelves {shelves['count']} have as many runs, {shelves['axis']} their direction")


main()
