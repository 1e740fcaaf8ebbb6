// Conformance of contact shape, mass and features, over a sample of every archetype.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "assets/print/label_sheet.h"
#include "assets/product_model.h"
#include "assets/shapes/contact_pieces.h"
#include "sample_produce.h"
#include "sample_products.h"

namespace marketgen {
namespace {

// Made once: every test is a process of its own, and names all cases.
const std::vector<catalog::Product>& products_of_every_shape() {
  static const std::vector<catalog::Product> all = [] {
    std::vector<catalog::Product> products = sample_products();
    for (const ProduceRow& row : produce_rows) {
      products.push_back(product_of(row));
      products.back().orientation = catalog::Orientation::any;
    }
    for (const std::string name : {"round_produce", "elongated_produce", "leafy_produce"})
      products.push_back(loose_produce(name, name));
    return products;
  }();
  return all;
}

class Bodies : public testing::TestWithParam<std::size_t> {
 protected:
  const catalog::Product product = products_of_every_shape()[GetParam()];
};

std::string name_of_body(const testing::TestParamInfo<std::size_t>& info) {
  return products_of_every_shape()[info.param].archetype + "_" + std::to_string(info.index);
}

INSTANTIATE_TEST_SUITE_P(All,
                         Bodies,
                         testing::Range(std::size_t{0}, products_of_every_shape().size()),
                         name_of_body);

// The volume that the mesh fills, parts that run into one another once: by lines along X. The code
// under test cuts columns along Z.
double filled_volume(const Mesh& mesh) {
  constexpr int lines = 150;
  const Bounds3 bounds = bounds_of(mesh);
  const double dy = static_cast<double>(bounds.size().y) / lines,
               dz = static_cast<double>(bounds.size().z) / lines;
  std::vector<std::vector<std::pair<double, int>>> crossings(lines * lines);
  for (const auto& t : mesh.triangles) {
    const Vec3 a = to_double(mesh.positions[t[0]]), b = to_double(mesh.positions[t[1]]),
               c = to_double(mesh.positions[t[2]]);
    const double area = (b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y);
    if (area == 0) continue;
    const auto first = [](double least, double low, double step) {
      return std::max(0, static_cast<int>((least - low) / step) - 1);
    };
    const auto last = [](double most, double low, double step) {
      return std::min(lines - 1, static_cast<int>((most - low) / step) + 1);
    };
    for (int j = first(std::min({a.y, b.y, c.y}), bounds.low.y, dy);
         j <= last(std::max({a.y, b.y, c.y}), bounds.low.y, dy);
         ++j) {
      for (int k = first(std::min({a.z, b.z, c.z}), bounds.low.z, dz);
           k <= last(std::max({a.z, b.z, c.z}), bounds.low.z, dz);
           ++k) {
        // Off the middle, where no edge of a symmetric pack runs.
        const double y = bounds.low.y + (j + 0.50173) * dy, z = bounds.low.z + (k + 0.50317) * dz;
        const double u = ((y - a.y) * (c.z - a.z) - (z - a.z) * (c.y - a.y)) / area;
        const double v = ((b.y - a.y) * (z - a.z) - (b.z - a.z) * (y - a.y)) / area;
        if (u < 0 || v < 0 || u + v > 1) continue;
        crossings[static_cast<std::size_t>(j * lines + k)].push_back(
            {a.x + u * (b.x - a.x) + v * (c.x - a.x), area > 0 ? -1 : 1});
      }
    }
  }
  double length = 0;
  for (auto& line : crossings) {
    std::sort(line.begin(), line.end());
    int depth = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      depth += line[i].second;
      if (depth > 0) length += line[i + 1].first - line[i].first;
    }
  }
  return length * dy * dz;
}

bool is_grown(const catalog::Product& product) {
  return assets::sheet_kind_of(product.archetype).value() == assets::SheetKind::skin;
}

TEST_P(Bodies, PiecesFillThePack) {
  const Mesh mesh = assets::make_product_model(product).value().mesh;
  const assets::ProductBody body = assets::make_product_body(product).value();
  ASSERT_GE(body.pieces.size(), 1U);
  EXPECT_LE(body.pieces.size(), 6U);
  double volume = 0;
  const Bounds3 bounds = bounds_of(mesh);
  const float margin = 0.03F * std::max({bounds.size().x, bounds.size().y, bounds.size().z}) / 2;
  for (const assets::ContactPiece& piece : body.pieces) {
    EXPECT_GT(assets::volume_of(piece), 0.0);
    volume += assets::volume_of(piece);
    EXPECT_EQ(piece.shape == assets::PieceShape::hull, !piece.points.empty());
    EXPECT_LE(piece.points.size(), 64U);
    const Vec3f half = piece.lying ? Vec3f{piece.half_size.z, piece.half_size.y, piece.half_size.x}
                                   : piece.half_size;
    const Vec3f low = piece.center - half, high = piece.center + half;
    EXPECT_GE(low.z, -1e-5F);
    EXPECT_LE(high.z, bounds.high.z + margin);
    EXPECT_GE(std::min(low.x - bounds.low.x, low.y - bounds.low.y), -margin);
    EXPECT_LE(std::max(high.x - bounds.high.x, high.y - bounds.high.y), margin);
  }
  EXPECT_NEAR(volume / filled_volume(mesh), 1.0, is_grown(product) ? 0.15 : 0.05);
}

TEST_P(Bodies, PacksStandOnAFlatFoot) {  // several contacts hold a primitive, one a hull
  if (product.orientation == catalog::Orientation::any) return;
  const assets::ProductBody body = assets::make_product_body(product).value();
  const assets::ContactPiece& foot = body.pieces.front();
  EXPECT_TRUE(foot.shape == assets::PieceShape::box ||
              (foot.shape == assets::PieceShape::cylinder && !foot.lying));
  EXPECT_NEAR(foot.center.z - foot.half_size.z, 0.0F, 1e-4F);
}

TEST_P(Bodies, MassIsInsideAndItsInertiaCanBe) {
  const assets::ProductBody body = assets::make_product_body(product).value();
  const auto& [xx, yy, zz, xy, xz, yz] = body.inertia_kg_m2;
  EXPECT_GT(std::min({xx, yy, zz}), 0.0F);
  EXPECT_GE(xx + yy, zz);
  EXPECT_GE(yy + zz, xx);
  EXPECT_GE(zz + xx, yy);
  EXPECT_GT(xx * yy - xy * xy, 0.0F);
  EXPECT_GT(xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz), 0.0F);
  // No heavier about an axis than with all mass at the corners of its box.
  const double w = product.width_m() / 2, d = product.depth_m() / 2, h = product.height_m() / 2;
  EXPECT_LT(xx, product.mass_kg * (d * d + h * h));
  EXPECT_LT(zz, product.mass_kg * (w * w + d * d));
  EXPECT_LT(std::abs(body.center_of_mass.x), 0.55 * w);
  const bool on_card = product.archetype == "blister";  // which stands behind its goods
  EXPECT_LT(std::abs(body.center_of_mass.y), (on_card ? 0.75 : 0.55) * d);
  EXPECT_GT(body.center_of_mass.z, 0.2 * h);
  EXPECT_LT(body.center_of_mass.z, 1.6 * h);
}

TEST_P(Bodies, FeaturesLieOnThePack) {
  const Bounds3 bounds = bounds_of(assets::make_product_model(product).value().mesh);
  const assets::ProductBody body = assets::make_product_body(product).value();
  for (const assets::PackFeature& feature : body.features) {
    SCOPED_TRACE(std::string(name_of(feature.kind)));
    const Vec3f low = feature.center - feature.half_size, high = feature.center + feature.half_size;
    constexpr float tolerance_m = 1e-3F;
    EXPECT_GE(low.x, bounds.low.x - tolerance_m);
    EXPECT_GE(low.y, bounds.low.y - tolerance_m);
    EXPECT_GE(low.z, bounds.low.z - tolerance_m);
    EXPECT_LE(high.x, bounds.high.x + tolerance_m);
    EXPECT_LE(high.y, bounds.high.y + tolerance_m);
    EXPECT_LE(high.z, bounds.high.z + tolerance_m);
    EXPECT_GT(std::max({feature.half_size.x, feature.half_size.y, feature.half_size.z}), 0.0F);
  }
}

TEST_P(Bodies, CoarseMeshesKeepWhatMatters) {
  const assets::ProductModel near = assets::make_product_model(product).value();
  std::size_t finer = near.mesh.triangles.size();
  const std::set<std::uint16_t> surfaces(near.mesh.surfaces.begin(), near.mesh.surfaces.end());
  for (const assets::Detail detail : {assets::Detail::middle, assets::Detail::far}) {
    SCOPED_TRACE(std::string(name_of(detail)));
    const Mesh mesh = assets::make_product_model(product, detail).value().mesh;
    EXPECT_TRUE(is_watertight(mesh));
    const Vec3f size = bounds_of(mesh).size();
    EXPECT_NEAR(size.x, product.width_m(), 1e-3);
    EXPECT_NEAR(size.y, product.depth_m(), 1e-3);
    EXPECT_NEAR(size.z, product.height_m(), 1e-3);
    EXPECT_NEAR(bounds_of(mesh).low.z, 0, 1e-4);
    EXPECT_EQ(std::set<std::uint16_t>(mesh.surfaces.begin(), mesh.surfaces.end()), surfaces);
    for (const Vec2f uv : mesh.uvs) {
      ASSERT_TRUE(std::isfinite(uv.x) && std::isfinite(uv.y));
      ASSERT_GE(std::min(uv.x, uv.y), -1e-5F);
      ASSERT_LE(std::max(uv.x, uv.y), 1.0F + 1e-5F);
    }
    for (const Vec3f n : mesh.normals)
      ASSERT_NEAR(length(n), 1.0F, 1e-3F);
    EXPECT_LE(mesh.triangles.size(), finer);
    finer = mesh.triangles.size();
  }
}

// ---- Known answers ----

catalog::Product sized(std::string_view archetype, std::array<int, 3> size_mm, double mass_kg) {
  catalog::Product product;
  product.sku = "test-" + std::string(archetype);
  product.name = "Test";
  product.archetype = archetype;
  product.size_mm = size_mm;
  product.mass_kg = mass_kg;
  return product;
}

TEST(ProductBody, EveryShapeHasASample) {
  std::set<std::string> sampled;
  for (const catalog::Product& product : products_of_every_shape())
    sampled.insert(product.archetype);
  for (const assets::ArchetypeInfo& info : assets::archetypes())
    EXPECT_TRUE(sampled.contains(std::string(info.name))) << info.name;
}

TEST(ProductBody, ACartonIsABox) {
  const assets::ProductBody body =
      assets::make_product_body(sized("box", {200, 60, 300}, 0.6)).value();
  ASSERT_EQ(body.pieces.size(), 1U);
  EXPECT_EQ(body.pieces[0].shape, assets::PieceShape::box);
  EXPECT_NEAR(body.pieces[0].half_size.x, 0.1F, 1e-5F);
  EXPECT_NEAR(body.pieces[0].half_size.z, 0.15F, 1e-5F);
  EXPECT_NEAR(body.center_of_mass.z, 0.15F, 1e-4F);
  EXPECT_NEAR(body.inertia_kg_m2[0], 0.6 * (0.06 * 0.06 + 0.3 * 0.3) / 12, 1e-4);
  EXPECT_NEAR(body.inertia_kg_m2[2], 0.6 * (0.06 * 0.06 + 0.2 * 0.2) / 12, 1e-5);
}

TEST(ProductBody, ACanStandsOnACylinderOfItsRadius) {
  catalog::Product can = sized("can", {66, 66, 115}, 0.355);
  can.unit_of_measure = "l";
  const assets::ProductBody body = assets::make_product_body(can).value();
  const assets::ContactPiece& foot = body.pieces.front();
  EXPECT_EQ(foot.shape, assets::PieceShape::cylinder);
  EXPECT_NEAR(foot.half_size.x, 0.033F, 5e-4F);
  EXPECT_GT(foot.half_size.z, 0.045F);             // nearly all of it
  const double along = 0.355 * 0.033 * 0.033 / 2;  // of a full cylinder; the necks are narrower
  EXPECT_NEAR(body.inertia_kg_m2[2], along, 0.08 * along);
  EXPECT_LT(body.center_of_mass.z, 0.0575F);  // not filled to the brim
}

TEST(ProductBody, AnOrangeIsAnEllipsoid) {
  catalog::Product orange = sized("citrus", {80, 80, 78}, 0.2);
  orange.name = "Orange";
  orange.orientation = catalog::Orientation::any;
  const assets::ProductBody body = assets::make_product_body(orange).value();
  ASSERT_EQ(body.pieces.size(), 1U);
  EXPECT_EQ(body.pieces[0].shape, assets::PieceShape::ellipsoid);
  const double ball = 0.4 * 0.2 * 0.04 * 0.04;  // 2/5 m r^2
  EXPECT_NEAR(body.inertia_kg_m2[2], ball, 0.05 * ball);
}

TEST(ProductBody, ABottlesCapAndNeckAreWhereTheyLook) {
  const assets::ProductBody body =
      assets::make_product_body(sized("soda_bottle", {88, 88, 330}, 1.55)).value();
  std::map<assets::FeatureKind, assets::PackFeature> features;
  for (const assets::PackFeature& feature : body.features)
    features[feature.kind] = feature;
  ASSERT_TRUE(features.contains(assets::FeatureKind::cap) &&
              features.contains(assets::FeatureKind::neck));
  const assets::PackFeature &cap = features[assets::FeatureKind::cap],
                            &neck = features[assets::FeatureKind::neck];
  EXPECT_NEAR(cap.half_size.x, 0.015F, 5e-4F);  // 30 mm across, see PCO 1881
  EXPECT_NEAR(cap.center.z + cap.half_size.z, 0.330F, 1e-4F);
  EXPECT_NEAR(neck.center.z + neck.half_size.z, cap.center.z - cap.half_size.z, 1e-4F);
  EXPECT_NEAR(neck.half_size.x, 1.12F * 0.015F, 5e-4F);  // the support ring
}

TEST(ProductBody, ADistantCanHasTwelveSides) {
  const Mesh far =
      assets::make_product_model(sized("can", {66, 66, 115}, 0.355), assets::Detail::far)
          .value()
          .mesh;
  std::set<int> directions;  // of the wall at half height, in degrees
  constexpr float half_height_m = 0.0575F;
  for (const auto& t : far.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3f a = far.positions[t[i]], b = far.positions[t[(i + 1) % 3]];
      if ((a.z < half_height_m) == (b.z < half_height_m)) continue;
      const Vec3f p = a + (b - a) * ((half_height_m - a.z) / (b.z - a.z));
      EXPECT_GT(std::hypot(p.x, p.y), 0.033F * 0.9F);
      directions.insert(static_cast<int>(std::lround(
                            std::atan2(p.y, p.x) * 180 / std::numbers::pi_v<float> + 360)) %
                        360);
    }
  }
  EXPECT_GE(directions.size(), 12U);
}

TEST(ProductBody, SameRowSameBody) {
  for (const catalog::Product& product :
       {sized("spray_bottle", {100, 60, 270}, 0.6), sized("grapes", {190, 110, 80}, 0.5)}) {
    const assets::ProductBody one = assets::make_product_body(product).value(),
                              two = assets::make_product_body(product).value();
    ASSERT_EQ(one.pieces.size(), two.pieces.size());
    for (std::size_t i = 0; i < one.pieces.size(); ++i) {
      EXPECT_EQ(one.pieces[i].points, two.pieces[i].points);
      EXPECT_EQ(one.pieces[i].half_size, two.pieces[i].half_size);
    }
    EXPECT_EQ(one.inertia_kg_m2, two.inertia_kg_m2);
    EXPECT_EQ(assets::make_product_model(product, assets::Detail::far).value().mesh.positions,
              assets::make_product_model(product, assets::Detail::far).value().mesh.positions);
  }
}

TEST(ProductBody, UnknownShapesNameTheNearest) {
  const Result<assets::ProductBody> body =
      assets::make_product_body(sized("soda_botle", {80, 80, 300}, 1));
  ASSERT_FALSE(body.ok());
  EXPECT_EQ(body.error().code, "catalog.unknown_kind");
}

}  // namespace
}  // namespace marketgen
