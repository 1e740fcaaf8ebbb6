// What a lens adds to a path-traced picture.
#include "render/path/lens.h"

#include <gtest/gtest.h>

#include <numeric>

namespace marketgen::render::raytrace {
namespace {

constexpr int side = 200;
constexpr std::size_t middle = side / 2 * side + side / 2;

double sum_of(const FloatPlane& plane) {
  return std::accumulate(plane.begin(), plane.end(), 0.0);
}

TEST(Lens, ScattersALittleOfALampEvenlyToAllSides) {
  ColorPlanes dark(side * side), lamp(side * side);
  lamp.set(middle, {1000, 2000, 0});
  const ColorPlanes seen = with_glare(dark, lamp, side);
  EXPECT_NEAR(sum_of(seen.axis[0]), 18, 0.3);  // 1.8 %
  EXPECT_NEAR(sum_of(seen.axis[1]), 36, 0.6);
  EXPECT_EQ(sum_of(seen.axis[2]), 0);
  for (const std::size_t step : {std::size_t{1}, std::size_t{side}}) {
    EXPECT_NEAR(seen.axis[0][middle + 3 * step], seen.axis[0][middle - 3 * step], 1e-5F);
    EXPECT_GT(seen.axis[0][middle], seen.axis[0][middle + 5 * step]);
    EXPECT_GT(seen.axis[0][middle + 5 * step], seen.axis[0][middle + 15 * step]);
  }
}

TEST(Lens, LeavesPicturesWithoutLampsAsTheyAre) {
  ColorPlanes light(side * side);
  light.set(middle, {1, 2, 3});
  EXPECT_EQ(with_glare(light, ColorPlanes(side * side), side).axis, light.axis);
}

TEST(Lens, LosesLightTowardsTheCornersOnly) {
  EXPECT_EQ(arriving_share(1), 1);
  EXPECT_NEAR(arriving_share(0.77F), 0.87F, 0.01F);  // 40 degrees off the axis
  EXPECT_LT(arriving_share(0.7F), arriving_share(0.8F));
}

}  // namespace
}  // namespace marketgen::render::raytrace
