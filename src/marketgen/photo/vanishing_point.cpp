#include "photo/vanishing_point.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace marketgen::photo {
namespace {

constexpr double min_length_px = 22;
constexpr std::size_t max_segments = 400;
constexpr double slant = 0.12;      // tangent of the angle to level and upright
constexpr double max_miss = 0.035;  // sine of the angle between a segment and the way to the point
constexpr int across = 41, down = 31;

bool leads_to(const Segment& segment, cv::Point2d point) {
  const cv::Point2d along = segment.b - segment.a, way = point - segment.middle();
  const double far2 = way.dot(way), miss = along.cross(way);
  if (far2 < 1) return false;
  return miss * miss < max_miss * max_miss * along.dot(along) * far2;
}

double support_of(const std::vector<Segment>& slanted, cv::Point2d point) {
  double length = 0;
  for (const Segment& segment : slanted)
    length += leads_to(segment, point) ? segment.length() : 0;
  return length;
}

// The best point of a grid over the photo and half of one around it.
cv::Point2d best_of_grid(const std::vector<Segment>& slanted, cv::Point2d from, cv::Size2d size) {
  cv::Point2d best = from;
  double most = -1;
  for (int row = 0; row < down; ++row) {
    for (int column = 0; column < across; ++column) {
      const cv::Point2d point(from.x + size.width * column / (across - 1),
                              from.y + size.height * row / (down - 1));
      const double support = support_of(slanted, point);
      if (support <= most) continue;
      most = support;
      best = point;
    }
  }
  return best;
}

}  // namespace

bool is_slanted(const Segment& segment) {
  const cv::Point2d along = segment.b - segment.a;
  return std::abs(along.y) > slant * std::abs(along.x) &&
         std::abs(along.x) > slant * std::abs(along.y);
}

std::vector<Segment> segments_of(const cv::Mat& lightness) {
  std::vector<cv::Vec4f> found;
  cv::createLineSegmentDetector(cv::LSD_REFINE_STD)->detect(lightness, found);
  std::vector<Segment> segments;
  for (const cv::Vec4f& line : found) {
    const Segment segment{{line[0], line[1]}, {line[2], line[3]}};
    if (segment.length() >= min_length_px) segments.push_back(segment);
  }
  std::ranges::stable_sort(segments, std::ranges::greater{}, &Segment::length);
  if (segments.size() > max_segments) segments.resize(max_segments);
  return segments;
}

VanishingPoint vanishing_point(const std::vector<Segment>& segments, cv::Size photo) {
  std::vector<Segment> slanted;
  std::ranges::copy_if(segments, std::back_inserter(slanted), is_slanted);
  VanishingPoint found;
  found.at = {0.5 * photo.width, 0.5 * photo.height};
  if (slanted.empty()) return found;
  const cv::Size2d wide(2.0 * photo.width, 2.0 * photo.height);
  found.at = best_of_grid(slanted, {-0.5 * photo.width, -0.5 * photo.height}, wide);
  const cv::Size2d near(4 * wide.width / across, 4 * wide.height / down);
  found.at =
      best_of_grid(slanted, found.at - cv::Point2d(0.5 * near.width, 0.5 * near.height), near);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (!is_slanted(segments[i]) || !leads_to(segments[i], found.at)) continue;
    found.leading.push_back(i);
    found.length += segments[i].length();
  }
  return found;
}

}  // namespace marketgen::photo
