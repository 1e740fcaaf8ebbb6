#include "drawing/zone_marks.h"

#include <algorithm>
#include <array>

#include <opencv2/imgproc.hpp>

#include "drawing/zone_picture.h"

namespace marketgen::drawing {
cv::Mat grey_marks(const cv::Mat& bgr, double side) {
  constexpr double darker = 0.86, grey_share = 0.4, smeared = 1.15;
  std::array<cv::Mat, 3> channels;
  cv::split(bgr, channels.data());
  const cv::Mat high = cv::max(cv::max(channels[0], channels[1]), channels[2]);
  const cv::Mat low = cv::min(cv::min(channels[0], channels[1]), channels[2]);
  const int window = 2 * static_cast<int>(side / 50) + 1;
  cv::Mat around, colour, ground, even;
  cv::GaussianBlur(high, even, {3, 3}, 0);
  cv::blur(high, around, {window, window});
  around.convertTo(around, CV_8U, darker);
  cv::divide(high - low, high, colour, 255);
  cv::blur(colour, ground, {window, window});
  ground.convertTo(ground, CV_8U, smeared, 12);
  const cv::Mat grey = colour < cv::max(ground, 255 * grey_share);
  return dark_ink(bgr) | ((even < around) & grey);
}

cv::Mat mended(const cv::Mat& marks) {
  constexpr int gap = 7;
  cv::Mat whole = marks, lengthwise;
  for (const cv::Size& way : {cv::Size(gap, 1), cv::Size(1, gap)}) {
    cv::morphologyEx(marks, lengthwise, cv::MORPH_CLOSE, cv::Mat::ones(way, CV_8UC1));
    whole = whole | lengthwise;
  }
  return whole;
}

}  // namespace marketgen::drawing
