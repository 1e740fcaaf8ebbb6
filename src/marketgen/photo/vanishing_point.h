// Straight lines of a photo, and the point that those which lead away from the photographer meet
// in.
#pragma once
#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

namespace marketgen::photo {

struct Segment {
  cv::Point2d a, b;  // pixels
  double length() const { return std::hypot(b.x - a.x, b.y - a.y); }
  cv::Point2d middle() const { return 0.5 * (a + b); }
};

// Longest first. `lightness`: CV_8UC1.
std::vector<Segment> segments_of(const cv::Mat& lightness);

struct VanishingPoint {
  cv::Point2d at;                    // pixels; may lie beside the photo
  double length = 0;                 // of the segments that lead to it
  std::vector<std::size_t> leading;  // which do
};

// Of the slanted segments only: level and upright ones lead everywhere. length 0 when there are
// none.
VanishingPoint vanishing_point(const std::vector<Segment>& segments, cv::Size photo);

// Neither level nor upright.
bool is_slanted(const Segment& segment);

}  // namespace marketgen::photo
