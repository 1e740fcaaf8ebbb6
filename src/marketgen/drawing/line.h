// Straight lines of a picture, in pixels.
#pragma once
#include <cmath>
#include <opencv2/core.hpp>
#include <optional>

namespace marketgen::drawing {

// `way` is of unit length.
struct Line {
  cv::Point2d at, way;
};

// Where two lines meet; nothing where the sine of the angle between them is less than `min_sine`.
inline std::optional<cv::Point2d> meeting(const Line& a, const Line& b, double min_sine) {
  const double sine = a.way.x * b.way.y - a.way.y * b.way.x;
  if (std::abs(sine) < min_sine) return std::nullopt;
  const cv::Point2d to = b.at - a.at;
  return a.at + a.way * ((to.x * b.way.y - to.y * b.way.x) / sine);
}

}  // namespace marketgen::drawing
