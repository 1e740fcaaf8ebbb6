// Ceiling panels mirrored in glossy surfaces, without noise: the lobe of reflected directions is
// laid on the ceiling as a row of blurred spots, and each spot asks a picture of the ceiling with
// blurred copies how much panel it covers. At
// grazing angles the lobe is long and narrow, which makes the stretched highlights of polished
// floors.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "render/tracing.h"

namespace marketgen::render::raytrace {

class PanelReflection {
 public:
  explicit PanelReflection(const World& world);

  // A glossy point each, and where its mirror looks.
  struct Points {
    Vec8 position, normal, mirror;
    Float8 roughness;
  };
  struct Seen {
    Vec8 radiance;    // of the lobe around `mirror`, nothing in the way
    Float8 distance;  // to the ceiling along `mirror`; 0 when it never gets there
  };
  Seen at(const Points& points) const;

 private:
  // The ceiling from above, row by row from its low corner: how much of each texel is panel.
  struct Level {
    int width = 1, height = 1, first = 0;  // of its texels in shares_
  };
  void draw_panels(const World& world);
  void halve_levels();
  Float8 covered(Float8 x, Float8 y, Float8 spread) const;

  std::vector<Level> levels_;  // finest first, each half as fine as the one before
  std::vector<float> shares_;
  std::array<std::int32_t, 16> widths_{}, heights_{}, firsts_{};  // of levels_, for look-ups
  Vec2f low_;
  float height_ = 0;
  Vec3f radiance_;
};

}  // namespace marketgen::render::raytrace
