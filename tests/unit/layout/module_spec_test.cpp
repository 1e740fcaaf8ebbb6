#include "layout/module_spec.h"

#include <gtest/gtest.h>

#include "sample_shop.h"

namespace marketgen {
namespace {

class ModuleSpecTest : public testing::Test {
 protected:
  ModuleSpec spec_of(const Zone& zone) const {
    const Plan plan = sample::one_zone(10000, 10000, zone);
    const Design design = make_design(plan, catalog_);
    return module_spec(design, plan.zones[0], *catalog_.fixture_kind(zone.fixture.kind));
  }
  Catalog catalog_ = sample::catalog();
};

TEST_F(ModuleSpecTest, GondolaTakesDepthFromTheProfileAndFinishFromTheLook) {
  const ModuleSpec spec = spec_of(sample::zone("z", "dry_goods", "gondola"));
  EXPECT_EQ(spec.depth_mm, 2 * 470 + 60);
  EXPECT_EQ(spec.sides, 2);
  EXPECT_EQ(spec.material, "metal-grey");
  EXPECT_EQ(spec.color, "#808080");
}

TEST_F(ModuleSpecTest, LevelsHangInSlots) {  // (1800 - 150) / 5 = 330, down to a 50 mm slot
  const ModuleSpec spec = spec_of(sample::zone("z", "dry_goods", "gondola"));
  EXPECT_EQ(spec.levels, 5);
  EXPECT_EQ(spec.spacing_mm, 300);
}

TEST_F(ModuleSpecTest, WishesComeFirst) {
  Zone zone = sample::zone("z", "dry_goods", "gondola");
  zone.fixture.levels = 4;
  zone.fixture.height_mm = 1600;
  zone.fixture.spacing_mm = 380;
  zone.fixture.color = "#123456";
  const ModuleSpec spec = spec_of(zone);
  EXPECT_EQ(spec.levels, 4);
  EXPECT_EQ(spec.spacing_mm, 380);
  EXPECT_EQ(spec.height_mm, 1600);
  EXPECT_EQ(spec.color, "#123456");
}

TEST_F(ModuleSpecTest, TheHeightGrowsForWishedLevelsAtAWishedDistance) {
  Zone zone = sample::zone("z", "dry_goods", "gondola");
  zone.fixture.levels = 6;
  zone.fixture.spacing_mm = 350;  // 150 + 5 * 350 + 150 for the top shelf
  EXPECT_EQ(spec_of(zone).height_mm, 2050);
}

TEST_F(ModuleSpecTest, OneSidedIsHalfAsDeep) {
  const ModuleSpec spec = one_sided(spec_of(sample::zone("z", "dry_goods", "gondola")));
  EXPECT_EQ(spec.sides, 1);
  EXPECT_EQ(spec.depth_mm, 500);
}

TEST_F(ModuleSpecTest, RunsAreFilledWithLessThanTheNarrowestModuleLeft) {
  ModuleSpec spec = spec_of(sample::zone("z", "dry_goods", "gondola"));
  EXPECT_EQ(fill_widths(spec, 3400), (std::vector<int>{1000, 1000, 1000}));
  EXPECT_EQ(fill_widths(spec, 3600), (std::vector<int>{1000, 1000, 1000, 500}));
  EXPECT_TRUE(fill_widths(spec, 400).empty());
  spec.widths_mm = {1250, 1000};
  // 1250 + 1250 leaves 1000 of 3500 for the other width; 3000 is filled best by three of it.
  EXPECT_EQ(fill_widths(spec, 3500), (std::vector<int>{1250, 1250, 1000}));
  EXPECT_EQ(fill_widths(spec, 3000), (std::vector<int>{1000, 1000, 1000}));
}

TEST_F(ModuleSpecTest, ZonesThatNeedCabinetsGetThemWhenNothingIsWished) {
  Zone dairy = sample::zone("z", "dairy", "gondola");
  EXPECT_EQ(kinds_of(dairy, catalog_).main->kind, "multideck");
  const Zone dry = sample::zone("z", "dry_goods", "gondola");
  EXPECT_EQ(kinds_of(dry, catalog_).main->kind, "gondola");
  EXPECT_EQ(kinds_of(dry, catalog_).wall->kind, "wall_unit");
  EXPECT_EQ(kinds_of(sample::zone("z", "backroom", "gondola"), catalog_).main, nullptr);
}

}  // namespace
}  // namespace marketgen
