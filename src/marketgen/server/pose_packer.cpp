#include "server/pose_packer.h"

#include <span>

#include "server/view_mesh.h"

namespace marketgen::server {

void PosePacker::add(const Pose& pose) {
  for (const double value : {pose.position.x, pose.position.y, pose.position.z})
    position_.push_back(static_cast<float>(value));
  const auto turned = packed_rotation(pose.rotation);
  rotation_.insert(rotation_.end(), turned.begin(), turned.end());
}

void PosePacker::pack(PackedSections& sections) const {
  sections.add("position", 3, std::span<const float>(position_));
  sections.add("rotation", 4, std::span<const std::int16_t>(rotation_));
}

}  // namespace marketgen::server
