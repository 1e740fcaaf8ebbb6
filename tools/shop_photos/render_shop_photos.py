#!/usr/bin/env python3
"""Photos of shops of known look, drawn by MarketGen's own renderer: what the bank of `marketgen.read_photo` is made and measured with.

    PYTHONPATH=build/release/python .venv/bin/python tools/shop_photos/render_shop_photos.py FOLDER [--shops 500] [--seed 1]
        [--photos 4] [--mode sensor] [--samples 0] [--jobs 2]

FOLDER/photos.jsonl has one line a photo: its file, its shop, and the truth: materials of floor, wall, ceiling and fixtures, lamps, colour
temperature, levels of the shelves, kind of shop, and what the photographer saw (direction and width of the aisle where he stood).
Beside each photo lies what its pixels show, FILE.parts.png: 0 nothing, 1 floor, 2 wall, 3 ceiling, 4 fixture, 5 goods.

Looks are drawn evenly over the classes of CLASSES, not over materials, so that rare ones are in the bank. Photos have what photos have:
hand-held poses, lenses from wide to normal, wrong white balance and exposure, noise, vignettes, JPEG. The same seed and build make the
same files; a run that was stopped goes on where it was.
"""

import argparse
import json
import math
import multiprocessing
import pathlib
import random
import tempfile

import numpy as np
from PIL import Image

import marketgen

ROOT = pathlib.Path(__file__).resolve().parents[2]
PARTS = {"floor": 1, "wall": 2, "ceiling": 3, "fixture": 4, "product": 5}
# What a person tells apart, by the pattern of data/materials.json.
CLASSES = {
    "floor": {
        "stone": ["terrazzo", "marble", "granite", "travertine", "slate", "crazy_paving"],
        "tiles": ["tiles", "chequer", "hex_tiles", "mosaic"],
        "wood": ["planks", "knotty_planks", "herringbone", "chevron", "basket", "cork"],
        "concrete": ["concrete"],
        "vinyl": ["flecks", "marbled", "carpet", "studs"],
    },
    "wall": {
        "plaster": ["plain", "limewash", "roughcast", "trowelled", "felt", "concrete", "cast_panels", "board_formed"],
        "brick": ["brick", "brick_english", "brick_flemish", "ledgestone"],
        "tiles": ["tiles", "hex_tiles", "mosaic", "glazed_tiles", "herringbone_tiles", "fish_scale", "brick_stack", "marble", "granite"],
        "wood": ["planks", "knotty_planks", "slats", "veneer", "strand_board", "herringbone", "chevron", "cork"],
    },
    "ceiling": {
        "grid": ["ceiling_grid", "tiles", "perforated", "open_grid"],
        "plain": ["plain", "concrete", "cast_panels", "board_formed", "felt"],
        "slats": ["slats", "ribbed"],
    },
    "fixture": {
        "metal": ["plain", "brushed", "galvanised"],
        "wood": ["planks", "knotty_planks", "veneer", "strand_board"],
    },
}
# Profile, and the sizes that such shops have: width and depth in metres.
SHOPS = {
    "convenience-us": ((9, 15), (8, 12)), "convenience-cn": ((8, 14), (7, 10)),
    "supermarket-eu": ((18, 27), (13, 18)), "supermarket-us": ((20, 30), (15, 20)), "organic-eu": ((16, 25), (13, 18)),
    "discounter": ((22, 30), (15, 20)), "hypermarket-eu": ((34, 42), (24, 30)),
}
# How often each is drawn.
SHOP_DRAWS = ["convenience-us", "convenience-cn", "supermarket-eu", "supermarket-us", "organic-eu", "discounter", "discounter",
              "hypermarket-eu"]
MIN_SHELVES = 0.02  # share of the picture
KELVIN = [(2700, 3300), (3500, 4300), (5000, 6500)]


def materials():
    return json.loads((ROOT / "data" / "materials.json").read_text())


def class_of(attribute, row):
    for name, patterns in CLASSES[attribute].items():
        if row["pattern"] in patterns:
            return name
    return None


def draw_look(rng, rows):
    look = {}
    for attribute, classes in CLASSES.items():
        wanted = rng.choice(list(classes))
        fitting = [r for r in rows if attribute in r["uses"] and class_of(attribute, r) == wanted]
        look[attribute] = rng.choice(fitting)["id"]
    low, high = rng.choice(KELVIN)
    look["light_kelvin"] = rng.randrange(low, high, 50)
    look["light_lux"] = rng.randrange(400, 1050, 50)
    look["lamps"] = rng.choice(["panel", "line", "pendant"])
    look["accent"] = "#%02x%02x%02x" % tuple(rng.randrange(30, 220) for _ in range(3))
    look["daylight"] = rng.choice([0.0, 0.3, 1.0])
    return look


def draw_prompt(rng, shop):
    """A size that such shops have, and wishes that half of them have."""
    (narrow, wide), (shallow, deep) = SHOPS[shop]
    words = [f"a {rng.randint(narrow, wide)} x {rng.randint(shallow, deep)} m shop"]
    wishes = [f"shelves with {rng.choice([4, 5, 6])} levels", f"shelves {rng.choice([1.4, 1.6, 1.8, 2.0, 2.2])} m high",
              f"aisles {rng.choice([1.2, 1.4, 1.6, 1.8, 2.0, 2.4, 2.8])} m wide",
              f"a ceiling of {rng.choice([2.7, 3.0, 3.4, 3.8, 4.2])} m"]
    return ", ".join(words + [wish for wish in wishes if rng.random() < 0.5])


def apart_deg(a, b):
    return abs((a - b + 90) % 180 - 90)


class Floor:
    """Where a photographer can stand, from the fixtures of a layout; metres."""

    def __init__(self, layout):
        shell = layout["shell"]
        self.width, self.depth = shell["width_mm"] / 1000, shell["depth_mm"] / 1000
        self.boxes, self.high = [], []
        for f in layout["fixtures"]:
            w, d = f.get("width_mm", 1250) / 2000, f.get("depth_mm", 500) / 2000
            if f.get("yaw_deg", 0) % 180 == 90:
                w, d = d, w
            x, y = f.get("x_mm", 0) / 1000, f.get("y_mm", 0) / 1000
            self.boxes.append((x - w, y - d, x + w, y + d))
            self.high.append(f.get("height_mm", 1800) / 1000)
        self.gondolas = [f for f in layout["fixtures"] if f["kind"] == "gondola" and not f.get("endcap_of")]

    def room(self, x, y):
        """Distance to the nearest fixture or wall."""
        near = min(x, y, self.width - x, self.depth - y)
        for x0, y0, x1, y1 in self.boxes:
            near = min(near, math.hypot(max(x0 - x, 0, x - x1), max(y0 - y, 0, y - y1)))
        return near

    def sight(self, x, y, yaw, eye, limit=12):
        for step in range(1, int(limit / 0.2)):
            px, py = x + 0.2 * step * math.cos(yaw), y + 0.2 * step * math.sin(yaw)
            if not (0 < px < self.width and 0 < py < self.depth):
                return 0.2 * step
            for (x0, y0, x1, y1), high in zip(self.boxes, self.high):
                if high > eye - 0.2 and x0 < px < x1 and y0 < py < y1:
                    return 0.2 * step
        return limit

    def shelves_ahead(self, x, y, yaw):
        """Sections of shelves within 30 degrees of the view and 9 m."""
        ahead = 0
        for f in self.gondolas:
            dx, dy = f.get("x_mm", 0) / 1000 - x, f.get("y_mm", 0) / 1000 - y
            off = abs((math.atan2(dy, dx) - yaw + math.pi) % (2 * math.pi) - math.pi)
            ahead += off < math.radians(30) and math.hypot(dx, dy) < 9
        return ahead

    def axis_deg(self):
        """Along the runs of gondolas: 0 east-west, 90 north-south; None without gondolas."""
        free = [f for f in self.gondolas if f.get("sides", 1) == 2] or self.gondolas
        along = [f.get("yaw_deg", 0) % 180 for f in free]
        return max(set(along), key=along.count) if along else None


def draw_pose(rng, floor, aisles, kind):
    """(x, y, eye, yaw, aisle or None): in an aisle along it, or anywhere with a view."""
    best, best_worth = None, -1
    for _ in range(60):
        eye = rng.uniform(1.35, 1.75)
        if kind == "aisle" and aisles:
            aisle = rng.choice([a for a in aisles if a.get("kind") == "secondary"] or aisles)
            xs, ys = [p[0] / 1000 for p in aisle["polygon_mm"]], [p[1] / 1000 for p in aisle["polygon_mm"]]
            x, y = rng.uniform(min(xs), max(xs)), rng.uniform(min(ys), max(ys))
            east_west = max(xs) - min(xs) > max(ys) - min(ys)
            yaw = math.radians((0 if east_west else 90) + rng.choice([0, 180]) + rng.gauss(0, 9))
        else:
            aisle, x, y = None, rng.uniform(0.5, floor.width - 0.5), rng.uniform(0.5, floor.depth - 0.5)
            yaw = rng.uniform(0, 2 * math.pi)
            if kind == "across" and floor.axis_deg() is not None:
                yaw = math.radians(floor.axis_deg() + 90 + rng.choice([0, 180]) + rng.gauss(0, 8))
        if floor.room(x, y) < 0.45:
            continue
        worth = min(floor.sight(x, y, yaw, eye), 7) + min(floor.shelves_ahead(x, y, yaw), 6) + rng.uniform(0, 3)
        if worth > best_worth:
            best, best_worth = (x, y, eye, yaw, aisle), worth
    return best


def draw_camera(rng, pose):
    x, y, eye, yaw, _ = pose
    width, height = rng.choice([(640, 480), (640, 426), (640, 360), (480, 640)])
    pitch = math.radians(rng.gauss(-4, 5))
    at = (x + math.cos(yaw), y + math.sin(yaw), eye + math.tan(pitch))
    return marketgen.Camera.look_at((x, y, eye), at, rng.uniform(48, 72), width, height)


def parts_of(frame, annotations):
    """Which part of the shop each pixel shows."""
    numbers, normals = np.asarray(frame.instance), np.asarray(frame.normals)
    table = np.zeros(int(numbers.max()) + 1, np.uint8)
    shell = np.zeros(len(table), bool)
    for thing in annotations["objects"]:
        if thing["kind"] == "shell":
            shell[thing["id"]] = True
        else:
            table[thing["id"]] = PARTS.get(thing["kind"], 0)
    parts = table[numbers]
    of_shell = shell[numbers]
    parts[of_shell & (normals[..., 2] > 0.7)] = PARTS["floor"]
    parts[of_shell & (normals[..., 2] < -0.7)] = PARTS["ceiling"]
    parts[of_shell & (abs(normals[..., 2]) <= 0.7)] = PARTS["wall"]
    return parts


def taken(rng, rgb):
    """As a phone would have recorded it."""
    light = (rgb.astype(np.float64) / 255) ** 2.2
    warmth = rng.gauss(0, 0.05)  # what automatic white balance leaves
    light *= np.array([1 + warmth, 1 + rng.gauss(0, 0.015), 1 - warmth]) * 2 ** rng.gauss(0, 0.25)
    height, width = light.shape[:2]
    y, x = np.mgrid[0:height, 0:width]
    far = ((x / width - 0.5) ** 2 + (y / height - 0.5) ** 2) / 0.5
    light *= (1 - rng.uniform(0, 0.3) * far)[..., None]
    picture = np.clip(light, 0, 1) ** (1 / 2.2) * 255
    picture += np.random.default_rng(rng.randrange(2**32)).normal(0, rng.uniform(0.5, 4), picture.shape)
    return np.clip(picture, 0, 255).astype(np.uint8)


def seen_shares(annotations, pixels):
    """Shares of the picture that show sections of shelves, and fixtures of any kind, without goods."""
    fixtures = [thing for thing in annotations["objects"] if thing["kind"] == "fixture"]
    shelves = sum(thing["pixels"] for thing in fixtures if thing.get("category", thing["name"]) == "gondola")
    return shelves / pixels, sum(thing["pixels"] for thing in fixtures) / pixels


def truth_of(look, shop, floor, pose, shelves, fixtures):
    """What may be asked of the photo: of shelves and fixtures only where it shows some."""
    truth = {"shop": shop, "lamps": look["lamps"], "kelvin": look["light_kelvin"]}
    truth |= {attribute: look[attribute] for attribute in CLASSES}
    if fixtures < MIN_SHELVES:
        del truth["fixture"]
    if shelves < MIN_SHELVES:
        return truth
    levels = [f.get("levels", 5) for f in floor.gondolas]
    if levels:
        truth["levels"] = max(set(levels), key=levels.count)
    axis = floor.axis_deg()
    if axis is not None:
        apart = apart_deg(math.degrees(pose[3]), axis)
        if apart < 25 or apart > 65:
            truth["direction"] = "away" if apart < 25 else "across"
        if pose[4] is not None and apart < 25:
            truth["aisle_mm"] = pose[4].get("width_mm", 0)
    return truth


def make_shop(work):
    number, args = work
    done = args.folder / f"shop-{number:04d}.json"
    if done.exists():
        return json.loads(done.read_text())
    rng = random.Random(f"{args.seed}/{number}")
    look, shop = draw_look(rng, materials()), rng.choice(SHOP_DRAWS)
    prompt = draw_prompt(rng, shop)
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        first = marketgen.generate(prompt, scratch / "first", seed=number + 1, profile=shop)
        plan = first.plan
        plan["look"] = look
        plan["outfit"] = "plain"  # what is drawn of levels, heights and directions is the plan's
        for zone in plan["zones"]:
            for fixture in [zone["fixture"], *zone.get("also", [])]:
                fixture.pop("color", None)
                fixture.pop("material", None)
        plan.pop("provenance", None)
        (scratch / "plan.json").write_text(json.dumps(plan))
        store = marketgen.generate("", scratch / "shop", seed=number + 1, plan=scratch / "plan.json")
        floor, aisles = Floor(store.layout), [a for a in store.layout["aisles"] if a.get("kind", "secondary") != "checkout"]
        renderer = store.renderer(fine_print=False, keep_light=False)
        for index in range(args.photos):
            kind = ["aisle", "anywhere", "aisle", "across"][index % 4]
            pose = draw_pose(rng, floor, aisles, kind)
            if pose is None:
                continue
            camera = draw_camera(rng, pose)
            seen = renderer.render(camera, quality="fast" if args.mode == "sensor" else "balanced", mode=args.mode,
                                   samples=args.samples)
            name = f"{number:04d}-{index}.jpg"
            shown = Image.fromarray(taken(rng, np.asarray(seen.rgb)))
            shown.save(args.folder / name, quality=rng.randrange(60, 95))
            annotations = renderer.annotate(seen, camera)
            parts = parts_of(seen, annotations)
            Image.fromarray(parts[2::4, 2::4]).save(args.folder / f"{name}.parts.png")
            rows.append({"file": name, "number": number, "truth": truth_of(look, shop, floor, pose, *seen_shares(annotations, parts.size))})
    done.with_suffix(".part").write_text(json.dumps(rows))
    done.with_suffix(".part").rename(done)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--shops", type=int, default=500)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--photos", type=int, default=4)
    parser.add_argument("--mode", choices=["sensor", "path"], default="sensor")
    parser.add_argument("--samples", type=int, default=0, help="of path mode, paths a pixel; 0: as the renderer thinks best")
    parser.add_argument("--jobs", type=int, default=2)
    args = parser.parse_args()
    args.folder.mkdir(parents=True, exist_ok=True)
    with multiprocessing.Pool(args.jobs, maxtasksperchild=20) as pool:
        work = [(number, args) for number in range(args.shops)]
        rows = [row for shop in pool.imap(make_shop, work) for row in shop]
    (args.folder / "photos.jsonl").write_text("".join(json.dumps(row) + "\n" for row in rows))
    print(f"{len(rows)} photos of {args.shops} shops in {args.folder}")


if __name__ == "__main__":
    main()
