// Clear packs: walls parted at the level of the contents, the outline as it was.
#include "render/stage/clear_pack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace marketgen::render::raytrace {
namespace {

catalog::Product bottle_of(const std::optional<catalog::Contents>& contents,
                           const std::string& archetype) {
  catalog::Product product;
  product.sku = "test-bottle";
  product.archetype = archetype;
  product.material = "glass";
  product.unit_of_measure = "l";
  product.size_mm = {70, 70, 250};
  product.contents = contents;
  return product;
}

assets::ProductModel model_of(const std::optional<catalog::Contents>& contents) {
  return assets::make_product_model(bottle_of(contents, "water_bottle")).value();
}

const catalog::Contents water{
    .color = "#d6e6ea", .opacity = catalog::Opacity::clear, .refraction = 1.33, .fill = 0.9};

// What lies in the level, and faces up.
struct Level {
  double area = 0, z = 0;
};
Level level_of(const Mesh& mesh, std::size_t first_triangle) {
  Level level;
  const std::vector<Vec3f>& p = mesh.positions;
  for (std::size_t t = first_triangle; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    level.area += 0.5 * static_cast<double>(cross(p[b] - p[a], p[c] - p[a]).z);
    level.z = static_cast<double>(p[a].z);
  }
  return level;
}

TEST(ClearPack, TheLevelLiesBehindTheOutline) {
  const assets::ProductModel model = model_of(water);
  const Mesh mesh = with_level(model);
  const Bounds3 before = bounds_of(model.mesh), after = bounds_of(mesh);
  EXPECT_EQ(before.low, after.low);
  EXPECT_EQ(before.high, after.high);
  ASSERT_GT(mesh.triangles.size(), model.mesh.triangles.size());
  for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t)
    ASSERT_EQ(mesh.triangles[t], model.mesh.triangles[t]);
  const Level level = level_of(mesh, model.mesh.triangles.size());
  EXPECT_GT(level.area, 1e-5);
  EXPECT_LT(level.area, 0.07 * 0.07);
  EXPECT_NEAR(level.z, static_cast<double>(model.level_m), 1e-6);
}

// A cylinder of the level's area and of the wall's width there: nothing of the rim is missing.
TEST(ClearPack, TheLevelOfAJarIsItsWholeCrossSection) {
  catalog::Contents jam{.color = "#8a1030", .fill = 0.8};
  const assets::ProductModel model = assets::make_product_model(bottle_of(jam, "jar")).value();
  const Mesh mesh = with_level(model);
  float radius = 0;
  for (const Vec3f& p : model.mesh.positions) {
    if (std::abs(p.z - model.level_m) < 1e-6F) radius = std::max(radius, std::hypot(p.x, p.y));
  }
  ASSERT_GT(radius, 0.02F);
  const double round = 3.14159 * static_cast<double>(radius) * static_cast<double>(radius);
  EXPECT_NEAR(level_of(mesh, model.mesh.triangles.size()).area, round, 0.03 * round);
}

TEST(ClearPack, WhatShowsNothingIsLeftAlone) {
  const assets::ProductModel model = model_of(std::nullopt);
  EXPECT_EQ(model.level_m, 0);
  EXPECT_EQ(with_level(model).triangles, model.mesh.triangles);
}

TEST(ClearPack, LiquidTakesItsColourOverTwiceTheDepthOfThePack) {
  const marketgen::assets::Surface wall{
      .color = {0.5F, 0.25F, 1}, .roughness = 0.1F, .refraction = 1.47F};
  const Material liquid = liquid_material(wall, {.color = wall.color}, 0.07F);
  EXPECT_TRUE(liquid.clear);
  EXPECT_EQ(liquid.refraction, 1.47F);
  EXPECT_NEAR(std::exp(-liquid.absorption_per_m.x * 0.14F), 0.5F, 1e-3F);
  EXPECT_NEAR(std::exp(-liquid.absorption_per_m.y * 0.14F), 0.25F, 1e-3F);
  EXPECT_GT(liquid.absorption_per_m.z, 0);  // nothing is quite clear
  const Material sheet = sheet_material({.color = wall.color});
  EXPECT_TRUE(sheet.clear);
  EXPECT_EQ(sheet.refraction, 1);
}

}  // namespace
}  // namespace marketgen::render::raytrace
