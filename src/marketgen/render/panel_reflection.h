// Ceiling panels mirrored in glossy surfaces, without noise: the lobe of reflected directions is
// laid on the ceiling as a row of blurred spots, and each spot asks a picture of the ceiling with
// blurred copies how much panel it covers. At
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
  // The ceiling from above, row by row from its low corner: how much of each texel is panel.
  struct Level {
    int width = 1, height = 1;
    std::vector<float> share;
  };
  void draw_panels(const World& world);
  void halve_levels();
  float covered(Vec2f point, float spread) const;

  std::vector<Level> levels_;  // finest first, each half as fine as the one before
  Vec2f low_;
  float height_ = 0;
  Vec3f radiance_;
};

}  // namespace marketgen::raytrace
