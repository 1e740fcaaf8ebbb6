#include "assets/asset_detail.h"

namespace marketgen::assets {
namespace {

std::array<float, 3> as_array(Vec3f v) {
  return {v.x, v.y, v.z};
}

ShownPiece shown(const ContactPiece& piece) {
  ShownPiece row{piece.shape, as_array(piece.center), as_array(piece.half_size), piece.lying, {}};
  for (const Vec3f& p : piece.points)
    row.points_m.push_back(as_array(p));
  return row;
}

std::string source_of(const catalog::FrictionRow& row, const catalog::Catalog& catalog) {
  for (const catalog::FrictionSource& source : catalog.friction_sources) {
    if (source.key != row.source) continue;
    return row.detail.empty() ? source.text : source.text + "; " + row.detail;
  }
  return row.source;
}

std::vector<ShownFriction> pairs_of(const std::string& material, const catalog::Catalog& catalog) {
  std::vector<ShownFriction> pairs;
  for (const catalog::FrictionRow& row : catalog.frictions) {
    if (row.a == material || row.b == material)
      pairs.push_back({row.a == material ? row.b : row.a, row.sliding, source_of(row, catalog)});
  }
  return pairs;
}

}  // namespace

Result<ProductDetail> detail_of(const catalog::Product& product, const catalog::Catalog& catalog) {
  MARKETGEN_TRY(const ProductModel model, make_product_model(product));
  MARKETGEN_TRY(const ProductBody body, make_product_body(product));
  ProductDetail detail;
  static_cast<catalog::Product&>(detail) = product;
  detail.triangles = static_cast<int>(model.mesh.triangles.size());
  detail.volume_m3 = marketgen::volume_of(model.mesh);
  detail.bounds_m = as_array(marketgen::bounds_of(model.mesh).size());
  detail.center_of_mass_m = as_array(body.center_of_mass);
  detail.inertia_kg_m2 = body.inertia_kg_m2;
  for (const PackFeature& f : body.features)
    detail.features.push_back({f.kind, as_array(f.center), as_array(f.half_size)});
  for (const ContactPiece& piece : body.pieces)
    detail.pieces.push_back(shown(piece));
  detail.friction_pairs = pairs_of(product.material, catalog);
  return detail;
}

}  // namespace marketgen::assets
