#include "export/mjcf_text.h"

#include <algorithm>
#include <cmath>

#include "geometry/srgb.h"

namespace marketgen::exporters {

double srgb_from_linear(float linear) {
  const double l = std::clamp(static_cast<double>(linear), 0.0, 1.0);
  return std::round(srgb_encoded(l) * 1000) / 1000;
}

std::string mjcf_vector(const Vec3& v) {
  return fmt::format(
      "{} {} {}", static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
}

std::string mjcf_pose(const Pose& pose) {
  const Quaternion& q = pose.rotation;
  std::string position = fmt::format(" pos=\"{}\"", mjcf_vector(pose.position));
  if (q == Quaternion{}) return position;
  return position + fmt::format(" quat=\"{} {} {} {}\"",
                                static_cast<float>(q.w),
                                static_cast<float>(q.x),
                                static_cast<float>(q.y),
                                static_cast<float>(q.z));
}

std::string mjcf_size(const assets::ContactShape& shape) {
  if (shape.shape != assets::CollisionShape::cylinder) return mjcf_vector(shape.size);
  return fmt::format("{} {}", static_cast<float>(shape.size.x), static_cast<float>(shape.size.y));
}

std::string mjcf_color(Vec3f linear, double alpha) {
  return fmt::format("{} {} {} {}",
                     srgb_from_linear(linear.x),
                     srgb_from_linear(linear.y),
                     srgb_from_linear(linear.z),
                     alpha);
}

}  // namespace marketgen::exporters
