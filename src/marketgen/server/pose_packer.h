// Poses as a page is given them.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/pose.h"
#include "server/packed_sections.h"

namespace marketgen::server {

class PosePacker {
 public:
  void add(const Pose& pose);
  // Sections "position" f32 x 3 and "rotation" i16 x 4: x, y, z, w as 32,767ths.
  void pack(PackedSections& sections) const;

 private:
  std::vector<float> position_;
  std::vector<std::int16_t> rotation_;
};

}  // namespace marketgen::server
