// Rectangles in whole millimetres.
#include "geometry/rectangle.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

TEST(Rectangle, BoundsOfTwoAreTheSmallestThatHaveBoth) {
  const RectMm a{0, 10, 20, 30}, inside{5, 15, 10, 20}, apart{100, -40, 120, 0};
  EXPECT_EQ(bounds_of(a, inside), a);
  EXPECT_EQ(bounds_of(a, apart), (RectMm{0, -40, 120, 30}));
  EXPECT_EQ(bounds_of(apart, a), bounds_of(a, apart));
  EXPECT_EQ(bounds_of(a, bounds_of(polygon_of(apart))), bounds_of(a, apart));
}

TEST(Rectangle, GapDistanceAndIntersection) {
  const RectMm a{0, 0, 10, 10}, beside{13, 0, 20, 10}, corner{13, 14, 20, 20},
      touching{10, 0, 20, 5};
  EXPECT_EQ(gap_mm(a, beside), 3);
  EXPECT_DOUBLE_EQ(distance_mm(a, corner), 5);
  EXPECT_FALSE(overlap(a, touching));
  EXPECT_FALSE(intersection(a, touching).has_value());
  EXPECT_EQ(intersection(a, a.grown(-2)), (RectMm{2, 2, 8, 8}));
}

}  // namespace
}  // namespace marketgen
