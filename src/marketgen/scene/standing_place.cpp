#include "scene/standing_place.h"

#include <cmath>

namespace marketgen::scene {

PointMm standing_point(const Scene& scene, std::uint32_t shelf) {
  const Vec3 at = world_from_shelf(scene, shelf) * Vec3{0, -standing_mm * 1e-3, 0};
  return floor_mm(at);
}

}  // namespace marketgen::scene
