#include "physics/goods/standing_goods.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "physics/soft/soft_pack.h"

namespace marketgen::physics {
namespace {

// A push of F at the top of a pack of weight W tips it from F / W = half its narrower side over its
// height, and slides it from the friction on painted steel.
double stands_share_of(const catalog::Product& product) {
  const double narrow = std::min(product.width_m(), product.depth_m());
  return std::min(product.friction, narrow / 2 / product.height_m());
}

}  // namespace

Result<StandingGoods> standing_goods(const catalog::Product& product) {
  MARKETGEN_TRY(const assets::CollisionPrimitive primitive, assets::collision_of(product));
  const Vec3f& half = primitive.half_size;
  const bool sized = half.x > 0 && half.y > 0 && half.z > 0;
  if (!(product.mass_kg > 0) || !std::isfinite(product.mass_kg) || !sized) {
    return Error{"catalog.bad_row",
                 product.sku,
                 fmt::format("a product that can move needs a mass and a size greater than 0; it "
                             "has {} kg and {} x {} x {} m",
                             product.mass_kg,
                             2 * half.x,
                             2 * half.y,
                             2 * half.z)};
  }
  StandingGoods goods;
  goods.shape = assets::contact_shape_of(primitive);
  goods.contact = goods_contact_of(product, primitive);
  goods.mass_kg = product.mass_kg;
  goods.stands_share = stands_share_of(product);
  goods.may_be_soft = may_be_soft_pack(product) && goods.shape.shape == assets::CollisionShape::box;
  return goods;
}

}  // namespace marketgen::physics
