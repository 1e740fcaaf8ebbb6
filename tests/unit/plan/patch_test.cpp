// market-patch/1: every operation of the list does what it says and nothing else, can be undone,
// and is refused with the place where its example is wrong.
#include "plan/patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>

#include "io/json.h"
#include "plan/bsp.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

constexpr const char* sample_text = R"({
  "schema": "market-plan/1", "name": "Corner", "profile": "supermarket-eu",
  "shell": {"width_mm": 20000, "depth_mm": 15000,
    "openings": [{"id": "entrance", "kind": "entrance", "wall": "south", "center": 0.25, "width_mm": 2000},
                 {"id": "exit", "kind": "exit", "wall": "south", "center": 0.75, "width_mm": 2000}]},
  "nodes": [{"id": "root", "split": "y", "ratio": 0.4, "gap_mm": 2000, "children": ["front", "back"]},
            {"id": "front", "zone": "tills"},
            {"id": "back", "split": "x", "ratio": 0.5, "gap_mm": 1800, "children": ["west", "east"]},
            {"id": "west", "zone": "snacks"}, {"id": "east", "zone": "dairy"}],
  "zones": [{"id": "tills", "type": "checkout", "fixture": {"kind": "checkout_lane", "count": 2}},
            {"id": "snacks", "type": "snacks",
             "fixture": {"kind": "gondola", "levels": 5, "height_mm": 1800}},
            {"id": "dairy", "type": "dairy", "fixture": {"kind": "multideck"}, "stock": {"fill": 0.9}}],
  "relations": [{"kind": "near", "a": "dairy", "b": "north"}],
  "overrides": [{"fixture": "snacks/run-1/module-1", "field": "levels", "value": "4"}]
})";

plan::Plan sample() {
  auto plan = plan::read_plan(sample_text, "corner.json", committed_catalog());
  if (!plan.ok()) fatal(to_string(plan.error()).c_str());
  return std::move(plan).value();
}

Result<plan::Plan> after(const plan::Plan& plan, const std::string& patches) {
  const auto set =
      plan::read_patches(R"({"schema": "market-patch/1", "patches": [)" + patches + "]}", "p.json");
  if (!set.ok()) return set.error();
  return plan::apply_patches(plan, *set, "p.json", plan::Source::flag, committed_catalog());
}

// A plan apart from where its values come from.
std::string told(plan::Plan plan) {
  plan.provenance.clear();
  return io::write_json(plan);
}

// What a zone is, wherever it lies; rows may stand in another order after an inverse.
std::map<std::string, std::array<int, 4>> floors(const plan::Plan& plan) {
  std::map<std::string, std::array<int, 4>> floors;
  const std::vector<RectMm> rects = plan::zone_rectangles(plan);
  for (std::size_t i = 0; i < rects.size(); ++i)
    floors[plan.zones[i].id] = {rects[i].x0, rects[i].y0, rects[i].x1, rects[i].y1};
  return floors;
}

const plan::Zone& zone(const plan::Plan& plan, std::string_view id) {
  static const plan::Zone none;  // has nothing of what the examples set
  const plan::Zone* found = plan::find_zone(plan, id);
  return found != nullptr ? *found : none;
}

struct Example {
  const char* operation;
  const char* patch;
  std::function<bool(const plan::Plan&)> done;
  const char* inverse;  // gives the sample's values back
  const char* faulty;   // refused
  const char* code;
  const char* where;  // below /patches/0
};

const std::vector<Example>& examples() {
  static const std::vector<Example> all = {
      {"set_ratio",
       R"({"set_ratio": {"node": "root", "ratio": 0.5}})",
       [](const plan::Plan& p) { return plan::find_node(p, "root")->ratio == 0.5; },
       R"({"set_ratio": {"node": "root", "ratio": 0.4}})",
       R"({"set_ratio": {"node": "root", "ratio": 1.5}})",
       "json.out_of_range",
       "/set_ratio/ratio"},
      {"set_axis",
       R"({"set_axis": {"node": "back", "split": "y"}})",
       [](const plan::Plan& p) { return plan::find_node(p, "back")->split == plan::Axis::y; },
       R"({"set_axis": {"node": "back", "split": "x"}})",
       R"({"set_axis": {"node": "west", "split": "y"}})",
       "plan.bad_value",
       "/set_axis/node"},
      {"set_gap",
       R"({"set_gap": {"node": "back", "gap_mm": 2400}})",
       [](const plan::Plan& p) { return plan::find_node(p, "back")->gap_mm == 2400; },
       R"({"set_gap": {"node": "back", "gap_mm": 1800}})",
       R"({"set_gap": {"node": "bakc", "gap_mm": 2400}})",
       "plan.unknown_reference",
       "/set_gap/node"},
      {"swap_leaves",
       R"({"swap_leaves": {"a": "snacks", "b": "dairy"}})",
       [](const plan::Plan& p) { return plan::find_node(p, "west")->zone == "dairy"; },
       R"({"swap_leaves": {"a": "dairy", "b": "snacks"}})",
       R"({"swap_leaves": {"a": "snaks", "b": "dairy"}})",
       "plan.unknown_reference",
       "/swap_leaves/a"},
      {"move_leaf",
       R"({"move_leaf": {"zone": "dairy", "beside": "snacks", "side": "west", "share": 0.5}})",
       [](const plan::Plan& p) { return floors(p)["dairy"][0] == 0; },
       R"({"move_leaf": {"zone": "dairy", "beside": "snacks", "side": "east", "share": 0.5}})",
       R"({"move_leaf": {"zone": "dairy", "beside": "dairy", "side": "west"}})",
       "plan.bad_value",
       "/move_leaf/beside"},
      {"split_leaf",
       R"({"split_leaf": {"zone": "snacks", "part": "sweets", "side": "north", "gap_mm": 1500}})",
       [](const plan::Plan& p) { return zone(p, "sweets").type == "snacks"; },
       R"({"merge": {"zone": "sweets", "into": "snacks"}})",
       R"({"split_leaf": {"zone": "snacks", "part": "dairy", "side": "north"}})",
       "plan.duplicate_id",
       "/split_leaf"},
      {"merge",
       R"({"merge": {"zone": "dairy", "into": "snacks"}})",
       [](const plan::Plan& p) { return p.zones.size() == 2 && floors(p)["snacks"][2] == 20000; },
       nullptr,
       R"({"merge": {"zone": "tills", "into": "snacks"}})",
       "plan.bad_value",
       "/merge/into"},
      {"add_zone",
       R"({"add_zone": {"zone": {"id": "wine", "type": "alcohol"}, "beside": "snacks", "side": "south",
           "share": 0.4}})",
       [](const plan::Plan& p) { return floors(p)["wine"][1] == floors(p)["dairy"][1]; },
       R"({"drop_zone": {"zone": "wine"}})",
       R"({"add_zone": {"zone": {"id": "wine", "type": "wein"}, "beside": "snacks", "side": "south"}})",
       "catalog.unknown_kind",
       "/add_zone"},
      {"drop_zone",
       R"({"drop_zone": {"zone": "snacks"}})",
       [](const plan::Plan& p) { return p.zones.size() == 2 && p.overrides.empty(); },
       nullptr,
       R"({"drop_zone": {"zone": "bakery"}})",
       "plan.unknown_reference",
       "/drop_zone/zone"},
      {"set_fixture",
       R"({"set_fixture": {"zone": "snacks", "levels": 4, "aisle_mm": 1900}})",
       [](const plan::Plan& p) { return zone(p, "snacks").fixture.aisle_mm == 1900; },
       R"({"set_fixture": {"zone": "snacks", "levels": 5, "usual": ["aisle_mm"]}})",
       R"({"set_fixture": {"zone": "snacks", "levels": 10}})",
       "plan.bad_value",
       "/set_fixture/levels"},
      {"set_stock",
       R"({"set_stock": {"zone": "dairy", "fill": 0.5, "exclude": ["butter"]}})",
       [](const plan::Plan& p) { return zone(p, "dairy").stock.exclude.size() == 1; },
       R"({"set_stock": {"zone": "dairy", "fill": 0.9, "usual": ["exclude"]}})",
       R"({"set_stock": {"zone": "dairy", "categories": ["nothing at all"]}})",
       "catalog.unknown_kind",
       "/set_stock"},
      {"move_opening",
       R"({"move_opening": {"opening": "exit", "wall": "east", "center": 0.2}})",
       [](const plan::Plan& p) { return p.shell.openings[1].wall == plan::Wall::east; },
       R"({"move_opening": {"opening": "exit", "wall": "south", "center": 0.75}})",
       R"({"move_opening": {"opening": "exit", "center": 0.99}})",
       "plan.bad_opening",
       "/move_opening/center"},
      {"add_opening",
       R"({"add_opening": {"opening": {"id": "back", "kind": "emergency", "wall": "north", "width_mm": 1200}}})",
       [](const plan::Plan& p) {
         return p.shell.openings.size() == 3 && p.shell.openings.back().id == "back";
       },
       nullptr,
       R"({"add_opening": {"opening": {"id": "exit", "kind": "emergency", "wall": "north"}}})",
       "plan.duplicate_id",
       "/add_opening/opening/id"},
      {"set_look",
       R"({"set_look": {"light_kelvin": 3000, "neon": true}})",
       [](const plan::Plan& p) { return p.look.light_kelvin == 3000 && p.look.neon == true; },
       R"({"set_look": {"usual": ["light_kelvin", "neon"]}})",
       R"({"set_look": {"floor": "concret"}})",
       "catalog.unknown_kind",
       "/set_look/floor"},
      {"set_shell",
       R"({"set_shell": {"ceiling_mm": 4500}})",
       [](const plan::Plan& p) { return p.shell.ceiling_mm == 4500; },
       R"({"set_shell": {"usual": ["ceiling_mm"]}})",
       R"({"set_shell": {"ceiling_mm": 900}})",
       "json.out_of_range",
       "/set_shell/ceiling_mm"},
      {"set_time",
       R"({"set_time": {"time": "Sat 17:30"}})",
       [](const plan::Plan& p) { return p.time == "Sat 17:30"; },
       R"({"set_time": {}})",
       R"({"set_time": {"time": "at dawn"}})",
       "plan.bad_value",
       "/set_time/time"},
      {"set_relation",
       R"({"set_relation": {"kind": "near", "a": "snacks", "b": "entrance", "strength": "must"}})",
       [](const plan::Plan& p) { return p.relations.size() == 2; },
       R"({"set_relation": {"kind": "near", "a": "snacks", "b": "entrance", "drop": true}})",
       R"({"set_relation": {"kind": "near", "a": "snacks", "b": "the moon"}})",
       "json.bad_identifier",
       "/set_relation/b"},
      {"set_override",
       R"({"set_override": {"fixture": "snacks/run-1/module-1", "field": "levels", "value": "6"}})",
       [](const plan::Plan& p) { return p.overrides.at(0).value == "6"; },
       R"({"set_override": {"fixture": "snacks/run-1/module-1", "field": "levels", "value": "4"}})",
       R"({"set_override": {"fixture": "snacks/run-1/module-1", "field": "weight", "value": "4"}})",
       "plan.unknown_reference",
       "/set_override/field"},
      {"stock_shelves",
       R"({"stock_shelves": {"shelves": [{"fixture": "snacks/run-1/module-1", "shelf": 2, "blocks": []}]}})",
       [](const plan::Plan& p) { return p.planogram && p.planogram->at(0).shelf == 2; },
       R"({"stock_shelves": {"shelves": [{"fixture": "snacks/run-1/module-1", "shelf": 2}]}})",
       R"({"stock_shelves": {"shelves": [{"fixture": "snacks/run-1/module-1", "shelf": 2, "blocks": [{"sku": "no-such", "facings": 1}]}]}})",
       "catalog.unknown_sku",
       "/stock_shelves"},
      {"swap_blocks",
       R"({"stock_shelves": {"shelves": [{"fixture": "snacks/run-1/module-1", "shelf": 2, "blocks": [
           {"sku": "canned-sweetcorn-crisp-340g", "facings": 2}, {"sku": "dairy-fresh-milk-1-5-fat-1l", "facings": 3}]}]}},
         {"swap_blocks": {"a": {"fixture": "snacks/run-1/module-1", "shelf": 2, "position": 1},
           "b": {"fixture": "snacks/run-1/module-1", "shelf": 2, "position": 2, "sku": "dairy-fresh-milk-1-5-fat-1l"}}})",
       [](const plan::Plan& p) {
         return p.planogram &&
                p.planogram->at(0).blocks.at(0).sku == "dairy-fresh-milk-1-5-fat-1l" &&
                p.planogram->at(0).blocks.at(0).facings == 3;
       },
       R"({"stock_shelves": {"shelves": [{"fixture": "snacks/run-1/module-1", "shelf": 2}]}})",
       R"({"swap_blocks": {"a": {"fixture": "snacks/run-1/module-1", "shelf": 2, "position": 1},
           "b": {"fixture": "snacks/run-1/module-1", "shelf": 2, "position": 2}}})",
       "plan.unknown_reference",
       "/swap_blocks/a"},
  };
  return all;
}

TEST(Patches, EveryOperationHasAnExample) {
  std::vector<std::string> listed, shown;
#define PLAN_PATCH(name, Type, what) listed.emplace_back(#name);
#include "plan/patches.inc"
#undef PLAN_PATCH
  for (const Example& example : examples())
    shown.emplace_back(example.operation);
  EXPECT_EQ(shown, listed);
}

TEST(Patches, DoWhatTheySayAndTellWhatTheyChanged) {
  for (const Example& example : examples()) {
    const auto plan = after(sample(), example.patch);
    ASSERT_TRUE(plan.ok()) << example.operation << ": " << to_string(plan.error());
    EXPECT_FALSE(example.done(sample())) << example.operation;
    EXPECT_TRUE(example.done(*plan)) << example.operation;
    ASSERT_FALSE(plan->provenance.empty()) << example.operation;
    EXPECT_EQ(plan->provenance.back().source, plan::Source::flag) << example.operation;
  }
}

TEST(Patches, CanBeTakenBack) {  // to the same values and the same floor, millimetre for millimetre
  for (const Example& example : examples()) {
    if (example.inverse == nullptr) continue;
    const auto plan = after(sample(), std::string(example.patch));
    ASSERT_TRUE(plan.ok()) << example.operation;
    const auto back = after(*plan, example.inverse);
    ASSERT_TRUE(back.ok()) << example.operation << ": " << to_string(back.error());
    EXPECT_EQ(floors(*back), floors(sample())) << example.operation;
    plan::Plan rows = *back;  // the tree may have its rows in another order
    rows.nodes = sample().nodes;
    EXPECT_EQ(told(rows), told(sample())) << example.operation;
  }
}

TEST(Patches, FaultyOnesNameTheirPlace) {
  for (const Example& example : examples()) {
    const auto plan = after(sample(), example.faulty);
    ASSERT_FALSE(plan.ok()) << example.operation;
    EXPECT_EQ(plan.error().code, example.code) << to_string(plan.error());
    EXPECT_EQ(plan.error().where, "p.json:/patches/0" + std::string(example.where))
        << to_string(plan.error());
  }
}

// Three blocks on shelf 2 and one on shelf 3, then the patch.
Result<plan::Plan> swapped(const std::string& a, const std::string& b, const std::string& x = "") {
  const std::string block =
      R"({"sku": "canned-sweetcorn-crisp-340g", "facings": 2)" + x +
      R"(}, {"sku": "dairy-fresh-milk-1-5-fat-1l", "facings": 3, "facings_high": 1)" + x +
      R"(}, {"sku": "canned-sweetcorn-crisp-340g", "facings": 2)" + x + "}";
  const std::string fixture = R"({"fixture": "snacks/run-1/module-1", "shelf": )";
  return after(sample(),
               R"({"stock_shelves": {"shelves": [)" + fixture + R"(2, "blocks": [)" + block +
                   "]}, " + fixture +
                   R"(3, "blocks": [{"sku": "dairy-fresh-milk-1-5-fat-1l", "facings": 1}]}]}},)" +
                   R"({"swap_blocks": {"a": )" + fixture + a + R"(}, "b": )" + fixture + b + "}}}");
}

TEST(SwapBlocks, TakesWithABlockWhatFitsItsNewShelf) {
  const auto same = swapped(R"(2, "position": 1)", R"(2, "position": 2)", R"(, "x_mm": 7)");
  ASSERT_TRUE(same.ok()) << to_string(same.error());
  const std::vector<plan::ShelfBlock>& shelf = same->planogram->at(0).blocks;
  EXPECT_EQ(shelf[0].facings_high, 1) << "what was said of it goes with it";
  EXPECT_FALSE(shelf[0].x_mm || shelf[2].x_mm) << "the two are not as wide: all are spread";

  const auto other = swapped(R"(2, "position": 2)", R"(3, "position": 1, "facings": 2)");
  ASSERT_TRUE(other.ok()) << to_string(other.error());
  const plan::ShelfBlock& below = other->planogram->at(0).blocks[1];
  const plan::ShelfBlock& above = other->planogram->at(1).blocks[0];
  EXPECT_EQ(below.facings, 2) << "as said of b";
  EXPECT_EQ(above.facings, 3);
  EXPECT_FALSE(above.facings_high) << "another shelf has other room";

  const auto alike = swapped(R"(2, "position": 1)", R"(2, "position": 3)", R"(, "x_mm": 7)");
  ASSERT_TRUE(alike.ok()) << to_string(alike.error());
  EXPECT_EQ(alike->planogram->at(0).blocks[2].x_mm, 7) << "places go with the shelf";
}

TEST(SwapBlocks, SaysWhichBlockIsNotThere) {
  const auto beyond = swapped(R"(2, "position": 4)", R"(2, "position": 2)");
  ASSERT_FALSE(beyond.ok());
  EXPECT_EQ(
      to_string(beyond.error()),
      "error[plan.unknown_reference] p.json:/patches/1/swap_blocks/a/position: the shelf has 3 "
      "blocks; count them from the left");
  const auto another =
      swapped(R"(2, "position": 1)", R"(2, "position": 2, "sku": "dairy-oat-drink-barista-1l")");
  ASSERT_FALSE(another.ok());
  EXPECT_EQ(another.error().where, "p.json:/patches/1/swap_blocks/b/sku");
  EXPECT_NE(another.error().message.find("\"dairy-fresh-milk-1-5-fat-1l\" stands there"),
            std::string::npos);
  const auto itself = swapped(R"(2, "position": 1)", R"(2, "position": 1)");
  ASSERT_FALSE(itself.ok());
  EXPECT_EQ(itself.error().code, "plan.bad_value");
}

TEST(Patches, UnknownNamesAreAnsweredWithTheNearest) {
  const auto zone = after(sample(), R"({"drop_zone": {"zone": "snaks"}})");
  ASSERT_FALSE(zone.ok());
  EXPECT_NE(zone.error().message.find("did you mean \"snacks\""), std::string::npos)
      << zone.error().message;
  const auto operation = after(sample(), R"({"set_rato": {"node": "root", "ratio": 0.5}})");
  ASSERT_FALSE(operation.ok());
  EXPECT_EQ(operation.error().code, "json.unknown_field");
  EXPECT_NE(operation.error().message.find("did you mean \"set_ratio\""), std::string::npos)
      << operation.error().message;
}

TEST(Patches, HaveOneOperationEach) {
  const auto none = after(sample(), "{}");
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().where, "p.json:/patches/0");
  const auto two = after(
      sample(), R"({"drop_zone": {"zone": "dairy"}, "set_gap": {"node": "root", "gap_mm": 2000}})");
  ASSERT_FALSE(two.ok());
  EXPECT_EQ(two.error().code, "plan.bad_value");
}

TEST(Patches, ThatContradictEachOtherAreRefused) {
  const auto both = after(sample(),
                          R"({"set_fixture": {"zone": "snacks", "levels": 4}},
                             {"set_fixture": {"zone": "snacks", "levels": 6}})");
  ASSERT_FALSE(both.ok());
  EXPECT_EQ(both.error().where, "p.json:/patches/1/set_fixture/levels");
  EXPECT_NE(both.error().message.find("/patches/0"), std::string::npos) << both.error().message;
  EXPECT_TRUE(after(sample(),
                    R"({"set_fixture": {"zone": "snacks", "levels": 4}},
                       {"set_fixture": {"zone": "snacks", "levels": 4, "endcaps": "front"}})")
                  .ok());
  const auto gone = after(sample(),
                          R"({"drop_zone": {"zone": "dairy"}},
                             {"set_stock": {"zone": "dairy", "fill": 0.5}})");
  ASSERT_FALSE(gone.ok());
  EXPECT_NE(gone.error().message.find("taken away"), std::string::npos) << gone.error().message;
}

TEST(Patches, AZoneThatMovesLeavesItsFloorToTheOther) {
  const auto plan =
      after(sample(), R"({"move_leaf": {"zone": "dairy", "beside": "tills", "side": "east"}})");
  ASSERT_TRUE(plan.ok()) << to_string(plan.error());
  const auto floor = floors(*plan);
  EXPECT_EQ(floor.at("snacks"), (std::array<int, 4>{0, 7200, 20000, 15000}));
  EXPECT_EQ(floor.at("dairy")[2], 20000);
  EXPECT_EQ(floor.at("dairy")[1], 0);
}

TEST(Patches, ValuesThatAFieldListHasNotAreNamed) {
  const auto plan = after(sample(), R"({"set_fixture": {"zone": "snacks", "usual": ["levls"]}})");
  ASSERT_FALSE(plan.ok());
  EXPECT_EQ(plan.error().where, "p.json:/patches/0/set_fixture/usual/0");
}

TEST(Patches, HaveTheirMeaningsAndLimitsFromThePlan) {  // so that schema and docs say them
  for (const FieldInfo& operation : type_of<plan::Patch>().fields) {
    for (const FieldInfo& field : operation.type().element().fields)
      EXPECT_FALSE(field.doc.empty()) << operation.name << "/" << field.name;
  }
}

}  // namespace
}  // namespace marketgen
