// Surface that is known, put somewhere, against what a picture shows there. Single precision, since
// many thousand pieces are looked at.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "perception/view_cloud.h"

namespace marketgen::perception {

// The turn and shift of a pose.
class Placed {
 public:
  explicit Placed(const Pose& pose)
      : x_(to_float(rotate(pose.rotation, {1, 0, 0}))),
        y_(to_float(rotate(pose.rotation, {0, 1, 0}))),
        z_(to_float(rotate(pose.rotation, {0, 0, 1}))),
        at_(to_float(pose.position)) {}
  Vec3f turned(Vec3f v) const { return x_ * v.x + y_ * v.y + z_ * v.z; }
  Vec3f operator()(Vec3f v) const { return turned(v) + at_; }
  Vec3f back(Vec3f p) const {
    const Vec3f d = p - at_;
    return {dot(d, x_), dot(d, y_), dot(d, z_)};
  }

 private:
  Vec3f x_, y_, z_, at_;
};

// What a picture shows where a piece of surface should be seen.
struct ShownPiece {
  std::size_t pixel = 0;
  float off_m = 0;        // how far it should be behind what is measured
  float tolerance_m = 0;  // of that
  bool is_hidden() const { return off_m > 2 * tolerance_m; }
  bool is_missing() const { return off_m < -2 * tolerance_m; }  // something behind it is seen
  // 1 where it is as measured, to 0 where it is hidden or missing.
  double agreement() const {
    return std::clamp(2.0 - static_cast<double>(std::abs(off_m) / tolerance_m), 0.0, 1.0);
  }
};

// Base frame. Nothing where it is turned away, so that the cosine of its normal to the view is less
// than `min_facing`, out of the picture, or where there is no depth. `tolerance_m`: of a piece that
// is seen squarely; a pixel more of one seen aslant.
inline std::optional<ShownPiece> shown_piece(
    const ViewCloud& view, Vec3f point, Vec3f normal, float min_facing, float tolerance_m) {
  const float facing = dot(normal, normalized(view.eye() - point));
  if (facing < min_facing) return std::nullopt;
  const auto seen = view.project(point);
  if (!seen || !view.has(seen->pixel)) return std::nullopt;
  // Normals are unit within a rounding.
  const float slope = std::sqrt(std::max(0.0F, 1 - facing * facing)) / facing;
  return ShownPiece{seen->pixel,
                    seen->depth_m - view.view().depth_m[seen->pixel],
                    tolerance_m + view.pixel_m(seen->depth_m) * slope};
}

}  // namespace marketgen::perception
