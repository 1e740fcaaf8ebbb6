#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>

#include "io/json.h"
#include "layout/layout.h"
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

TEST(Repair, DividesTheFloorAsItsZonesNeed) {  // four small steps would not get there
  const catalog::Catalog catalog = sample::catalog();
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
  const Result<layout::Repaired> repaired = layout::repair_plan(plan, catalog, Seed(1));
  ASSERT_TRUE(repaired.ok());
  const plan::Node* back = plan::find_node(repaired->plan, "back");
  ASSERT_NE(back, nullptr);
  EXPECT_NEAR(*back->ratio, 0.5, 0.01);
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

TEST(Repair, IsTheSameEveryTime) {
  const catalog::Catalog catalog = sample::catalog();
  const plan::Plan plan =
      sample::one_zone(16000, 14000, sample::zone("goods", "dry_goods", "gondola"));
  EXPECT_EQ(io::write_json(layout::repair_plan(plan, catalog, Seed(3))->plan),
            io::write_json(layout::repair_plan(plan, catalog, Seed(3))->plan));
}

}  // namespace
}  // namespace marketgen
