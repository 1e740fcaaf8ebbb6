// The curve of sRGB, IEC 61966-2-1.
#pragma once
#include <cmath>

namespace marketgen {
inline namespace geometry {

// Of linear light 0..1: 0..1.
inline double srgb_encoded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

}  // namespace geometry
}  // namespace marketgen
