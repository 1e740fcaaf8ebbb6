#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>

#include "io/json.h"
#include "layout/layout.h"
#include "layout/repair_moves.h"
#include "layout/zone_faults.h"
#include "plan/bsp.h"
#include "plan/egress.h"
#include "sample_shop.h"

namespace marketgen {
namespace {

int hard_faults(const plan::Plan& plan, const catalog::Catalog& catalog) {
  const Result<layout::Layout> layout = layout::make_layout(plan, catalog, Seed(1));
  if (!layout.ok()) return 1000;
  return static_cast<int>(
      std::ranges::count(layout->violations, layout::Severity::hard, &layout::Violation::severity));
}

TEST(Repair, ASoundPlanStaysAsItIs) {
  const catalog::Catalog catalog = sample::catalog();
  const plan::Plan plan = sample::small_shop();
  const Result<layout::Repaired> repaired = layout::repair_plan(plan, catalog, Seed(1));
  ASSERT_TRUE(repaired.ok());
  EXPECT_TRUE(repaired->changes.empty());
  EXPECT_EQ(io::write_json(repaired->plan), io::write_json(plan));
}

TEST(Repair, PutsTillsIntoAShopWithoutAny) {
  const catalog::Catalog catalog = sample::catalog();
  plan::Plan plan = sample::one_zone(16000, 14000, sample::zone("goods", "dry_goods", "gondola"));
  ASSERT_GT(hard_faults(plan, catalog), 0);
  const Result<layout::Repaired> repaired = layout::repair_plan(plan, catalog, Seed(1));
  ASSERT_TRUE(repaired.ok());
  EXPECT_EQ(hard_faults(repaired->plan, catalog), 0);
  EXPECT_TRUE(std::ranges::any_of(repaired->plan.zones,
                                  [](const plan::Zone& z) { return z.type == "checkout"; }));
  ASSERT_FALSE(repaired->changes.empty());
  EXPECT_TRUE(std::ranges::all_of(repaired->plan.provenance, [](const plan::Provenance& p) {
    return p.source == plan::Source::repair;
  }));
}

TEST(Repair, GivesFloorToAZoneThatHasNone) {  // 8 % of 16 m leaves the snacks 1.1 m
  const catalog::Catalog catalog = sample::catalog();
  plan::Plan plan = sample::small_shop();
  plan.zones.push_back(sample::zone("snacks", "snacks", "gondola"));
  plan.nodes = {sample::cut("root", plan::Axis::y, 0.4, 2400, "front", "back"),
                sample::leaf("front", "tills"),
                sample::cut("back", plan::Axis::x, 0.08, 1800, "sliver", "rest"),
                sample::leaf("sliver", "snacks"),
                sample::leaf("rest", "goods")};
  const Result<layout::Repaired> repaired = layout::repair_plan(plan, catalog, Seed(1));
  ASSERT_TRUE(repaired.ok());
  EXPECT_LE(hard_faults(repaired->plan, catalog), hard_faults(plan, catalog));
  EXPECT_EQ(hard_faults(repaired->plan, catalog), 0);
}

// Two zones that need 45 m2 each, of which the first has a fifth of the floor.
plan::Plan lopsided_shop() {
  plan::Plan plan = sample::small_shop();
  plan.zones.push_back(sample::zone("snacks", "snacks", "gondola"));
  for (plan::Zone& zone : plan.zones) {
    if (zone.id == "goods" || zone.id == "snacks") zone.area_m2.min = zone.area_m2.target = 45;
  }
  plan.nodes = {sample::cut("root", plan::Axis::y, 0.4, 2400, "front", "back"),
                sample::leaf("front", "tills"),
                sample::cut("back", plan::Axis::x, 0.2, 1800, "sliver", "rest"),
                sample::leaf("sliver", "snacks"),
                sample::leaf("rest", "goods")};
  return plan;
}

TEST(Repair, GivesAZoneTheFloorThatItLacksAndNoMore) {  // four small steps would not get there
  const catalog::Catalog catalog = sample::catalog();
  const Result<layout::Repaired> repaired = layout::repair_plan(lopsided_shop(), catalog, Seed(1));
  ASSERT_TRUE(repaired.ok());
  const std::vector<RectMm> rects = plan::zone_rectangles(repaired->plan);
  for (std::size_t i = 0; i < rects.size(); ++i) {
    if (repaired->plan.zones[i].id == "snacks") {
      EXPECT_GE(rects[i].area_m2(), 45);
      EXPECT_LE(rects[i].area_m2(), 46);
    }
    if (repaired->plan.zones[i].id == "goods") {
      EXPECT_GE(rects[i].area_m2(), 45);
    }
  }
}

TEST(Repair, DividesTheFloorAsItsZonesNeed) {
  const catalog::Catalog catalog = sample::catalog();
  const plan::Plan plan = lopsided_shop();
  const Result<layout::Layout> layout = layout::make_layout(plan, catalog, Seed(1));
  ASSERT_TRUE(layout.ok());
  const auto small = std::ranges::find(
      layout->violations, std::string("ZONE_TOO_SMALL"), &layout::Violation::code);
  ASSERT_NE(small, layout->violations.end());
  const std::vector<layout::RepairCandidate> balanced =
      layout::propose(layout::RepairMove::balance, {plan, *layout, *small, catalog});
  ASSERT_FALSE(balanced.empty());
  EXPECT_NEAR(*plan::find_node(balanced.front().plan, "back")->ratio, 0.5, 0.01);
}

TEST(Repair, WidensAislesThatNobodyAskedFor) {
  const catalog::Catalog catalog = sample::catalog();
  plan::Plan plan = sample::small_shop();
  for (plan::Zone& zone : plan.zones)
    if (zone.id == "goods") zone.fixture.aisle_mm = 1000;
  const auto tight = [&](const plan::Plan& p) {
    const Result<layout::Layout> layout = layout::make_layout(p, catalog, Seed(1));
    return layout.ok() && std::ranges::any_of(layout->violations, [](const layout::Violation& v) {
             return v.code == "AISLE_TIGHT";
           });
  };
  ASSERT_TRUE(tight(plan));
  const Result<layout::Repaired> repaired = layout::repair_plan(plan, catalog, Seed(1));
  ASSERT_TRUE(repaired.ok());
  EXPECT_FALSE(tight(repaired->plan));
  for (std::size_t i = 0; i < plan.zones.size(); ++i) {
    if (plan.zones[i].id != "goods") continue;
    plan.provenance.push_back(
        {fmt::format("/zones/{}/fixture/aisle_mm", i), plan::Source::text, std::nullopt, 1});
  }
  const Result<layout::Repaired> asked = layout::repair_plan(plan, catalog, Seed(1));
  ASSERT_TRUE(asked.ok());
  EXPECT_EQ(plan::find_zone(asked->plan, "goods")->fixture.aisle_mm, 1000) << "somebody said so";
}

TEST(Repair, MovesZonesForARelationThatMustHold) {
  const catalog::Catalog catalog = sample::catalog();
  plan::Plan plan = sample::small_shop();
  plan.zones.push_back(sample::zone("snacks", "snacks", "gondola"));
  plan.nodes = {sample::cut("root", plan::Axis::y, 0.4, 2400, "front", "back"),
                sample::leaf("front", "tills"),
                sample::cut("back", plan::Axis::x, 0.5, 1800, "west", "east"),
                sample::leaf("west", "goods"),
                sample::leaf("east", "snacks")};
  plan.relations = {{plan::RelationKind::left_of, "snacks", "goods", {}, plan::Strength::must}};
  ASSERT_EQ(hard_faults(plan, catalog), 1);
  const Result<layout::Repaired> repaired = layout::repair_plan(plan, catalog, Seed(1));
  ASSERT_TRUE(repaired.ok());
  EXPECT_EQ(hard_faults(repaired->plan, catalog), 0);
  EXPECT_EQ(repaired->changes,
            (std::vector<std::string>{"let zones snacks and goods change places"}));
}

// A hall for 538 people with two doors.
plan::Plan hall() {
  plan::Plan plan = sample::small_shop();
  plan.shell.width_mm = 60000;
  plan.shell.depth_mm = 50000;
  return plan;
}

int ways_out(const plan::Plan& plan) {
  return static_cast<int>(std::ranges::count_if(plan.shell.openings, plan::leads_outside));
}

TEST(Repair, PutsEmergencyExitsIntoAHall) {
  const catalog::Catalog catalog = sample::catalog();
  ASSERT_EQ(ways_out(hall()), 2);
  const Result<layout::Repaired> repaired = layout::repair_plan(hall(), catalog, Seed(1));
  ASSERT_TRUE(repaired.ok());
  EXPECT_EQ(ways_out(repaired->plan), 3);
  const plan::Opening& exit = repaired->plan.shell.openings.back();
  EXPECT_EQ(exit.kind, plan::OpeningKind::emergency);
  const std::string path =
      fmt::format("/shell/openings/{}", repaired->plan.shell.openings.size() - 1);
  const auto entry = std::ranges::find(repaired->plan.provenance, path, &plan::Provenance::path);
  ASSERT_NE(entry, repaired->plan.provenance.end());
  EXPECT_EQ(entry->source, plan::Source::repair);
}

TEST(Repair, LeavesDoorsAsTheyWereDrawnOrAskedFor) {
  const catalog::Catalog catalog = sample::catalog();
  plan::Plan drawn = hall();
  drawn.provenance = {{"/shell/openings/0", plan::Source::drawing, std::nullopt, 1}};
  EXPECT_EQ(ways_out(layout::repair_plan(drawn, catalog, Seed(1))->plan), 2);
  plan::Plan larger = hall();  // 1,076 people: four doors
  larger.shell.width_mm = 120000;
  larger.shell.openings.push_back(
      sample::door("back", plan::OpeningKind::emergency, plan::Wall::north, 0.5, 1200));
  EXPECT_EQ(ways_out(layout::repair_plan(larger, catalog, Seed(1))->plan), 4);
  larger.provenance = {{fmt::format("/shell/openings/{}", larger.shell.openings.size() - 1),
                        plan::Source::text,
                        std::nullopt,
                        1}};
  EXPECT_EQ(ways_out(layout::repair_plan(larger, catalog, Seed(1))->plan), 3)
      << "somebody asked for one";
}

// Two zones below the tills of a small shop, the first with a tenth of the floor.
plan::Plan narrow_and_wide(const plan::Zone& narrow, const plan::Zone& wide) {
  plan::Plan plan = sample::small_shop();
  std::erase_if(plan.zones, [](const plan::Zone& zone) { return zone.id == "goods"; });
  plan.zones.push_back(narrow);
  plan.zones.push_back(wide);
  plan.nodes = {sample::cut("root", plan::Axis::y, 0.4, 2400, "front", "back"),
                sample::leaf("front", "tills"),
                sample::cut("back", plan::Axis::x, 0.3, 1800, "west", "east"),
                sample::leaf("west", narrow.id),
                sample::leaf("east", wide.id)};
  return plan;
}

TEST(Repair, GivesAZoneThePlaceThatSuitsBoth) {
  const catalog::Catalog catalog = sample::catalog();
  plan::Zone goods = sample::zone("goods", "dry_goods", "gondola");
  plan::Zone snacks = sample::zone("snacks", "snacks", "gondola");
  const plan::Plan sketch = narrow_and_wide(goods, snacks);
  const std::vector<RectMm> rects = plan::zone_rectangles(sketch);
  const auto area = [&](std::string_view id) {
    for (std::size_t i = 0; i < rects.size(); ++i)
      if (sketch.zones[i].id == id) return rects[i].area_m2();
    return 0.0;
  };
  // Each wants what the other has; no cut gives both of them that.
  goods.area_m2.min = goods.area_m2.target = 0.99 * area("snacks");
  snacks.area_m2.target = snacks.area_m2.min = 0.99 * area("goods");
  plan::Plan plan = narrow_and_wide(goods, snacks);
  const Result<layout::Repaired> repaired = layout::repair_plan(plan, catalog, Seed(1));
  ASSERT_TRUE(repaired.ok());
  ASSERT_FALSE(repaired->changes.empty());
  EXPECT_EQ(layout::zone_faults(plan, catalog).soft, 1);
  EXPECT_EQ(layout::zone_faults(repaired->plan, catalog).soft, 0);
}

TEST(Repair, GathersWhatIsRefrigerated) {
  const catalog::Catalog catalog = sample::catalog();
  plan::Plan plan = sample::small_shop();
  plan.shell.width_mm = 60000;
  std::erase_if(plan.zones, [](const plan::Zone& zone) { return zone.id == "goods"; });
  plan.nodes = {sample::cut("root", plan::Axis::y, 0.4, 2400, "front", "back"),
                sample::leaf("front", "tills")};
  // Cold, dry, cold, dry, cold from west to east: three groups.
  const std::vector<std::pair<std::string, std::string>> row = {{"deli", "multideck"},
                                                                {"snacks", "gondola"},
                                                                {"dairy", "multideck"},
                                                                {"bakery", "gondola"},
                                                                {"meat_fish", "multideck"}};
  std::string node = "back";
  for (std::size_t i = 0; i < row.size(); ++i) {
    plan.zones.push_back(sample::zone(row[i].first, row[i].first, row[i].second));
    const std::string leaf = row[i].first + "-leaf", rest = fmt::format("rest-{}", i);
    if (i + 1 == row.size()) {
      plan.nodes.push_back(sample::leaf(node, row[i].first));
      break;
    }
    plan.nodes.push_back(sample::cut(
        node, plan::Axis::x, 1.0 / static_cast<double>(row.size() - i), 1800, leaf, rest));
    plan.nodes.push_back(sample::leaf(leaf, row[i].first));
    node = rest;
  }
  const auto scattered = [&](const plan::Plan& p) {
    const Result<layout::Layout> made = layout::make_layout(p, catalog, Seed(1));
    return !made.ok() || std::ranges::any_of(made->violations, [](const layout::Violation& v) {
      return v.code == "COLD_SCATTERED";
    });
  };
  ASSERT_TRUE(scattered(plan));
  const Result<layout::Repaired> repaired = layout::repair_plan(plan, catalog, Seed(1));
  ASSERT_TRUE(repaired.ok());
  EXPECT_FALSE(scattered(repaired->plan));
  EXPECT_EQ(repaired->plan.zones.size(), plan.zones.size()) << "none is left out";
}

TEST(Repair, FaultsOfZonesAreThoseOfTheLayout) {
  const catalog::Catalog catalog = sample::catalog();
  plan::Plan plan = sample::small_shop();
  for (plan::Zone& zone : plan.zones)
    zone.area_m2.min = 10000;
  plan.relations = {{plan::RelationKind::left_of, "goods", "tills", {}, plan::Strength::must},
                    {plan::RelationKind::far, "goods", "tills", {}, plan::Strength::prefer}};
  const layout::FaultCount alone = layout::zone_faults(plan, catalog);
  const Result<layout::Layout> made = layout::make_layout(plan, catalog, Seed(1));
  ASSERT_TRUE(made.ok());
  std::vector<layout::Violation> about_zones;
  for (const layout::Violation& v : made->violations)
    if (layout::is_about_zones(v.code)) about_zones.push_back(v);
  EXPECT_EQ(alone, layout::count_faults(about_zones));
  EXPECT_GE(alone.soft, 2) << "no zone has 10,000 m2";
}

TEST(Repair, IsTheSameEveryTime) {
  const catalog::Catalog catalog = sample::catalog();
  const plan::Plan plan =
      sample::one_zone(16000, 14000, sample::zone("goods", "dry_goods", "gondola"));
  EXPECT_EQ(io::write_json(layout::repair_plan(plan, catalog, Seed(3))->plan),
            io::write_json(layout::repair_plan(plan, catalog, Seed(3))->plan));
}

}  // namespace
}  // namespace marketgen
