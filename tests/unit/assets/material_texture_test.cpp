// Material textures: seamless, in the row's colours, the same for the same row.
#include "assets/materials/material_texture.h"
#include "assets/contents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "assets/materials/texture_field.h"
#include "catalog/catalog.h"
#include "image_steps.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

catalog::MaterialRow row_of(catalog::MaterialPattern pattern) {
  catalog::MaterialRow row;
  row.id = "sample-" + std::string(catalog::names_of(pattern)[static_cast<std::size_t>(pattern)]);
  row.pattern = pattern;
  row.color = "#c69c6d";
  row.second_color = "#94693d";
  row.period_mm = 300;
  return row;
}

// The step over the border must be no larger than the steps inside, give or take one step among
// equals.
void expect_seamless(const Image& image, const std::string& what) {
  double widest_column = 0;
  double widest_row = 0;
  for (int i = 1; i < image.width; ++i) {
    widest_column = std::max(widest_column, column_difference(image, i - 1, i));
    widest_row = std::max(widest_row, row_difference(image, i - 1, i));
  }
  const auto most = [](double widest) { return widest * 1.05 + 0.1; };
  EXPECT_LE(column_difference(image, image.width - 1, 0), most(widest_column)) << what;
  EXPECT_LE(row_difference(image, image.width - 1, 0), most(widest_row)) << what;
}

class EveryPattern : public testing::TestWithParam<catalog::MaterialPattern> {};

TEST_P(EveryPattern, IsSeamlessAlongBothAxes) {
  const assets::MaterialMaps maps = assets::draw_material_maps(row_of(GetParam()), 256);
  ASSERT_EQ(maps.base_color.width, 256);
  ASSERT_EQ(maps.base_color.height, 256);
  expect_seamless(maps.base_color, "colour");
  expect_seamless(maps.normal, "normal");
  expect_seamless(maps.roughness, "roughness");
}

TEST_P(EveryPattern, IsTheSameForTheSameRowAndNearItsColour) {
  const Image image = assets::draw_material(row_of(GetParam()), 128);
  const assets::MaterialMaps maps = assets::draw_material_maps(row_of(GetParam()), 128);
  EXPECT_EQ(image.pixels, maps.base_color.pixels);
  EXPECT_EQ(maps.normal.pixels, assets::draw_material_maps(row_of(GetParam()), 128).normal.pixels);
  double red = 0;
  double blue = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    red += image.pixels[i];
    blue += image.pixels[i + 2];
  }
  const double count = static_cast<double>(image.pixels.size()) / 3;
  EXPECT_GT(red / count, 0x94 * 0.75);  // between the two colours, give or take shading
  EXPECT_LT(red / count, 0xc6 * 1.10);
  EXPECT_GT(blue / count, 0x3d * 0.75);
  EXPECT_LT(blue / count, 0x6d * 1.10);
}

TEST_P(EveryPattern, HasUnitNormalsThatMostlyFaceOut) {
  const Image normal = assets::draw_material_maps(row_of(GetParam()), 128).normal;
  double mean_z = 0;
  for (std::size_t i = 0; i < normal.pixels.size(); i += 3) {
    const auto axis = [&](std::size_t k) { return normal.pixels[i + k] / 127.5 - 1; };
    const double length = std::sqrt(axis(0) * axis(0) + axis(1) * axis(1) + axis(2) * axis(2));
    ASSERT_NEAR(length, 1, 0.02);  // a byte is within 0.004 on each axis
    ASSERT_GT(axis(2), 0.5);
    mean_z += axis(2);
  }
  EXPECT_GT(mean_z / (128 * 128), 0.7);
}

std::vector<catalog::MaterialPattern> all_patterns() {
  std::vector<catalog::MaterialPattern> patterns;
  for (std::size_t i = 0; i < catalog::names_of(catalog::MaterialPattern{}).size(); ++i)
    patterns.push_back(static_cast<catalog::MaterialPattern>(i));
  return patterns;
}

INSTANTIATE_TEST_SUITE_P(Material,
                         EveryPattern,
                         testing::ValuesIn(all_patterns()),
                         [](const auto& each) { return std::string(name_of(each.param)); });

// How often the texture's row `y` goes from below `level` to above it, round the border.
int rises_in_row(const Image& image, int y, int level) {
  int rises = 0;
  for (int x = 0; x < image.width; ++x) {
    const int before = image.at((x + image.width - 1) % image.width, y)[0];
    rises += before < level && image.at(x, y)[0] >= level ? 1 : 0;
  }
  return rises;
}

int rises_in_column(const Image& image, int x, int level) {
  int rises = 0;
  for (int y = 0; y < image.height; ++y) {
    const int before = image.at(x, (y + image.height - 1) % image.height)[0];
    rises += before < level && image.at(x, y)[0] >= level ? 1 : 0;
  }
  return rises;
}

catalog::MaterialRow white_on_black(catalog::MaterialPattern pattern, int period_mm) {
  catalog::MaterialRow row = row_of(pattern);
  row.color = "#f0f0f0";
  row.second_color = "#303030";
  row.period_mm = period_mm;
  row.roughness = 0.1;  // glazed: the bricks hardly differ
  return row;
}

// Pieces are counted across their joints: the metric period is the extent over that count.
TEST(MaterialTexture, PiecesHaveTheirPeriod) {
  struct Case {
    catalog::MaterialPattern pattern;
    int period_mm, pieces, row;  // along texture row `row` of 512
  };
  for (const Case& c : {Case{catalog::MaterialPattern::hex_tiles, 200, 7, 32},
                        Case{catalog::MaterialPattern::mosaic, 50, 16, 16},
                        Case{catalog::MaterialPattern::brick_stack, 250, 4, 18},
                        Case{catalog::MaterialPattern::brick_english, 250, 4, 18},
                        Case{catalog::MaterialPattern::glazed_tiles, 100, 4, 64},
                        Case{catalog::MaterialPattern::perforated, 25, 8, 32}}) {
    const catalog::MaterialRow row = white_on_black(c.pattern, c.period_mm);
    const Image image = assets::draw_material(row, 512);
    EXPECT_EQ(rises_in_row(image, c.row, 0x90), c.pieces) << name_of(c.pattern);
    const int per_period = c.pattern == catalog::MaterialPattern::mosaic ? 2 : 1;
    EXPECT_NEAR(assets::material_extent_m(row) * 1000 / c.pieces * per_period, c.period_mm, 1e-9)
        << name_of(c.pattern);
  }
}

TEST(MaterialTexture, EnglishBondLaysHeadersBetweenStretchers) {  // 8 headers over 4 stretchers
  const Image image =
      assets::draw_material(white_on_black(catalog::MaterialPattern::brick_english, 250), 512);
  EXPECT_EQ(rises_in_row(image, 512 / 14 / 2, 0x90), 4);
  EXPECT_EQ(rises_in_row(image, 512 / 14 * 3 / 2, 0x90), 8);
}

TEST(MaterialTexture, FlemishBondLaysBothInOneCourse) {  // 4 pairs of a stretcher and a header
  const Image image =
      assets::draw_material(white_on_black(catalog::MaterialPattern::brick_flemish, 375), 512);
  EXPECT_EQ(rises_in_row(image, 512 / 20 / 2, 0x90), 8);
}

TEST(MaterialTexture, BrickCoursesAre75Millimetres) {
  const catalog::MaterialRow row = white_on_black(catalog::MaterialPattern::brick_flemish, 375);
  const Image image = assets::draw_material(row, 512);
  EXPECT_EQ(rises_in_column(image, 50, 0x90), 20);  // 1500 mm
}

TEST(MaterialTexture,
     JointsLieBelowTheTiles) {  // the tile's edge falls towards the joint beside it
  catalog::MaterialRow row = row_of(catalog::MaterialPattern::tiles);
  row.period_mm = 100;
  const Image normal =
      assets::draw_material_maps(row, 512).normal;  // 0.39 mm a texel, joint at column 256
  EXPECT_GT(normal.at(253, 128)[0], 160);           // left of it the surface falls to the right
  EXPECT_LT(normal.at(258, 128)[0], 95);
  EXPECT_LT(normal.at(128, 253)[1], 95);  // above it the surface falls to the picture's bottom
  EXPECT_GT(normal.at(128, 258)[1], 160);
}

TEST(MaterialTexture, JointsAreRougherThanTheGlaze) {
  catalog::MaterialRow row = row_of(catalog::MaterialPattern::tiles);
  row.roughness = 0.2;
  const Image roughness = assets::draw_material_maps(row, 512).roughness;
  EXPECT_GT(*roughness.at(256, 128), 180);  // mortar, 0.85
  EXPECT_NEAR(*roughness.at(128, 128), 51, 20);
}

TEST(MaterialTexture, WithoutReliefNormalsPointStraightOut) {
  catalog::MaterialRow row = row_of(catalog::MaterialPattern::brick);
  row.relief = 0;
  const Image normal = assets::draw_material_maps(row, 64).normal;
  for (std::size_t i = 0; i < normal.pixels.size(); i += 3) {
    ASSERT_EQ(normal.pixels[i], 128);
    ASSERT_EQ(normal.pixels[i + 1], 128);
    ASSERT_EQ(normal.pixels[i + 2], 255);
  }
}

TEST(MaterialTexture, HolesInMetalAreNoMetal) {
  catalog::MaterialRow row = row_of(catalog::MaterialPattern::perforated);
  row.metallic = 1;
  const Image metallic = assets::draw_material_maps(row, 512).metallic;
  EXPECT_EQ(*metallic.at(32, 32), 0);  // holes stand in the middle of 64-texel cells
  EXPECT_EQ(*metallic.at(2, 2), 255);
}

TEST(MaterialTexture, CommittedRowsReflectWhatRealSurfacesDo) {
  const catalog::Catalog& catalog = committed_catalog();
  EXPECT_GE(catalog.materials.size(), 80U);
  std::set<catalog::MaterialPattern> used;
  for (const catalog::MaterialRow& row : catalog.materials) {
    used.insert(row.pattern);
    const Image image = assets::draw_material(row, 64);
    // sRGB 39 and 243 are albedo 0.02 and 0.9.
    const auto [darkest, whitest] = std::minmax_element(image.pixels.begin(), image.pixels.end());
    EXPECT_GE(*darkest, 39) << row.id;
    EXPECT_LE(*whitest, 243) << row.id;
    EXPECT_TRUE(row.metallic == 0 || row.metallic == 1) << row.id << ": half a metal";
  }
  for (const catalog::Product& product : catalog.products) {
    if (product.contents && product.contents->particle_mm > 0)
      used.insert(assets::contents_material(*product.contents).pattern);
  }
  EXPECT_EQ(used.size(), catalog::names_of(catalog::MaterialPattern{}).size())
      << "a pattern that no row shows";
}

TEST(MaterialTexture,
     TilesHaveTheirPeriod) {  // grout lies at every multiple of the tile, here 300 of 600 mm
  catalog::MaterialRow row = row_of(catalog::MaterialPattern::tiles);
  row.color = "#f0f0f0";
  row.second_color = "#202020";
  EXPECT_DOUBLE_EQ(assets::material_extent_m(row), 0.6);
  const Image image = assets::draw_material(row, 512);
  EXPECT_LT(image.at(100, 256)[0], 60);   // on the joint half way down
  EXPECT_LT(image.at(100, 0)[0], 60);     // and at the border
  EXPECT_GT(image.at(100, 128)[0], 200);  // in the middle of a tile
}

TEST(TextureField, NoiseStaysWithinItsBoundsAboutOneHalf) {
  const assets::TextureField field = assets::noise_field(128, 128, {4, 4, 4, 0.5F}, Seed(7));
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
