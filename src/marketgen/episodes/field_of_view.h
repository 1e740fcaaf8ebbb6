// Fields of view of rows, which say how wide a camera sees.
#pragma once
#include <cmath>
#include <numbers>

namespace marketgen::episodes {

// Vertical field of view of a picture that is `fov_across_deg` wide.
inline double fov_down_deg(double fov_across_deg, double width, double height) {
  constexpr double half = std::numbers::pi / 360;
  return std::atan(std::tan(fov_across_deg * half) * height / width) / half;
}

}  // namespace marketgen::episodes
