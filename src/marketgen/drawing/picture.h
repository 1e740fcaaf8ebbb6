// Pictures as files have them, made ready to be looked at.
#pragma once
#include <array>
#include <opencv2/core.hpp>

#include "geometry/image.h"

namespace marketgen::drawing {

// CV_8UC3 of a picture with any channels; what is see-through is white.
cv::Mat bgr_of(const Image& image);

// How many masked pixels have each value. Both are CV_8UC1 of one size; a mask is 0 where it hides.
std::array<int, 256> masked_histogram(const cv::Mat& value, const cv::Mat& mask);

// Makes a picture whose longer side is longer so large. How many of its pixels are one now.
double shrink(cv::Mat& picture, int longest_side_px);

}  // namespace marketgen::drawing
