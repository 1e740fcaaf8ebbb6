"""Looks: basic colours of a hex code, families of materials, and which style a store has."""
import colorsys

from store_facts import load_rows

WOOD_PATTERNS = {"planks", "knotty_planks", "veneer", "herringbone", "chevron", "basket", "strand_board"}
TILE_PATTERNS = {"tiles", "hex_tiles", "mosaic", "glazed_tiles", "fish_scale", "herringbone_tiles", "chequer"}
BRICK_PATTERNS = {"brick", "brick_english", "brick_flemish", "brick_stack"}
STONE_PATTERNS = {"granite", "slate", "travertine", "ledgestone", "crazy_paving"}
PLASTER_PATTERNS = {"limewash", "roughcast", "trowelled"}
CONCRETE_PATTERNS = {"concrete", "board_formed", "cast_panels"}
METALS = ("steel", "metal", "aluminium", "brass", "copper", "chrome")
HUES = (("red", 0, 18), ("orange", 15, 42), ("yellow", 38, 68), ("green", 65, 172), ("turquoise", 160, 200),
        ("blue", 190, 255), ("purple", 250, 320), ("pink", 310, 345), ("red", 345, 361))
STYLE_PARTS = ("floor", "wall", "ceiling", "fixture", "accent", "lamps", "light_kelvin", "light_lux")


def hsv(color):
    r, g, b = (int(color[i:i + 2], 16) / 255 for i in (1, 3, 5))
    h, s, v = colorsys.rgb_to_hsv(r, g, b)
    return h * 360, s, v


def basic_colors(color):
    """Plain names for a colour; near a border it has more than one."""
    h, s, v = hsv(color)
    if v < 0.25:
        return {"black"} | ({"green"} if s > 0.3 and 80 <= h < 170 else set())
    if s < 0.12 or (s < 0.2 and v < 0.5):
        return {"white"} if v > 0.855 else {"grey", "white"} if v > 0.8 else {"grey"}
    names = {name for name, low, high in HUES if low <= h < high}
    if v > 0.85 and s < 0.18:
        names |= {"white", "cream", "beige"}
    return refine(names, h, s, v)


def refine(names, h, s, v):
    if (h < 20 or h > 330) and s < 0.55 and v > 0.7 or h < 24 and s < 0.35 and v > 0.8:
        names = (names - {"red", "orange"}) | {"pink"}
    if 15 <= h < 50 and v < 0.72:
        names = (names - ({"orange"} if v < 0.6 else set())) | {"brown"}
    if 20 <= h < 50 and s < 0.5 and v > 0.7:
        names = (names - {"yellow", "orange"}) | {"beige", "cream"}
    if 33 <= h < 56 and s >= 0.4 and v > 0.6:
        names.add("gold")
    return names


def family_of(material, rows=None):
    """All families of ids.txt that a material belongs to."""
    rows = rows if rows is not None else {r["id"]: r for r in load_rows("materials.json")}
    row = rows.get(material)
    if row is None:
        return set()
    pattern, label, families = row["pattern"], (row["id"] + " " + row["name"]).lower(), set()
    by_pattern = ((WOOD_PATTERNS, "wood"), (STONE_PATTERNS, "stone"), (PLASTER_PATTERNS, "plaster"),
                  (CONCRETE_PATTERNS, "concrete"))
    families |= {family for patterns, family in by_pattern if pattern in patterns}
    by_label = (("terrazzo", "terrazzo"), ("marble", "marble"), ("vinyl", "vinyl"), ("linoleum", "linoleum"),
                ("carpet", "carpet"), ("terracotta", "terracotta"), ("quarry", "terracotta"), ("slate", "stone"),
                ("plaster", "plaster"), ("steel", "steel"))
    families |= {family for word, family in by_label if word in label}
    if pattern == "slats" and any(w in label for w in ("oak", "wood", "pine", "walnut")):
        families.add("wood")
    is_tile = pattern in TILE_PATTERNS or "tile" in label or "metro" in label
    if pattern in BRICK_PATTERNS and not is_tile:
        families.add("brick")
    return families | shaded(row, is_tile, families) | metals(row, label)


def shaded(row, is_tile, families):
    h, s, v = hsv(row["color"])
    found = set()
    if is_tile and "plaster" not in families and row["pattern"] != "chequer":
        colors = basic_colors(row["color"])
        found |= {"white tile"} if "white" in colors else set()
        found |= {"grey tile"} if "grey" in colors else set()
    if "wood" in families and v < 0.56:
        found.add("dark wood")
    return found


def metals(row, label):
    """Powder-coated shelving is sheet steel."""
    if row["metallic"] or any(label.startswith(m) for m in METALS) or "metal" in label:
        return {"metal", "steel"} if label.startswith(("metal-", "steel")) else {"metal"}
    return set()


def nearest_styles(look, styles=None):
    """The styles that share most parts with the store's look, and how many they share."""
    styles = styles if styles is not None else load_rows("styles.json")
    shared = {s["id"]: sum(look.get(p, "panel" if p == "lamps" else None) == s.get(p, "panel" if p == "lamps" else None)
                           for p in STYLE_PARTS) for s in styles}
    most = max(shared.values(), default=0)
    return {name for name, number in shared.items() if number == most}, most
