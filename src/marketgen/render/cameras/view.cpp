#include "render/cameras/view.h"

#include <cmath>
#include <numbers>

namespace marketgen::render::raytrace {
View::View(const Camera& camera)
    : origin_(to_float(place_of(camera))),
      width_(camera.width),
      height_(camera.height),
      orthographic_(camera.ortho_height_m > 0) {
  const CameraAxes axes = axes_of(camera);
  forward_ = to_float(axes.ahead);
  right_ = to_float(axes.right);
  up_ = to_float(-axes.down);
  if (camera.intrinsics && !orthographic_) {
    const Intrinsics& k = *camera.intrinsics;
    half_width_ = static_cast<float>(camera.width / (2 * k.fx));
    half_height_ = static_cast<float>(camera.height / (2 * k.fy));
    shift_x_ = static_cast<float>(((camera.width - 1) / 2.0 - k.cx) / k.fx);
    shift_y_ = static_cast<float>((k.cy - (camera.height - 1) / 2.0) / k.fy);
    if (!k.distortion.none()) lens_ = k;
  } else {
    const double half = orthographic_ ? camera.ortho_height_m / 2
                                      : std::tan(camera.fov_deg * std::numbers::pi / 360);
    half_height_ = static_cast<float>(half);
    half_width_ = static_cast<float>(half * camera.width / camera.height);
  }
  const float pixel = 2 * half_height_ / static_cast<float>(camera.height);
  (orthographic_ ? pixel_ : pixel_per_m_) = pixel;
}

Vec3f View::bent_offset(float x, float y) const {
  const Vec2 seen{(static_cast<double>(x) - 0.5 - lens_->cx) / lens_->fx,
                  (static_cast<double>(y) - 0.5 - lens_->cy) / lens_->fy};
  // check_lens has shown that it converges all over the picture.
  const Vec2 ideal = undistorted(lens_->distortion, seen).value_or(seen);
  return right_ * static_cast<float>(ideal.x) - up_ * static_cast<float>(ideal.y);
}

Ray View::ray(float x, float y) const {
  if (lens_) return {origin_, normalized(forward_ + bent_offset(x, y)), near_m};
  const float across = (2 * x / static_cast<float>(width_) - 1) * half_width_ + shift_x_;
  const float up = (1 - 2 * y / static_cast<float>(height_)) * half_height_ + shift_y_;
  const Vec3f offset = right_ * across + up_ * up;
  if (orthographic_) return {origin_ + offset, forward_, near_m};
  return {origin_, normalized(forward_ + offset), near_m};
}

Rays8 View::rays(Float8 x, Float8 y) const {
  if (lens_) {
    Vec8 directions;
    for (std::size_t k = 0; k < lane_count; ++k)
      set_lane(directions, k, ray(x[k], y[k]).direction);
    return {all(origin_), directions};
  }
  const Float8 across =
      (2 * x / static_cast<float>(width_) - 1) * Float8(half_width_) + Float8(shift_x_);
  const Float8 up =
      (1 - 2 * y / static_cast<float>(height_)) * Float8(half_height_) + Float8(shift_y_);
  const Vec8 offset = all(right_) * across + all(up_) * up;
  if (orthographic_) return {all(origin_) + offset, all(forward_)};
  return {all(origin_), normalized(all(forward_) + offset)};
}

}  // namespace marketgen::render::raytrace
