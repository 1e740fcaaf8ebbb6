#include "geometry/area_filter.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace marketgen {
inline namespace geometry {
namespace {

// What of a row or column of pixels lies in a box.
struct Span {
  double from, to;
  int first, last;  // pixels that it touches

  double weight(int i) const {
    return std::min(to, static_cast<double>(i) + 1) - std::max(from, static_cast<double>(i));
  }
};

Span span_of(double from, double to, int length) {
  if (to - from < 1) {
    const double middle = (from + to) / 2;
    from = middle - 0.5;
    to = middle + 0.5;
  }
  // So far out nothing but the border is met, and the pixels' numbers stay small.
  from = std::clamp(from, -1.0, length + 0.0);
  to = std::clamp(to, from + 1, std::max(from + 1, length + 1.0));
  return {from, to, static_cast<int>(std::floor(from)), static_cast<int>(std::ceil(to)) - 1};
}

}  // namespace

Rgb8 area_mean(const Image& picture, const PixelBox& box) {
  const Span across = span_of(box.x0, box.x1, picture.width);
  const Span down = span_of(box.y0, box.y1, picture.height);
  std::array<double, 3> sum{};
  double all = 0;
  for (int y = down.first; y <= down.last; ++y) {
    for (int x = across.first; x <= across.last; ++x) {
      const double weight = across.weight(x) * down.weight(y);
      const std::uint8_t* pixel =
          picture.at(std::clamp(x, 0, picture.width - 1), std::clamp(y, 0, picture.height - 1));
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += weight * pixel[c];
      all += weight;
    }
  }
  const auto mean = [&](std::size_t c) {
    return static_cast<std::uint8_t>(std::clamp<long>(std::lround(sum[c] / all), 0, 255));
  };
  return {mean(0), mean(1), mean(2)};
}

Image area_scaled(const Image& picture, int width, int height) {
  Image scaled(std::max(1, width), std::max(1, height));
  const double across = static_cast<double>(picture.width) / scaled.width;
  const double down = static_cast<double>(picture.height) / scaled.height;
  for (int y = 0; y < scaled.height; ++y) {
    for (int x = 0; x < scaled.width; ++x) {
      const Rgb8 mean =
          area_mean(picture, {x * across, y * down, (x + 1) * across, (y + 1) * down});
      std::uint8_t* pixel = scaled.at(x, y);
      pixel[0] = mean.r;
      pixel[1] = mean.g;
      pixel[2] = mean.b;
    }
  }
  return scaled;
}

}  // namespace geometry
}  // namespace marketgen
