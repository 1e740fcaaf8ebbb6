"""Plain geometry of a floor: rectangles [x0, y0, x1, y1] in metres, runs of modules, faces, aisles."""

INWARD = {"south": (0, 1), "north": (0, -1), "west": (1, 0), "east": (-1, 0)}  # from a wall into the store
FRONT_OF_YAW = {0: (0, -1), 90: (1, 0), 180: (0, 1), 270: (-1, 0)}
WALL_TOWARDS = {(0, 1): "north", (0, -1): "south", (1, 0): "east", (-1, 0): "west"}
# Goods can be taken from every side.
OPEN_KINDS = {"produce_table", "pallet", "bin", "promo_stack", "checkout_lane", "self_checkout"}
# What makes an aisle: shelves, racks and cabinets that stand in lines.
AISLE_KINDS = {"gondola", "wall_unit", "multideck", "glass_door_cooler", "glass_door_freezer", "chest_freezer",
               "island_freezer", "peg_wall", "wine_rack", "bakery_rack"}
TOUCH_M = 0.06       # modules that are this near to one another touch
WIDEST_AISLE_M = 5.0  # more is open floor
NARROWEST_M = 0.3
AISLE_LENGTH_M = 2.0  # shelves face one another along so much at least


def rect_of(x, y, width, depth, yaw):
    w, d = (width, depth) if yaw % 180 == 0 else (depth, width)
    return [x - w / 2, y - d / 2, x + w / 2, y + d / 2]


def centre(rect):
    return ((rect[0] + rect[2]) / 2, (rect[1] + rect[3]) / 2)


def area(rect):
    return (rect[2] - rect[0]) * (rect[3] - rect[1])


def bounds(rects):
    return [min(r[0] for r in rects), min(r[1] for r in rects), max(r[2] for r in rects), max(r[3] for r in rects)]


def polygon_area(points):
    return abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1]))) / 2


def gap(a, b):
    """Distance between the edges of two rectangles, 0 when they touch."""
    dx = max(a[0] - b[2], b[0] - a[2], 0)
    dy = max(a[1] - b[3], b[1] - a[3], 0)
    return (dx * dx + dy * dy) ** 0.5


def covered_length(intervals):
    total, reached = 0.0, None
    for low, high in sorted(intervals):
        start = low if reached is None else max(low, reached)
        total += max(0.0, high - start)
        reached = high if reached is None else max(reached, high)
    return total


def touching_groups(fixtures):
    """Maximal straight lines of touching modules: same kind, zone and direction, ends that meet."""
    lines = {}
    for f in fixtures:
        along = 0 if f["yaw"] % 180 == 0 else 1
        key = (f["kind"], f["zone"], f["yaw"] if f["sides"] == 1 else f["yaw"] % 180)
        lines.setdefault((key, along), []).append(f)
    groups = []
    for (_, along), members in sorted(lines.items(), key=str):
        members.sort(key=lambda f: (round(centre(f["rect"])[1 - along], 1), f["rect"][along]))
        for f in members:
            last = groups[-1][-1] if groups else None
            if last is not None and last in members and follows(last, f, along):
                groups[-1].append(f)
            else:
                groups.append([f])
    return groups


def follows(last, f, along):
    in_line = abs(centre(last["rect"])[1 - along] - centre(f["rect"])[1 - along]) <= TOUCH_M
    return in_line and abs(f["rect"][along] - last["rect"][along + 2]) <= TOUCH_M


def runs_of(fixtures):
    runs = []
    for group in touching_groups(fixtures):
        first = group[0]
        runs.append({"kind": first["kind"], "zone": first["zone"], "sides": first["sides"], "yaw": first["yaw"],
                     "rect": bounds([f["rect"] for f in group]), "modules": len(group), "back_to_back": False})
    for a in runs:
        a["back_to_back"] = a["sides"] == 1 and any(stand_back_to_back(a, b) for b in runs if b is not a)
    return runs


def stand_back_to_back(a, b):
    """Two single-sided lines of one kind with their backs together make one double-sided run."""
    if b["sides"] != 1 or a["kind"] != b["kind"] or (a["yaw"] - b["yaw"]) % 360 != 180:
        return False
    front = FRONT_OF_YAW[a["yaw"]]
    (ax, ay), (bx, by) = centre(a["rect"]), centre(b["rect"])
    is_behind = (bx - ax) * front[0] + (by - ay) * front[1] < 0
    along = 0 if a["yaw"] % 180 == 0 else 1
    shared = min(a["rect"][along + 2], b["rect"][along + 2]) - max(a["rect"][along], b["rect"][along])
    shorter = min(r["rect"][along + 2] - r["rect"][along] for r in (a, b))
    return is_behind and shared >= 0.5 * shorter and gap(a["rect"], b["rect"]) <= 0.15


def normals_of(thing):
    if thing["kind"] in OPEN_KINDS:
        return list(FRONT_OF_YAW.values())
    front = FRONT_OF_YAW[thing["yaw"]]
    return [front, (-front[0], -front[1])] if thing["sides"] == 2 else [front]


def strip_ahead(rect, normal, other):
    """(distance, length shared) from the side of `rect` that `normal` leaves to `other`; None when it isn't ahead."""
    along = 1 if normal[0] else 0
    across = 1 - along
    shared = min(rect[along + 2], other[along + 2]) - max(rect[along], other[along])
    if normal[across] > 0:
        distance = other[across] - rect[across + 2]
    else:
        distance = rect[across] - other[across + 2]
    return (distance, shared) if distance > -TOUCH_M and shared > 0 else None


def aisles_of(runs, obstacles, floor):
    """The free floor before each face of each run: its width, what bounds it, and the zones at both sides."""
    found = []
    for run in runs:
        if run["kind"] not in AISLE_KINDS:
            continue
        for normal in normals_of(run):
            aisle = aisle_before(run, normal, runs, obstacles, floor)
            if aisle is not None:
                found.append(aisle)
    return found


def aisle_before(run, normal, runs, obstacles, floor):
    nearest = None
    for o in obstacles:
        ahead = strip_ahead(run["rect"], normal, o["rect"])
        if not ahead or ahead[1] < NARROWEST_M or stands_in_the_corner(o["rect"], normal, ahead[1], floor):
            continue
        if nearest is None or ahead[0] < nearest[0]:
            nearest = (ahead[0], o)
    to_wall = wall_ahead(run["rect"], normal, floor)
    width = min(to_wall, nearest[0]) if nearest else to_wall
    if not NARROWEST_M <= width <= WIDEST_AISLE_M:
        return None
    partners = facing_runs(run, normal, runs, width + 1.0)
    zones = sorted({run["zone"]} | {p["zone"] for p in partners})
    return {"width_m": round(width, 4), "zones": zones, "zone": run["zone"], "kind": run["kind"],
            "opposite": sorted({p["kind"] for p in partners}), "between_shelves": bool(partners),
            "normal": normal, "strip": strip_rect(run["rect"], normal, width)}


def stands_in_the_corner(rect, normal, shared, floor):
    """Something at the side wall, across a corner from the run's last module, narrows no aisle."""
    along = 1 if normal[0] else 0
    to_side_wall = min(rect[along] - floor[along], floor[along + 2] - rect[along + 2])
    return to_side_wall <= 0.3 and shared <= 1.3


def wall_ahead(rect, normal, floor):
    return {(0, 1): floor[3] - rect[3], (0, -1): rect[1] - floor[1],
            (1, 0): floor[2] - rect[2], (-1, 0): rect[0] - floor[0]}[normal]


def strip_rect(rect, normal, width):
    x0, y0, x1, y1 = rect
    return {(0, 1): [x0, y1, x1, y1 + width], (0, -1): [x0, y0 - width, x1, y0],
            (1, 0): [x1, y0, x1 + width, y1], (-1, 0): [x0 - width, y0, x0, y1]}[normal]


def facing_runs(run, normal, runs, reach):
    opposite = (-normal[0], -normal[1])
    length = min(AISLE_LENGTH_M, 0.8 * max(run["rect"][2] - run["rect"][0], run["rect"][3] - run["rect"][1]))
    partners = []
    for other in runs:
        if other is run or other["kind"] not in AISLE_KINDS or opposite not in normals_of(other):
            continue
        ahead = strip_ahead(run["rect"], normal, other["rect"])
        if ahead and ahead[0] <= reach and ahead[1] >= length:
            partners.append(other)
    return partners


def count_aisles(aisles, kind=None):
    """Aisles with shelves at both sides (of this kind); parts of one straight aisle that a cross aisle cuts
    count once."""
    lanes = []
    mine = [a for a in aisles if a["between_shelves"] and (kind is None or a["kind"] == kind in a["opposite"])]
    for aisle in sorted(mine, key=lambda a: a["strip"]):
        across = 0 if aisle["normal"][0] else 1
        low, high = aisle["strip"][across], aisle["strip"][across + 2]
        for lane in lanes:
            shared = min(high, lane[2]) - max(low, lane[1])
            if lane[0] == across and shared >= 0.5 * min(high - low, lane[2] - lane[1]):
                break
        else:
            lanes.append((across, low, high))
    return len(lanes)
