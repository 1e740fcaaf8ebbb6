// Conformance of every container shape of archetypes.inc, over ordinary and awkward proportions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "assets/print/label_sheet.h"
#include "assets/product_model.h"
#include "sample_produce.h"

namespace marketgen {
namespace {

// Each archetype is one instanced mesh a SKU: a pack in the hand may spend 3,000 triangles, a pack
// of packs 8,000. What grew has no flat faces: 4,000, a bunch 10,000.
std::size_t max_triangles(std::string_view archetype) {
  for (const ProduceRow& row : produce_rows) {
    if (row.archetype == archetype) return row.bunch ? 10000 : 4000;
  }
  constexpr std::string_view packs_of_packs[] = {
      "can_six_pack", "bottle_six_pack", "crate", "roll_pack", "net_bag"};
  const bool many = std::find(std::begin(packs_of_packs), std::end(packs_of_packs), archetype) !=
                    std::end(packs_of_packs);
  return many ? 8000 : 3000;
}

catalog::Product product_of(std::string_view archetype, std::array<int, 3> size_mm) {
  catalog::Product product;
  product.sku = "test-" + std::string(archetype);
  product.archetype = archetype;
  product.size_mm = size_mm;
  product.name = "Test";
  return product;
}

constexpr std::array<int, 3> proportions[] = {
    {66, 66, 115},    // a can
    {75, 75, 300},    // tall and round
    {190, 60, 290},   // a cereal box
    {300, 300, 40},   // flat
    {200, 50, 45},    // lying
    {120, 260, 115},  // lying lengthwise
    {15, 12, 20},     // tiny
    {600, 400, 500},  // huge
    {70, 64, 180},    // nearly round
    {40, 40, 400},    // a stick
};

assets::ProductModel model_of(const catalog::Product& product) {
  Result<assets::ProductModel> model = assets::make_product_model(product);
  EXPECT_TRUE(model.ok()) << to_string(model.error());
  return std::move(model).value();
}

Vec3 scaled_normal(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const Vec3 a = to_double(mesh.positions[t[0]]);
  return cross(to_double(mesh.positions[t[1]]) - a, to_double(mesh.positions[t[2]]) - a);
}

double uv_area(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const Vec2f a = mesh.uvs[t[0]], b = mesh.uvs[t[1]] - a, c = mesh.uvs[t[2]] - a;
  return 0.5 * (static_cast<double>(b.x) * c.y - static_cast<double>(b.y) * c.x);
}

double volume_of(const assets::CollisionPrimitive& p) {
  const double box = 8.0 * p.half_size.x * p.half_size.y * p.half_size.z;
  if (p.shape == assets::CollisionShape::cylinder) return box * std::numbers::pi / 4;
  return p.shape == assets::CollisionShape::ellipsoid ? box * std::numbers::pi / 6 : box;
}

class Archetypes : public testing::TestWithParam<assets::ArchetypeInfo> {};

std::string name_of_case(const testing::TestParamInfo<assets::ArchetypeInfo>& info) {
  return std::string(info.param.name);
}

INSTANTIATE_TEST_SUITE_P(All, Archetypes, testing::ValuesIn(assets::archetypes()), name_of_case);

TEST_P(Archetypes, ClosedOfTheRowsSizeAndSmall) {
  for (const auto& size : proportions) {
    const Mesh mesh = model_of(product_of(GetParam().name, size)).mesh;
    SCOPED_TRACE(testing::PrintToString(size));
    EXPECT_TRUE(is_watertight(mesh));
    EXPECT_GT(marketgen::volume_of(mesh), 0.0);
    const Bounds3 bounds = bounds_of(mesh);
    EXPECT_NEAR(bounds.size().x, size[0] * 1e-3, 1e-3);
    EXPECT_NEAR(bounds.size().y, size[1] * 1e-3, 1e-3);
    EXPECT_NEAR(bounds.size().z, size[2] * 1e-3, 1e-3);
    EXPECT_NEAR(bounds.low.z, 0, 1e-4);
    EXPECT_NEAR(bounds.center().x, 0, 1e-4);
    EXPECT_NEAR(bounds.center().y, 0, 1e-4);
    EXPECT_LE(mesh.triangles.size(), max_triangles(GetParam().name));
  }
}

TEST_P(Archetypes, NormalsAreUnitAndFaceOutwards) {
  for (const auto& size : proportions) {
    const Mesh mesh = model_of(product_of(GetParam().name, size)).mesh;
    SCOPED_TRACE(testing::PrintToString(size));
    for (const Vec3f n : mesh.normals)
      ASSERT_NEAR(length(n), 1.0F, 1e-4F);
    for (const auto& triangle : mesh.triangles) {
      const Vec3 face = normalized(scaled_normal(mesh, triangle));
      for (const std::uint32_t v : triangle)
        ASSERT_GT(dot(to_double(mesh.normals[v]), face), 0.0);
    }
  }
}

TEST_P(Archetypes, PrintIsOnTheSheetAndNeverMirrored) {
  for (const auto& size : proportions) {
    const assets::ProductModel model = model_of(product_of(GetParam().name, size));
    SCOPED_TRACE(testing::PrintToString(size));
    for (const Vec2f uv : model.mesh.uvs) {
      ASSERT_GE(std::min(uv.x, uv.y), -1e-5F);
      ASSERT_LE(std::max(uv.x, uv.y), 1.0F + 1e-5F);
    }
    for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
      if (model.surfaces[model.mesh.surfaces[t]].texture != "label") continue;
      ASSERT_LE(uv_area(model.mesh, model.mesh.triangles[t]),
                1e-6);  // v runs down: upright print turns clockwise
    }
  }
}

TEST_P(Archetypes, EveryPrintedTriangleLiesInOnePanel) {
  const catalog::Product product = product_of(GetParam().name, {75, 70, 180});
  const assets::ProductModel model = model_of(product);
  const std::vector<assets::Panel> panels = assets::panels_of(product).value();
  const auto inside = [](const assets::Panel& p, Vec2f uv) {
    return uv.x >= p.u0 - 1e-4F && uv.x <= p.u1 + 1e-4F && uv.y >= p.v0 - 1e-4F &&
           uv.y <= p.v1 + 1e-4F;
  };
  for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
    if (model.surfaces[model.mesh.surfaces[t]].texture != "label") continue;
    const auto& triangle = model.mesh.triangles[t];
    EXPECT_TRUE(std::any_of(panels.begin(),
                            panels.end(),
                            [&](const assets::Panel& panel) {
                              return std::all_of(
                                  triangle.begin(), triangle.end(), [&](std::uint32_t v) {
                                    return inside(panel, model.mesh.uvs[v]);
                                  });
                            }))
        << "triangle " << t;
  }
}

TEST_P(Archetypes, SurfacesAreValidAndAllUsed) {
  const assets::ProductModel model = model_of(product_of(GetParam().name, {75, 70, 180}));
  std::set<std::uint16_t> used(model.mesh.surfaces.begin(), model.mesh.surfaces.end());
  EXPECT_EQ(used.size(), model.surfaces.size());
  EXPECT_EQ(*used.rbegin() + 1U, model.surfaces.size());
  bool printed = false;
  for (const assets::Surface& surface : model.surfaces) {
    printed = printed || surface.texture == "label";
    EXPECT_TRUE(surface.texture.empty() || surface.texture == "label");
    for (const float value :
         {surface.color.x, surface.color.y, surface.color.z, surface.roughness, surface.metallic}) {
      EXPECT_GE(value, 0.0F);
      EXPECT_LE(value, 1.0F);
    }
    EXPECT_GT(surface.roughness, 0.0F);
  }
  EXPECT_TRUE(printed);
}

TEST_P(Archetypes, CollisionStandsInTheFootprintAndHoldsTheMesh) {
  for (const auto& size : proportions) {
    const catalog::Product product = product_of(GetParam().name, size);
    const assets::ProductModel model = model_of(product);
    const assets::CollisionPrimitive& p = model.collision;
    SCOPED_TRACE(testing::PrintToString(size));
    const Vec3f extent = p.lying ? Vec3f{p.half_size.z, p.half_size.y, p.half_size.x} : p.half_size;
    EXPECT_GT(std::min({extent.x, extent.y, extent.z}), 0.0F);
    EXPECT_NEAR(p.center.z - extent.z, 0.0F, 1e-6F);
    EXPECT_LE(p.center.z + extent.z, size[2] * 1e-3 + 1e-6);
    EXPECT_LE(std::abs(p.center.x) + extent.x, size[0] * 0.5e-3 + 1e-6);
    EXPECT_LE(std::abs(p.center.y) + extent.y, size[1] * 0.5e-3 + 1e-6);
    // A fruit's shoulders and a head's leaves may stand out of their ellipsoid by a fifth.
    EXPECT_GE(volume_of(p), 0.8 * marketgen::volume_of(model.mesh));
    const Result<assets::CollisionPrimitive> alone = assets::collision_of(product);
    ASSERT_TRUE(alone.ok());
    EXPECT_EQ(alone.value().shape, p.shape);
    EXPECT_EQ(alone.value().half_size, p.half_size);
  }
}

TEST_P(Archetypes, HasADescriptionAndASheet) {
  EXPECT_FALSE(GetParam().description.empty());
  EXPECT_TRUE(assets::sheet_kind_of(GetParam().name).ok());
}

// How much of the primitive a pack fills, where a primitive can do it well.
struct FillCase {
  std::string_view archetype;
  std::array<int, 3> size_mm;
  double tolerance;
  std::string_view motif = "none";
};

TEST(ArchetypeShapes, PrimitivesHaveAboutTheVolumeOfThePack) {
  const FillCase cases[] = {
      {"can", {66, 66, 115}, 0.06},
      {"food_tin", {75, 75, 110}, 0.06},
      {"box", {190, 60, 290}, 0.05},
      {"brick_carton", {75, 60, 200}, 0.07},
      {"gable_carton", {70, 70, 235}, 0.15},
      {"jar", {70, 70, 120}, 0.15},
      {"bundle", {440, 110, 200}, 0.20},
      {"paper_bag", {100, 65, 180}, 0.20},
      {"round_produce", {78, 78, 74}, 0.15, "apple"},
      {"round_produce", {75, 75, 58}, 0.15, "tomato"},
  };
  for (const FillCase& c : cases) {
    catalog::Product product = product_of(c.archetype, c.size_mm);
    product.label.motif = c.motif;
    const assets::ProductModel model = model_of(product);
    const double ratio = marketgen::volume_of(model.mesh) / volume_of(model.collision);
    EXPECT_NEAR(ratio, 1.0, c.tolerance) << c.archetype << " " << c.motif;
  }
}

// Area on the pack against area on the sheet: 1 where print is as large as it was drawn.
TEST(ArchetypeShapes, PrintIsNotStretched) {
  const std::map<std::string_view, std::array<int, 3>> packs{{"can", {66, 66, 115}},
                                                             {"food_tin", {75, 75, 110}},
                                                             {"soda_bottle", {88, 88, 330}},
                                                             {"water_bottle", {85, 85, 320}},
                                                             {"wine_bottle", {75, 75, 300}},
                                                             {"beer_bottle", {61, 61, 230}},
                                                             {"sauce_bottle", {75, 50, 190}},
                                                             {"flask", {75, 45, 210}},
                                                             {"gable_carton", {70, 70, 235}},
                                                             {"brick_carton", {75, 60, 200}},
                                                             {"box", {190, 60, 290}},
                                                             {"jar", {70, 70, 120}},
                                                             {"tub", {140, 95, 65}},
                                                             {"pouch", {140, 70, 210}},
                                                             {"pillow_bag", {180, 80, 260}},
                                                             {"paper_bag", {100, 65, 180}},
                                                             {"tray", {200, 150, 50}},
                                                             {"loaf", {260, 110, 115}},
                                                             {"bundle", {440, 110, 200}},
                                                             {"tube", {55, 38, 165}},
                                                             {"slim_can", {53, 53, 134}},
                                                             {"flat_tin", {85, 85, 35}},
                                                             {"sardine_tin", {105, 60, 22}},
                                                             {"round_tin", {190, 190, 60}},
                                                             {"canister", {75, 75, 240}},
                                                             {"spirit_bottle", {80, 80, 260}},
                                                             {"oil_bottle", {70, 70, 290}},
                                                             {"squeeze_bottle", {75, 50, 190}},
                                                             {"milk_jug", {115, 115, 245}},
                                                             {"jerrycan", {190, 150, 330}},
                                                             {"detergent_bottle", {200, 95, 290}},
                                                             {"spray_bottle", {100, 60, 270}},
                                                             {"pump_bottle", {70, 60, 190}},
                                                             {"aerosol", {50, 50, 190}},
                                                             {"stick", {60, 35, 120}},
                                                             {"cream_jar", {70, 70, 50}},
                                                             {"yogurt_cup", {68, 68, 80}},
                                                             {"flow_pack", {130, 40, 20}},
                                                             {"vacuum_pack", {160, 20, 220}},
                                                             {"chub", {200, 60, 60}},
                                                             {"meat_tray", {185, 140, 55}},
                                                             {"cheese_wedge", {120, 80, 40}},
                                                             {"foil_brick", {100, 65, 35}},
                                                             {"egg_box", {245, 105, 70}},
                                                             {"net_bag", {180, 120, 260}},
                                                             {"can_six_pack", {200, 133, 122}},
                                                             {"bottle_six_pack", {270, 180, 320}},
                                                             {"crate", {400, 300, 290}},
                                                             {"roll_pack", {330, 220, 240}},
                                                             {"blister", {90, 30, 180}},
                                                             {"sachet", {100, 12, 140}},
                                                             {"soft_pack", {200, 110, 70}},
                                                             {"baguette_bag", {90, 70, 560}}};
  for (const auto& [archetype, size] : packs) {
    const catalog::Product product = product_of(archetype, size);
    const assets::ProductModel model = model_of(product);
    const assets::SheetSize sheet = assets::sheet_size_of(product).value();
    double on_pack = 0, on_sheet = 0;
    for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
      if (model.surfaces[model.mesh.surfaces[t]].texture != "label") continue;
      on_pack += length(scaled_normal(model.mesh, model.mesh.triangles[t])) / 2;
      on_sheet -= uv_area(model.mesh, model.mesh.triangles[t]) * sheet.width_m * sheet.height_m;
    }
    EXPECT_NEAR(on_pack / on_sheet, 1.0, 0.2) << archetype;
  }
}

TEST(ArchetypeShapes, TheMiddleOfARoundLabelFacesTheShopper) {
  const assets::ProductModel can = model_of(product_of("can", {66, 66, 115}));
  int found = 0;
  for (std::size_t t = 0; t < can.mesh.triangles.size(); ++t) {
    if (can.surfaces[can.mesh.surfaces[t]].texture != "label") continue;
    for (const std::uint32_t v : can.mesh.triangles[t]) {
      if (std::abs(can.mesh.uvs[v].x - 0.5F) > 1e-5F) continue;
      ++found;
      EXPECT_NEAR(can.mesh.positions[v].x, 0.0F, 1e-5F);
      EXPECT_NEAR(can.mesh.positions[v].y, -0.033F, 1e-4F);
    }
  }
  EXPECT_GT(found, 0);
}

TEST(ArchetypeShapes, SameRowSameMesh) {
  for (const assets::ArchetypeInfo& info : assets::archetypes()) {
    const catalog::Product product = product_of(info.name, {80, 70, 150});
    const assets::ProductModel one = model_of(product), two = model_of(product);
    EXPECT_EQ(one.mesh.positions, two.mesh.positions) << info.name;
    EXPECT_EQ(one.mesh.triangles, two.mesh.triangles) << info.name;
  }
}

TEST(ArchetypeErrors, AnUnknownShapeNamesTheNearest) {
  const Result<assets::ProductModel> model =
      assets::make_product_model(product_of("soda_botle", {80, 80, 300}));
  ASSERT_FALSE(model.ok());
  EXPECT_EQ(model.error().code, "catalog.unknown_kind");
  EXPECT_NE(model.error().message.find("soda_bottle"), std::string::npos) << model.error().message;
  EXPECT_FALSE(assets::collision_of(product_of("kan", {80, 80, 300})).ok());
  EXPECT_FALSE(assets::panels_of(product_of("kan", {80, 80, 300})).ok());
}

TEST(ArchetypeErrors, SizesAndColoursThatCannotBeBuilt) {
  const Result<assets::ProductModel> flat =
      assets::make_product_model(product_of("box", {80, 0, 300}));
  ASSERT_FALSE(flat.ok());
  EXPECT_EQ(flat.error().code, "assets.bad_row");
  EXPECT_EQ(flat.error().where, "test-box/size_mm");
  EXPECT_FALSE(assets::make_product_model(product_of("box", {80, 80, 30000})).ok());
  catalog::Product cap = product_of("soda_bottle", {80, 80, 300});
  cap.label.accent = "crimson";
  const Result<assets::ProductModel> painted = assets::make_product_model(cap);
  ASSERT_FALSE(painted.ok());
  EXPECT_EQ(painted.error().code, "assets.bad_row");
  EXPECT_EQ(painted.error().where, "test-soda_bottle/label/accent");
}

}  // namespace
}  // namespace marketgen
