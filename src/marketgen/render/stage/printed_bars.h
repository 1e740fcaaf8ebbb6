// The bars of a code on a label, drawn at every look-up instead of from texels, so that a scanner
// reads them as near as it likes.
#pragma once
#include <array>
#include <optional>

#include "assets/print/label.h"
#include "geometry/vector.h"

namespace marketgen::render::raytrace {

class PrintedBars {
 public:
  // On a picture of this size.
  PrintedBars(const assets::LabelBars& bars, int width_px, int height_px);

  // Reflectance 0..1 at (u, v) over 2^lod pixels of the picture each way; nothing beside the bars.
  std::optional<float> sample(float u, float v, float lod) const;

 private:
  static constexpr int modules = 95;
  float white_to(const std::array<float, modules + 1>& sums, float module) const;

  assets::LabelBars place_;
  float modules_per_pixel_ = 1;
  // White modules before each module: of all bars, and of the guard bars alone.
  std::array<float, modules + 1> whites_{}, guard_whites_{};
};

}  // namespace marketgen::render::raytrace
