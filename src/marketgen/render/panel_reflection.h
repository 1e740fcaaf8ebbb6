// Ceiling panels mirrored in glossy surfaces, without noise: the lobe of reflected directions is
// laid on the ceiling as a row of blurred spots, and each spot asks how much panel it covers. At
// grazing angles the lobe is long and narrow, which makes the stretched highlights of polished
// floors.
#pragma once
#include <cstdint>
#include <vector>

#include "render/tracing.h"

namespace marketgen::raytrace {

class PanelReflection {
 public:
  explicit PanelReflection(const World& world);

  struct Seen {
    Vec3f radiance;      // of the lobe around `mirror`, nothing in the way
    float distance = 0;  // to the ceiling along `mirror`; 0 when it never gets there
  };
  Seen at(const Surface& surface, Vec3f mirror) const;

 private:
  float covered(Vec2f point, float spread) const;

  struct Panel {
    Vec2f middle, half;
  };
  std::vector<Panel> panels_;
  std::vector<std::vector<std::uint32_t>> panels_near_;  // of each cell of the ceiling
  Vec2f low_;
  int columns_ = 1, rows_ = 1;
  float height_ = 0;
  Vec3f radiance_;
};

}  // namespace marketgen::raytrace
