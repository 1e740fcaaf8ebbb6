// What is drawn in black or grey on coloured or white ground.
#pragma once
#include <opencv2/core.hpp>

namespace marketgen::drawing {

// CV_8UC1: 255 where something is darker than what is around it and has no colour but that of the
// ground.
cv::Mat grey_marks(const cv::Mat& bgr, double longer_side);

// Lines that a photo shows in pieces are whole.
cv::Mat mended(const cv::Mat& marks);

}  // namespace marketgen::drawing
