// Every fault that a schema cannot see: a valid plan with one thing spoilt, the code of its error
// and where it points.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "io/json.h"
#include "plan/bsp.h"
#include "plan/plan.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

constexpr const char* valid_text = R"({
  "schema": "market-plan/1", "name": "Corner", "profile": "supermarket-eu",
  "shell": {"width_mm": 12000, "depth_mm": 9000,
    "openings": [{"id": "entrance", "kind": "entrance", "wall": "south", "center": 0.25, "width_mm": 2000},
                 {"id": "exit", "kind": "exit", "wall": "south", "center": 0.75, "width_mm": 2000}],
    "columns": [{"x_mm": 6000, "y_mm": 4500, "size_mm": 400}]},
  "nodes": [{"id": "root", "split": "y", "ratio": 0.4, "gap_mm": 2000, "children": ["front", "back"]},
            {"id": "front", "zone": "tills"},
            {"id": "back", "split": "x", "ratio": 0.5, "gap_mm": 1800, "children": ["west", "east"]},
            {"id": "west", "zone": "snacks"}, {"id": "east", "zone": "dairy"}],
  "zones": [{"id": "tills", "type": "checkout", "fixture": {"kind": "checkout_lane"}},
            {"id": "snacks", "type": "snacks", "fixture": {"kind": "gondola", "levels": 5, "height_mm": 1800},
             "stock": {"categories": ["snacks"]}},
            {"id": "dairy", "type": "dairy", "fixture": {"kind": "multideck"}}],
  "relations": [{"kind": "near", "a": "dairy", "b": "north"},
                {"kind": "between", "a": "snacks", "b": "entrance", "c": "dairy"}],
  "overrides": [{"fixture": "snacks/run-1/module-1", "field": "levels", "value": "4"}]
})";

plan::Plan valid_plan() {
  auto plan = plan::read_plan(valid_text, "corner.json", committed_catalog());
  if (!plan.ok()) fatal(to_string(plan.error()).c_str());
  return std::move(plan).value();
}

plan::FixtureSpec so_many(const std::string& kind, std::optional<int> count) {
  plan::FixtureSpec spec;
  spec.kind = kind;
  spec.count = count;
  return spec;
}

// Nodes are root, front, back, west, east; zones are tills, snacks, dairy.
struct Fault {
  const char* name;
  std::function<void(plan::Plan&)> spoil;
  const char* code;
  const char* where;
};

plan::Node leaf_node(const std::string& id, const std::string& zone) {
  plan::Node node;
  node.id = id;
  node.zone = zone;
  return node;
}

// A tree that goes one cut deeper with every zone.
void grow_deep(plan::Plan& plan, int cuts) {
  plan.shell.width_mm = plan.shell.depth_mm = 100000;
  plan.nodes.clear();
  plan.zones.resize(1);
  plan.relations.clear();
  plan.overrides.clear();
  plan.zones[0].id = "z0";
  for (int i = 0; i < cuts; ++i) {
    plan::Node cut;
    cut.id = "cut" + std::to_string(i);
    cut.split = i % 2 == 0 ? plan::Axis::x : plan::Axis::y;
    const std::string next = i + 1 < cuts ? "cut" + std::to_string(i + 1) : "last";
    cut.children = {"leaf" + std::to_string(i), next};
    plan.nodes.push_back(cut);
    plan.nodes.push_back(leaf_node("leaf" + std::to_string(i), "z" + std::to_string(i)));
    plan.zones.push_back(plan.zones[0]);
    plan.zones.back().id = "z" + std::to_string(i + 1);
  }
  plan.nodes.push_back(leaf_node("last", "z" + std::to_string(cuts)));
}

const std::vector<Fault> faults = {
    {"duplicate_node",
     [](plan::Plan& p) { p.nodes[3].id = "front"; },
     "plan.duplicate_id",
     "/nodes/3/id"},
    {"duplicate_zone",
     [](plan::Plan& p) { p.zones[2].id = "snacks"; },
     "plan.duplicate_id",
     "/zones/2/id"},
    {"opening_named_like_a_zone",
     [](plan::Plan& p) { p.shell.openings[0].id = "dairy"; },
     "plan.duplicate_id",
     "/shell/openings/0/id"},
    {"unknown_child",
     [](plan::Plan& p) { p.nodes[0].children[1] = "bakc"; },
     "plan.unknown_reference",
     "/nodes/0/children/1"},
    {"unknown_zone",
     [](plan::Plan& p) { p.nodes[4].zone = "diary"; },
     "plan.unknown_reference",
     "/nodes/4/zone"},
    {"unknown_material",
     [](plan::Plan& p) { p.look.floor = "teraco"; },
     "catalog.unknown_kind",
     "/look/floor"},
    {"unknown_fixture",
     [](plan::Plan& p) { p.zones[1].fixture.kind = "gondla"; },
     "catalog.unknown_kind",
     "/zones/1/fixture/kind"},
    {"unknown_zone_type",
     [](plan::Plan& p) { p.zones[1].type = "snack"; },
     "catalog.unknown_kind",
     "/zones/1/type"},
    {"unknown_category",
     [](plan::Plan& p) { p.zones[1].stock.categories = {"snaks"}; },
     "catalog.unknown_kind",
     "/zones/1/stock/categories/0"},
    {"unknown_profile",
     [](plan::Plan& p) { p.profile = "supermarket"; },
     "catalog.unknown_kind",
     "/profile"},
    {"unknown_fixture_material",
     [](plan::Plan& p) { p.zones[0].fixture.material = "mud"; },
     "catalog.unknown_kind",
     "/zones/0/fixture/material"},
    {"unknown_anchor",
     [](plan::Plan& p) { p.zones[0].anchor = "nort"; },
     "plan.unknown_reference",
     "/zones/0/anchor"},
    {"whole_tree_is_a_cycle",
     [](plan::Plan& p) {
       p.nodes[2].children[0] = "root";
       p.nodes.erase(p.nodes.begin() + 3);
       p.zones.erase(p.zones.begin() + 1);
     },
     "plan.cyclic_tree",
     "/nodes"},
    {"node_is_its_own_child",
     [](plan::Plan& p) { p.nodes[2].children[0] = "back"; },
     "plan.overlapping_nodes",
     "/nodes/2/children/0"},
    {"cycle_beside_the_tree",
     [](plan::Plan& p) {
       plan::Node a = p.nodes[2], b = p.nodes[2];
       a.id = "a", b.id = "b";
       a.children = {"b", "c"}, b.children = {"a", "d"};
       p.nodes.insert(p.nodes.end(), {a, b, leaf_node("c", "snacks"), leaf_node("d", "dairy")});
     },
     "plan.cyclic_tree",
     "/nodes"},
    {"node_used_twice",
     [](plan::Plan& p) { p.nodes[2].children[1] = "west"; },
     "plan.overlapping_nodes",
     "/nodes/2/children/1"},
    {"zone_used_twice",
     [](plan::Plan& p) { p.nodes[4].zone = "snacks"; },
     "plan.overlapping_nodes",
     "/nodes/4/zone"},
    {"zone_in_no_leaf",
     [](plan::Plan& p) {
       p.zones.push_back(p.zones[1]);
       p.zones.back().id = "lost";
     },
     "plan.bad_tree",
     "/zones/3"},
    {"two_roots",
     [](plan::Plan& p) { p.nodes.push_back(leaf_node("stray", "dairy")); },
     "plan.bad_tree",
     "/nodes/5"},
    {"no_nodes", [](plan::Plan& p) { p.nodes.clear(); }, "plan.bad_tree", "/nodes"},
    {"inner_without_split",
     [](plan::Plan& p) { p.nodes[2].split.reset(); },
     "plan.bad_tree",
     "/nodes/2/split"},
    {"one_child",
     [](plan::Plan& p) { p.nodes[2].children.pop_back(); },
     "plan.bad_tree",
     "/nodes/2/children"},
    {"split_and_zone",
     [](plan::Plan& p) { p.nodes[2].zone = "dairy"; },
     "plan.bad_tree",
     "/nodes/2/zone"},
    {"neither_split_nor_zone",
     [](plan::Plan& p) { p.nodes[3].zone.reset(); },
     "plan.bad_tree",
     "/nodes/3"},
    {"leaf_with_ratio",
     [](plan::Plan& p) { p.nodes[3].ratio = 0.5; },
     "plan.bad_tree",
     "/nodes/3/ratio"},
    {"leaf_with_gap",
     [](plan::Plan& p) { p.nodes[3].gap_mm = 900; },
     "plan.bad_tree",
     "/nodes/3/gap_mm"},
    {"seven_cuts_deep", [](plan::Plan& p) { grow_deep(p, 7); }, "plan.too_deep", "/nodes/13"},
    {"no_room",
     [](plan::Plan& p) {
       p.nodes[2].gap_mm = 8000;
       p.nodes[2].ratio = 0.1;
     },
     "plan.bad_value",
     "/nodes/2/ratio"},
    {"gap_wider_than_the_shop",
     [](plan::Plan& p) {
       p.shell.depth_mm = 4000;
       p.nodes[0].gap_mm = 8000;
       p.shell.columns.clear();
     },
     "plan.bad_value",
     "/nodes/0/ratio"},
    {"opening_beyond_its_wall",
     [](plan::Plan& p) { p.shell.openings[0].center = 0.02; },
     "plan.bad_opening",
     "/shell/openings/0/center"},
    {"openings_overlap",
     [](plan::Plan& p) { p.shell.openings[1].center = 0.35; },
     "plan.bad_opening",
     "/shell/openings/1/center"},
    {"outline_crosses_itself",
     [](plan::Plan& p) {
       p.shell.outline_mm = PolygonMm{{0, 0}, {12000, 9000}, {12000, 0}, {0, 9000}};
     },
     "plan.bad_shell",
     "/shell/outline_mm/0"},
    {"outline_beyond_the_size",
     [](plan::Plan& p) {
       p.shell.outline_mm = PolygonMm{{0, 0}, {12001, 0}, {12001, 9000}, {0, 9000}};
     },
     "plan.bad_shell",
     "/shell/outline_mm/1"},
    {"outline_clockwise",
     [](plan::Plan& p) {
       p.shell.outline_mm = PolygonMm{{0, 0}, {0, 9000}, {12000, 9000}, {12000, 0}};
     },
     "plan.bad_shell",
     "/shell/outline_mm"},
    {"outline_too_small",
     [](plan::Plan& p) {
       p.shell.outline_mm = PolygonMm{{0, 0}, {3000, 0}, {3000, 3000}, {0, 3000}};
       p.shell.columns.clear();
     },
     "plan.bad_shell",
     "/shell/outline_mm"},
    {"outline_folds_back",
     [](plan::Plan& p) {
       p.shell.outline_mm = PolygonMm{{0, 0}, {12000, 0}, {6000, 0}, {6000, 9000}, {0, 9000}};
     },
     "plan.bad_shell",
     "/shell/outline_mm/0"},
    {"outline_of_three_corners",
     [](plan::Plan& p) {
       p.shell.outline_mm = PolygonMm{{0, 0}, {12000, 0}, {0, 9000}};
     },
     "plan.bad_shell",
     "/shell/outline_mm"},
    {"opening_where_the_outline_has_no_wall",
     [](plan::Plan& p) {
       p.shell.outline_mm =
           PolygonMm{{6000, 0}, {12000, 0}, {12000, 9000}, {0, 9000}, {0, 3000}, {6000, 3000}};
     },
     "plan.bad_opening",
     "/shell/openings/0/center"},
    {"column_outside",
     [](plan::Plan& p) { p.shell.columns[0].x_mm = 12100; },
     "plan.bad_shell",
     "/shell/columns/0"},
    {"column_outside_the_outline",
     [](plan::Plan& p) {
       p.shell.openings.clear();
       p.relations.pop_back();
       p.shell.outline_mm =
           PolygonMm{{0, 0}, {12000, 0}, {12000, 3000}, {5000, 3000}, {5000, 9000}, {0, 9000}};
     },
     "plan.bad_shell",
     "/shell/columns/0"},
    {"area_min_over_max",
     [](plan::Plan& p) {
       p.zones[1].area_m2 = {20, {}, 10};
     },
     "plan.bad_value",
     "/zones/1/area_m2/min"},
    {"area_target_over_max",
     [](plan::Plan& p) {
       p.zones[1].area_m2 = {5, 20, 10};
     },
     "plan.bad_value",
     "/zones/1/area_m2/target"},
    {"colour_without_hash",
     [](plan::Plan& p) { p.look.accent = "2e7d32"; },
     "plan.bad_value",
     "/look/accent"},
    {"colour_with_bad_digit",
     [](plan::Plan& p) { p.zones[1].fixture.color = "#12345g"; },
     "plan.bad_value",
     "/zones/1/fixture/color"},
    {"levels_beyond_the_kind",
     [](plan::Plan& p) { p.zones[1].fixture.levels = 10; },
     "plan.bad_value",
     "/zones/1/fixture/levels"},
    {"height_beyond_the_kind",
     [](plan::Plan& p) { p.zones[1].fixture.height_mm = 900; },
     "plan.bad_value",
     "/zones/1/fixture/height_mm"},
    {"higher_than_the_ceiling",
     [](plan::Plan& p) {
       p.shell.ceiling_mm = 2300;
       p.zones[1].fixture = {};
       p.zones[1].fixture.kind = "pillar";  // a gondola is never that high
       p.zones[1].fixture.height_mm = 2500;
     },
     "plan.bad_value",
     "/zones/1/fixture/height_mm"},
    {"levels_too_far_apart",
     [](plan::Plan& p) { p.zones[1].fixture.spacing_mm = 500; },
     "plan.bad_value",
     "/zones/1/fixture/spacing_mm"},
    {"unknown_fixture_beside",
     [](plan::Plan& p) { p.zones[1].also = {so_many("bins", 2)}; },
     "catalog.unknown_kind",
     "/zones/1/also/0/kind"},
    {"beside_its_own_kind",
     [](plan::Plan& p) { p.zones[1].also = {so_many("gondola", 2)}; },
     "plan.bad_value",
     "/zones/1/also/0/kind"},
    {"twice_beside",
     [](plan::Plan& p) {
       p.zones[1].also = {so_many("bin", 2), so_many("bin", 1)};
     },
     "plan.bad_value",
     "/zones/1/also/1/kind"},
    {"beside_without_a_count",
     [](plan::Plan& p) { p.zones[1].also = {so_many("bin", {})}; },
     "plan.bad_value",
     "/zones/1/also/0/count"},
    {"tills_beside_goods",
     [](plan::Plan& p) { p.zones[1].also = {so_many("checkout_lane", 1)}; },
     "plan.bad_value",
     "/zones/1/also/0/kind"},
    {"levels_of_one_beside",
     [](plan::Plan& p) {
       p.zones[1].also = {so_many("bin", 1)};
       p.zones[1].also->front().levels = 4;
     },
     "plan.bad_value",
     "/zones/1/also/0/levels"},
    {"more_runs_than_fixtures",
     [](plan::Plan& p) {
       p.zones[1].fixture.count = 2;
       p.zones[1].fixture.runs = 3;
     },
     "plan.bad_value",
     "/zones/1/fixture/runs"},
    {"equipment_of_unknown_kind",
     [](plan::Plan& p) {
       p.equipment = {{"gates", 1, {}}};
     },
     "catalog.unknown_kind",
     "/equipment/0/kind"},
    {"shelving_as_equipment",
     [](plan::Plan& p) {
       p.equipment = {{"gondola", 1, {}}};
     },
     "plan.bad_value",
     "/equipment/0/kind"},
    {"tills_as_equipment",
     [](plan::Plan& p) {
       p.equipment = {{"checkout_lane", 1, {}}};
     },
     "plan.bad_value",
     "/equipment/0/kind"},
    {"equipment_at_no_door",
     [](plan::Plan& p) {
       p.equipment = {{"gate", 1, "snacks"}};
     },
     "plan.unknown_reference",
     "/equipment/0/at"},
    {"equipment_named_twice",
     [](plan::Plan& p) {
       p.equipment = {{"gate", 1, {}}, {"gate", 0, {}}};
     },
     "plan.bad_value",
     "/equipment/1/kind"},
    {"facings_reversed",
     [](plan::Plan& p) {
       p.zones[1].stock.facings = {4, 2};
     },
     "plan.bad_value",
     "/zones/1/stock/facings"},
    {"relation_to_nothing",
     [](plan::Plan& p) { p.relations[0].b = "norht"; },
     "plan.unknown_reference",
     "/relations/0/b"},
    {"between_without_second",
     [](plan::Plan& p) { p.relations[1].c.reset(); },
     "plan.bad_value",
     "/relations/1/c"},
    {"near_with_second",
     [](plan::Plan& p) { p.relations[0].c = "snacks"; },
     "plan.bad_value",
     "/relations/0/c"},
    {"unknown_override_field",
     [](plan::Plan& p) { p.overrides[0].field_name = "level"; },
     "plan.unknown_reference",
     "/overrides/0/field"},
    {"override_is_no_number",
     [](plan::Plan& p) { p.overrides[0].value = "four"; },
     "plan.bad_value",
     "/overrides/0/value"},
    {"unknown_sku",
     [](plan::Plan& p) {
       p.placements.push_back({"no-such-sku", {1, 1, 0}, 0});
     },
     "catalog.unknown_sku",
     "/placements/0/sku"},
    {"placement_outside",
     [](plan::Plan& p) {
       p.placements.push_back({committed_catalog().products[0].sku, {13, 1, 0}, 0});
     },
     "plan.bad_value",
     "/placements/0/position_m"},
};

class PlanFaults : public testing::TestWithParam<Fault> {};

TEST_P(PlanFaults, IsFoundWhereItIs) {
  plan::Plan plan = valid_plan();
  GetParam().spoil(plan);
  const auto valid = plan::validate_plan(plan, "corner.json", committed_catalog());
  ASSERT_FALSE(valid.ok());
  EXPECT_EQ(valid.error().code, GetParam().code) << to_string(valid.error());
  EXPECT_EQ(valid.error().where, std::string("corner.json:") + GetParam().where)
      << to_string(valid.error());
}

INSTANTIATE_TEST_SUITE_P(Table, PlanFaults, testing::ValuesIn(faults), [](const auto& fault) {
  return std::string(fault.param.name);
});

TEST(PlanValidation, NamesTheNearestName) {
  plan::Plan plan = valid_plan();
  plan.zones[1].fixture.kind = "gondla";
  EXPECT_NE(plan::validate_plan(plan, "p", committed_catalog()).error().message.find("gondola"),
            std::string::npos);
}

TEST(PlanValidation, SixCutsAreAllowed) {
  plan::Plan plan = valid_plan();
  grow_deep(plan, 6);
  EXPECT_TRUE(plan::validate_plan(plan, "p", committed_catalog()).ok());
}

// A store of 25 equal zones in a grid is one leaf too many; it has only five levels of cuts.
TEST(PlanValidation, TwentyFiveLeavesAreTooMany) {
  plan::Plan plan = valid_plan();
  plan.relations.clear();
  plan.overrides.clear();
  plan.shell.width_mm = plan.shell.depth_mm = 150000;
  plan.nodes.clear();
  const plan::Zone sample = plan.zones[1];
  plan.zones.clear();
  // A heap: node i has children 2i + 1 and 2i + 2; the last 25 of 49 nodes are leaves.
  constexpr int nodes = 49, first_leaf = 24;
  for (int i = 0; i < nodes; ++i) {
    plan::Node node;
    node.id = "n" + std::to_string(i);
    if (i < first_leaf) {
      node.split = i % 3 == 0 ? plan::Axis::x : plan::Axis::y;
      node.children = {"n" + std::to_string(2 * i + 1), "n" + std::to_string(2 * i + 2)};
    } else {
      // There are 24 zones at most: the last leaf names one again.
      const bool last = i + 1 == nodes;
      node.zone = "z" + std::to_string(last ? first_leaf : i);
      if (!last) plan.zones.push_back(sample);
      plan.zones.back().id = last ? plan.zones.back().id : *node.zone;
    }
    plan.nodes.push_back(node);
  }
  const auto valid = plan::validate_plan(plan, "p", committed_catalog());
  ASSERT_FALSE(valid.ok());
  EXPECT_EQ(valid.error().code, "plan.too_deep");
  EXPECT_NE(valid.error().message.find("25 leaves"), std::string::npos);
}

TEST(PlanReading, SchemaFaultsKeepTheirPlace) {
  const auto plan =
      plan::read_plan(R"({"schema": "market-plan/1", "shell": {"width_mm": 12000, "depth_mm": 9000},
    "nodes": [{"id": "a", "zone": "z"}], "zones": [{"id": "z", "type": "snacks", "fixture": {"tiers": 5}}]})",
                      "f.json",
                      committed_catalog());
  ASSERT_FALSE(plan.ok());
  EXPECT_EQ(plan.error().code, "json.unknown_field");
  EXPECT_EQ(plan.error().where, "f.json:/zones/0/fixture/tiers");
}

TEST(PlanReading, WrittenPlanReadsBackTheSame) {
  const plan::Plan plan = valid_plan();
  const std::string text = io::write_json(plan);
  const auto again = plan::read_plan(text, "again.json", committed_catalog());
  ASSERT_TRUE(again.ok()) << to_string(again.error());
  EXPECT_EQ(io::write_json(*again), text);
}

TEST(PlanReading, FindersFind) {
  const plan::Plan plan = valid_plan();
  EXPECT_EQ(plan::find_zone(plan, "dairy")->type, "dairy");
  EXPECT_EQ(plan::find_node(plan, "west")->zone, "snacks");
  EXPECT_EQ(plan::find_zone(plan, "nowhere"), nullptr);
}

// A planner's plan is held to the limits of its fields as a file is.
TEST(PlanValidation, LimitsHoldForPlansInMemory) {
  plan::Plan plan = valid_plan();
  plan.zones[1].fixture.aisle_mm = 300;
  const auto valid = plan::validate_plan(plan, "plan", committed_catalog());
  ASSERT_FALSE(valid.ok());
  EXPECT_EQ(valid.error().code, "json.out_of_range");
  EXPECT_EQ(valid.error().where, "plan:/zones/1/fixture/aisle_mm");
  EXPECT_EQ(valid.error().message, "300 is outside 600 to 8000");
  EXPECT_FALSE(plan::read_plan(io::write_json(plan), "plan", committed_catalog()).ok());
}

// Their pairs grow with the square of their number: five thousand million here.
TEST(PlanValidation, AHundredThousandProductsOnOneSpot) {
  plan::Plan plan = valid_plan();
  const std::string sku = committed_catalog().products.front().sku;
  plan.placements.assign(100'000, {sku, {6, 2, 0}, 0});
  const auto valid = plan::validate_plan(plan, "plan", committed_catalog());
  ASSERT_FALSE(valid.ok());
  EXPECT_EQ(valid.error().code, "plan.too_crowded");
  EXPECT_NE(valid.error().where.find("/placements/"), std::string::npos) << valid.error().where;
  EXPECT_NE(valid.error().message.find("spread them out"), std::string::npos);
}

TEST(PlanValidation, ManyProductsBesideOneAnother) {
  plan::Plan plan = valid_plan();
  const catalog::Product& product = committed_catalog().products.front();
  const double pitch = 0.001 + std::max(product.width_m(), product.depth_m());
  for (int i = 0; i < 20'000; ++i)
    plan.placements.push_back({product.sku,
                               {0.5 + pitch * (i % 50),
                                0.5 + pitch * (i / 50 % 40),
                                (product.height_m() + 0.001) * (i / 2000)},
                               i % 2 == 0 ? 0.0 : 180.0});
  plan.shell.width_mm = plan.shell.depth_mm = 60'000;
  plan.shell.ceiling_mm = 12'000;
  const auto valid = plan::validate_plan(plan, "plan", committed_catalog());
  EXPECT_TRUE(valid.ok()) << to_string(valid.error());
}

}  // namespace
}  // namespace marketgen
