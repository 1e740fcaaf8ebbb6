// A path-traced picture while it is made: means over the pixels' paths, split for the denoisers,
// and what each pixel's middle shows.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "render/path/path.h"

namespace marketgen::render::raytrace {

using FloatPlane = std::vector<float>;

// Three planes of one colour or vector, row-major from the top left.
struct ColorPlanes {
  std::array<FloatPlane, 3> axis;
  explicit ColorPlanes(std::size_t count = 0)
      : axis{FloatPlane(count), FloatPlane(count), FloatPlane(count)} {}
  Vec3f at(std::size_t i) const { return {axis[0][i], axis[1][i], axis[2][i]}; }
  void set(std::size_t i, Vec3f v) {
    axis[0][i] = v.x;
    axis[1][i] = v.y;
    axis[2][i] = v.z;
  }
};

// What a pixel's middle shows behind panes.
struct PictureGuides {
  ColorPlanes position, normal;  // store frame
  FloatPlane depth_m;            // along the optical axis, 0 = nothing
  FloatPlane roughness;
  std::vector<std::uint32_t> instance;  // Frame::instance
  explicit PictureGuides(std::size_t count)
      : position(count), normal(count), depth_m(count), roughness(count), instance(count) {}
};

// Sums over one pixel's paths.
struct PathSums {
  PathLight light;
  // Of luminance, and of its square: the first rough surface's irradiance over pi, and gloss.
  float irradiance = 0, irradiance2 = 0, gloss = 0, gloss2 = 0;
  void add(const PathLight& path);
};

// Light kept apart from colour; radiance = albedo * irradiance + gloss + glow.
struct PathFilm {
  int width = 0, height = 0;
  ColorPlanes albedo, paint;  // see PathLight
  ColorPlanes irradiance;     // over pi, on the first rough surface
  ColorPlanes gloss, glow;
  ColorPlanes beyond;                              // of glow, see PathLight
  FloatPlane irradiance_variance, gloss_variance;  // of the means' luminance
  PathFilm(int w, int h, const std::vector<PathSums>& sums, int paths);
  std::size_t count() const { return irradiance_variance.size(); }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  Vec3f radiance(std::size_t i) const {
    return albedo.at(i) * irradiance.at(i) + gloss.at(i) + glow.at(i);
  }
};

}  // namespace marketgen::render::raytrace
