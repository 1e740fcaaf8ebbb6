#include "skills/carried_basket.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "motion/grasp_surface.h"

namespace marketgen::skills {
namespace {

constexpr double column_m = 0.005;
constexpr double beyond_m = 1;  // rays begin so far outside
// What is compared lies up to a column off, and both edges reach up to one beyond what was probed.
constexpr int aside_columns = 2;

int column_of(double at) {
  return static_cast<int>(std::floor(at / column_m));
}
double middle_of(int column) {
  return (column + 0.5) * column_m;
}

// Heights at which vertical rays meet a pack that is turned.
class Probe {
 public:
  Probe(const std::vector<assets::ContactPiece>& pieces, const Pose& pose)
      : surface_(pieces), product_from_frame_(inverse(pose)) {}

  // Of its surface over `from`, rays going the way that `up` (1 or -1) says.
  std::optional<double> height(Vec3 from, double up) const {
    const auto hit = surface_.first_hit(product_from_frame_ * from,
                                        rotate(product_from_frame_.rotation, Vec3{0, 0, up}));
    return hit ? std::optional(from.z + up * hit->distance_m) : std::nullopt;
  }

 private:
  motion::GraspSurface surface_;
  Pose product_from_frame_;
};

}  // namespace

CarriedItem carried_box(const TurnedBox& base_box) {
  return {{{assets::PieceShape::box, {}, to_float(base_box.half)}}, {base_box.middle, {}}};
}

motion::BoxObstacle box_of(const CarriedItem& item) {
  const TurnedBox box = turned_box({item.pieces, {}, {}, {}}, {});
  return {item.base_from_product * Pose{box.middle, {}}, box.half};
}

Underside::Underside(const assets::ProductBody& held, const Quaternion& basket_from_product)
    : box_(turned_box(held, {{}, basket_from_product})) {
  const Probe probe(held.pieces, {-box_.middle, basket_from_product});
  for (int x = column_of(-box_.half.x); x <= column_of(box_.half.x); ++x) {
    for (int y = column_of(-box_.half.y); y <= column_of(box_.half.y); ++y) {
      const auto low = probe.height({middle_of(x), middle_of(y), -beyond_m}, 1);
      if (low) columns_.push_back({x, y, *low});
    }
  }
}

BasketFill::BasketFill(const CarriedBasket& basket, const std::vector<CarriedItem>& inside)
    : low_{-basket.size.x / 2 - aside_columns * column_m,
           -basket.size.y / 2 - aside_columns * column_m,
           0},
      wide_(column_of(basket.size.x) + 1 + 2 * aside_columns),
      deep_(column_of(basket.size.y) + 1 + 2 * aside_columns),
      tops_(static_cast<std::size_t>(wide_ * deep_), 0.0) {
  const Pose basket_from_base = inverse(basket.base_from_floor);
  for (const CarriedItem& item : inside) {
    const Probe probe(item.pieces, basket_from_base * item.base_from_product);
    for (int y = 0; y < deep_; ++y) {
      for (int x = 0; x < wide_; ++x) {
        const auto top = probe.height(low_ + Vec3{middle_of(x), middle_of(y), beyond_m}, -1);
        if (!top) continue;
        for (int v = std::max(0, y - aside_columns); v <= std::min(deep_ - 1, y + aside_columns);
             ++v)
          for (int u = std::max(0, x - aside_columns); u <= std::min(wide_ - 1, x + aside_columns);
               ++u) {
            double& most = tops_[static_cast<std::size_t>(v * wide_ + u)];
            most = std::max(most, *top);
          }
      }
    }
  }
}

double BasketFill::rest_m(const Underside& held, double x, double y) const {
  double rest = 0;
  const int x0 = column_of(x - low_.x), y0 = column_of(y - low_.y);
  for (const Underside::Column& column : held.columns_) {
    const int u = x0 + column.x, v = y0 + column.y;
    if (u < 0 || v < 0 || u >= wide_ || v >= deep_) continue;
    const double top = tops_[static_cast<std::size_t>(v * wide_ + u)];
    if (top > 0) rest = std::max(rest, top - column.low_m - held.box_.half.z);
  }
  return rest;
}

}  // namespace marketgen::skills
