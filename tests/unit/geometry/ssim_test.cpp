#include "geometry/ssim.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace marketgen {
namespace {

Image grey(int width, int height, const auto& value) {
  Image image(width, height, 1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      *image.at(x, y) = static_cast<std::uint8_t>(value(x, y));
  return image;
}

// Deterministic noise in 0..n-1.
int noise(int x, int y, int n) {
  auto h =
      static_cast<std::uint32_t>(x) * 0x9E3779B9U ^ static_cast<std::uint32_t>(y) * 0x85EBCA6BU;
  h = (h ^ h >> 15) * 0x2C1B3C6DU;
  return static_cast<int>((h ^ h >> 13) % static_cast<std::uint32_t>(n));
}

Image stripes() {
  return grey(48, 40, [](int x, int) { return x / 4 % 2 == 0 ? 60 : 180; });
}

TEST(Ssim, IsOneForTheSamePicture) {
  EXPECT_DOUBLE_EQ(ssim(stripes(), stripes()), 1);
}

TEST(Ssim, OfFlatPicturesIsTheirLuminanceTerm) {  // (2ab + C1) / (a^2 + b^2 + C1), C1 = 2.55^2
  const Image a = grey(32, 32, [](int, int) { return 100; });
  const Image b = grey(32, 32, [](int, int) { return 150; });
  EXPECT_NEAR(ssim(a, b), (30000 + 6.5025) / (32500 + 6.5025), 1e-9);
}

// Against noise of equal variance and no correlation, 2 cov + C2 is C2 alone on average.
TEST(Ssim, OfUnrelatedNoiseIsNearZero) {
  const Image a = grey(96, 96, [](int x, int y) { return noise(x, y, 256); });
  const Image b = grey(96, 96, [](int x, int y) { return noise(x + 500, y, 256); });
  EXPECT_NEAR(ssim(a, b), 0, 0.03);
}

TEST(Ssim, OfANegativeIsNegative) {
  const Image a = stripes();
  Image negative = a;
  for (std::uint8_t& value : negative.pixels)
    value = static_cast<std::uint8_t>(240 - value);
  EXPECT_LT(ssim(a, negative), -0.8);
}

TEST(Ssim, FallsWithNoiseAndIsSymmetric) {
  const auto noisy = [](int amount) {
    return grey(48, 40, [&](int x, int y) {
      return (x / 4 % 2 == 0 ? 60 : 180) + noise(x, y, amount) - amount / 2;
    });
  };
  const double little = ssim(stripes(), noisy(10)), much = ssim(stripes(), noisy(60));
  EXPECT_GT(little, much);
  EXPECT_GT(little, 0.95);
  EXPECT_DOUBLE_EQ(much, ssim(noisy(60), stripes()));
}

TEST(Ssim, ReadsColourAsLuma) {  // BT.601: pure blue is 0.114 of white
  Image blue(16, 16), black(16, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      blue.at(x, y)[2] = 255;
  const double luma = 0.114 * 255;
  EXPECT_NEAR(ssim(blue, black), 6.5025 / (luma * luma + 6.5025), 1e-9);
}

TEST(Ssim, TakesPicturesSmallerThanItsWindow) {
  const Image a = grey(4, 3, [](int x, int) { return 40 * x; });
  EXPECT_DOUBLE_EQ(ssim(a, a), 1);
  EXPECT_LT(ssim(a, grey(4, 3, [](int, int) { return 60; })), 0.5);
}

}  // namespace
}  // namespace marketgen
