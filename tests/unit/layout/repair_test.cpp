#include <gtest/gtest.h>

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
