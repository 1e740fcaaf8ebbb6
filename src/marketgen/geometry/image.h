// Pictures in memory: 8-bit sRGB colour, or float planes.
#pragma once
#include <cstdint>
#include <vector>

namespace marketgen {
inline namespace geometry {

struct Rgb8 {
  std::uint8_t r = 0, g = 0, b = 0;
  friend constexpr bool operator==(const Rgb8&, const Rgb8&) = default;
};

// Row-major from the top left, `channels` bytes a pixel (3 = RGB, 4 = RGBA), sRGB-encoded.
struct Image {
  int width = 0, height = 0, channels = 3;
  std::vector<std::uint8_t> pixels;

  Image() = default;
  Image(int w, int h, int c = 3)
      : width(w),
        height(h),
        channels(c),
        pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) *
               static_cast<std::size_t>(c)) {}
  std::uint8_t* at(int x, int y) {
    return &pixels[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x)) *
                   static_cast<std::size_t>(channels)];
  }
  const std::uint8_t* at(int x, int y) const { return const_cast<Image*>(this)->at(x, y); }
  bool empty() const { return pixels.empty(); }
};

struct PictureSize {
  int width = 0, height = 0;  // pixels
  friend constexpr bool operator==(const PictureSize&, const PictureSize&) = default;
};

}  // namespace geometry
}  // namespace marketgen
