#include "skills/held_product.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "assets/contact_shape.h"
#include "base/gravity.h"

namespace marketgen::skills {
namespace {

constexpr double larger = 1.1;
constexpr double put_n = 20;
constexpr double end_share = 0.4;  // of its radius, by which the last ball reaches beyond the end

void widen(Vec3& low, Vec3& high, Vec3 point) {
  low = {std::min(low.x, point.x), std::min(low.y, point.y), std::min(low.z, point.z)};
  high = {std::max(high.x, point.x), std::max(high.y, point.y), std::max(high.z, point.z)};
}

}  // namespace

Result<assets::ProductBody> make_store_body(const catalog::Product& product) {
  MARKETGEN_TRY(const auto pack, assets::product_body(product));
  assets::ProductBody body = *pack;
  MARKETGEN_TRY(const assets::CollisionPrimitive solid, assets::collision_of(product));
  body.pieces = {assets::piece_of(solid)};
  return body;
}

double putting_force_n(const catalog::Product& product) {
  return put_n + product.mass_kg * standard_gravity;
}

TurnedBox turned_box(const assets::ProductBody& body, const Pose& pose) {
  Vec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
  for (const assets::ContactPiece& piece : body.pieces) {
    if (piece.shape == assets::PieceShape::hull) {
      for (const Vec3f& point : piece.points)
        widen(low, high, pose * to_double(point));
      continue;
    }
    const assets::ContactShape shape = pose * assets::contact_shape_of(piece);
    const Vec3 half = assets::half_extents(shape);
    widen(low, high, shape.pose.position - half);
    widen(low, high, shape.pose.position + half);
  }
  return {(low + high) * 0.5, (high - low) * 0.5};
}

motion::AttachedObject held_product(const robots::Robot& robot,
                                    int tip_frame,
                                    const assets::ProductBody& body,
                                    const Pose& tip_from_product,
                                    std::vector<int> may_touch) {
  const robots::RobotFrame& tip = robot.frames[static_cast<std::size_t>(tip_frame)];
  motion::AttachedObject held{tip.link, {}, std::move(may_touch)};
  const TurnedBox box = turned_box(body, {});
  std::array<std::pair<double, Vec3>, 3> axes{
      std::pair{box.half.x, Vec3{1, 0, 0}}, {box.half.y, {0, 1, 0}}, {box.half.z, {0, 0, 1}}};
  std::ranges::sort(axes, {}, [](const auto& axis) { return axis.first; });
  const double radius = larger * std::max(axes[0].first, axes[1].first);
  const double run = std::max(0.0, axes[2].first - end_share * radius);
  const int count = 1 + 2 * static_cast<int>(std::ceil(run / radius));
  for (int i = 0; i < count; ++i) {
    const double along = count > 1 ? run * (2.0 * i / (count - 1) - 1) : 0;
    held.spheres.push_back(
        {tip.link_from_frame * (tip_from_product * (box.middle + axes[2].second * along)), radius});
  }
  return held;
}

}  // namespace marketgen::skills
