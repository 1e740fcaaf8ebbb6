#include "layout/aisles.h"

#include <gtest/gtest.h>

#include "sample_shop.h"

namespace marketgen {
namespace {

// Two lines of three cabinets that face each other across `gap` mm, in a room of 12 x 10 m.
std::vector<layout::Fixture> facing_lines(std::string kind, int depth, int gap) {
  std::vector<layout::Fixture> fixtures;
  for (int i = 0; i < 3; ++i) {
    const std::string n = std::to_string(i + 1);
    const int y = 3000 + 1250 * i;
    fixtures.push_back(sample::fixture("z/run-1/module-" + n, kind, "z", 4000, y, 90, 1250, depth));
    fixtures.push_back(
        sample::fixture("z/run-2/module-" + n, kind, "z", 4000 + depth + gap, y, 270, 1250, depth));
  }
  return fixtures;
}

const layout::Aisle* aisle_between(const std::vector<layout::Aisle>& aisles, int x) {
  for (const layout::Aisle& aisle : aisles) {
    if (contains(aisle.polygon_mm, {x, 4000})) return &aisle;
  }
  return nullptr;
}

class AisleTest : public testing::Test {
 protected:
  catalog::Catalog catalog_ = sample::catalog();
  plan::Plan plan_ = sample::one_zone(12000, 10000, sample::zone("z", "dairy", "multideck"));
  layout::Design design_ = layout::make_design(plan_, catalog_);
};

TEST_F(AisleTest, LinesThatFaceEachOtherShareOneAisle) {
  const std::vector<layout::Aisle> aisles =
      layout::find_aisles(design_, facing_lines("multideck", 1000, 2800));
  const layout::Aisle* aisle = aisle_between(aisles, 5900);
  ASSERT_NE(aisle, nullptr);
  EXPECT_EQ(aisle->width_mm, 2800);
  EXPECT_EQ(bounds_of(aisle->polygon_mm), (RectMm{4500, 2375, 7300, 6125}));
  EXPECT_FALSE(layout::runs_along_x(*aisle));
}

TEST_F(AisleTest, OpenDoorsOnBothSidesNarrowIt) {  // 2800 less 600 on either side
  const std::vector<layout::Aisle> aisles =
      layout::find_aisles(design_, facing_lines("glass_door_cooler", 700, 2800));
  const layout::Aisle* aisle = aisle_between(aisles, 5700);
  ASSERT_NE(aisle, nullptr);
  EXPECT_EQ(aisle->width_mm, 1600);
}

TEST_F(AisleTest, ColumnsNarrowThem) {
  plan_.shell.columns = {{5000, 4200, 400}};
  const layout::Design design = layout::make_design(plan_, catalog_);
  const std::vector<layout::Aisle> aisles =
      layout::find_aisles(design, facing_lines("multideck", 1000, 2800));
  ASSERT_FALSE(aisles.empty());
  int narrowest = 100000;
  for (const layout::Aisle& aisle : aisles)
    narrowest = std::min(narrowest, aisle.width_mm);
  EXPECT_EQ(narrowest, 300);  // from the front at x = 4,500 to the column at 4,800
}

TEST_F(AisleTest, NoFixturesNoAisles) {
  EXPECT_TRUE(layout::find_aisles(design_, {}).empty());
}

TEST_F(AisleTest, PassagesBetweenLanesAreCheckoutAisles) {
  const std::vector<layout::Fixture> lanes{
      sample::fixture("t/run-1/module-1", "checkout_lane", "t", 3000, 4000, 0, 1100, 2400),
      sample::fixture("t/run-1/module-2", "checkout_lane", "t", 5100, 4000, 0, 1100, 2400)};
  const std::vector<layout::Aisle> aisles = layout::find_aisles(design_, lanes);
  ASSERT_EQ(aisles.size(), 1U);
  EXPECT_EQ(aisles[0].kind, layout::AisleKind::checkout);
  EXPECT_EQ(aisles[0].width_mm, 1000);
}

}  // namespace
}  // namespace marketgen
