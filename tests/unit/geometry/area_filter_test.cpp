// Means over parts of pictures, against what is reckoned by hand.
#include "geometry/area_filter.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

// A row of pixels with these reds.
Image reds(const std::vector<std::uint8_t>& values) {
  Image picture(static_cast<int>(values.size()), 1);
  for (std::size_t x = 0; x < values.size(); ++x)
    picture.at(static_cast<int>(x), 0)[0] = values[x];
  return picture;
}

TEST(AreaFilter, PixelsCountByTheirCoveredPart) {
  const Image picture = reds({0, 100, 200});
  EXPECT_EQ(area_mean(picture, {0, 0, 3, 1}).r, 100);
  EXPECT_EQ(area_mean(picture, {0, 0, 1.5, 1}).r, 33);  // (0 + 100 / 2) / 1.5
  EXPECT_EQ(area_mean(picture, {0.5, 0, 2, 1}).r, 67);  // (0 / 2 + 100) / 1.5
}

TEST(AreaFilter, ANarrowBoxIsAPixelWide) {
  const Image picture = reds({0, 100, 200});
  EXPECT_EQ(area_mean(picture, {1.5, 0.5, 1.5, 0.5}).r, 100);  // the middle of a pixel
  EXPECT_EQ(area_mean(picture, {1, 0.5, 1, 0.5}).r, 50);       // between two
}

TEST(AreaFilter, APictureGoesOnAtItsBorder) {
  const Image picture = reds({40, 100, 200});
  EXPECT_EQ(area_mean(picture, {-5, -3, -4, 9}).r, 40);
  EXPECT_EQ(area_mean(picture, {7, 0, 9, 1}).r, 200);
  EXPECT_EQ(area_mean(picture, {1e12, 0, 2e12, 1}).r, 200);
}

TEST(AreaFilter, ScalingKeepsTheMean) {
  Image picture(4, 4, 4);  // what a fourth channel says is left out
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x)
      picture.at(x, y)[1] = static_cast<std::uint8_t>(10 * x + 40 * y);
  }
  const Image half = area_scaled(picture, 2, 2);
  EXPECT_EQ(half.channels, 3);
  EXPECT_EQ(half.at(0, 0)[1], 25);
  EXPECT_EQ(half.at(1, 1)[1], 125);
  EXPECT_EQ(area_scaled(picture, 4, 4).at(3, 2)[1], 110);
  EXPECT_EQ(area_scaled(picture, 1, 1).at(0, 0)[1], 75);
  EXPECT_EQ(area_scaled(picture, 0, 0).width, 1);
}

}  // namespace
}  // namespace marketgen
