#include "render/path/lens.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

// Light that lenses scatter: a halo near the lamp and a wide veil (McCann and Rizzi 2007 find 1 to
// 3 % in all for good lenses).
struct Halo {
  float share;   // of the light
  float spread;  // standard deviation over the picture's height
};
constexpr std::array halos{Halo{0.012F, 0.012F}, Halo{0.006F, 0.06F}};
constexpr int box_passes = 3;        // as good as a Gaussian for what nobody sees by itself
constexpr float corner_loss = 0.2F;  // of what cos^4 takes from a lens without correction

// Half the width of the boxes that make a Gaussian of so many pixels' spread together.
int box_reach(float spread_px) {
  const float width = std::sqrt(12 * spread_px * spread_px / box_passes + 1);
  return std::max(1, static_cast<int>(std::lround((width - 1) / 2)));
}

// Means over `reach` entries to each side along lines of a plane; beside it lies nothing.
struct Lines {
  std::size_t count = 0, length = 0;  // of lines, of entries in each
  std::size_t step = 1, next = 0;     // from entry to entry, from line to line
};
void box_blur(FloatPlane& plane, const Lines& lines, int reach) {
  parallel_for(
      lines.count,
      [&](std::size_t line) {
        const auto at = [&](std::size_t i) { return line * lines.next + i * lines.step; };
        const auto r = static_cast<std::size_t>(reach);
        std::vector<float> before(lines.length);
        for (std::size_t i = 0; i < lines.length; ++i)
          before[i] = plane[at(i)];
        double sum = 0;
        for (std::size_t i = 0; i < std::min(r, lines.length); ++i)
          sum += static_cast<double>(before[i]);
        for (std::size_t i = 0; i < lines.length; ++i) {
          if (i + r < lines.length) sum += static_cast<double>(before[i + r]);
          if (i > r) sum -= static_cast<double>(before[i - r - 1]);
          plane[at(i)] = static_cast<float>(sum / static_cast<double>(2 * r + 1));
        }
      },
      16);
}

void spread_out(FloatPlane& plane, std::size_t width, float spread_px) {
  const std::size_t height = plane.size() / width;
  const int reach = box_reach(spread_px);
  for (int pass = 0; pass < box_passes; ++pass) {
    box_blur(plane, {height, width, 1, width}, reach);
    box_blur(plane, {width, height, width, 1}, reach);
  }
}

}  // namespace

ColorPlanes with_glare(ColorPlanes light, const ColorPlanes& beyond, int width) {
  const auto across = static_cast<std::size_t>(width);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const FloatPlane& source = beyond.axis[axis];
    if (std::none_of(source.begin(), source.end(), [](float x) { return x > 0; })) continue;
    const auto height = static_cast<float>(source.size() / across);
    for (const Halo& halo : halos) {
      FloatPlane scattered = source;
      spread_out(scattered, across, halo.spread * height);
      for (std::size_t i = 0; i < scattered.size(); ++i)
        light.axis[axis][i] += halo.share * scattered[i];
    }
  }
  return light;
}

float arriving_share(float cosine) {
  const float square = cosine * cosine;
  return 1 - corner_loss * (1 - square * square);
}

}  // namespace marketgen::render::raytrace
