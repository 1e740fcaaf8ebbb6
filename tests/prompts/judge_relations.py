"""Relations between places, measured on where fixtures stand. One function for each word of SPEC.md.

A zone's place is the rectangle round its own fixtures (baskets, trolleys and gates at the door aside);
without fixtures, its floor. Left, right and behind are seen by someone who comes in by the first entrance.

Where these limits differ from the program's own (src/marketgen/plan/relation.h):
  near          3 m, or 15 % of the diagonal up to 8 m (program: 20 %, no upper limit)
  far           gap at least 25 % AND centres at least 40 % of the diagonal (program: gap 35 %)
  along a wall  modules within 1 m of the wall over half of the zone's length there (program: zone rectangle, 1.5 m)
  at a wall     most of the place lies in the third of the floor that is nearest (program: as `along`)
  at the middle the common centre lies in the middle third both ways (program: reaches in with half its length)
  left/right/behind  centres 0.5 m apart that way AND not more than three times as far the other way
                (program: 0.1 m and nothing else); of a door only the first
  facing        fronts that look at one another over 0.6 to 5 m with nothing between (program: rectangles, 6 m)
  between       the centre 10 to 90 % of the way and off the line by no more than it is from the nearer end, or 1.5 m
                (program: 15 % of the diagonal as detour)
  not_adjacent  1.5 m between the fixtures of every pair (program: 1 m between zones)
"""
import store_geometry as geometry

WALLS = ("north", "south", "east", "west")
SEEN_WALLS = ("back", "front", "left", "right")
OPENINGS = ("entrance", "exit", "service", "emergency", "window")
TILLS = ("checkout_lane", "self_checkout")
EQUIPMENT = ("basket_stack", "trolley_bay", "gate", "pillar")


def diagonal(facts):
    x0, y0, x1, y1 = facts["shell"]["floor"]
    return ((x1 - x0) ** 2 + (y1 - y0) ** 2) ** 0.5


def way_in(facts):
    """Unit vector into the store from the first entrance, else exit, service door; else from the south."""
    for kind in ("entrance", "exit", "service"):
        for o in facts["openings"]:
            if o["kind"] == kind:
                return geometry.INWARD[o["wall"]]
    return (0, 1)


def wall_named(name, facts):
    """north ... as it is; back, front, left and right as seen coming in."""
    x, y = way_in(facts)
    towards = {"back": (x, y), "front": (-x, -y), "left": (-y, x), "right": (y, -x)}.get(name)
    return name if towards is None else geometry.WALL_TOWARDS[towards]


def fixtures_of(name, facts):
    if name in ("checkout",):
        return [f for f in facts["fixtures"] if f["kind"] in TILLS]
    of_kind = [f for f in facts["fixtures"] if f["kind"] == name]
    own = [f for f in facts["fixtures"] if f["zone"] == name and f["kind"] not in EQUIPMENT]
    return own or of_kind


def places(name, facts):
    """The rectangles that go by a name: a zone's places, fixtures of a kind, openings; [] when there are none."""
    if name in OPENINGS:
        return [o["rect"] for o in facts["openings"] if o["kind"] == name]
    if name == "checkout":
        return [f["rect"] for f in fixtures_of(name, facts)]
    zones = [z["rect"] for z in facts["zones"] if z["type"] == name and z["is_there"]]
    return zones or [f["rect"] for f in facts["fixtures"] if f["kind"] == name]


def common_centre(rects):
    weight = sum(max(geometry.area(r), 0.01) for r in rects)
    return tuple(sum(max(geometry.area(r), 0.01) * geometry.centre(r)[i] for r in rects) / weight for i in (0, 1))


def nearest_gap(a, b):
    return min(geometry.gap(p, q) for p in a for q in b)


def near(a, b, facts):
    limit = max(3.0, min(8.0, 0.15 * diagonal(facts)))
    if b in WALLS + SEEN_WALLS:
        measured = min(to_wall(r, wall_named(b, facts), facts) for r in places(a, facts))
    elif b == "center":
        return at(a, b, facts)
    else:
        measured = nearest_gap(places(a, facts), places(b, facts))
    return measured <= limit, f"gap {measured:.1f} m, at most {limit:.1f} m"


def far(a, b, facts):
    d = diagonal(facts)
    if b in WALLS + SEEN_WALLS:
        measured = min(to_wall(r, wall_named(b, facts), facts) for r in places(a, facts))
        return measured >= 0.25 * d, f"gap to the wall {measured:.1f} m, at least {0.25 * d:.1f} m"
    first, second = places(a, facts), places(b, facts)
    measured = nearest_gap(first, second)
    centres = min(distance(geometry.centre(p), geometry.centre(q)) for p in first for q in second)
    return (measured >= 0.25 * d and centres >= 0.4 * d,
            f"gap {measured:.1f} m, centres {centres:.1f} m; at least {0.25 * d:.1f} and {0.4 * d:.1f} m")


def distance(p, q):
    return ((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2) ** 0.5


def to_wall(rect, wall, facts):
    x0, y0, x1, y1 = facts["shell"]["floor"]
    return {"west": rect[0] - x0, "east": x1 - rect[2], "south": rect[1] - y0, "north": y1 - rect[3]}[wall]


def along(a, b, facts):
    if b not in WALLS + SEEN_WALLS:
        return beside(a, b, facts)
    wall = wall_named(b, facts)
    axis = 0 if wall in ("north", "south") else 1
    rects = [f["rect"] for f in fixtures_of(a, facts)] or places(a, facts)
    length = geometry.covered_length([(r[axis], r[axis + 2]) for r in rects])
    there = geometry.covered_length([(r[axis], r[axis + 2]) for r in rects if to_wall(r, wall, facts) <= 1.0])
    return (there >= 0.5 * length and there > 0,
            f"{there:.1f} of its {length:.1f} m stand within 1 m of the {wall} wall; at least half")


def beside(a, b, facts):
    measured = nearest_gap(places(a, facts), places(b, facts))
    return measured <= 2.5, f"gap {measured:.1f} m, at most 2.5 m"


def at(a, b, facts):
    x0, y0, x1, y1 = facts["shell"]["floor"]
    rects = [f["rect"] for f in fixtures_of(a, facts)] or places(a, facts)
    if b == "center":
        x, y = common_centre(rects)
        u, v = (x - x0) / (x1 - x0), (y - y0) / (y1 - y0)
        return 1 / 3 <= u <= 2 / 3 and 1 / 3 <= v <= 2 / 3, f"centre at {u:.2f}, {v:.2f} of the floor; 0.33 to 0.67"
    if b not in WALLS + SEEN_WALLS:
        return beside(a, b, facts)
    wall = wall_named(b, facts)
    depth = (y1 - y0) if wall in ("north", "south") else (x1 - x0)
    is_there = [to_wall([*geometry.centre(r)] * 2, wall, facts) <= depth / 3 for r in rects]
    share = sum(geometry.area(r) for r, there in zip(rects, is_there) if there) / max(1e-9, sum(geometry.area(r) for r in rects))
    return share >= 0.5, f"{share:.0%} of it in the third of the floor at the {wall} wall; at least half"


def offset(a, b, facts):
    """(to the right, ahead) from b's centre to a's, in metres, as someone who comes in sees it."""
    x, y = way_in(facts)
    (ax, ay), (bx, by) = common_centre(places(a, facts)), common_centre(places(b, facts))
    dx, dy = ax - bx, ay - by
    return dx * y - dy * x, dx * x + dy * y


def beyond(measured, across, b):
    free = b in OPENINGS
    return measured >= 0.5 and (free or measured >= abs(across) / 3)


def left_of(a, b, facts):
    right, ahead = offset(a, b, facts)
    return beyond(-right, ahead, b), f"{-right:.1f} m to the left, {ahead:.1f} m ahead; at least 0.5 m and a third of that"


def right_of(a, b, facts):
    right, ahead = offset(a, b, facts)
    return beyond(right, ahead, b), f"{right:.1f} m to the right, {ahead:.1f} m ahead; at least 0.5 m and a third of that"


def behind(a, b, facts):
    right, ahead = offset(a, b, facts)
    return beyond(ahead, right, b), f"{ahead:.1f} m farther in, {right:.1f} m aside; at least 0.5 m and a third of that"


def facing(a, b, facts):
    """Some front of the one looks at some front of the other across an aisle."""
    reach = 5.0
    if b in OPENINGS:
        reach = 12.0
        others = [{"rect": o["rect"], "kind": b, "normals": [geometry.INWARD[o["wall"]]]} for o in facts["openings"] if o["kind"] == b]
    else:
        others = [{**f, "normals": geometry.normals_of(f)} for f in fixtures_of(b, facts)]
    for first in fixtures_of(a, facts):
        for normal in geometry.normals_of(first):
            for other in others:
                if looks_at(first, normal, other, reach, facts):
                    return True, f"{first.get('id', a)} looks at {other.get('id', b)}"
    return False, f"no front looks at a front of the other within {reach:g} m"


def looks_at(first, normal, other, reach, facts):
    if other is first or (-normal[0], -normal[1]) not in other["normals"]:
        return False
    ahead = geometry.strip_ahead(first["rect"], normal, other["rect"])
    least = 0.6 if reach <= 5 else 0.0
    if not ahead or ahead[1] < 0.3 or not least <= ahead[0] <= reach:
        return False
    along = 1 if normal[0] else 0
    low = max(first["rect"][along], other["rect"][along])
    high = min(first["rect"][along + 2], other["rect"][along + 2])
    strip = geometry.strip_rect(first["rect"], normal, ahead[0])
    strip[along], strip[along + 2] = low, high
    return not any(overlap(strip, f["rect"]) for f in facts["fixtures"])


def overlap(a, b, by=0.05):
    return min(a[2], b[2]) - max(a[0], b[0]) > by and min(a[3], b[3]) - max(a[1], b[1]) > by


def between(a, b, c, facts):
    (ax, ay), (bx, by), (cx, cy) = (common_centre(places(n, facts)) for n in (a, b, c))
    dx, dy = cx - bx, cy - by
    length = max(1e-9, (dx * dx + dy * dy) ** 0.5)
    share = ((ax - bx) * dx + (ay - by) * dy) / length ** 2
    off = abs((ax - bx) * dy - (ay - by) * dx) / length
    limit = max(1.5, min(share, 1 - share) * length)
    return (0.1 <= share <= 0.9 and off <= limit,
            f"{share:.0%} of the way, {off:.1f} m off a line of {length:.1f} m; 10 to 90 %, at most {limit:.1f} m off")


def not_adjacent(a, b, facts):
    if b in WALLS + SEEN_WALLS:
        measured = min(to_wall(r, wall_named(b, facts), facts) for r in places(a, facts))
    else:
        first = [f["rect"] for f in fixtures_of(a, facts)] or places(a, facts)
        second = [f["rect"] for f in fixtures_of(b, facts)] or places(b, facts)
        measured = nearest_gap(first, second)
    return measured >= 1.5, f"gap {measured:.1f} m, at least 1.5 m"


RELATIONS = {"near": near, "far": far, "along": along, "at": at, "left_of": left_of, "right_of": right_of,
             "behind": behind, "facing": facing, "not_adjacent": not_adjacent}


def judge_relation(wish, facts):
    fixed = WALLS + SEEN_WALLS + ("center",)
    names = [wish["a"], wish["b"]] + ([wish["c"]] if wish.get("c") else [])
    for name in names:
        if name not in fixed and not places(name, facts):
            return False, f"the store has no {name}"
    if wish["relation"] == "between":
        return between(wish["a"], wish["b"], wish["c"], facts)
    return RELATIONS[wish["relation"]](wish["a"], wish["b"], facts)
