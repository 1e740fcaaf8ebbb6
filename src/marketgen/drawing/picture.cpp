#include "drawing/picture.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace marketgen::drawing {

cv::Mat bgr_of(const Image& image) {
  cv::Mat bgr(image.height, image.width, CV_8UC3);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* p = image.at(x, y);
      const bool see_through = image.channels == 4 || image.channels == 2;
      const int alpha = see_through ? p[image.channels - 1] : 255;
      const auto over = [&](int value) {
        return static_cast<std::uint8_t>((value * alpha + 255 * (255 - alpha)) / 255);
      };
      const bool colour = image.channels >= 3;
      bgr.at<cv::Vec3b>(y, x) = {over(p[colour ? 2 : 0]), over(p[colour ? 1 : 0]), over(p[0])};
    }
  }
  return bgr;
}

std::array<int, 256> masked_histogram(const cv::Mat& value, const cv::Mat& mask) {
  std::array<int, 256> counts{};
  for (int y = 0; y < value.rows; ++y) {
    for (int x = 0; x < value.cols; ++x)
      if (mask.at<std::uint8_t>(y, x) != 0) ++counts[value.at<std::uint8_t>(y, x)];
  }
  return counts;
}

double shrink(cv::Mat& picture, int longest_side_px) {
  const int longer = std::max(picture.cols, picture.rows);
  if (longer <= longest_side_px) return 1;
  const double px = static_cast<double>(longer) / longest_side_px;
  cv::resize(picture, picture, {}, 1 / px, 1 / px, cv::INTER_AREA);
  return px;
}

}  // namespace marketgen::drawing
