#include <algorithm>
#include <cstdint>

#include "assets/import/vlm_annotator.h"

namespace marketgen::assets {
namespace {

// First source pixel that belongs to pixel `i` of `small` out of `large`.
int source_start(int i, int small, int large) {
  return static_cast<int>(static_cast<std::int64_t>(i) * large / small);
}

std::uint8_t mean_of(const Image& picture, int x0, int x1, int y0, int y1, int channel) {
  std::int64_t sum = 0;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x)
      sum += picture.at(x, y)[channel];
  }
  const std::int64_t count = static_cast<std::int64_t>(x1 - x0) * (y1 - y0);
  return static_cast<std::uint8_t>((sum + count / 2) / count);
}

}  // namespace

Image scaled_within(const Image& picture, int longest_px) {
  const int longest = std::max(picture.width, picture.height);
  if (longest <= longest_px) return picture;
  const auto side = [&](int length) {
    return std::max(1, static_cast<int>(static_cast<std::int64_t>(length) * longest_px / longest));
  };
  Image small(side(picture.width), side(picture.height), picture.channels);
  for (int y = 0; y < small.height; ++y) {
    const int y0 = source_start(y, small.height, picture.height);
    const int y1 = source_start(y + 1, small.height, picture.height);
    for (int x = 0; x < small.width; ++x) {
      const int x0 = source_start(x, small.width, picture.width);
      const int x1 = source_start(x + 1, small.width, picture.width);
      for (int c = 0; c < picture.channels; ++c)
        small.at(x, y)[c] = mean_of(picture, x0, x1, y0, y1, c);
    }
  }
  return small;
}

}  // namespace marketgen::assets
