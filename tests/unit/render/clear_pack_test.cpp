// Clear packs: parted at the fill height, the outline as it was.
#include "render/stage/clear_pack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace marketgen::render::raytrace {
namespace {

catalog::Product bottle_of(const std::string& name, const std::string& archetype) {
  catalog::Product product;
  product.sku = "test-bottle";
  product.name = name;
  product.archetype = archetype;
  product.material = "glass";
  product.unit_of_measure = "l";
  product.size_mm = {70, 70, 250};
  return product;
}

assets::ProductModel model_of(const std::string& name, const std::string& archetype) {
  return assets::make_product_model(bottle_of(name, archetype)).value();
}

TEST(ClearPack, WaterOilAndHoneyAreClearKetchupAndMilkAreNot) {
  EXPECT_TRUE(is_clear_pack(model_of("Still Water", "water_bottle")));
  EXPECT_TRUE(is_clear_pack(model_of("Sunflower Oil", "oil_bottle")));
  EXPECT_TRUE(is_clear_pack(model_of("Blossom Honey", "jar")));
  EXPECT_FALSE(is_clear_pack(model_of("Ketchup", "sauce_bottle")));
  EXPECT_FALSE(is_clear_pack(model_of("Strawberry Jam", "jar")));
  EXPECT_FALSE(is_clear_pack(model_of("Extra Virgin Olive Oil", "box")));
}

TEST(ClearPack, CuttingKeepsTheOutline) {
  const assets::ProductModel model = model_of("Still Water", "water_bottle");
  const ClearPack pack = clear_pack(model);
  const Bounds3 before = bounds_of(model.mesh), after = bounds_of(pack.mesh);
  EXPECT_EQ(before.low, after.low);
  EXPECT_EQ(before.high, after.high);
  Mesh outline = pack.mesh;
  outline.triangles.resize(pack.outline_triangles);
  outline.surfaces.resize(pack.outline_triangles);
  EXPECT_TRUE(is_watertight(outline));
  EXPECT_NEAR(volume_of(outline), volume_of(model.mesh), 1e-4 * volume_of(model.mesh));
  double level_area = 0, brim_z = 0;
  for (std::size_t t = pack.outline_triangles; t < pack.mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = pack.mesh.triangles[t];
    const std::vector<Vec3f>& p = pack.mesh.positions;
    level_area += 0.5 * static_cast<double>(cross(p[b] - p[a], p[c] - p[a]).z);
    brim_z = static_cast<double>(p[a].z);
  }
  EXPECT_GT(level_area, 1e-5);  // faces up, all of it
  EXPECT_LT(level_area, 0.07 * 0.07);
  EXPECT_GT(brim_z, 0.15);
  EXPECT_LT(pack.mesh.triangles.size(), model.mesh.triangles.size() * 5 / 4);
}

// The body of liquid is closed: walls and label below the fill height, and its surface.
TEST(ClearPack, LiquidReachesItsSurfaceAndTheSheetStartsThere) {
  const assets::ProductModel model = model_of("Still Water", "water_bottle");
  const ClearPack pack = clear_pack(model);
  float liquid_top = 0, sheet_foot = 1;
  for (std::size_t t = 0; t < pack.mesh.triangles.size(); ++t) {
    const std::uint16_t surface = pack.mesh.surfaces[t];
    const bool sheet = surface >= model.surfaces.size();
    const bool liquid = !sheet && model.surfaces[surface].refraction > 0;
    for (const std::uint32_t v : pack.mesh.triangles[t]) {
      if (liquid) liquid_top = std::max(liquid_top, pack.mesh.positions[v].z);
      if (sheet) sheet_foot = std::min(sheet_foot, pack.mesh.positions[v].z);
    }
  }
  EXPECT_NEAR(liquid_top, sheet_foot, 1e-5F);
  EXPECT_GT(liquid_top, 0.6F * 0.25F);
  EXPECT_LT(liquid_top, 0.25F);
}

TEST(ClearPack, LiquidTakesItsColourOverTwiceTheDepthOfThePack) {
  marketgen::assets::Surface wall{
      .color = {0.5F, 0.25F, 1}, .roughness = 0.1F, .refraction = 1.47F};
  const ClearMaterials made = clear_materials(wall, {.color = wall.color}, 0.07F);
  EXPECT_TRUE(made.liquid.clear);
  EXPECT_TRUE(made.sheet.clear);
  EXPECT_EQ(made.liquid.refraction, 1.47F);
  EXPECT_EQ(made.sheet.refraction, 1);
  EXPECT_NEAR(std::exp(-made.liquid.absorption_per_m.x * 0.14F), 0.5F, 1e-3F);
  EXPECT_NEAR(std::exp(-made.liquid.absorption_per_m.y * 0.14F), 0.25F, 1e-3F);
  EXPECT_GT(made.liquid.absorption_per_m.z, 0);  // nothing is quite clear
}

}  // namespace
}  // namespace marketgen::render::raytrace
