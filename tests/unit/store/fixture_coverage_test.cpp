// Everything the catalogue has stands somewhere: accessories without being asked for, the rest
// where a plan names it.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "layout/accessories.h"
#include "layout/in_line.h"
#include "layout/makes.h"
#include "store/design.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

// Rows that no layout places, and why.
const std::map<std::string_view, std::string_view> not_placed{
    {"sliding_door", "the room's openings are built as doors: render and physics"},
    {"swing_door", "the room's openings are built as doors: render and physics"},
    {"ceiling_light", "the room's lamps are built from the look: Look::lamps"},
    {"hanging_sign", "the room's signs are built from the zones' labels"},
    {"pillar", "columns are the shell's: Shell::columns"}};

// Accessories that these stores have no spot for or did not draw;
// EveryOtherRowStandsWhereAPlanNamesIt has their kinds.
const std::set<std::string_view> drawn_elsewhere{"medicine_drawers",
                                                 "bottle_return",
                                                 "rolling_baskets",
                                                 "bags_lockers",
                                                 "ham_slicer",
                                                 "vending"};

// Makes and units in line that none of these stores has drawn.
const std::set<std::string_view> not_drawn{"wall-unit-paper",
                                           "multideck-slim",
                                           "freezer-three-door",
                                           "freezer-us-5-door",
                                           "combi-freezer",
                                           "combi-freezer-us",
                                           "chest_freezer",
                                           "chest-freezer-compact",
                                           "serve-over-pastry",
                                           "pallet-us",
                                           "checkout-4000",
                                           "checkout-us",
                                           "self-checkout-wide",
                                           "gate-double"};

// Units that find no free wall beside the only door of plan_with's room, which is short of it.
const std::set<std::string_view> no_spot_at_this_door{"salad-bar",
                                                      "salad-bar-steel",
                                                      "gate-double",
                                                      "gate-black",
                                                      "basket-trolley",
                                                      "basket-trolley-blue",
                                                      "atm",
                                                      "scales-wood",
                                                      "a-board",
                                                      "a-board-steel",
                                                      "a-board-wet-floor",
                                                      "bread-slicer",
                                                      "orange-juicer",
                                                      "antenna-gate-black"};

const std::vector<std::string> varied_stores{
    "a supermarket of 24 x 15 m with produce, bakery, dairy and frozen food",
    "organic market 24 x 18 m with a back room, lots of fruit and vegetables",
    "discounter 30 x 20 m",
    "US supermarket 36 x 24 m with a deli and a stockroom",
    "Chinese supermarket 36 x 24 m",
    "a pharmacy of 140 m2 with customer service",
    "forecourt shop 14 x 10 m with a cafe",
    "cash and carry 48 x 32 m with a stockroom",
    "a supermarket of 600 m2 with self-checkout, wine and cheese, bakery, flowers",
    "a 1000 m2 supermarket with a large produce area, deli, bakery, drinks and household",
    "European hypermarket 50 x 40 m with cafe, customer service and a backroom",
    "supermarket 18 x 12 m with wide aisles",
    "a supermarket 20 x 30 m with offers, self-checkouts and customer service",
    "a kiosk of 60 m2",
    "Chinese convenience store 14 x 10 m with frozen food and chilled drinks",
    "US convenience store 16 x 12 m with frozen food and chilled drinks",
    "a shop without tills of 20 x 14 m with a deli"};

struct MadeStores {
  std::vector<plan::Plan> plans;
  std::vector<layout::Layout> layouts;
};

MadeStores make_stores() {
  MadeStores made;
  std::uint64_t seed = 0;
  for (const std::string& prompt : varied_stores) {
    intake::Brief brief;
    brief.prompt = prompt;
    auto store = store::design_store(brief, committed_catalog(), Seed(++seed));
    EXPECT_TRUE(store.ok()) << prompt;
    if (!store.ok()) continue;
    made.plans.push_back(std::move(store->repaired.plan));
    made.layouts.push_back(std::move(store->layout));
  }
  return made;
}

const MadeStores& stores() {
  static const MadeStores made = make_stores();
  return made;
}

// What stands in these stores' plans with several seeds, accessories apart.
std::set<std::string> kinds_drawn() {
  constexpr std::uint64_t seeds = 12;
  std::set<std::string> kinds;
  for (const plan::Plan& plan : stores().plans) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const auto made = layout::make_layout(plan, committed_catalog(), Seed(seed));
      EXPECT_TRUE(made.ok()) << plan.name;
      if (!made.ok()) continue;
      for (const layout::Fixture& fixture : made->fixtures)
        if (fixture.run.find("/with/") == std::string::npos) kinds.insert(fixture.kind);
    }
  }
  return kinds;
}

// A room with tills and one zone of everything but the kind asked for: shelving is its zone's,
// tills are the tills', equipment stands at the door.
plan::Plan plan_with(const catalog::FixtureKind& kind) {
  plan::Plan plan;
  plan.profile = "supermarket-eu";
  plan.shell.width_mm = 20000;
  plan.shell.depth_mm = 16000;
  plan.shell.openings = {{"entrance", plan::OpeningKind::entrance, plan::Wall::south, 0.5, 2000}};
  plan::Node root, front, back;
  root.id = "root";
  root.split = plan::Axis::y;
  root.ratio = 0.4;
  root.gap_mm = 2400;
  root.children = {"front", "back"};
  front.id = "front";
  front.zone = "tills";
  back.id = "back";
  back.zone = "goods";
  plan.nodes = {root, front, back};
  plan::Zone tills, goods;
  tills.id = "tills";
  tills.type = "checkout";
  tills.fixture.kind = kind.role == catalog::FixtureRole::checkout ? kind.kind : "till-counter";
  goods.id = "goods";
  goods.type = kind.temperature == catalog::Storage::frozen    ? "frozen"
               : kind.temperature == catalog::Storage::chilled ? "dairy"
                                                               : "dry_goods";
  if (kind.role == catalog::FixtureRole::shelving) goods.fixture.kind = kind.kind;
  plan.zones = {tills, goods};
  if (kind.role == catalog::FixtureRole::equipment) {
    plan.equipment = {{kind.kind, 1, std::nullopt}};
    for (const char* usual : {"trolley_bay", "basket_stack", "gate"})  // leave it the room
      if (kind.kind != usual) plan.equipment->push_back({usual, 0, std::nullopt});
  }
  return plan;
}

bool has(const layout::Layout& layout, std::string_view kind) {
  return std::ranges::find(layout.fixtures, kind, &layout::Fixture::kind) != layout.fixtures.end();
}

TEST(FixtureCoverage, EveryAccessoryStandsInSomeStoreUnasked) {
  std::set<std::string> rows;
  for (const layout::Layout& store : stores().layouts) {
    for (const layout::Fixture& fixture : store.fixtures) {
      const std::size_t at = fixture.run.find("/with/");
      if (at == std::string::npos) continue;
      const std::string name = fixture.run.substr(at + 6);
      rows.insert(name.substr(0, name.rfind('-')));
    }
    for (const layout::Violation& fault : store.violations)
      EXPECT_EQ(fault.severity, layout::Severity::soft) << fault.code << ": " << fault.message;
  }
  for (const layout::AccessoryRow& row : layout::accessory_rows())
    EXPECT_NE(rows.contains(std::string(row.id)), drawn_elsewhere.contains(row.id)) << row.id;
}

TEST(FixtureCoverage, EveryMakeAndUnitInLineStandsInSomeStore) {
  const std::set<std::string> kinds = kinds_drawn();
  const auto stands = [&](std::string_view kind) { return kinds.contains(std::string(kind)); };
  for (const layout::MakeRow& row : layout::make_rows())
    EXPECT_NE(stands(row.kind), not_drawn.contains(row.kind)) << row.kind;
  for (const layout::InLineRow& row : layout::in_line_rows())
    EXPECT_NE(stands(row.kind), not_drawn.contains(row.kind)) << row.kind;
}

TEST(FixtureCoverage, EveryOtherRowStandsWhereAPlanNamesIt) {
  for (const catalog::FixtureKind& kind : committed_catalog().fixture_kinds) {
    if (not_placed.contains(kind.generator)) continue;
    if (kind.mount != catalog::FixtureMount::floor) continue;  // accessories, all of them
    const auto made = layout::make_layout(plan_with(kind), committed_catalog(), Seed(1));
    ASSERT_TRUE(made.ok()) << kind.kind << ": " << to_string(made.error());
    EXPECT_TRUE(has(*made, kind.kind) || no_spot_at_this_door.contains(kind.kind)) << kind.kind;
  }
}

TEST(FixtureCoverage, WhatTheWallCarriesIsAnAccessory) {
  for (const catalog::FixtureKind& kind : committed_catalog().fixture_kinds) {
    if (kind.mount != catalog::FixtureMount::wall || not_placed.contains(kind.generator)) continue;
    const bool named =
        std::ranges::any_of(layout::accessory_rows(), [&](const layout::AccessoryRow& row) {
          return std::ranges::find(row.kinds, std::string_view(kind.kind)) != row.kinds.end();
        });
    EXPECT_TRUE(named) << kind.kind;
  }
}

TEST(FixtureCoverage, RowsNameWhatTheCatalogueHas) {
  const catalog::Catalog& catalog = committed_catalog();
  for (const layout::AccessoryRow& row : layout::accessory_rows()) {
    for (const std::string_view kind : row.kinds)
      EXPECT_NE(catalog.fixture_kind(kind), nullptr) << row.id << ": " << kind;
    for (const std::string_view zone : row.zones)
      EXPECT_NE(catalog.zone_type(zone), nullptr) << row.id << ": " << zone;
    for (const std::string_view profile : row.profiles)
      EXPECT_NE(catalog.profile(profile), nullptr) << row.id << ": " << profile;
    EXPECT_FALSE(row.places.empty()) << row.id;
    EXPECT_EQ(row.at_door(), row.zones.empty()) << row.id;
    EXPECT_FALSE(row.source.empty()) << row.id;
  }
}

}  // namespace
}  // namespace marketgen
