// Material textures: seamless, in the row's colours, the same for the same row.
#include "assets/material_texture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "assets/texture_field.h"

namespace marketgen {
namespace {

MaterialRow row_of(MaterialPattern pattern) {
  MaterialRow row;
  row.id = "sample-" + std::string(names_of(pattern)[static_cast<std::size_t>(pattern)]);
  row.pattern = pattern;
  row.color = "#c69c6d";
  row.second_color = "#94693d";
  row.period_mm = 300;
  return row;
}

double row_difference(const Image& image, int a, int b) {
  double sum = 0;
  for (int x = 0; x < image.width; ++x) {
    for (int c = 0; c < 3; ++c)
      sum += std::abs(int{image.at(x, a)[c]} - int{image.at(x, b)[c]});
  }
  return sum / (3.0 * image.width);
}

double column_difference(const Image& image, int a, int b) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int c = 0; c < 3; ++c)
      sum += std::abs(int{image.at(a, y)[c]} - int{image.at(b, y)[c]});
  }
  return sum / (3.0 * image.height);
}

class EveryPattern : public testing::TestWithParam<MaterialPattern> {};

TEST_P(EveryPattern,
       IsSeamlessAlongBothAxes) {  // the step over the border is no larger than steps inside
  const Image image = draw_material(row_of(GetParam()), 256);
  ASSERT_EQ(image.width, 256);
  ASSERT_EQ(image.height, 256);
  double widest_column = 0;
  double widest_row = 0;
  for (int i = 1; i < 256; ++i) {
    widest_column = std::max(widest_column, column_difference(image, i - 1, i));
    widest_row = std::max(widest_row, row_difference(image, i - 1, i));
  }
  EXPECT_LE(column_difference(image, 255, 0), widest_column);
  EXPECT_LE(row_difference(image, 255, 0), widest_row);
}

TEST_P(EveryPattern, IsTheSameForTheSameRowAndNearItsColour) {
  const Image image = draw_material(row_of(GetParam()), 128);
  EXPECT_EQ(image.pixels, draw_material(row_of(GetParam()), 128).pixels);
  double red = 0;
  double blue = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    red += image.pixels[i];
    blue += image.pixels[i + 2];
  }
  const double count = static_cast<double>(image.pixels.size()) / 3;
  EXPECT_GT(red / count, 0x94 * 0.85);  // between the two colours, give or take shading
  EXPECT_LT(red / count, 0xc6 * 1.10);
  EXPECT_GT(blue / count, 0x3d * 0.85);
  EXPECT_LT(blue / count, 0x6d * 1.10);
}

INSTANTIATE_TEST_SUITE_P(Material,
                         EveryPattern,
                         testing::Values(MaterialPattern::plain,
                                         MaterialPattern::tiles,
                                         MaterialPattern::planks,
                                         MaterialPattern::terrazzo,
                                         MaterialPattern::brick,
                                         MaterialPattern::concrete,
                                         MaterialPattern::ceiling_grid,
                                         MaterialPattern::brushed),
                         [](const auto& each) {
                           return std::string(
                               names_of(each.param)[static_cast<std::size_t>(each.param)]);
                         });

TEST(MaterialTexture,
     TilesHaveTheirPeriod) {  // grout lies at every multiple of the tile, here 300 of 600 mm
  MaterialRow row = row_of(MaterialPattern::tiles);
  row.color = "#ffffff";
  row.second_color = "#000000";
  EXPECT_DOUBLE_EQ(material_extent_m(row), 0.6);
  const Image image = draw_material(row, 512);
  EXPECT_LT(image.at(100, 256)[0], 60);   // on the joint half way down
  EXPECT_LT(image.at(100, 0)[0], 60);     // and at the border
  EXPECT_GT(image.at(100, 128)[0], 200);  // in the middle of a tile
}

TEST(TextureField, NoiseStaysWithinItsBoundsAboutOneHalf) {
  const TextureField field = noise_field(128, 128, {4, 4, 4, 0.5F}, Seed(7));
  double sum = 0;
  for (const float value : field.values) {
    EXPECT_GE(value, 0.0F);
    EXPECT_LE(value, 1.0F);
    sum += static_cast<double>(value);
  }
  EXPECT_NEAR(sum / static_cast<double>(field.values.size()), 0.5, 0.1);
}

}  // namespace
}  // namespace marketgen
