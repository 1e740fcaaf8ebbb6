// How much neighbouring columns and rows of a picture differ, for tests of seams.
#pragma once
#include <cstdlib>

#include "geometry/image.h"

namespace marketgen {

// Mean difference per value of the pixels of two columns, 0..255.
inline double column_difference(const Image& image, int a, int b) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int c = 0; c < image.channels; ++c)
      sum += std::abs(int{image.at(a, y)[c]} - int{image.at(b, y)[c]});
  }
  return sum / (image.channels * image.height);
}

inline double row_difference(const Image& image, int a, int b) {
  double sum = 0;
  for (int x = 0; x < image.width; ++x) {
    for (int c = 0; c < image.channels; ++c)
      sum += std::abs(int{image.at(x, a)[c]} - int{image.at(x, b)[c]});
  }
  return sum / (image.channels * image.width);
}

}  // namespace marketgen
