// For every rule of layout_rules.inc one hand-made layout that breaks it and one that does not.
#include "layout/layout_rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "plan/bsp.h"
#include "sample_shop.h"

namespace marketgen {
namespace {

// A room of 20 x 12 m with an entrance in the south-west and an exit in the south-east, one shelf
// against the north wall, and a till before the exit: breaks nothing. Cases change it.
struct Shop {
  plan::Plan plan;
  layout::Layout layout;
};

void put(Shop& shop, layout::Fixture fixture) {
  shop.layout.fixtures.push_back(std::move(fixture));
}

void add_zone(Shop& shop,
              const std::string& id,
              const std::string& type,
              const std::string& kind,
              RectMm rect) {
  shop.plan.zones.push_back(sample::zone(id, type, kind));
  shop.layout.zones.push_back(sample::layout_zone(id, type, rect));
}

Shop sound_shop() {
  Shop shop;
  shop.plan.profile = "test";
  shop.plan.shell.width_mm = 20000;
  shop.plan.shell.depth_mm = 12000;
  shop.plan.shell.openings = {
      sample::door("entrance", plan::OpeningKind::entrance, plan::Wall::south, 0.2),
      sample::door("exit", plan::OpeningKind::exit, plan::Wall::south, 0.8)};
  add_zone(shop, "goods", "dry_goods", "gondola", {0, 9000, 20000, 12000});
  add_zone(shop, "tills", "checkout", "checkout_lane", {12000, 0, 20000, 6000});
  put(shop,
      sample::fixture("goods/run-1/module-1", "wall_unit", "goods", 8000, 11730, 0, 1000, 500));
  put(shop,
      sample::fixture(
          "tills/run-1/module-1", "checkout_lane", "tills", 16000, 4000, 0, 1100, 2400));
  return shop;
}

layout::Aisle aisle(layout::AisleKind kind, RectMm rect, int width) {
  return {"goods/run-1/aisle-south", kind, polygon_of(rect), width};
}

Shop with_one_door(int depth_mm) {
  Shop shop = sound_shop();
  shop.plan.shell.depth_mm = depth_mm;
  shop.plan.shell.openings.pop_back();
  return shop;
}

Shop with_doors_of(int width_mm) {
  Shop shop = sound_shop();
  for (plan::Opening& door : shop.plan.shell.openings)
    door.width_mm = width_mm;
  return shop;
}

Shop with_aisle(layout::AisleKind kind, RectMm rect, int width) {
  Shop shop = sound_shop();
  shop.layout.aisles = {aisle(kind, rect, width)};
  return shop;
}

// An aisle 1.6 m wide and `length` deep between two blocks against the north wall: shut at the
// north.
Shop with_blind_alley(int length) {
  Shop shop = sound_shop();
  shop.layout.fixtures.erase(shop.layout.fixtures.begin());
  const int y = 12000 - length / 2;
  put(shop, sample::fixture("goods/run-1/module-1", "gondola", "goods", 7200, y, 90, length, 2000));
  put(shop,
      sample::fixture("goods/run-2/module-1", "gondola", "goods", 10800, y, 270, length, 2000));
  shop.layout.aisles = {
      aisle(layout::AisleKind::secondary, {8200, 12000 - length, 9800, 12000}, 1600)};
  return shop;
}

Shop with_fixture(layout::Fixture fixture) {
  Shop shop = sound_shop();
  put(shop, std::move(fixture));
  return shop;
}

// Fixtures round the place (6, 6): with the gap, a person gets in.
Shop with_pen(int gap) {
  Shop shop = sound_shop();
  put(shop,
      sample::fixture("goods/pen/module-1", "wall_unit", "goods", 6000, 8250, 180, 5000, 500));
  put(shop,
      sample::fixture("goods/pen/module-2", "wall_unit", "goods", 3750, 6000, 270, 4000, 500));
  put(shop, sample::fixture("goods/pen/module-3", "wall_unit", "goods", 8250, 6000, 90, 4000, 500));
  put(shop,
      sample::fixture(
          "goods/pen/module-4", "wall_unit", "goods", 6000 - gap / 2, 3750, 0, 4000 - gap, 500));
  return shop;
}

// A shelf of a zone of its own within the pen.
Shop with_shelf_in_pen(int gap) {
  Shop shop = with_pen(gap);
  add_zone(shop, "inner", "snacks", "gondola", {5000, 5000, 7000, 7000});
  put(shop, sample::fixture("inner/run-1/module-1", "wall_unit", "inner", 6000, 6000, 0, 500, 500));
  return shop;
}

// Zones of two types with one fixture each, `gap` apart along the north wall.
Shop with_neighbours(const std::string& type_a, const std::string& type_b, int gap) {
  Shop shop = sound_shop();
  add_zone(shop, "a", type_a, "multideck", {0, 6000, 6000, 9000});
  add_zone(shop, "b", type_b, "multideck", {6000, 6000, 12000, 9000});
  put(shop, sample::fixture("a/run-1/module-1", "multideck", "a", 4000, 7000, 0, 1250, 1000));
  put(shop,
      sample::fixture(
          "b/run-1/module-1", "multideck", "b", 4000 + 1250 + gap, 7000, 0, 1250, 1000));
  return shop;
}

Shop with_cold_zones(std::vector<int> at) {
  Shop shop = sound_shop();
  for (const int x : at) {
    const std::string id = "cold-" + std::to_string(x);
    add_zone(shop, id, "dairy", "multideck", {x, 6500, x + 1500, 8500});
    put(shop,
        sample::fixture(id + "/run-1/module-1", "multideck", id, x + 700, 7500, 0, 1250, 1000));
  }
  return shop;
}

Shop with_relation(plan::Strength strength, plan::RelationKind kind, const std::string& b) {
  Shop shop = sound_shop();
  shop.plan.relations = {{kind, "tills", b, {}, strength}};
  return shop;
}

Shop with_smallest(double area) {
  Shop shop = sound_shop();
  shop.plan.zones[0].area_m2.min = area;
  return shop;
}

Shop with_tills_wanted(int count) {
  Shop shop = sound_shop();
  for (plan::Zone& zone : shop.plan.zones) {
    if (zone.id == "tills") zone.fixture.count = count;
  }
  return shop;
}

Shop with_cooler_before(int distance) {
  Shop shop = sound_shop();
  put(shop,
      sample::fixture(
          "goods/run-2/module-1", "glass_door_cooler", "goods", 5000, 7000, 0, 1250, 700));
  put(shop,
      sample::fixture(
          "goods/run-3/module-1", "wall_unit", "goods", 5000, 6650 - distance - 250, 0, 1000, 500));
  return shop;
}

Shop with_run(int length) {
  return with_fixture(
      sample::fixture("goods/run-9/module-1", "gondola", "goods", 9000, 7500, 0, length, 1000, 2));
}

Shop with_produce_at(int x) {
  Shop shop = sound_shop();
  shop.plan.shell.openings[0].center = 0.1;
  add_zone(shop, "fruit", "produce", "produce_table", {x, 6000, x + 3000, 9000});
  put(shop,
      sample::fixture(
          "fruit/run-1/module-1", "produce_table", "fruit", x + 1500, 7500, 0, 1200, 1200));
  return shop;
}

Shop with_till_at(int x, int y) {
  Shop shop = sound_shop();
  shop.layout.fixtures[1].x_mm = x;
  shop.layout.fixtures[1].y_mm = y;
  return shop;
}

Shop without_fixture(std::size_t index) {
  Shop shop = sound_shop();
  shop.layout.fixtures.erase(shop.layout.fixtures.begin() + static_cast<std::ptrdiff_t>(index));
  return shop;
}

struct Case {
  std::function<Shop()> broken, sound;
};

const std::map<std::string, Case>& cases() {
  static const RectMm alley{4000, 5000, 14000, 6500};
  static const auto low = [](int height) {
    layout::Fixture f =
        sample::fixture("goods/run-2/module-1", "wall_unit", "goods", 4000, 2500, 180, 1000, 500);
    f.height_mm = height;
    return with_fixture(f);
  };
  static const std::map<std::string, Case> all{
      {"AISLE_TOO_NARROW",
       {[] { return with_aisle(layout::AisleKind::secondary, alley, 990); },
        [] { return with_aisle(layout::AisleKind::secondary, alley, 1000); }}},
      {"AISLE_TIGHT",
       {[] { return with_aisle(layout::AisleKind::secondary, alley, 1400); },
        [] { return with_aisle(layout::AisleKind::secondary, alley, 1500); }}},
      {"AISLE_DEAD_END",
       {[] { return with_blind_alley(4500); }, [] { return with_blind_alley(2500); }}},
      {"DEAD_END_TOO_LONG",
       {[] { return with_blind_alley(7500); }, [] { return with_blind_alley(5000); }}},
      {"LANE_TOO_NARROW",
       {[] { return with_aisle(layout::AisleKind::checkout, alley, 900); },
        [] { return with_aisle(layout::AisleKind::checkout, alley, 920); }}},
      {"EXIT_BLOCKED",
       {[] {
          return with_fixture(sample::fixture(
              "goods/run-2/module-1", "gondola", "goods", 16000, 1500, 0, 1000, 500));
        },
        [] {
          return with_fixture(sample::fixture(
              "goods/run-2/module-1", "gondola", "goods", 19000, 1500, 0, 1000, 500));
        }}},
      {"EXITS_FEW",  // 280 m2 are for 50 people, 270 m2 for 48
       {[] { return with_one_door(14000); }, [] { return with_one_door(13500); }}},
      {"EGRESS_NARROW",  // 240 m2 are for 43 people, who need 219 mm
       {[] { return with_doors_of(100); }, [] { return with_doors_of(120); }}},
      {"DOOR_SWING_BLOCKED",
       {[] { return with_cooler_before(500); }, [] { return with_cooler_before(1700); }}},
      {"FIXTURE_OUTSIDE",
       {[] {
          return with_fixture(
              sample::fixture("goods/run-2/module-1", "gondola", "goods", 300, 8000, 0, 1000, 500));
        },
        [] {
          return with_fixture(
              sample::fixture("goods/run-2/module-1", "gondola", "goods", 500, 8000, 0, 1000, 500));
        }}},
      {"FIXTURE_OVERLAP",
       {[] {
          return with_fixture(sample::fixture(
              "goods/run-1/module-2", "wall_unit", "goods", 8990, 11730, 0, 1000, 500));
        },
        [] {
          return with_fixture(sample::fixture(
              "goods/run-1/module-2", "wall_unit", "goods", 9000, 11730, 0, 1000, 500));
        }}},
      {"RUN_TOO_LONG", {[] { return with_run(14000); }, [] { return with_run(12000); }}},
      {"SIGHT_LINE", {[] { return low(1800); }, [] { return low(1200); }}},
      {"WHEELCHAIR_ROUTE",
       {[] { return with_shelf_in_pen(0); }, [] { return with_shelf_in_pen(1200); }}},
      {"ZONE_UNREACHABLE",
       {[] { return with_shelf_in_pen(0); }, [] { return with_shelf_in_pen(1200); }}},
      {"FLOOR_SHUT_OFF", {[] { return with_pen(0); }, [] { return with_pen(1200); }}},
      {"ZONE_TOO_SMALL", {[] { return with_smallest(61); }, [] { return with_smallest(60); }}},
      {"ZONE_EMPTY", {[] { return without_fixture(0); }, [] { return sound_shop(); }}},
      {"COUNT_SHORT", {[] { return with_tills_wanted(2); }, [] { return with_tills_wanted(1); }}},
      {"COLD_SCATTERED",
       {[] {
          return with_cold_zones({500, 8000, 15000});
        },
        [] {
          return with_cold_zones({500, 3000, 15000});
        }}},
      {"RAW_NEXT_TO_READY",
       {[] { return with_neighbours("meat_fish", "deli", 100); },
        [] { return with_neighbours("meat_fish", "deli", 1500); }}},
      {"CHEMICAL_NEXT_TO_FOOD",
       {[] { return with_neighbours("household", "snacks", 100); },
        [] { return with_neighbours("household", "snacks", 700); }}},
      {"PRODUCE_FAR",
       {[] { return with_produce_at(16000); }, [] { return with_produce_at(3000); }}},
      {"CHECKOUT_MISSING", {[] { return without_fixture(1); }, [] { return sound_shop(); }}},
      {"CHECKOUT_NOT_AT_EXIT",
       {[] {
          Shop shop = with_till_at(1500, 7000);
          shop.plan.shell.openings[1].center = 0.93;
          return shop;
        },
        [] { return sound_shop(); }}},
      {"CHECKOUT_TIGHT",
       {[] { return with_till_at(16000, 10000); }, [] { return with_till_at(16000, 9000); }}},
      {"RELATION_BROKEN",
       {[] { return with_relation(plan::Strength::must, plan::RelationKind::near, "entrance"); },
        [] { return with_relation(plan::Strength::must, plan::RelationKind::near, "exit"); }}},
      {"RELATION_MISSED",
       {[] {
          return with_relation(plan::Strength::prefer, plan::RelationKind::left_of, "entrance");
        },
        [] {
          return with_relation(plan::Strength::prefer, plan::RelationKind::right_of, "entrance");
        }}},
      {"RELATION_NOT_JUDGED",
       {[] { return with_relation(plan::Strength::must, plan::RelationKind::near, "moon"); },
        [] { return with_relation(plan::Strength::must, plan::RelationKind::near, "exit"); }}},
  };
  return all;
}

std::set<std::string> codes_broken_by(Shop shop) {
  shop.layout.profile = shop.plan.profile;
  shop.layout.shell = shop.plan.shell;
  shop.layout.shell.outline_mm = polygon_of(plan::shell_rect(shop.plan.shell));
  const catalog::Catalog catalog = sample::catalog();
  std::set<std::string> codes;
  for (const layout::Violation& v : layout::check_layout(shop.layout, shop.plan, catalog))
    codes.insert(v.code);
  return codes;
}

TEST(LayoutRules, TheSoundShopBreaksNone) {
  EXPECT_EQ(codes_broken_by(sound_shop()), std::set<std::string>{});
}

TEST(LayoutRules, EveryRuleHasACase) {
  std::set<std::string> rules, tested;
  for (const layout::LayoutRule& rule : layout::layout_rules()) {
    rules.insert(std::string(rule.code));
    EXPECT_FALSE(rule.source.empty()) << rule.code;
  }
  for (const auto& [code, unused] : cases())
    tested.insert(code);
  EXPECT_EQ(rules, tested);
}

TEST(LayoutRules, EachIsBrokenByItsBrokenLayout) {
  for (const auto& [code, example] : cases())
    EXPECT_TRUE(codes_broken_by(example.broken()).contains(code)) << code;
}

TEST(LayoutRules, EachIsKeptByItsSoundLayout) {
  for (const auto& [code, example] : cases())
    EXPECT_FALSE(codes_broken_by(example.sound()).contains(code)) << code;
}

TEST(LayoutRules, ViolationsCarryMeasureLimitAndPlace) {
  Shop shop = with_aisle(layout::AisleKind::secondary, {4000, 5000, 14000, 6500}, 700);
  shop.layout.shell = shop.plan.shell;
  shop.layout.shell.outline_mm = polygon_of(plan::shell_rect(shop.plan.shell));
  const std::vector<layout::Violation> found =
      layout::check_layout(shop.layout, shop.plan, sample::catalog());
  const auto narrow = std::ranges::find(found, "AISLE_TOO_NARROW", &layout::Violation::code);
  ASSERT_NE(narrow, found.end());
  EXPECT_EQ(narrow->severity, layout::Severity::hard);
  EXPECT_EQ(narrow->value, 700);
  EXPECT_EQ(narrow->limit, 1000);
  EXPECT_EQ(narrow->at_mm, (PointMm{9000, 5750}));
  EXPECT_EQ(narrow->where, "goods/run-1/aisle-south");
}

}  // namespace
}  // namespace marketgen
