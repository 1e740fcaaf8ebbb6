// What is seen through clear walls: rows say it, models show it.
#include "assets/contents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "assets/materials/material_texture.h"
#include "assets/print/color.h"
#include "assets/shapes/pack_shape.h"
#include "support/committed_catalog.h"

namespace marketgen::assets {
namespace {

// Shapes with walls that show what is in them, and those that come in dark glass or tin, too.
const std::set<std::string> always_clear{"soda_bottle",
                                         "water_bottle",
                                         "sauce_bottle",
                                         "spirit_bottle",
                                         "squeeze_bottle",
                                         "pump_bottle",
                                         "jar",
                                         "bottle_six_pack"};
const std::set<std::string> clear_or_dark{
    "wine_bottle", "beer_bottle", "oil_bottle", "crate", "jerrycan"};

catalog::Product jar_of(const std::optional<catalog::Contents>& contents) {
  catalog::Product product;
  product.sku = "test-jar";
  product.archetype = "jar";
  product.material = "glass";
  product.size_mm = {70, 70, 100};
  product.contents = contents;
  return product;
}

const Surface& wall_of(const ProductModel& model) {
  return *std::ranges::find_if(model.surfaces, [](const Surface& s) { return s.fill > 0; });
}

bool near_in_color(Vec3f a, Vec3f b, float tolerance) {
  return std::abs(a.x - b.x) <= tolerance && std::abs(a.y - b.y) <= tolerance &&
         std::abs(a.z - b.z) <= tolerance;
}

Vec3f mean_of(const Image& image) {
  Vec3f sum;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* p = image.at(x, y);
      sum += Vec3f{linear_from_srgb(p[0]), linear_from_srgb(p[1]), linear_from_srgb(p[2])};
    }
  }
  return sum / static_cast<float>(image.width * image.height);
}

TEST(Contents, EveryRowOfAClearPackSaysWhatIsSeen) {
  int seen = 0;
  for (const catalog::Product& row : committed_catalog().products) {
    if (row.contents) ++seen;
    if (always_clear.contains(row.archetype)) {
      EXPECT_TRUE(row.contents.has_value()) << row.sku;
    } else if (!clear_or_dark.contains(row.archetype)) {
      EXPECT_FALSE(row.contents.has_value()) << row.sku << ": nobody draws them";
    }
  }
  EXPECT_GE(seen, 400);
}

TEST(Contents, EveryModelHasItsRowsColourLevelAndPieces) {
  for (const catalog::Product& row : committed_catalog().products) {
    if (!row.contents || row.archetype == "crate" || row.archetype == "bottle_six_pack") continue;
    const ProductModel model = make_product_model(row).value();
    const Surface& wall = wall_of(model);
    EXPECT_EQ(wall.refraction > 1, row.contents->opacity == catalog::Opacity::clear) << row.sku;
    EXPECT_EQ(wall.texture == "contents", row.contents->particle_mm > 0) << row.sku;
    float low = 1, high = 0;  // of the clear wall
    for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
      const Surface& surface = model.surfaces[model.mesh.surfaces[t]];
      if (surface.fill <= 0 && !surface.empty) continue;
      for (const std::uint32_t v : model.mesh.triangles[t]) {
        const float z = model.mesh.positions[v].z;
        low = std::min(low, z);
        high = std::max(high, z);
        if (surface.empty) {
          ASSERT_GE(z, model.level_m - 1e-6F) << row.sku;
        } else {
          ASSERT_LE(z, model.level_m + 1e-6F) << row.sku;
        }
      }
    }
    EXPECT_NEAR((model.level_m - low) / (high - low), row.contents->fill, 1e-3) << row.sku;
    if (row.contents->particle_mm > 0) continue;
    EXPECT_TRUE(near_in_color(wall.color, linear_from_hex(row.contents->color).value(), 1e-6F))
        << row.sku;
  }
}

// From afar a wall has one colour, from near a texture: both are the same on average.
TEST(Contents, PiecesAreOnAverageTheColourFromAfar) {
  std::set<std::string> drawn;
  for (const catalog::Product& row : committed_catalog().products) {
    if (!row.contents || row.contents->particle_mm == 0) continue;
    const catalog::MaterialRow material = contents_material(*row.contents);
    if (!drawn.insert(material.id).second) continue;
    const Vec3f mean = mean_of(draw_material(material, 128));
    EXPECT_TRUE(near_in_color(mean, wall_of(make_product_model(row).value()).color, 0.03F))
        << row.sku << " " << mean.x << " " << mean.y << " " << mean.z;
  }
  EXPECT_GE(drawn.size(), 60U);
}

TEST(Contents, PartingKeepsTheOutline) {
  for (const std::string archetype : {"jar", "squeeze_bottle", "soda_bottle", "jerrycan"}) {
    catalog::Product product = jar_of(catalog::Contents{.color = "#8a1030", .fill = 0.7});
    product.archetype = archetype;
    product.size_mm = {90, 60, 200};
    const ProductModel whole = make_pack_shape(product).value();
    const ProductModel parted = make_product_model(product).value();
    EXPECT_TRUE(is_watertight(parted.mesh)) << archetype;
    EXPECT_EQ(bounds_of(whole.mesh).low, bounds_of(parted.mesh).low);
    EXPECT_EQ(bounds_of(whole.mesh).high, bounds_of(parted.mesh).high);
    EXPECT_NEAR(volume_of(parted.mesh), volume_of(whole.mesh), 1e-4 * volume_of(whole.mesh));
  }
}

// How full a jar is seen to be does not change what a hand touches.
TEST(Contents, TheBodyDoesNotDependOnThem) {
  const ProductBody empty = make_product_body(jar_of(std::nullopt)).value();
  const ProductBody full =
      make_product_body(jar_of(catalog::Contents{.color = "#8a1030", .fill = 0.6})).value();
  ASSERT_EQ(empty.pieces.size(), full.pieces.size());
  for (std::size_t i = 0; i < empty.pieces.size(); ++i) {
    EXPECT_EQ(empty.pieces[i].center, full.pieces[i].center);
    EXPECT_EQ(empty.pieces[i].points, full.pieces[i].points);
  }
}

TEST(Contents, AColourThatIsNoneIsNamed) {
  const Result<ProductModel> made = make_product_model(jar_of(catalog::Contents{.color = "plum"}));
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().where, "test-jar/contents/color");
}

}  // namespace
}  // namespace marketgen::assets
