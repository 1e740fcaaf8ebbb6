// One picture while it is made: planes of what the first hits are, and of the light on them, kept
// apart for filtering.
//
// Radiance of a pixel = transmittance * (albedo * irradiance / pi + reflectance * gloss + emission)
// + overlay.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/vector.h"

namespace marketgen::raytrace {

using Plane = std::vector<float>;

// Three planes of one colour or vector.
struct Planes3 {
  std::array<Plane, 3> axis;
  explicit Planes3(std::size_t count = 0) : axis{Plane(count), Plane(count), Plane(count)} {}
  Vec3f at(std::size_t i) const { return {axis[0][i], axis[1][i], axis[2][i]}; }
  void set(std::size_t i, Vec3f v) {
    axis[0][i] = v.x;
    axis[1][i] = v.y;
    axis[2][i] = v.z;
  }
};

struct Film {
  int width = 0, height = 0;
  Planes3 position, normal;             // of what is behind any glass
  Plane depth;                          // along the optical axis, 0 = nothing
  std::vector<std::uint32_t> instance;  // Frame::instance
  std::vector<std::uint16_t> material;
  std::vector<std::uint8_t> matter;  // Frame::matter
  Planes3 albedo, irradiance;        // diffuse
  Planes3 reflectance, gloss;        // mirrored light
  Planes3 emission, transmittance, overlay;

  Film(int w, int h);
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  std::size_t count() const { return depth.size(); }
  Vec3f radiance(std::size_t i) const;
};

}  // namespace marketgen::raytrace
