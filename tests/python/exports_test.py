"""Exports for other trades, judged from outside: Nav2 maps with PyYAML, Pillow and NumPy, planograms with csv."""

import collections
import csv
import json
import math

import numpy as np
import pytest
import yaml
from conftest import ROOT, run
from PIL import Image

RADIUS = 0.42  # of the robot that waypoints are for, by itself
STORES = {
    "kiosk": ("a tiny kiosk with snacks and cold drinks", "5x4m", 3),
    "shop": ("a supermarket with bakery, dairy, produce, snacks, frozen, a deli counter, a backroom and two checkouts", "20x14m", 11),
}
KINDS = {kind["kind"]: kind for kind in json.loads((ROOT / "data/fixtures.json").read_text())}


@pytest.fixture(scope="module", params=STORES)
def shop(request, tmp_path_factory):
    """Folder of a store, with its exports beside it."""
    prompt, size, seed = STORES[request.param]
    folder = tmp_path_factory.mktemp(request.param)
    run("generate", prompt, "--size", size, "--seed", seed, "-o", folder / "store", "--no-previews", "--quiet")
    run("export", folder / "store", "--format", "nav2", "-o", folder / "map.yaml", "--check", "--quiet")
    run("export", folder / "store", "--format", "planogram", "-o", folder / "planogram.csv", "--check", "--quiet")
    return folder


def layout(shop):
    return json.loads((shop / "store/layout.json").read_text())


def footprint(fixture):
    """West, south, east, north in metres."""
    width, depth = fixture.get("width_mm", 1250), fixture.get("depth_mm", 500)
    if fixture.get("yaw_deg", 0) % 180:
        width, depth = depth, width
    x, y = fixture["x_mm"], fixture["y_mm"]
    return (x - width / 2) / 1000, (y - depth / 2) / 1000, (x + width / 2) / 1000, (y + depth / 2) / 1000


def query(shop, table):
    return json.loads(run("query", shop / "store", table, "--format", "json"))


# ---- Nav2 ----


class Grid:
    """A map as nav2_map_server publishes it: row 0 in the south, -1 unknown, 0 free to 100 occupied.

    From its documentation: `occ` is how dark a pixel is, 0 to 1 (with `negate`, how light). Trinary: occ > occupied_thresh is 100,
    occ < free_thresh is 0, all else -1. Scale: between the thresholds it is the share of the way from one to the other, in percent.
    """

    def __init__(self, file):
        meta = yaml.safe_load(file.read_text())
        assert set(meta) == {"image", "mode", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"}
        with Image.open(file.parent / meta["image"]) as image:
            assert (image.format, image.mode) == ("PPM", "L")
            shade = np.asarray(image).astype(float)[::-1] / 255
        occ = shade if meta["negate"] else 1 - shade
        free, occupied = meta["free_thresh"], meta["occupied_thresh"]
        between = np.rint((occ - free) / (occupied - free) * 100) if meta["mode"] == "scale" else -1
        self.values = np.where(occ > occupied, 100, np.where(occ < free, 0, between)).astype(int)
        self.resolution, self.origin, self.mode = meta["resolution"], meta["origin"], meta["mode"]

    def cell(self, x, y):
        return int((y - self.origin[1]) // self.resolution), int((x - self.origin[0]) // self.resolution)

    def at(self, x, y):
        return self.values[self.cell(x, y)]

    def middles(self):
        """x of each column, y of each row."""
        rows, columns = self.values.shape
        return (self.origin[0] + (np.arange(columns) + 0.5) * self.resolution, self.origin[1] + (np.arange(rows) + 0.5) * self.resolution)

    def inside(self, west, south, east, north):
        x, y = self.middles()
        return np.outer((y > south) & (y < north), (x > west) & (x < east))


def inflated(grid, radius):
    """Cells whose middle lies nearer than `radius` to that of an occupied cell."""
    reach = int(radius / grid.resolution) + 1
    solid = grid.values == 100
    near = np.zeros_like(solid)
    rows, columns = solid.shape
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            if math.hypot(dx, dy) * grid.resolution < radius - 1e-6:
                near[max(0, dy) : rows + min(0, dy), max(0, dx) : columns + min(0, dx)] |= solid[
                    max(0, -dy) : rows + min(0, -dy), max(0, -dx) : columns + min(0, -dx)
                ]
    return near


def reached(room, start):
    """Cells that hang together with `start` by their sides."""
    seen = np.zeros_like(room)
    seen[start] = room[start]
    queue = collections.deque([start] if room[start] else [])
    while queue:
        row, column = queue.popleft()
        for r, c in ((row + 1, column), (row - 1, column), (row, column + 1), (row, column - 1)):
            if 0 <= r < room.shape[0] and 0 <= c < room.shape[1] and room[r, c] and not seen[r, c]:
                seen[r, c] = True
                queue.append((r, c))
    return seen


@pytest.fixture(scope="module")
def nav2(shop):
    """Map, keepout mask, speed mask, waypoints, filters."""
    beside = shop / "map_assets"
    return (
        Grid(shop / "map.yaml"),
        Grid(beside / "keepout_mask.yaml"),
        Grid(beside / "speed_mask.yaml"),
        yaml.safe_load((beside / "waypoints.yaml").read_text()),
        yaml.safe_load((beside / "filters.yaml").read_text()),
    )


def test_the_map_is_the_layout(shop, nav2):
    grid, *_ = nav2
    plan = layout(shop)
    assert (grid.resolution, grid.mode, grid.origin[2]) == (0.05, "trinary", 0)
    room = np.zeros(grid.values.shape, bool)
    taken = np.zeros(grid.values.shape, bool)
    room |= grid.inside(0, 0, plan["shell"]["width_mm"] / 1000, plan["shell"]["depth_mm"] / 1000)
    floor_m2 = plan["shell"]["width_mm"] * plan["shell"]["depth_mm"] / 1e6
    for fixture in plan["fixtures"]:
        west, south, east, north = footprint(fixture)
        assert grid.at((west + east) / 2, (south + north) / 2) == 100, fixture["id"]
        covered = grid.inside(west, south, east, north)
        if (covered & ~taken).any():  # a mirror hangs over what stands there
            floor_m2 -= (east - west) * (north - south)
        taken |= covered
    for column in plan["shell"].get("columns", []):
        half = column.get("size_mm", 400) / 2000
        taken |= grid.inside(*(column[axis] / 1000 + side * half for side in (-1, 1) for axis in ("x_mm", "y_mm")))
    assert (grid.values[room & taken] == 100).all()
    assert (grid.values[room & ~taken] == 0).all()
    assert not (grid.values[~room] == 0).any()
    assert (grid.values == 0).sum() * 0.05**2 == pytest.approx(floor_m2, rel=0.03)
    edge = np.concatenate([grid.values[0], grid.values[-1], grid.values[:, 0], grid.values[:, -1]])
    assert (edge == -1).all(), "beyond the walls nothing is known"


def test_a_robot_gets_from_the_entrance_to_every_waypoint(nav2):
    grid, keepout, _, waypoints, _ = nav2
    assert waypoints["frame_id"] == "map" and waypoints["robot_radius"] == RADIUS
    places = waypoints["waypoints"]
    room = (grid.values == 0) & ~inflated(grid, RADIUS) & (keepout.values == 0)
    entrance = next(place for place in places if place["kind"] == "entrance")
    there = reached(room, grid.cell(entrance["x"], entrance["y"]))
    for place in places:
        assert there[grid.cell(place["x"], place["y"])], place["name"]
        assert keepout.at(place["x"], place["y"]) == 0, place["name"]
    assert len({place["name"] for place in places}) == len(places)
    assert {"entrance", "exit", "checkout", "shelf"} == {place["kind"] for place in places}


def test_waypoints_face_their_shelves(shop, nav2):
    _, _, _, waypoints, _ = nav2
    fixtures = {fixture["id"]: footprint(fixture) for fixture in layout(shop)["fixtures"]}
    for place in waypoints["waypoints"]:
        if place["kind"] != "shelf":
            continue
        west, south, east, north = fixtures[place["fixture"]]
        ahead = [(place["x"] + d * math.cos(place["yaw"]), place["y"] + d * math.sin(place["yaw"])) for d in np.arange(0.4, 1.01, 0.05)]
        assert any(west < x < east and south < y < north for x, y in ahead), place


def test_every_category_on_offer_is_reached(shop, nav2):
    _, _, _, waypoints, _ = nav2
    sold = {row["category"] for row in query(shop, "products") if row["fixture"] and not row["fixture"].startswith("backroom/")}
    assert set(waypoints["categories"]) == sold
    assert all(name.startswith("backroom/") for name in waypoints["unreachable"])  # roll cages, which staff moves
    by_name = {place["name"]: place for place in waypoints["waypoints"]}
    items = collections.Counter((row["fixture"], row["category"]) for row in query(shop, "products"))
    for category, names in waypoints["categories"].items():
        for name in names:
            assert category in by_name[name]["categories"]
            assert items[by_name[name]["fixture"], category] > 0


def test_robots_keep_out_of_where_staff_works(shop, nav2):
    grid, keepout, *_ = nav2
    plan = layout(shop)
    assert keepout.mode == "scale" and set(np.unique(keepout.values)) == {0, 100}
    x, y = keepout.middles()
    room = np.outer((y > 0) & (y < plan["shell"]["depth_mm"] / 1000), (x > 0) & (x < plan["shell"]["width_mm"] / 1000))
    assert (keepout.values[~room] == 100).all(), "a robot does not leave the store"
    staffed = 0
    for fixture in plan["fixtures"]:
        generator = KINDS[fixture["kind"]]["generator"]
        if generator not in ("kiosk", "serve_over"):
            continue
        back = math.radians(fixture.get("yaw_deg", 0) + 90)  # 0 faces south
        behind = fixture.get("depth_mm", 500) / 2000 + 0.3
        at = fixture["x_mm"] / 1000 + behind * math.cos(back), fixture["y_mm"] / 1000 + behind * math.sin(back)
        assert keepout.at(*at) == 100, fixture["id"]
        staffed += 1
    for zone in plan["zones"]:
        if zone["type"] == "backroom":
            west, south = np.min(zone["polygon_mm"], axis=0) / 1000
            east, north = np.max(zone["polygon_mm"], axis=0) / 1000
            assert (keepout.values[keepout.inside(west, south, east, north)] == 100).all()
            staffed += 1
    assert staffed > 0
    assert ((keepout.values == 0) & (grid.values == 0)).sum() > 0.7 * (grid.values == 0).sum()


def test_speed_limits_are_those_of_the_speed_filter(shop, nav2):
    """speed = base + multiplier * value, in percent of the robot's greatest; 0 of the mask means no limit."""
    _, _, speed, _, filters = nav2
    info = filters["speed_costmap_filter_info_server"]["ros__parameters"]
    assert info["type"] == 1 and info["mask_topic"] == filters["speed_filter_mask_server"]["ros__parameters"]["topic_name"]
    limits = {int(info["base"] + info["multiplier"] * value) for value in np.unique(speed.values) if value}
    assert limits <= {50, 70} and 50 in limits
    shell = layout(shop)["shell"]
    for door in shell["openings"]:
        if door["kind"] != "entrance" or door["wall"] != "south":
            continue
        value = speed.at(door["center"] * shell["width_mm"] / 1000, 0.5)
        assert info["base"] + info["multiplier"] * value == 50
    assert (speed.values[speed.inside(0, 0, shell["width_mm"] / 1000, shell["depth_mm"] / 1000)] == 0).any()
    assert (speed.values >= 0).all()


def test_the_filters_name_files_and_topics_that_are_there(shop, nav2):
    *_, filters = nav2
    for kind in ("keepout", "speed"):
        server = filters[f"{kind}_filter_mask_server"]["ros__parameters"]
        info = filters[f"{kind}_costmap_filter_info_server"]["ros__parameters"]
        assert (shop / server["yaml_filename"]).is_file()
        assert info["mask_topic"] == server["topic_name"]
        for costmap in ("global_costmap", "local_costmap"):
            layers = filters[costmap][costmap]["ros__parameters"]
            assert layers[f"{kind}_filter"]["filter_info_topic"] == info["filter_info_topic"]
            assert f"{kind}_filter" in layers["filters"]
    assert filters["keepout_costmap_filter_info_server"]["ros__parameters"]["type"] == 0
    nodes = filters["lifecycle_manager_costmap_filters"]["ros__parameters"]["node_names"]
    assert all(node in filters for node in nodes)


def test_cells_and_robots_of_other_sizes(shop, tmp_path):
    told = run(
        "export", shop / "store", "--format", "nav2", "--resolution", 0.1, "--robot-radius", 0.25, "-o", tmp_path / "m.yaml", "--check", "--json"
    )
    grid, fine = Grid(tmp_path / "m.yaml"), Grid(shop / "map.yaml")
    assert grid.resolution == 0.1
    assert json.loads(told)["free_m2"] == pytest.approx((fine.values == 0).sum() * 0.05**2, rel=0.06)
    places = yaml.safe_load((tmp_path / "m_assets/waypoints.yaml").read_text())
    assert places["robot_radius"] == 0.25
    room = (grid.values == 0) & ~inflated(grid, 0.25)
    assert all(room[grid.cell(place["x"], place["y"])] for place in places["waypoints"])


# ---- Planogram ----


@pytest.fixture(scope="module")
def planogram(shop):
    with (shop / "planogram.csv").open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def number(row, *columns):
    values = [int(row[column]) for column in columns]
    return values[0] if len(columns) == 1 else values


def test_units_are_the_items_of_the_store(shop, planogram):
    items = collections.Counter(row["fixture"] for row in query(shop, "products") if row["fixture"])
    units = collections.Counter()
    for row in planogram:
        units[row["fixture"]] += number(row, "units")
        wide, high, deep = number(row, "facings_wide", "facings_high", "facings_deep")
        assert 0 <= number(row, "units") <= number(row, "capacity")
        assert number(row, "capacity") == max(number(row, "units"), wide * high * deep)
    assert +units == items


def test_gtins_have_their_check_digit(planogram):
    weighed = 0
    for row in planogram:
        digits = [int(digit) for digit in row["gtin"]]
        weighed += not digits
        if digits:
            assert len(digits) == 13
            assert sum(digit * (3 if i % 2 else 1) for i, digit in enumerate(digits)) % 10 == 0, row
    assert weighed < 0.5 * len(planogram)


def test_shelves_are_numbered_from_the_floor_and_positions_from_the_left(planogram):
    shelves = collections.defaultdict(list)
    for row in planogram:
        shelves[row["fixture"], row["side"], number(row, "shelf")].append(row)
    for rows in shelves.values():
        by_surface = collections.defaultdict(list)
        for row in rows:
            by_surface[row["shelf_height_mm"], row["y_mm"]].append(row)
        for surface in by_surface.values():
            surface.sort(key=lambda row: number(row, "x_mm"))
            positions = [number(row, "position") for row in surface]
            assert positions == sorted(positions) and positions[0] >= 1
            for left, right in zip(surface, surface[1:], strict=False):
                reach = number(left, "x_mm") + number(left, "facings_wide") * number(left, "width_mm")
                assert left["merchandising"] == "loose" or reach <= number(right, "x_mm") + 2
    heights = collections.defaultdict(dict)
    for (fixture, side, shelf), rows in shelves.items():
        heights[fixture, side][shelf] = min(number(row, "shelf_height_mm") for row in rows)
    for levels in heights.values():
        ordered = [levels[shelf] for shelf in sorted(levels)]
        assert ordered == sorted(ordered) and ordered[0] >= 0


def test_items_stand_where_the_rows_say(shop, planogram):
    """X from the left front of the bay, seen by who faces it; Z over the floor."""
    fixtures = {fixture["id"]: fixture for fixture in layout(shop)["fixtures"]}
    blocks = collections.defaultdict(list)
    for row in planogram:
        fixture = fixtures[row["fixture"]]
        width, depth = fixture.get("width_mm", 1250), fixture.get("depth_mm", 500)
        x, y, bay = number(row, "x_mm", "y_mm", "bay_width_mm")
        assert 0 <= x and x + number(row, "facings_wide") * number(row, "width_mm") <= bay + 5
        if KINDS[fixture["kind"]]["role"] == "checkout":
            continue  # their racks face along the lane
        assert bay == width
        turn = math.radians(fixture.get("yaw_deg", 0) + (180 if row["side"] == "back" else 0))
        right, into = (math.cos(turn), math.sin(turn)), (-math.sin(turn), math.cos(turn))
        corner = [fixture[f"{axis}_mm"] - right[i] * width / 2 - into[i] * depth / 2 for i, axis in enumerate("xy")]
        blocks[row["fixture"], number(row, "shelf") - 1, row["sku"]].append((row, corner, right, into))
    looked = 0
    for item in query(shop, "products"):
        key = item["fixture"], item["level"], item["sku"]
        if key not in blocks or item["misplaced"]:
            continue
        looked += 1
        misses = []
        for row, corner, right, into in blocks[key]:
            offset = [item["x_m"] * 1000 - corner[0], item["y_m"] * 1000 - corner[1]]
            along = offset[0] * right[0] + offset[1] * right[1] - number(row, "x_mm")
            inward = offset[0] * into[0] + offset[1] * into[1] - number(row, "y_mm")
            above = item["z_m"] * 1000 - number(row, "z_mm")
            room = number(row, "facings_wide") * (max(number(row, "width_mm"), number(row, "depth_mm")) + 10) + 40
            misses.append(not (-3 <= along <= room and inward >= -3 and above >= -60))
        assert not all(misses), item
    assert looked > 0.8 * sum(number(row, "units") for row in planogram)
