#include "render/stage/printed_bars.h"

#include <algorithm>
#include <cmath>

namespace marketgen::render::raytrace {
namespace {

// Print on white: EN ISO/IEC 15416 wants a symbol contrast of 70 % for the best grade.
constexpr float ink = 0.02F, paper = 0.9F;

// Left, middle and right guard patterns of EAN-13.
bool is_guard(std::size_t module) {
  return module < 3 || module >= 92 || (module >= 45 && module < 50);
}

}  // namespace

PrintedBars::PrintedBars(const assets::LabelBars& bars, int width_px, int height_px)
    : place_(bars) {
  const float length_px = place_.ladder ? (place_.v1 - place_.v0) * static_cast<float>(height_px)
                                        : (place_.u1 - place_.u0) * static_cast<float>(width_px);
  modules_per_pixel_ = modules / length_px;
  for (std::size_t i = 0; i < modules; ++i) {
    const bool bar = i < place_.modules.size() && place_.modules[i] == '1';
    whites_[i + 1] = whites_[i] + (bar ? 0.0F : 1.0F);
    guard_whites_[i + 1] = guard_whites_[i] + (bar && is_guard(i) ? 0.0F : 1.0F);
  }
}

float PrintedBars::white_to(const std::array<float, modules + 1>& sums, float module) const {
  const float at = std::clamp(module, 0.0F, static_cast<float>(modules));
  const auto whole = std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(modules - 1));
  return sums[whole] + (at - static_cast<float>(whole)) * (sums[whole + 1] - sums[whole]);
}

std::optional<float> PrintedBars::sample(float u, float v, float lod) const {
  u -= std::floor(u);
  v -= std::floor(v);
  if (u < place_.u0 || u >= place_.u1 || v < place_.v0 || v >= place_.v1) return std::nullopt;
  const float across_u = (u - place_.u0) / (place_.u1 - place_.u0);
  const float across_v = (v - place_.v0) / (place_.v1 - place_.v0);
  // A symbol that lies reads downwards and has its feet at the left.
  const float along = place_.ladder ? across_v : across_u;
  const float down = place_.ladder ? 1 - across_u : across_v;
  constexpr float least = 0.02F;  // modules: keeps the quotient below finite
  const float span =
      std::clamp(std::exp2(lod) * modules_per_pixel_, least, static_cast<float>(modules));
  const auto& sums = down < 1 - place_.foot ? whites_ : guard_whites_;
  const float middle = along * modules;
  const float from = std::max(middle - span / 2, 0.0F);
  const float to = std::min(middle + span / 2, static_cast<float>(modules));
  const float white = (white_to(sums, to) - white_to(sums, from)) / (to - from);
  return ink + white * (paper - ink);
}

}  // namespace marketgen::render::raytrace
