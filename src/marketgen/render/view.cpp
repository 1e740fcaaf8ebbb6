#include "render/view.h"

#include <cmath>
#include <numbers>

namespace marketgen::raytrace {
namespace {

constexpr float near_m = 0.02F;  // a lens has a size: what touches it is not seen

}  // namespace

View::View(const Camera& camera)
    : origin_(to_float(camera.from)),
      width_(camera.width),
      height_(camera.height),
      orthographic_(camera.ortho_height_m > 0) {
  const Vec3 forward = normalized(camera.at - camera.from);
  // Looking straight up or down, north is the top of the picture.
  const Vec3 upward = std::fabs(forward.z) > 0.9999 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  const Vec3 right = normalized(cross(forward, upward));
  forward_ = to_float(forward);
  right_ = to_float(right);
  up_ = to_float(cross(right, forward));
  const double half =
      orthographic_ ? camera.ortho_height_m / 2 : std::tan(camera.fov_deg * std::numbers::pi / 360);
  half_height_ = static_cast<float>(half);
  half_width_ = static_cast<float>(half * camera.width / camera.height);
  const float pixel = 2 * half_height_ / static_cast<float>(camera.height);
  (orthographic_ ? pixel_ : pixel_per_m_) = pixel;
}

Ray View::ray(float x, float y) const {
  const float across = (2 * x / static_cast<float>(width_) - 1) * half_width_;
  const float up = (1 - 2 * y / static_cast<float>(height_)) * half_height_;
  const Vec3f offset = right_ * across + up_ * up;
  if (orthographic_) return {origin_ + offset, forward_, near_m};
  return {origin_, normalized(forward_ + offset), near_m};
}

}  // namespace marketgen::raytrace
