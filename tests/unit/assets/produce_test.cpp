// What grows or is baked: closed, true to size, each piece its own, with a skin that is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <set>

#include "assets/print/label.h"
#include "assets/product_model.h"
#include "sample_produce.h"

namespace marketgen {
namespace {

const ProduceRow& row_named(std::string_view name) {
  return *std::find_if(std::begin(produce_rows), std::end(produce_rows), [&](const ProduceRow& r) {
    return r.name == name;
  });
}

Mesh mesh_of(const catalog::Product& product) {
  return assets::make_product_model(product).value().mesh;
}

double volume_share(std::string_view name, double of_m3) {
  return volume_of(mesh_of(product_of(row_named(name)))) / of_m3;
}

constexpr double ellipsoid_share = std::numbers::pi / 6;  // of its box

TEST(Produce, EveryShapeIsClosedOfItsSizeAndWithinItsTriangles) {
  for (const ProduceRow& row : produce_rows) {
    SCOPED_TRACE(row.name);
    const Mesh mesh = mesh_of(product_of(row));
    EXPECT_TRUE(is_watertight(mesh));
    const Vec3f size = bounds_of(mesh).size();
    EXPECT_NEAR(size.x, row.size_mm[0] * 1e-3, 1e-3);
    EXPECT_NEAR(size.y, row.size_mm[1] * 1e-3, 1e-3);
    EXPECT_NEAR(size.z, row.size_mm[2] * 1e-3, 1e-3);
    EXPECT_LE(mesh.triangles.size(), row.bunch ? 10000U : 4000U);
  }
}

TEST(Produce, RoundFruitHaveABallsVolume) {  // an orange fills its box as an ellipsoid does
  EXPECT_NEAR(volume_share("Orange", 0.080 * 0.080 * 0.078), ellipsoid_share, 0.03);
  EXPECT_NEAR(volume_share("Watermelon", 0.260 * 0.220 * 0.220), ellipsoid_share, 0.04);
  EXPECT_NEAR(volume_share("Plum", 0.055 * 0.045 * 0.045), ellipsoid_share, 0.05);
  // A cone that tapers to a point holds a third of its cylinder; a carrot, blunt at its top, more.
  const double carrot = volume_share("Carrot", 0.190 * 0.032 * 0.032 * std::numbers::pi / 4);
  EXPECT_GT(carrot, 1.0 / 3);
  EXPECT_LT(carrot, 0.55);
}

TEST(Produce, NoTwoPiecesAreAlikeAndEachStaysItself) {
  for (const ProduceRow& row : produce_rows) {
    if (row.archetype == "pretzel") continue;  // shaped by machine
    SCOPED_TRACE(row.name);
    const Mesh one = mesh_of(product_of(row, 1));
    EXPECT_EQ(one.positions, mesh_of(product_of(row, 1)).positions);
    EXPECT_NE(one.positions, mesh_of(product_of(row, 2)).positions);
  }
}

TEST(Produce, TheStalkIsAtTheStem) {
  const assets::ProductModel apple =
      assets::make_product_model(product_of(row_named("Apple Gala"))).value();
  ASSERT_EQ(apple.features.size(), 1U);
  EXPECT_EQ(apple.features[0].kind, assets::FeatureKind::stem);
  EXPECT_NEAR(apple.features[0].center.x, 0, 0.015);
  EXPECT_NEAR(apple.features[0].center.z + apple.features[0].half_size.z, 0.070, 1e-3);
  // Long goods lie with the stem at the left.
  const assets::ProductModel aubergine =
      assets::make_product_model(product_of(row_named("Aubergine"))).value();
  ASSERT_EQ(aubergine.features.size(), 1U);
  EXPECT_NEAR(aubergine.features[0].center.x - aubergine.features[0].half_size.x, -0.110, 1e-3);
}

// Largest difference of a colour component between the skin's first and last column.
int seam_step(const Image& skin) {
  int most = 0;
  for (int y = 0; y < skin.height; ++y) {
    const std::uint8_t *left = skin.at(0, y), *right = skin.at(skin.width - 1, y);
    for (int c = 0; c < 3; ++c)
      most = std::max(most, std::abs(left[c] - right[c]));
  }
  return most;
}

int largest_step_inside(const Image& skin) {
  int most = 0;
  for (int y = 0; y < skin.height; ++y) {
    for (int x = 1; x < skin.width; ++x) {
      for (int c = 0; c < 3; ++c)
        most = std::max(most, std::abs(skin.at(x, y)[c] - skin.at(x - 1, y)[c]));
    }
  }
  return most;
}

TEST(ProduceSkins, MeetAtTheBackWithoutASeam) {
  constexpr int small_px = 128;
  for (const ProduceRow& row : produce_rows) {
    const Image skin = assets::draw_label(product_of(row), small_px).value();
    EXPECT_LE(seam_step(skin), std::max(12, 5 * largest_step_inside(skin) / 4)) << row.name;
  }
}

int differing_pixels(const Image& a, const Image& b) {
  int count = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x)
      count += std::equal(a.at(x, y), a.at(x, y) + 3, b.at(x, y)) ? 0 : 1;
  }
  return count;
}

// A yellow tomato is a tomato in the row's yellow; one whose name says nothing is drawn as its
// shape is.
TEST(ProduceSkins, TakeTheRowsColour) {
  const auto mean_of = [](const Image& skin) {
    std::array<double, 3> mean{};
    for (int y = skin.height / 3; y < skin.height * 2 / 3; ++y) {
      for (int x = 0; x < skin.width; ++x) {
        for (std::size_t c = 0; c < 3; ++c)
          mean[c] += skin.at(x, y)[c] / (static_cast<double>(skin.width) * (skin.height / 3));
      }
    }
    return mean;
  };
  for (const std::string_view name : {"Tomato", "Potato", "Kiwi", "Onion"}) {
    catalog::Product product = product_of(row_named(name));
    product.plu.clear();
    product.label.primary = "#d8b02e";  // 216, 176, 46
    const std::array<double, 3> mean = mean_of(assets::draw_label(product, 96).value());
    EXPECT_NEAR(mean[0], 216, 55) << name;
    EXPECT_NEAR(mean[1], 176, 55) << name;
    EXPECT_NEAR(mean[2], 46, 55) << name;
    const Image named = assets::draw_label(product, 96).value();
    product.name = "Xyz";
    EXPECT_EQ(differing_pixels(named, assets::draw_label(product, 96).value()), 0) << name;
  }
}

TEST(PluStickers, LooseFruitWithACodeCarriesASmallOval) {
  catalog::Product apple = product_of(row_named("Apple Gala"));
  const Image with = assets::draw_label(apple, 512).value();
  apple.plu.clear();
  const Image without = assets::draw_label(apple, 512).value();
  ASSERT_EQ(with.width, without.width);
  const double share = static_cast<double>(differing_pixels(with, without)) /
                       (static_cast<double>(with.width) * with.height);
  // 24 x 19 mm of about 236 x 114 mm.
  EXPECT_NEAR(share, 24.0 * 19.2 * std::numbers::pi / 4 / (236.0 * 114.0), 0.003);
  catalog::Product parsley = product_of(row_named("Parsley"));
  const Image bunch = assets::draw_label(parsley, 128).value();
  parsley.plu.clear();
  EXPECT_EQ(differing_pixels(bunch, assets::draw_label(parsley, 128).value()), 0);
}

}  // namespace
}  // namespace marketgen
