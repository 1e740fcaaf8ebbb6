// Drawn floors become slices: what can be cut from wall to wall is found again.
#include "intake/fit_slices.h"

#include <gtest/gtest.h>

#include <random>

#include "support/painted_map.h"

namespace marketgen {
namespace {

// Cuts the largest rectangle across its longer side until there are `count`.
std::vector<RectMm> divided(std::mt19937& random, int width_mm, int depth_mm, int count) {
  std::vector<RectMm> rects{{0, 0, width_mm, depth_mm}};
  while (static_cast<int>(rects.size()) < count) {
    const auto largest =
        std::ranges::max_element(rects, {}, [](const RectMm& r) { return r.area_mm2(); });
    RectMm first = *largest, second = *largest;
    const int percent = 30 + static_cast<int>(random() % 41);
    if (first.width() >= first.depth())
      first.x1 = second.x0 = first.x0 + first.width() * percent / 100;
    else
      first.y1 = second.y0 = first.y0 + first.depth() * percent / 100;
    *largest = first;
    rects.push_back(second);
  }
  return rects;
}

TEST(FitSlices, FindsGuillotineDivisionsAgain) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    std::mt19937 random(seed);
    const int width = 12000 + static_cast<int>(random() % 29) * 1000;
    const int depth = 10000 + static_cast<int>(random() % 21) * 1000;
    const int count = 2 + static_cast<int>(random() % 11);
    const auto rects = divided(random, width, depth, count);
    const auto fitted =
        intake::fit_slices(painted_map(width, depth, rects), rects.size(), width, depth);
    EXPECT_GE(fitted.iou, 0.98) << "seed " << seed;
    for (const RectMm& rect : fitted.rects)
      EXPECT_FALSE(rect.empty()) << "seed " << seed;
  }
}

TEST(FitSlices, APinwheelGetsItsNearest) {
  const std::vector<RectMm> rects{{0, 0, 12000, 6000},
                                  {12000, 0, 18000, 12000},
                                  {6000, 12000, 18000, 18000},
                                  {0, 6000, 6000, 18000},
                                  {6000, 6000, 12000, 12000}};
  const auto fitted = intake::fit_slices(painted_map(18000, 18000, rects), 5, 18000, 18000);
  EXPECT_GE(fitted.iou, 0.75);
  for (const RectMm& rect : fitted.rects)
    EXPECT_FALSE(rect.empty());
}

TEST(FitSlices, BareFloorBetweenZonesIsAGap) {
  const std::vector<RectMm> rects{{0, 0, 8000, 10000}, {10000, 0, 20000, 10000}};
  const auto fitted = intake::fit_slices(painted_map(20000, 10000, rects), 2, 20000, 10000);
  EXPECT_EQ(fitted.root.gaps_mm, std::vector{2000});
  EXPECT_EQ(fitted.rects, rects);
  EXPECT_EQ(fitted.iou, 1);
}

TEST(FitSlices, StretchesTheMapToTheFloor) {
  const std::vector<RectMm> rects{{0, 0, 5000, 10000}, {5000, 0, 20000, 10000}};
  const auto fitted = intake::fit_slices(painted_map(20000, 10000, rects), 2, 40000, 10000);
  EXPECT_EQ(fitted.rects[0], (RectMm{0, 0, 10000, 10000}));
}

// A zone without squares gets no floor, and so no share in the union.
TEST(FitSlices, LeavesOutZonesThatAreNotOnTheMap) {
  const std::vector<RectMm> rects{{0, 0, 5000, 10000}, {5000, 0, 20000, 10000}};
  const auto fitted = intake::fit_slices(painted_map(20000, 10000, rects), 3, 20000, 10000);
  EXPECT_TRUE(fitted.rects[2].empty());
  EXPECT_EQ(fitted.iou, 1);
}

TEST(MicroIou, CountsWhatEitherNames) {
  const auto map = painted_map(20000, 10000, {{0, 0, 10000, 10000}, {10000, 0, 20000, 10000}});
  // Of 200 m2, 50 of the second zone are named by the map alone.
  const double iou =
      intake::micro_iou(map, {{0, 0, 10000, 10000}, {15000, 0, 20000, 10000}}, 20000, 10000);
  EXPECT_DOUBLE_EQ(iou, 0.75);
}

}  // namespace
}  // namespace marketgen
