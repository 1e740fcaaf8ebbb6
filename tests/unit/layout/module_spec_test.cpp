#include "layout/module_spec.h"

#include <gtest/gtest.h>

#include "sample_shop.h"
#include "support/plan_sampler.h"

namespace marketgen {
namespace {

class ModuleSpecTest : public testing::Test {
 protected:
  layout::ModuleSpec spec_of(const plan::Zone& zone) const {
    const plan::Plan plan = sample::one_zone(10000, 10000, zone);
    const layout::Design design = layout::make_design(plan, catalog_);
    return layout::module_spec(design, plan.zones[0], *catalog_.fixture_kind(zone.fixture.kind));
  }
  catalog::Catalog catalog_ = sample::catalog();
};

TEST_F(ModuleSpecTest, GondolaTakesDepthFromTheProfileAndFinishFromTheLook) {
  const layout::ModuleSpec spec = spec_of(sample::zone("z", "dry_goods", "gondola"));
  EXPECT_EQ(spec.depth_mm, 2 * 470 + 60);
  EXPECT_EQ(spec.sides, 2);
  EXPECT_EQ(spec.material, "metal-grey");
  EXPECT_EQ(spec.color, "#808080");
}

TEST_F(ModuleSpecTest, LevelsHangInSlots) {  // (1800 - 150) / 5 = 330, down to a 50 mm slot
  const layout::ModuleSpec spec = spec_of(sample::zone("z", "dry_goods", "gondola"));
  EXPECT_EQ(spec.levels, 5);
  EXPECT_EQ(spec.spacing_mm, 300);
}

TEST_F(ModuleSpecTest, WishesComeFirst) {
  plan::Zone zone = sample::zone("z", "dry_goods", "gondola");
  zone.fixture.levels = 4;
  zone.fixture.height_mm = 1600;
  zone.fixture.spacing_mm = 380;
  zone.fixture.color = "#123456";
  const layout::ModuleSpec spec = spec_of(zone);
  EXPECT_EQ(spec.levels, 4);
  EXPECT_EQ(spec.spacing_mm, 380);
  EXPECT_EQ(spec.height_mm, 1600);
  EXPECT_EQ(spec.color, "#123456");
}

TEST_F(ModuleSpecTest, TheHeightGrowsForWishedLevelsAtAWishedDistance) {
  plan::Zone zone = sample::zone("z", "dry_goods", "gondola");
  zone.fixture.levels = 6;
  zone.fixture.spacing_mm = 350;  // 150 + 5 * 350 + 150 for the top shelf
  EXPECT_EQ(spec_of(zone).height_mm, 2050);
}

TEST_F(ModuleSpecTest, OneSidedIsHalfAsDeep) {
  const layout::ModuleSpec spec =
      layout::one_sided(spec_of(sample::zone("z", "dry_goods", "gondola")));
  EXPECT_EQ(spec.sides, 1);
  EXPECT_EQ(spec.depth_mm, 500);
}

TEST_F(ModuleSpecTest, RunsAreFilledWithLessThanTheNarrowestModuleLeft) {
  layout::ModuleSpec spec = spec_of(sample::zone("z", "dry_goods", "gondola"));
  EXPECT_EQ(layout::fill_widths(spec, 3400), (std::vector<int>{1000, 1000, 1000}));
  EXPECT_EQ(layout::fill_widths(spec, 3600), (std::vector<int>{1000, 1000, 1000, 500}));
  EXPECT_TRUE(layout::fill_widths(spec, 400).empty());
  spec.widths_mm = {1250, 1000};
  // 1250 + 1250 leaves 1000 of 3500 for the other width; 3000 is filled best by three of it.
  EXPECT_EQ(layout::fill_widths(spec, 3500), (std::vector<int>{1250, 1250, 1000}));
  EXPECT_EQ(layout::fill_widths(spec, 3000), (std::vector<int>{1000, 1000, 1000}));
}

TEST_F(ModuleSpecTest, ZonesThatNeedCabinetsGetThemWhenNothingIsWished) {
  plan::Zone dairy = sample::zone("z", "dairy", "gondola");
  EXPECT_EQ(layout::kinds_of(dairy, catalog_).main->kind, "multideck");
  const plan::Zone dry = sample::zone("z", "dry_goods", "gondola");
  EXPECT_EQ(layout::kinds_of(dry, catalog_).main->kind, "gondola");
  EXPECT_EQ(layout::kinds_of(dry, catalog_).wall->kind, "wall_unit");
  EXPECT_EQ(layout::kinds_of(sample::zone("z", "backroom", "gondola"), catalog_).main, nullptr);
}

// The least and the most that a layout's field may be.
const FieldRules& rules_of(std::string_view name) {
  for (const FieldInfo& field : type_of<layout::Fixture>().fields)
    if (field.name == name) return field.rules;
  fatal("no such field");
}

bool holds(std::string_view field, const IntRange& range) {
  return rules_of(field).min <= range[0] && range[1] <= rules_of(field).max;
}

// A layout that may be made can be written: its rules are no narrower than the rows'.
TEST(FixtureKinds, AreBuiltInSizesThatALayoutHolds) {
  for (const catalog::FixtureKind& kind : committed_catalog().fixture_kinds) {
    EXPECT_TRUE(holds("depth_mm", kind.depth_range_mm)) << kind.kind;
    EXPECT_TRUE(holds("height_mm", kind.height_range_mm)) << kind.kind;
    EXPECT_TRUE(holds("levels", kind.level_range)) << kind.kind;
    for (const int width : kind.module_widths_mm)
      EXPECT_TRUE(holds("width_mm", {width, width})) << kind.kind;
  }
}

// A module narrower than its kind can be built is refused where it was asked for, before the
// layout; the narrowest that can be is not.
TEST(FixtureKinds, AreRefusedNarrowerThanTheyCanBeBuilt) {
  plan::Plan plan = sampled_shop();
  plan::FixtureSpec& fixture = plan.zones[1].fixture;
  fixture.module_mm = 300;
  EXPECT_TRUE(layout::make_layout(plan, committed_catalog(), Seed(1)).ok());
  fixture.module_mm = 299;
  const auto refused = layout::make_layout(plan, committed_catalog(), Seed(1));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, "plan.bad_value");
  EXPECT_EQ(refused.error().where, "/zones/1/fixture/module_mm");
  EXPECT_NE(refused.error().message.find("needs at least 300"), std::string::npos)
      << refused.error().message;
  EXPECT_NE(refused.error().message.find("leave module_mm out"), std::string::npos);
}

}  // namespace
}  // namespace marketgen
