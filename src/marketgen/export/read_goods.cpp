#include "export/read_goods.h"

#include <algorithm>

namespace marketgen::exporters {
namespace {

bool same(const ExportedGoods& a, const ExportedGoods& b) {
  if (a.mass_kg != b.mass_kg || a.friction != b.friction) return false;
  if (!a.solid || !b.solid) return a.solid.has_value() == b.solid.has_value();
  // A solid's place in its pack comes from the difference of two.
  constexpr double near_m = 1e-6, near_rad = 1e-6;
  const Quaternion turn = inverse(a.solid->pose.rotation) * b.solid->pose.rotation;
  return a.solid->shape == b.solid->shape && length(a.solid->size - b.solid->size) <= near_m &&
         length(a.solid->pose.position - b.solid->pose.position) <= near_m &&
         2 * length(Vec3{turn.x, turn.y, turn.z}) <= near_rad;
}

}  // namespace

void GoodsReader::add(const ExportedGoods& goods) {
  std::vector<ExportedGoods>& known = by_sku_[goods.sku];
  if (std::ranges::none_of(known, [&](const ExportedGoods& k) { return same(k, goods); }))
    known.push_back(goods);
}

std::vector<ExportedGoods> GoodsReader::take() {
  std::vector<ExportedGoods> all;
  for (auto& [sku, goods] : by_sku_)
    all.insert(all.end(), goods.begin(), goods.end());
  by_sku_.clear();
  return all;
}

void include_solid(Bounds3& bounds, const assets::ContactShape& shape) {
  const Vec3 half = assets::half_extents(shape);
  bounds.include(to_float(shape.pose.position - half));
  bounds.include(to_float(shape.pose.position + half));
}

}  // namespace marketgen::exporters
