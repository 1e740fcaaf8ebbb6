#include "catalog/standing_box.h"

#include <cmath>

namespace marketgen::catalog {

StandingBox standing_box(const Product& product, const Vec3& position, const Quaternion& rotation) {
  const Vec3 x = rotate(rotation, {product.width_m() / 2, 0, 0}),
             y = rotate(rotation, {0, product.depth_m() / 2, 0});
  const double half_x = std::abs(x.x) + std::abs(y.x), half_y = std::abs(x.y) + std::abs(y.y);
  return {{position.x - half_x, position.y - half_y, position.z},
          {position.x + half_x, position.y + half_y, position.z + product.height_m()}};
}

}  // namespace marketgen::catalog
