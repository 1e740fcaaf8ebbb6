// The street outside doors and windows.
#include "render/stage/surroundings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

Surroundings street(float daylight) {
  Surroundings outside;
  outside.white = 250;
  outside.daylight = daylight;
  return outside;
}

// Mean over what a window shows: the ring of directions a little above and below the horizon.
float mean_seen(const Surroundings& outside) {
  float sum = 0;
  int count = 0;
  for (int i = 0; i < 720; ++i) {
    for (int j = -15; j <= 35; ++j, ++count) {
      const float turn = two_pi * static_cast<float>(i) / 720;
      const Vec3f direction{std::cos(turn), std::sin(turn), static_cast<float>(j) * 0.01F};
      sum += luminance(outside.radiance(normalized(direction)));
    }
  }
  return sum / static_cast<float>(count);
}

TEST(Surroundings, LampsOfTheOpeningsStandForWhatIsSeen) {
  for (const float daylight : {0.0F, 0.4F, 1.0F}) {
    const Surroundings outside = street(daylight);
    const float mean = luminance(outside.mean_radiance());
    EXPECT_GT(mean, 0.6F * mean_seen(outside)) << daylight;
    EXPECT_LT(mean, 1.6F * mean_seen(outside)) << daylight;
  }
}

TEST(Surroundings, NightIsFarDarkerThanTheShopAndDayBrighter) {
  EXPECT_LT(mean_seen(street(0)), 0.2F * street(0).white);
  EXPECT_GT(mean_seen(street(1)), 1.2F * street(1).white);
}

TEST(Surroundings, WithoutTheStreetOnlyTheEvenLight) {
  Surroundings outside;
  EXPECT_EQ(outside.radiance({1, 0, 0}).x, 0);
  outside.even = {1, 2, 3};
  EXPECT_EQ(outside.radiance({0, 0, 1}).y, 2);
}

TEST(Surroundings, TheStreetIsOutOfFocusAllRound) {
  constexpr int steps = 3600;
  for (const float rise : {-0.05F, 0.0F, 0.1F}) {
    const auto seen = [&](int i) {
      const float turn = two_pi * static_cast<float>(i) / steps;
      return luminance(street(1).radiance(normalized(Vec3f{std::cos(turn), std::sin(turn), rise})));
    };
    for (int i = 0; i < steps; ++i)  // a tenth of a degree on, next to nothing has changed
      EXPECT_LT(std::fabs(seen(i + 1) - seen(i)), 0.4F * street(1).white) << i;
  }
}

TEST(Surroundings, EveryDirectionHasFiniteLight) {
  for (const float daylight : {0.0F, 1.0F}) {
    for (const Vec3f direction :
         {Vec3f{0, 0, 1}, {0, 0, -1}, {-1, 0, 0}, {-1, -1e-9F, 0}, {1, 0, 0}}) {
      EXPECT_TRUE(is_finite(street(daylight).radiance(direction)));
      EXPECT_GT(luminance(street(daylight).radiance(direction)), 0);
    }
  }
}

}  // namespace
}  // namespace marketgen::render::raytrace
