// Runs as people count them: by where modules stand.
#include "audit/straight_runs.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace marketgen {
namespace {

layout::Fixture module(int x_mm, int y_mm, int yaw_deg, int sides = 1) {
  layout::Fixture fixture;
  fixture.id = "z/run-1/module-" + std::to_string(x_mm) + "-" + std::to_string(y_mm);
  fixture.run = "z/run-1";
  fixture.kind = "gondola";
  fixture.zone = "z";
  fixture.x_mm = x_mm;
  fixture.y_mm = y_mm;
  fixture.yaw_deg = yaw_deg;
  fixture.width_mm = 1000;
  fixture.depth_mm = 500;
  fixture.sides = sides;
  return fixture;
}

TEST(StraightRuns, ModulesThatTouchAreOne) {
  const auto runs =
      audit::straight_runs({module(3500, 1000, 0), module(1500, 1000, 0), module(2500, 1000, 0)});
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].modules, 3);
  EXPECT_EQ(runs[0].rect, (RectMm{1000, 750, 4000, 1250}));
}

TEST(StraightRuns, AGapEndsARun) {
  const auto runs = audit::straight_runs({module(1500, 1000, 0), module(2700, 1000, 0)});
  EXPECT_EQ(runs.size(), 2u);
}

TEST(StraightRuns, LinesBesideEachOtherAreTwo) {
  const auto runs = audit::straight_runs({module(1500, 1000, 0), module(1500, 3000, 0)});
  EXPECT_EQ(runs.size(), 2u);
  for (const audit::StraightRun& run : runs)
    EXPECT_FALSE(run.back_to_back);
}

TEST(StraightRuns, BacksTogetherAreBackToBack) {  // the one faces south, the other north
  const auto runs = audit::straight_runs({module(1500, 1000, 0), module(1500, 1500, 180)});
  ASSERT_EQ(runs.size(), 2u);
  for (const audit::StraightRun& run : runs)
    EXPECT_TRUE(run.back_to_back);
}

TEST(StraightRuns, FrontsTogetherAreNot) {
  const auto runs = audit::straight_runs({module(1500, 1000, 180), module(1500, 1500, 0)});
  for (const audit::StraightRun& run : runs)
    EXPECT_FALSE(run.back_to_back);
}

TEST(StraightRuns, DoubleSidedOnesLookTheSameFromBehind) {
  const auto runs = audit::straight_runs({module(1500, 1000, 0, 2), module(2500, 1000, 180, 2)});
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].sides, 2);
}

}  // namespace
}  // namespace marketgen
