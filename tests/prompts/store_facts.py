"""Reads a finished store folder into plain facts (docs/formats.md of the program describes the files).

Taken from the finished store: layout.json for the room, zones, fixtures and look; scene.bin for shelves,
facings and goods; report.json only for what the program says it did NOT understand or could not keep,
and for its times. What it lists as understood ("requirements") is never read."""
import json
import math
import pathlib
import statistics

import store_geometry as geometry
from scene_reader import FLAG_FRONT, USE_STAND, read_scene

DATA = pathlib.Path(__file__).resolve().parents[2] / "data"
ENTRANCE_EQUIPMENT = {"basket_stack", "trolley_bay", "gate", "pillar"}
# Kinds of the catalogue by how they are built, where the name differs from ids.txt.
KIND_OF_GENERATOR = {"coffee_machine": "coffee_counter", "fish_counter": "serve_over", "ice_cream_chest": "chest_freezer",
                     "produce_bins": "produce_table", "bread_cabinet": "bakery_rack"}
# A zone without goods is there when its equipment is.
EQUIPMENT_OF_ZONE = {"checkout": {"checkout_lane"}, "self_checkout": {"self_checkout"},
                     "customer_service": {"kiosk"}, "cafe": {"coffee_counter"}}


def load_json(path):
    with open(path, encoding="utf8") as file:
        return json.load(file)


def load_rows(name):
    return load_json(DATA / name)


def kind_names():
    """id in the layout -> the kind of ids.txt that it is one of"""
    names = {}
    for row in load_rows("fixtures.json"):
        kind = KIND_OF_GENERATOR.get(row["generator"], row["generator"])
        if kind == "glass_door_cooler" and row["temperature"] == "frozen":
            kind = "glass_door_freezer"
        if kind == "kiosk" and row["role"] == "checkout":
            kind = "checkout_lane"  # the counter with a till of a small shop
        names[row["kind"]] = kind
    return names


def read_shell(layout):
    shell = layout["shell"]
    w, d = shell["width_mm"] / 1000, shell["depth_mm"] / 1000
    outline = [(x / 1000, y / 1000) for x, y in shell.get("outline_mm") or []]
    return {"width_m": w, "depth_m": d, "ceiling_m": shell["ceiling_mm"] / 1000, "columns": len(shell.get("columns", [])),
            "area_m2": geometry.polygon_area(outline) if len(outline) > 2 else w * d, "floor": [0, 0, w, d]}


def read_openings(layout, shell):
    w, d = shell["width_m"], shell["depth_m"]
    openings = []
    for o in layout["shell"].get("openings", []):
        share, half = o["center"], o["width_mm"] / 2000
        x = {"west": 0, "east": w}.get(o["wall"], share * w)
        y = {"south": 0, "north": d}.get(o["wall"], share * d)
        dx, dy = geometry.INWARD[o["wall"]]
        beside = half if dy else 0, half if dx else 0
        rect = [x - beside[0], y - beside[1], x + beside[0], y + beside[1]]
        inside = [rect[0] + min(dx, 0), rect[1] + min(dy, 0), rect[2] + max(dx, 0), rect[3] + max(dy, 0)]
        openings.append({"kind": o["kind"], "wall": o["wall"], "center": share, "rect": inside})
    return openings


def read_fixtures(layout, scene):
    names = kind_names()
    zone_type = {z["id"]: z["type"] for z in layout["zones"]}
    fixtures = []
    for f in layout["fixtures"]:
        yaw = f.get("yaw_deg", 0)
        rect = geometry.rect_of(f["x_mm"] / 1000, f["y_mm"] / 1000, f["width_mm"] / 1000, f["depth_mm"] / 1000, yaw)
        fixtures.append({"id": f["id"], "kind": names.get(f["kind"], f["kind"]), "zone": zone_type.get(f["zone"], f["zone"]),
                         "zone_id": f["zone"], "rect": rect, "yaw": yaw, "sides": f.get("sides", 1),
                         "height_m": f["height_mm"] / 1000, "material": f.get("material", ""), "color": f.get("color", ""),
                         "items": 0, "levels": 0, "pitches_m": []})
    if len(scene["fixtures"]) != len(fixtures):
        raise ValueError("scene.bin and layout.json have different numbers of fixtures")
    add_shelves(fixtures, scene)
    return fixtures


def add_shelves(fixtures, scene):
    heights = [{} for _ in fixtures]
    for shelf in scene["shelves"]:
        side = heights[shelf["fixture"]].setdefault(shelf["side"], {})
        side[shelf["level"]] = shelf["z"]
    for f, sides in zip(fixtures, heights):
        f["levels"] = max((len(levels) for levels in sides.values()), default=0)
        for levels in sides.values():
            zs = sorted(levels.values())
            f["pitches_m"] += [round(b - a, 4) for a, b in zip(zs, zs[1:])]
    for facing in scene["facings"]:
        fixtures[scene["shelves"][facing["shelf"]]["fixture"]]["items"] += facing["items"]


def read_zones(layout, fixtures):
    zones = []
    for z in layout["zones"]:
        polygon = [(x / 1000, y / 1000) for x, y in z["polygon_mm"]]
        own = [f for f in fixtures if f["zone_id"] == z["id"] and f["kind"] not in ENTRANCE_EQUIPMENT]
        equipment = EQUIPMENT_OF_ZONE.get(z["type"])
        if z["type"] == "backroom":
            is_there = geometry.polygon_area(polygon) > 0
        elif equipment:
            is_there = any(f["kind"] in equipment for f in own)
        else:
            is_there = any(f["items"] > 0 for f in own)
        rect = geometry.bounds([f["rect"] for f in own] or [(x, y, x, y) for x, y in polygon])
        zones.append({"id": z["id"], "type": z["type"], "rect": rect, "area_m2": geometry.polygon_area(polygon),
                      "is_there": is_there})
    return zones


def yaw_off_degrees(rotation, quarter_turns):
    w, x, y, z = rotation
    yaw = math.degrees(math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)))
    return abs((yaw - 90 * quarter_turns + 45) % 90 - 45)


def read_stock(fixtures, scene):
    """Figures of each zone type: shelf front and what is stocked, facings, the goods in the front row."""
    stock = {}
    zones = [stock.setdefault(f["zone"], {"front_m": 0.0, "stocked_m": 0.0, "facings": 0, "empty_facings": 0, "front_items": 0,
                                          "misplaced": 0, "standing": 0, "out_of_line": 0}) for f in fixtures]
    for shelf in scene["shelves"]:
        zones[shelf["fixture"]]["front_m"] += shelf["width"]
    for facing in scene["facings"]:
        zone = zones[scene["shelves"][facing["shelf"]]["fixture"]]
        zone["facings"] += 1
        zone["empty_facings"] += facing["items"] == 0
        zone["stocked_m"] += facing["width"] if facing["items"] else 0
    front = {}
    for product in scene["products"]:
        facing = scene["facings"][product["facing"]]
        zone = zones[scene["shelves"][facing["shelf"]]["fixture"]]
        zone["misplaced"] += product["sku"] != facing["sku"]
        zone["front_items"] += bool(product["flags"] & FLAG_FRONT)
        if product["flags"] & FLAG_FRONT:
            front.setdefault(product["facing"], []).append(product)
    for row, products in front.items():
        shelf = scene["shelves"][scene["facings"][row]["shelf"]]
        if shelf["use"] == USE_STAND:
            zones[shelf["fixture"]]["standing"] += len(products)
            zones[shelf["fixture"]]["out_of_line"] += out_of_line(products, scene["fixtures"][shelf["fixture"]]["quarter_turns"])
    return {name: zone for name, zone in stock.items() if zone["front_m"] > 0}


def out_of_line(products, quarter_turns):
    """How many goods in the front of one block are turned by more than 3 degrees, or stand more than
    10 mm before or behind the block's middle one: what an eye sees as untidy."""
    turn = math.radians(90 * quarter_turns)
    depths = [p["position"][1] * math.cos(turn) - p["position"][0] * math.sin(turn) for p in products]
    middle = statistics.median(depths)
    return sum(abs(depth - middle) > 0.010 or yaw_off_degrees(p["rotation"], quarter_turns) > 3
               for p, depth in zip(products, depths))


def read_goods(fixtures, scene):
    """Each product that stands in the store, with the zone types where it does."""
    zones = {}
    for product in scene["products"]:
        shelf = scene["shelves"][scene["facings"][product["facing"]]["shelf"]]
        zones.setdefault(product["sku"], set()).add(fixtures[shelf["fixture"]]["zone"])
    return [{**scene["catalog"][row], "zones": sorted(where)} for row, where in sorted(zones.items())]


def read_report(folder):
    report = load_json(folder / "report.json")
    times = {t["stage"]: t["seconds"] for t in report.get("timing_s", [])}
    planning = [times[s] for s in ("plan", "repair", "layout") if s in times]
    return {"unparsed": report.get("unparsed", []), "conflicts": report.get("conflicts", []),
            "planning_s": sum(planning) if planning else None}


def read_store(folder):
    folder = pathlib.Path(folder)
    layout = load_json(folder / "layout.json")
    scene = read_scene(folder / "scene.bin")
    shell = read_shell(layout)
    fixtures = read_fixtures(layout, scene)
    runs = geometry.runs_of(fixtures)
    return {"name": layout.get("name", ""), "profile": layout.get("profile", ""), "shell": shell,
            "openings": read_openings(layout, shell), "zones": read_zones(layout, fixtures), "fixtures": fixtures,
            "runs": runs, "aisles": geometry.aisles_of(runs, fixtures, shell["floor"]),
            "stock": read_stock(fixtures, scene), "goods": read_goods(fixtures, scene), "look": layout.get("look", {}),
            **read_report(folder)}
