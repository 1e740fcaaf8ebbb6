"""python3 -m unittest test_judge (in this folder): each kind of wish with a store that meets it and one that does not."""
import copy
import unittest

import store_geometry as geometry
from judge import judge, judge_cannot, judge_conflict
from judge_looks import basic_colors, family_of, nearest_styles
from judge_words import stem
from score import wilson


def fixture(kind, zone, rect, yaw=0, **more):
    return {"id": f"{zone}/{kind}", "kind": kind, "zone": zone, "zone_id": zone, "rect": rect, "yaw": yaw, "sides": 1,
            "height_m": 1.8, "material": "metal-white", "color": "#f2f2f0", "items": 10, "levels": 5,
            "pitches_m": [0.3, 0.3, 0.3, 0.3], **more}


def zone(kind, rect, **more):
    return {"id": kind, "type": kind, "rect": rect, "area_m2": geometry.area(rect), "is_there": True, **more}


def figures(**more):
    return {"front_m": 10.0, "stocked_m": 9.5, "facings": 100, "empty_facings": 3, "front_items": 200, "misplaced": 0,
            "standing": 200, "out_of_line": 3, **more}


def product(name, category, subcategory, zones, variant="", keywords=()):
    return {"sku": name, "name": name, "name_zh": "", "variant": variant, "category": category, "subcategory": subcategory,
            "keywords": list(keywords), "zones": zones}


def small_store():
    """20 x 12 m, entrance in the middle of the south wall. Dairy along the north wall, bakery along the west
    wall, in the middle two double-sided gondola runs of dry goods and snacks, 2 m apart; one till."""
    fixtures = [fixture("multideck", "dairy", [6 + 1.25 * i, 11, 7.25 + 1.25 * i, 12]) for i in range(6)]
    fixtures += [fixture("bakery_rack", "bakery", [0, 4 + i, 0.6, 5 + i], yaw=90) for i in range(3)]
    fixtures += [fixture("gondola", "dry_goods", [8, 4 + i, 9, 5 + i], yaw=90, sides=2) for i in range(4)]
    fixtures += [fixture("gondola", "snacks", [11, 4 + i, 12, 5 + i], yaw=90, sides=2) for i in range(4)]
    fixtures += [fixture("checkout_lane", "checkout", [15, 1, 16, 3], yaw=90, items=0, levels=0, pitches_m=[])]
    runs = geometry.runs_of(fixtures)
    floor = [0, 0, 20, 12]
    return {
        "name": "Corner Shop", "profile": "supermarket-eu", "fixtures": fixtures, "runs": runs,
        "shell": {"width_m": 20.0, "depth_m": 12.0, "ceiling_m": 3.0, "area_m2": 240.0, "columns": 0, "floor": floor},
        "openings": [{"kind": "entrance", "wall": "south", "center": 0.5, "rect": [9, 0, 11, 1]},
                     {"kind": "exit", "wall": "south", "center": 0.9, "rect": [17, 0, 19, 1]}],
        "zones": [zone("dairy", [6, 11, 13.5, 12]), zone("bakery", [0, 4, 0.6, 7]), zone("dry_goods", [8, 4, 9, 8]),
                  zone("snacks", [11, 4, 12, 8]), zone("checkout", [15, 1, 16, 3])],
        "aisles": geometry.aisles_of(runs, fixtures, floor),
        "stock": {"dairy": figures(), "bakery": figures(stocked_m=2.0), "dry_goods": figures(), "snacks": figures(empty_facings=50)},
        "goods": [product("Milk", "dairy", "milk", ["dairy"], "Whole"), product("Flour", "dry_goods", "flour & baking", ["dry_goods"], "Wheat"),
                  product("Egg Noodles", "dry_goods", "pasta", ["dry_goods"]), product("Potato Crisps", "snacks", "crisps", ["snacks"])],
        "look": {"floor": "wood-oak", "wall": "plaster-white", "ceiling": "plaster-white", "fixture": "metal-white",
                 "accent": "#2e7d32", "light_kelvin": 3000, "light_lux": 950},
        "unparsed": [], "conflicts": [], "planning_s": 0.1}


class JudgeTest(unittest.TestCase):
    def setUp(self):
        self.store = small_store()

    def both(self, kind, met, unmet):
        """The first fields are met by the small store, the second are not."""
        for fields, wanted in ((met, True), (unmet, False)):
            got, why = judge({"kind": kind, "text": "", **fields}, self.store)
            self.assertEqual(got, wanted, f"{kind} {fields}: {why}")
            self.assertFalse(why.startswith("not judged"), why)

    def test_size(self):
        self.both("size", {"width_m": 20, "depth_m": 12}, {"width_m": 12, "depth_m": 20})
        self.both("size", {"width_m": None, "depth_m": 12.1}, {"width_m": None, "depth_m": 12.2})

    def test_size_across_the_front(self):
        self.store["openings"][0]["wall"] = "west"
        self.both("size", {"width_m": 12, "depth_m": 20, "across": "front"}, {"width_m": 20, "depth_m": 12, "across": "front"})

    def test_area(self):
        self.both("area", {"zone": "store", "m2": 240, "comparison": "equal"}, {"zone": "store", "m2": 200, "comparison": "about"})
        self.both("area", {"zone": "dairy", "m2": 7, "comparison": "at_least"}, {"zone": "frozen", "m2": 7, "comparison": "at_most"})

    def test_zone(self):
        self.both("zone", {"zone": "dairy", "count": None}, {"zone": "cafe", "count": None})
        self.both("zone", {"zone": "dairy", "count": 1, "comparison": "equal"}, {"zone": "dairy", "count": 2, "comparison": "at_least"})

    def test_no_zone(self):
        self.both("no_zone", {"zone": "alcohol"}, {"zone": "dairy"})
        self.store["goods"].append(product("Riesling", "beverages", "wine", ["beverages"]))
        self.assertFalse(judge({"kind": "no_zone", "zone": "alcohol"}, self.store)[0])

    def test_only_zones(self):
        everything = ["dairy", "bakery", "dry_goods", "snacks"]
        self.both("only_zones", {"zones": everything}, {"zones": everything[:3]})
        self.both("only_zones", {"zones": everything}, {"zones": everything + ["frozen"]})

    def test_fixture(self):
        self.both("fixture", {"fixture": "multideck", "zone": "dairy", "count": 6, "comparison": "equal"},
                  {"fixture": "multideck", "zone": "bakery", "count": None})

    def test_no_fixture(self):
        self.both("no_fixture", {"fixture": "bin", "zone": None}, {"fixture": "gondola", "zone": "snacks"})

    def test_pillars_are_columns_too(self):
        self.store["shell"]["columns"] = 4
        self.both("fixture", {"fixture": "pillar", "count": 4, "comparison": "equal"}, {"fixture": "pillar", "count": 5, "comparison": "equal"})

    def test_runs(self):
        self.both("runs", {"fixture": "gondola", "zone": None, "count": 2, "sides": 2}, {"fixture": "gondola", "zone": None, "count": 2, "sides": 1})
        self.both("runs", {"fixture": "gondola", "zone": "snacks", "count": 1, "sides": 2}, {"fixture": "gondola", "zone": "snacks", "count": 4, "sides": None})

    def test_back_to_back_is_double_sided(self):
        self.store["runs"] = geometry.runs_of([fixture("gondola", "snacks", [0, 0, 1, 0.5], yaw=0), fixture("gondola", "snacks", [0, 0.5, 1, 1], yaw=180)])
        self.both("runs", {"fixture": "gondola", "zone": None, "count": 1, "sides": 2}, {"fixture": "gondola", "zone": None, "count": 2, "sides": 1})

    def test_aisles(self):
        self.both("aisles", {"count": 1, "comparison": "equal"}, {"count": 2, "comparison": "at_least"})

    def test_aisle_width(self):
        self.both("aisle_width", {"m": 2.0, "comparison": "equal", "zone": "snacks"}, {"m": 1.5, "comparison": "equal", "zone": None})
        self.both("aisle_width", {"m": 1.9, "comparison": "at_least", "zone": None}, {"m": 2.1, "comparison": "at_least", "zone": None})

    def test_levels(self):
        self.store["fixtures"][-2]["levels"] = 4  # a gondola of snacks
        self.both("levels", {"zone": "dry_goods", "count": 5, "comparison": "equal"}, {"zone": None, "count": 5, "comparison": "equal"})
        self.both("levels", {"zone": None, "count": 5, "comparison": "equal", "except": ["snacks"]}, {"zone": None, "count": 5, "except": ["dairy"]})

    def test_shelf_pitch(self):
        self.both("shelf_pitch", {"zone": None, "m": 0.302, "comparison": "equal"}, {"zone": "snacks", "m": 0.35, "comparison": "at_least"})

    def test_height(self):
        self.both("height", {"of": "ceiling", "zone": None, "m": 3.0, "comparison": "equal"}, {"of": "ceiling", "zone": None, "m": 3.5, "comparison": "at_least"})
        self.both("height", {"of": "gondola", "zone": None, "m": 1.8, "comparison": "equal"}, {"of": "fixture", "zone": None, "m": 1.6, "comparison": "at_most"})
        self.store["fixtures"][0]["height_m"] = 2.1  # a cooler is no shelf
        self.both("height", {"of": "fixture", "zone": None, "m": 1.8, "comparison": "at_most"},
                  {"of": "fixture", "zone": None, "m": 1.8, "comparison": "at_most", "all_kinds": True})

    def relation(self, met, unmet):
        name = lambda r: dict(zip(("relation", "a", "b", "c"), r + (None,)))
        self.both("relation", name(met), name(unmet))

    def test_relations(self):
        self.relation(("near", "snacks", "entrance"), ("near", "dairy", "entrance"))
        self.relation(("far", "dairy", "entrance"), ("far", "snacks", "entrance"))
        self.relation(("along", "dairy", "back"), ("along", "snacks", "back"))
        self.relation(("along", "bakery", "left"), ("along", "bakery", "right"))
        self.relation(("at", "dairy", "north"), ("at", "dairy", "center"))
        self.relation(("at", "gondola", "center"), ("at", "bakery", "center"))
        self.relation(("left_of", "dry_goods", "snacks"), ("left_of", "snacks", "dry_goods"))
        self.relation(("right_of", "checkout", "entrance"), ("right_of", "bakery", "entrance"))
        self.relation(("behind", "dairy", "snacks"), ("behind", "bakery", "checkout"))
        self.relation(("facing", "snacks", "dry_goods"), ("facing", "dairy", "bakery"))
        self.relation(("not_adjacent", "dairy", "snacks"), ("not_adjacent", "multideck", "dairy"))

    def test_between_and_missing_places(self):
        self.both("relation", {"relation": "between", "a": "dry_goods", "b": "bakery", "c": "snacks"},
                  {"relation": "between", "a": "dairy", "b": "bakery", "c": "snacks"})
        met, why = judge({"kind": "relation", "relation": "near", "a": "wine", "b": "entrance", "c": None}, self.store)
        self.assertEqual((met, why), (False, "the store has no wine"))

    def test_left_is_mirrored_for_a_north_entrance(self):
        self.store["openings"] = [{"kind": "entrance", "wall": "north", "center": 0.5, "rect": [9, 11, 11, 12]}]
        self.relation(("left_of", "snacks", "dry_goods"), ("left_of", "dry_goods", "snacks"))
        self.relation(("along", "bakery", "right"), ("along", "bakery", "left"))

    def test_opening(self):
        opening = lambda *v: dict(zip(("opening", "wall", "end", "count"), v))
        self.both("opening", opening("entrance", "south", "center", 1), opening("entrance", "north", None, None))
        self.both("opening", opening("exit", "south", "left", None), opening("exit", "south", "right", None))
        self.both("opening", opening("window", None, None, 0), opening("entrance", None, None, 0))

    def test_checkouts(self):
        self.both("checkouts", {"type": "any", "count": 1, "comparison": "equal"}, {"type": "checkout_lane", "count": 0, "comparison": "equal"})
        self.both("checkouts", {"type": "self_checkout", "count": 0, "comparison": "equal"}, {"type": "self_checkout", "count": 1, "comparison": "at_least"})

    def test_profile(self):
        self.both("profile", {"profile": "supermarket-eu"}, {"profile": "dark-store"})
        self.store["openings"], self.store["fixtures"] = [], self.store["fixtures"][:-1]
        self.both("profile", {"profile": "dark-store"}, {"profile": "forecourt"})
        self.store["profile"] = "discounter"
        self.both("profile", {"profile": "discounter-eu"}, {"profile": "supermarket-eu"})

    def test_style(self):
        self.store["look"] = {"floor": "concrete-dark", "wall": "concrete-board", "ceiling": "concrete-raw", "fixture": "metal-black",
                              "accent": "#d9a92e", "light_kelvin": 4000, "light_lux": 600, "lamps": "line"}
        self.both("style", {"style": "brutalist"}, {"style": "modern"})

    def test_material(self):
        self.both("material", {"part": "floor", "family": "wood"}, {"part": "floor", "family": "dark wood"})
        self.both("material", {"part": "fixture", "family": "steel"}, {"part": "fixture", "family": "wood"})

    def test_color(self):
        self.both("color", {"part": "accent", "color": "green"}, {"part": "accent", "color": "yellow"})
        self.both("color", {"part": "fixture", "color": "white"}, {"part": "wall", "color": "pink"})

    def test_light(self):
        self.both("light", {"what": "kelvin", "value": 3000, "degree": None}, {"what": "kelvin", "value": 4000, "degree": None})
        self.both("light", {"what": "lux", "value": None, "degree": "bright"}, {"what": "kelvin", "value": None, "degree": "cold"})

    def test_stock(self):
        self.both("stock", {"what": "fill", "value": 0.2, "degree": None, "zone": "bakery"}, {"what": "fill", "value": 0.2, "degree": None, "zone": "dairy"})
        self.both("stock", {"what": "out_of_stock", "value": 0.5, "degree": None, "zone": "snacks"}, {"what": "out_of_stock", "value": None, "degree": "none", "zone": "dairy"})
        self.both("stock", {"what": "misplaced", "value": None, "degree": "none", "zone": None}, {"what": "misplaced", "value": None, "degree": "few", "zone": None})
        self.both("stock", {"what": "untidy", "value": None, "degree": "none", "zone": None}, {"what": "untidy", "value": None, "degree": None, "zone": None})

    def test_stock_exceptions(self):
        wish = {"what": "fill", "value": 0.95, "degree": None, "zone": None}
        self.both("stock", {**wish, "except": ["bakery"]}, wish)

    def test_product(self):
        self.both("product", {"sku": "flour", "present": True, "zone": None}, {"sku": "flour", "present": True, "zone": "snacks"})
        self.both("product", {"sku": "eggs", "present": False, "zone": None}, {"sku": "cow's milk", "present": False, "zone": None})
        self.both("product", {"sku": "chips", "present": True, "zone": None}, {"sku": "almond milk", "present": True, "zone": None})

    def test_goods_in_any_number_and_as_they_are_kept(self):
        self.assertEqual(stem("sandwiches"), stem("sandwich"))
        self.assertEqual(stem("mangoes"), stem("mango"))
        self.store["goods"].append(product("Peach Halves", "canned", "fruit", ["canned"]))
        self.store["goods"].append(product("Dumplings", "frozen", "frozen meals", ["frozen"], "Pork"))
        self.both("product", {"sku": "frozen dumplings", "present": True, "zone": None}, {"sku": "frozen peas", "present": True, "zone": None})
        self.both("product", {"sku": "tinned halves", "present": True, "zone": None}, {"sku": "frozen halves", "present": True, "zone": None})

    def test_endcaps(self):
        self.both("endcaps", {"wanted": False}, {"wanted": True})

    def test_name(self):
        self.both("name", {"name": "“Corner Shop”"}, {"name": "Corner"})

    def test_what_cannot_be_judged_is_unmet(self):
        self.assertEqual(judge({"kind": "smell"}, self.store)[0], False)
        self.store["stock"] = {}
        met, why = judge({"kind": "stock", "what": "fill", "value": 1, "degree": None, "zone": None}, self.store)
        self.assertTrue(not met and why.startswith("not judged"))


class ReportedTest(unittest.TestCase):
    prompt = "Walls of wood, please. Walls of brick. And a unicorn stable. 一扇窗"

    def facts(self, conflicts=(), unparsed=()):
        return {"conflicts": list(conflicts), "unparsed": list(unparsed)}

    def test_conflict_by_words(self):
        both = [{"what": "wall", "kept": "walls of brick", "dropped": "Walls of wood", "why": ""}]
        pair = ["Walls of wood", "Walls of brick"]
        self.assertTrue(judge_conflict(pair, self.prompt, self.facts(both))[0])
        self.assertFalse(judge_conflict(pair, self.prompt, self.facts([{"kept": "oak", "dropped": "carpet"}]))[0])

    def test_conflict_by_spans(self):
        spans = [{"kept_span": [23, 37], "dropped_span": [0, 13]}]
        pair = ["Walls of wood", "Walls of brick"]
        self.assertTrue(judge_conflict(pair, self.prompt, self.facts(spans))[0])
        self.assertFalse(judge_conflict(pair, self.prompt, self.facts([{"kept_span": [23, 37]}]))[0])

    def test_cannot(self):
        word = {"text": "unicorn", "span": [45, 52]}
        self.assertTrue(judge_cannot("a unicorn stable", self.prompt, self.facts(unparsed=[word]))[0])
        self.assertFalse(judge_cannot("a unicorn stable", self.prompt, self.facts())[0])

    def test_spans_are_bytes(self):
        start = len(self.prompt.encode()) - 9
        self.assertTrue(judge_cannot("一扇窗", self.prompt, self.facts(unparsed=[{"text": "", "span": [start, start + 9]}]))[0])


class LooksTest(unittest.TestCase):
    def test_colors(self):
        for color, name in (("#a92b2c", "red"), ("#1f2123", "black"), ("#f2f2f0", "white"), ("#9aa0a4", "grey"), ("#2f6f70", "turquoise"),
                            ("#c8a561", "gold"), ("#6d4c35", "brown"), ("#6a1b9a", "purple"), ("#d39a9a", "pink"), ("#d9a92e", "yellow")):
            self.assertIn(name, basic_colors(color), color)
        self.assertNotIn("black", basic_colors("#3a3f44"))
        self.assertNotIn("pink", basic_colors("#a92b2c"))

    def test_families(self):
        self.assertEqual(family_of("wood-dark"), {"wood", "dark wood"})
        self.assertEqual(family_of("tile-metro"), {"white tile"})
        self.assertEqual(family_of("no such material"), set())

    def test_styles_that_tie(self):
        self.assertGreater(len(nearest_styles({})[0]), 1)


class GeometryTest(unittest.TestCase):
    def test_a_gap_cuts_a_run(self):
        pieces = [fixture("gondola", "snacks", [0, 0, 1, 1]), fixture("gondola", "snacks", [1, 0, 2, 1]), fixture("gondola", "snacks", [4, 0, 5, 1])]
        self.assertEqual([r["modules"] for r in geometry.runs_of(pieces)], [2, 1])
        self.assertEqual(geometry.runs_of(copy.deepcopy(pieces[::-1])), geometry.runs_of(pieces))

    def test_a_cross_aisle_does_not_make_two_aisles(self):
        store = small_store()
        more = [fixture("gondola", z, [x, 9.5, x + 1, 11.5], yaw=90, sides=2) for z, x in (("dry_goods", 8), ("snacks", 11))]
        runs = geometry.runs_of(store["fixtures"] + more)
        self.assertEqual(geometry.count_aisles(geometry.aisles_of(runs, store["fixtures"] + more, [0, 0, 20, 14])), 1)


class WilsonTest(unittest.TestCase):
    def test_interval(self):
        low, high = wilson(8, 10)
        self.assertAlmostEqual(low, 0.490, places=3)
        self.assertAlmostEqual(high, 0.943, places=3)


if __name__ == "__main__":
    unittest.main()
