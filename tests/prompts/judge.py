"""Is a wish of SPEC.md met by a finished store? judge(wish, facts) -> (met, why).

Looks only at facts (store_facts.read_store). One function for each kind of wish. Tolerances: counts are
exact, lengths within 1 % (shelf pitches 2 %), `about` within 15 %, a zone's `equal` area within 10 %
because zones have no walls, shares of stock within 8 points of fill and 3 points (or 15 %) otherwise."""
import store_geometry as geometry
from judge_looks import basic_colors, family_of, nearest_styles
from judge_relations import TILLS, judge_relation
from judge_words import is_in_conflicts, is_named, share_of_words_reported
from store_facts import load_rows

ABOUT = 0.15
# Shelves as people say it: boards over one another, without doors.
PLAIN_SHELVES = ("gondola", "wall_unit")
SHELVING = ("gondola", "wall_unit", "endcap", "wine_rack", "bakery_rack", "peg_wall", "promo_stack")
LEVELLED = SHELVING + ("multideck", "glass_door_cooler", "glass_door_freezer")
NOT_SELLING = {"checkout", "self_checkout", "customer_service", "backroom"}
# Goods that are this zone's alone, (category, subcategories): "no alcohol" is not met by wine among the drinks.
GOODS_OF_ZONE = {"frozen": ("frozen", None), "produce": ("produce", None),
                 "alcohol": ("beverages", {"beer", "wine", "spirits"}),
                 "meat_fish": ("dairy", {"fresh meat", "poultry", "fish"})}
WARM_KELVIN, COLD_KELVIN, BRIGHT_LUX, DIM_LUX = 3300, 5000, 900, 450


def compares(measured, asked, comparison, tolerance=0.0):
    slack = tolerance * abs(asked) + 1e-9
    if comparison == "at_least":
        return measured >= asked - slack
    if comparison == "at_most":
        return measured <= asked + slack
    if comparison == "about":
        return abs(measured - asked) <= max(slack, ABOUT * abs(asked))
    return abs(measured - asked) <= slack


def judge_number(what, measured, wish, asked, unit="", tolerance=0.0):
    comparison = wish.get("comparison") or "equal"
    met = compares(measured, asked, comparison, tolerance)
    return met, f"{what} {measured:g}{unit}; asked for {comparison.replace('_', ' ')} {asked:g}{unit}"


def excepted(wish):
    return set(wish.get("except") or [])


def in_scope(wish, zone):
    return (wish.get("zone") in (None, zone)) and zone not in excepted(wish)


def judge_size(wish, facts):
    """Width runs along the entrance's wall; a width from west to east is taken, too, unless the wish says
    {"across": "front"}, which means that the first figure is the front's."""
    shell = facts["shell"]
    asked = (wish.get("width_m"), wish.get("depth_m"))
    entrance = next((o["wall"] for o in facts["openings"] if o["kind"] == "entrance"), "south")
    along_wall = (shell["width_m"], shell["depth_m"]) if entrance in ("north", "south") else (shell["depth_m"], shell["width_m"])
    candidates = [along_wall] if wish.get("across") == "front" else [along_wall, (shell["width_m"], shell["depth_m"])]
    fits = [all(a is None or compares(m, a, "equal", 0.01) for m, a in zip(c, asked)) for c in candidates]
    return any(fits), f"the room is {shell['width_m']:g} x {shell['depth_m']:g} m, entrance {entrance}"


def judge_area(wish, facts):
    if wish["zone"] == "store":
        return judge_number("the floor has", round(facts["shell"]["area_m2"], 2), wish, wish["m2"], " m2", 0.02)
    zones = [z for z in facts["zones"] if z["type"] == wish["zone"] and z["is_there"]]
    if not zones:
        return False, f"the store has no {wish['zone']}"
    tolerance = 0.10 if (wish.get("comparison") or "equal") == "equal" else 0.02
    return judge_number(f"{wish['zone']} has", round(sum(z["area_m2"] for z in zones), 1), wish, wish["m2"], " m2", tolerance)


def judge_zone(wish, facts):
    number = sum(z["type"] == wish["zone"] and z["is_there"] for z in facts["zones"])
    if wish.get("count") is None:
        return number >= 1, f"{number} {wish['zone']} zones"
    return judge_number(f"{wish['zone']} zones:", number, wish, wish["count"])


def judge_no_zone(wish, facts):
    zone = wish["zone"]
    number = sum(z["type"] == zone for z in facts["zones"])
    if number:
        return False, f"{number} {zone} zones"
    category, groups = GOODS_OF_ZONE.get(zone, (None, None))
    sold = sorted({g["name"] for g in facts["goods"] if g["category"] == category
                   and (groups is None or g["subcategory"] in groups)})
    if sold:
        return False, f"no such zone, but it sells {', '.join(sold[:3])}"
    equipment = {"cafe": "coffee_counter", "customer_service": "kiosk"}.get(zone)
    if any(f["kind"] == equipment for f in facts["fixtures"]):
        return False, f"no such zone, but a {equipment}"
    return True, f"no {zone} zone"


def judge_only_zones(wish, facts):
    there = {z["type"] for z in facts["zones"] if z["is_there"]}
    more, missing = there - set(wish["zones"]) - NOT_SELLING, set(wish["zones"]) - there
    why = [f"also sells {', '.join(sorted(more))}"] if more else []
    why += [f"without {', '.join(sorted(missing))}"] if missing else []
    return not why, "; ".join(why) or "nothing else is sold"


def modules(kind, facts, wish=None):
    if kind == "pillar":
        return facts["shell"]["columns"] + sum(f["kind"] == "pillar" for f in facts["fixtures"])
    return sum(f["kind"] == kind and (wish is None or in_scope(wish, f["zone"])) for f in facts["fixtures"])


def judge_fixture(wish, facts):
    number = modules(wish["fixture"], facts, wish)
    where = f" in {wish['zone']}" if wish.get("zone") else ""
    if wish.get("count") is None:
        return number >= 1, f"{number} {wish['fixture']}{where}"
    return judge_number(f"{wish['fixture']}{where}:", number, wish, wish["count"])


def judge_no_fixture(wish, facts):
    number = modules(wish["fixture"], facts, wish)
    return number == 0, f"{number} {wish['fixture']}" + (f" in {wish['zone']}" if wish.get("zone") else "")


def judge_runs(wish, facts):
    """Two single-sided lines back to back are one double-sided run."""
    runs = [r for r in facts["runs"] if r["kind"] == wish["fixture"] and in_scope(wish, r["zone"])]
    double = sum(r["sides"] == 2 for r in runs) + sum(r["back_to_back"] for r in runs) // 2
    single = sum(r["sides"] == 1 and not r["back_to_back"] for r in runs)
    number = {2: double, 1: single, None: len(runs)}[wish.get("sides")]
    others = {2: single, 1: double, None: 0}[wish.get("sides")]
    met, why = judge_number("runs:", number, wish, wish["count"])
    return met and others == 0, why + (f"; {others} of the other kind" if others else "")


def judge_aisles(wish, facts):
    """People count the aisles between gondolas, or those between any shelves and cabinets: either will do."""
    every, of_gondolas = geometry.count_aisles(facts["aisles"]), geometry.count_aisles(facts["aisles"], "gondola")
    counts = sorted({every, of_gondolas or every})
    met = any(compares(n, wish["count"], wish.get("comparison")) for n in counts)
    return met, f"{' or '.join(map(str, counts))} aisles; asked for {wish['count']}"


def judge_aisle_width(wish, facts):
    """at least and at most hold for every aisle before a shelf; `equal` for those between shelves: their
    middle one within 5 %, none narrower than that. With {"fixture": K} only aisles between two of that kind."""
    mine = [a for a in facts["aisles"] if in_scope(wish, a["zone"])]
    if wish.get("fixture"):
        mine = [a for a in mine if a["kind"] == wish["fixture"] in a["opposite"]]
    if not mine:
        return False, "no aisle before such shelves"
    comparison = wish.get("comparison") or "equal"
    if comparison == "at_least":
        return judge_number("narrowest aisle", min(a["width_m"] for a in mine), wish, wish["m"], " m", 0.01)
    between = sorted(a["width_m"] for a in mine if a["between_shelves"]) or sorted(a["width_m"] for a in mine)
    if comparison == "at_most":
        return judge_number("widest aisle between shelves", between[-1], wish, wish["m"], " m", 0.01)
    tolerance = ABOUT if comparison == "about" else 0.05
    middle = between[len(between) // 2]
    met = abs(middle - wish["m"]) <= tolerance * wish["m"] and between[0] >= (1 - tolerance) * wish["m"]
    return met, f"aisles of {between[0]:g} to {between[-1]:g} m, the middle one {middle:g} m; asked for {wish['m']:g} m"


def shelves_meant(wish, facts, kinds=LEVELLED):
    """Gondolas and wall units; in a zone that has none, its other shelves."""
    there = [f for f in facts["fixtures"] if in_scope(wish, f["zone"]) and f["kind"] in kinds]
    return [f for f in there if f["kind"] in PLAIN_SHELVES] or there


def judge_levels(wish, facts):
    shelves = shelves_meant(wish, facts)
    if not shelves:
        return False, "no such shelves"
    wrong = [f for f in shelves if not compares(f["levels"], wish["count"], wish.get("comparison"))]
    found = sorted({f["levels"] for f in shelves})
    return not wrong, f"{found} levels, {len(wrong)} of {len(shelves)} modules otherwise than asked ({wish['count']})"


def judge_shelf_pitch(wish, facts):
    pitches = [p for f in shelves_meant(wish, facts) for p in f["pitches_m"]]
    if not pitches:
        return False, "no such shelves"
    wrong = [p for p in pitches if not compares(p, wish["m"], wish.get("comparison"), 0.02)]
    return not wrong, f"pitches {min(pitches):g} to {max(pitches):g} m, {len(wrong)} of {len(pitches)} otherwise than {wish['m']:g} m"


def judge_height(wish, facts):
    """of "fixture": gondolas and wall units; for `at most` every kind of shelving, and with
    {"all_kinds": true} everything that stands there but pillars, gates and tills."""
    if wish["of"] == "ceiling":
        return judge_number("the ceiling is at", facts["shell"]["ceiling_m"], wish, wish["m"], " m", 0.01)
    inside = [f for f in facts["fixtures"] if in_scope(wish, f["zone"])]
    if wish.get("all_kinds"):
        meant = [f for f in inside if f["kind"] not in TILLS + ("pillar", "gate")]
    elif wish["of"] != "fixture":
        meant = [f for f in inside if f["kind"] == wish["of"]]
    elif wish.get("comparison") == "at_most":
        meant = [f for f in inside if f["kind"] in SHELVING]
    else:
        meant = shelves_meant(wish, facts, SHELVING)
    if not meant:
        return False, f"no {wish['of']} there"
    wrong = sorted({(f["kind"], f["height_m"]) for f in meant if not compares(f["height_m"], wish["m"], wish.get("comparison"), 0.01)})
    low, high = min(f["height_m"] for f in meant), max(f["height_m"] for f in meant)
    return not wrong, f"{low:g} to {high:g} m; asked for {wish['m']:g} m" + (f"; not {wrong[0]}" if wrong else "")


def judge_opening(wish, facts):
    """Ends are seen from inside, facing the wall: outer thirds are left and right, 0.4 to 0.6 the middle."""
    kind, wall, end, count = (wish.get(k) for k in ("opening", "wall", "end", "count"))
    found = [o for o in facts["openings"] if o["kind"] == kind and wall in (None, o["wall"])]
    at_end = [o for o in found if end is None or end_of(o) == end]
    told = ", ".join(f"{o['wall']} {o['center']:.2f}" for o in facts["openings"] if o["kind"] == kind) or "none"
    if count is None:
        return bool(at_end), f"{kind}: {told}"
    return len(found) == count and len(at_end) == count, f"{kind}: {told}; asked for {count}"


def end_of(opening):
    from_left = 1 - opening["center"] if opening["wall"] in ("south", "east") else opening["center"]
    return "left" if from_left <= 1 / 3 else "right" if from_left >= 2 / 3 else "center" if 0.4 <= from_left <= 0.6 else None


def judge_checkouts(wish, facts):
    kinds = TILLS if wish["type"] == "any" else (wish["type"],)
    return judge_number(f"{wish['type']}:", sum(modules(k, facts) for k in kinds), wish, wish["count"])


# Profiles that have another name today than in ids.txt, which stays as the prompts were written by it.
PROFILE_TODAY = {"discounter-eu": "discounter"}


def judge_profile(wish, facts):
    """By the store's own profile id; a dark store, kiosk or chemist's also by what stands there."""
    plain = lambda text: "".join(c for c in text.lower() if c.isalnum())
    profile, asked = facts["profile"], PROFILE_TODAY.get(wish["profile"], wish["profile"])
    if plain(asked) in plain(profile):
        return True, f"profile {profile}"
    there = {z["type"] for z in facts["zones"] if z["is_there"]} - NOT_SELLING
    tills = sum(modules(k, facts) for k in TILLS)
    matching = {
        "dark-store": bool(there) and tills == 0 and not any(o["kind"] == "entrance" for o in facts["openings"]),
        "kiosk": bool(there) and facts["shell"]["area_m2"] <= 30 and tills <= 1,
        "pharmacy": "personal_care" in there and there <= {"personal_care", "baby_pet", "household"},
    }.get(asked, False)
    return matching, f"profile {profile}" + (", but it is one by what stands there" if matching else "")


def judge_style(wish, facts):
    """The style that shares most parts of the look, with at least three parts, alone at the top."""
    nearest, shared = nearest_styles(facts["look"])
    return nearest == {wish["style"]} and shared >= 3, f"nearest to {', '.join(sorted(nearest))} ({shared} parts)"


def shelf_bodies(facts):
    own = [f for f in facts["fixtures"] if f["kind"] in SHELVING]
    return [f for f in own if f["kind"] in PLAIN_SHELVES] or own


def judge_material(wish, facts):
    rows = {r["id"]: r for r in load_rows("materials.json")}
    if wish["part"] != "fixture":
        material = facts["look"].get(wish["part"], "")
        return wish["family"] in family_of(material, rows), f"{wish['part']} of {material}"
    bodies = shelf_bodies(facts)
    if not bodies:
        return False, "no shelving"
    share = sum(wish["family"] in family_of(f["material"], rows) for f in bodies) / len(bodies)
    return share >= 0.8, f"{share:.0%} of the shelving; of {', '.join(sorted({f['material'] for f in bodies})[:3])}"


def judge_color(wish, facts):
    if wish["part"] == "accent":
        color = facts["look"].get("accent", "#000000")
        return wish["color"] in basic_colors(color), f"accent {color}"
    if wish["part"] == "fixture":
        bodies = shelf_bodies(facts)
        if not bodies:
            return False, "no shelving"
        share = sum(wish["color"] in basic_colors(f["color"]) for f in bodies) / len(bodies)
        return share >= 0.8, f"{share:.0%} of the shelving; of {', '.join(sorted({f['color'] for f in bodies})[:3])}"
    material = facts["look"].get(wish["part"], "")
    row = next((r for r in load_rows("materials.json") if r["id"] == material), None)
    return row is not None and wish["color"] in basic_colors(row["color"]), f"{wish['part']} of {material}"


def judge_light(wish, facts):
    value = facts["look"].get("light_kelvin" if wish["what"] == "kelvin" else "light_lux", 0)
    if wish.get("value") is not None:
        return judge_number(wish["what"], value, {}, wish["value"], "", 0.02)
    met = {"warm": value <= WARM_KELVIN, "cold": value >= COLD_KELVIN,
           "bright": value >= BRIGHT_LUX, "dim": value <= DIM_LUX}.get(wish["degree"], False)
    return met, f"{wish['what']} {value}; asked for {wish['degree']}"


def share_judged(share, wish, limits, tolerance):
    """By the number when there is one, else by the degree's limits (least, most)."""
    asked = wish.get("value")
    if asked is not None:
        met = abs(share - asked) <= tolerance(asked) + 1e-9
        return met, f"{share:.1%}; asked for {asked:.0%} within {tolerance(asked):.0%}"
    low, high = limits[wish.get("degree")]
    return low <= share <= high, f"{share:.1%}; {wish.get('degree') or 'some'} is {low:.0%} to {high:.0%}"


# Limits for each degree; None is a wish without a degree ("untidy").
STOCK_LIMITS = {
    "fill": {"all": (0.92, 1), "many": (0.75, 1), "some": (0.3, 0.75), "few": (0.001, 0.25), "none": (0, 0.02), None: (0.85, 1)},
    "out_of_stock": {"none": (0, 0), "few": (0.001, 0.1), "some": (0.05, 0.35), "many": (0.25, 1), "all": (0.97, 1), None: (0.05, 1)},
    "misplaced": {"none": (0, 0), "few": (1e-9, 0.04), "some": (0.01, 0.15), "many": (0.05, 1), "all": (0.9, 1), None: (0.01, 1)},
    "untidy": {"none": (0, 0.03), "few": (0.02, 0.15), "some": (0.08, 0.4), "many": (0.12, 1), "all": (0.5, 1), None: (0.08, 1)},
}
FIGURES = {"fill": ("stocked_m", "front_m"), "out_of_stock": ("empty_facings", "facings"),
           "misplaced": ("misplaced", "front_items"), "untidy": ("out_of_line", "standing")}


def judge_stock(wish, facts):
    """fill: stocked share of the shelf front; out_of_stock: empty share of the facing blocks; misplaced:
    goods in another's block over the goods in the front row; untidy: goods in the front row out of line."""
    zones = [figures for zone, figures in facts["stock"].items()
             if in_scope(wish, zone) and (wish.get("zone") or zone not in NOT_SELLING)]
    part, whole = FIGURES[wish["what"]]
    total = sum(z[whole] for z in zones)
    if total <= 0:
        return False, f"not judged: nothing to measure {wish['what']} on in {wish.get('zone') or 'the store'}"
    what = wish["what"]
    tolerance = (lambda v: 0.08) if what == "fill" else (lambda v: max(0.03, 0.15 * v) if v > 0 else 0.0)
    met, why = share_judged(sum(z[part] for z in zones) / total, wish, STOCK_LIMITS[what], tolerance)
    return met, f"{what} {why}"


def judge_product(wish, facts):
    named = [g for g in facts["goods"] if is_named(g, wish["sku"])]
    if wish.get("zone"):
        named = [g for g in named if wish["zone"] in g["zones"]]
    names = ", ".join(sorted({(g["name"] + " " + g["variant"]).strip() for g in named})[:3]) or "none"
    return bool(named) == wish["present"], f"{len(named)} products: {names}"


def judge_endcaps(wish, facts):
    number = modules("endcap", facts)
    return (number > 0) == wish["wanted"], f"{number} endcaps"


def judge_name(wish, facts):
    plain = lambda text: " ".join("".join(c for c in text if c not in "\"'“”„‘’「」").split()).casefold()
    return plain(facts["name"]) == plain(wish["name"]), f"the name is {facts['name']!r}"


KINDS = {"size": judge_size, "area": judge_area, "zone": judge_zone, "no_zone": judge_no_zone, "only_zones": judge_only_zones,
         "fixture": judge_fixture, "no_fixture": judge_no_fixture, "runs": judge_runs, "aisles": judge_aisles,
         "aisle_width": judge_aisle_width, "levels": judge_levels, "shelf_pitch": judge_shelf_pitch, "height": judge_height,
         "relation": judge_relation, "opening": judge_opening, "checkouts": judge_checkouts, "profile": judge_profile,
         "style": judge_style, "material": judge_material, "color": judge_color, "light": judge_light, "stock": judge_stock,
         "product": judge_product, "endcaps": judge_endcaps, "name": judge_name}


def judge(wish, facts):
    check = KINDS.get(wish.get("kind"))
    if check is None:
        return False, f"not judged: unknown kind {wish.get('kind')!r}"
    try:
        return check(wish, facts)
    except (KeyError, TypeError, ValueError) as error:
        return False, f"not judged: {type(error).__name__} {error}"


def judge_conflict(pair, prompt, facts):
    """Both texts are reported in the list of conflicts."""
    missing = [text for text in pair if not is_in_conflicts(text, prompt, facts["conflicts"])]
    return not missing, f"{len(pair) - len(missing)} of {len(pair)} texts reported"


def judge_cannot(text, prompt, facts):
    """At least half of its content words are listed as not understood or as given up."""
    share = share_of_words_reported(text, prompt, facts["unparsed"] + facts["conflicts"])
    return share >= 0.5, f"{share:.0%} of its words reported"
