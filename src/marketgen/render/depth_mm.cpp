#include "render/depth_mm.h"

#include <algorithm>

namespace marketgen::render {

constexpr float max_depth_mm = 65535;  // in 16 bits

std::vector<std::uint16_t> depth_in_mm(const std::vector<float>& depth_m) {
  std::vector<std::uint16_t> millimetres(depth_m.size());
  std::ranges::transform(depth_m, millimetres.begin(), [](float depth) {
    return static_cast<std::uint16_t>(std::min(depth * 1000.0F + 0.5F, max_depth_mm));
  });
  return millimetres;
}

}  // namespace marketgen::render
