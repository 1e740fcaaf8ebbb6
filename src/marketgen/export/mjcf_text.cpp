#include "export/mjcf_text.h"

namespace marketgen::exporters {

std::string mjcf_pose(const Pose& pose) {
  const Quaternion& q = pose.rotation;
  std::string position = fmt::format(" pos=\"{}\"", xml_vector(pose.position));
  if (q == Quaternion{}) return position;
  return position + fmt::format(" quat=\"{} {} {} {}\"",
                                static_cast<float>(q.w),
                                static_cast<float>(q.x),
                                static_cast<float>(q.y),
                                static_cast<float>(q.z));
}

std::string mjcf_size(const assets::ContactShape& shape) {
  if (shape.shape != assets::CollisionShape::cylinder) return xml_vector(shape.size);
  return fmt::format("{} {}", static_cast<float>(shape.size.x), static_cast<float>(shape.size.y));
}

}  // namespace marketgen::exporters
