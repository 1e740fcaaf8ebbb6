// What a picture shows of each object: how many pixels, their bounds and their depth.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace marketgen::render {

struct VisiblePart {
  int pixels = 0;
  std::array<int, 4> box{};  // x0, y0, x1, y1; x1 and y1 are past the last pixel
  double depth_sum_m = 0;

  void include(int x, int y, float depth_m);
};

// By the numbers of Frame::instance; nothing for 0. Planes are row-major from the top left.
std::map<std::uint32_t, VisiblePart> visible_parts(const std::vector<std::uint32_t>& instance,
                                                   const std::vector<float>& depth_m,
                                                   int width);

}  // namespace marketgen::render
