// A product row with all that is worked out from it: what `assets show` prints.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "assets/product_model.h"
#include "base/inherited_fields.h"
#include "base/result.h"
#include "catalog/catalog.h"

namespace marketgen::assets {

struct ShownFeature {
  FeatureKind kind = FeatureKind::cap;
  std::array<float, 3> center_m{}, half_size_m{};
  static constexpr auto fields =
      field_list(field("kind", &ShownFeature::kind, "what it is"),
                 field("center_m", &ShownFeature::center_m, "of its box, product frame"),
                 field("half_size_m", &ShownFeature::half_size_m, "of its box"));
};

struct ShownPiece {
  PieceShape shape = PieceShape::box;
  std::array<float, 3> center_m{}, half_size_m{};
  bool lying = false;
  std::vector<std::array<float, 3>> points_m;
  static constexpr auto fields =
      field_list(field("shape", &ShownPiece::shape, "box, cylinder, ellipsoid or hull"),
                 field("center_m", &ShownPiece::center_m, "product frame; not of a hull"),
                 field("half_size_m", &ShownPiece::half_size_m, "not of a hull"),
                 field("lying", &ShownPiece::lying, "cylinder along X"),
                 field("points_m", &ShownPiece::points_m, "corners of a hull"));
};

struct ShownFriction {
  std::string with;
  double sliding = 0;
  std::string source;
  static constexpr auto fields =
      field_list(field("with", &ShownFriction::with, "the other contact material"),
                 field("sliding", &ShownFriction::sliding, "coefficient of sliding friction"),
                 field("source", &ShownFriction::source, "where the number comes from"));
};

struct ProductDetail : catalog::Product {
  int triangles = 0;
  double volume_m3 = 0;
  std::array<float, 3> bounds_m{};
  std::array<float, 3> center_of_mass_m{};
  std::array<float, 6> inertia_kg_m2{};
  std::vector<ShownFeature> features;
  std::vector<ShownPiece> pieces;
  std::vector<ShownFriction> friction_pairs;

  static constexpr auto fields = inherited_fields<ProductDetail>(
      catalog::Product::fields,
      field_list(
          field("triangles", &ProductDetail::triangles, "of the mesh seen from near"),
          field("volume_m3", &ProductDetail::volume_m3, "that the mesh encloses"),
          field("bounds_m", &ProductDetail::bounds_m, "width, depth, height of the mesh"),
          field("center_of_mass_m", &ProductDetail::center_of_mass_m, "product frame"),
          field("inertia_kg_m2",
                &ProductDetail::inertia_kg_m2,
                "about the centre of mass: xx yy zz xy xz yz"),
          field("features", &ProductDetail::features, "parts that a hand may use or must mind"),
          field("pieces", &ProductDetail::pieces, "convex contact pieces"),
          field("friction_pairs",
                &ProductDetail::friction_pairs,
                "of its contact material with others")));
};

// Errors: those of make_product_model().
Result<ProductDetail> detail_of(const catalog::Product& product, const catalog::Catalog& catalog);

}  // namespace marketgen::assets
