// Parts of a floor that are told apart by colour, by hatching in colour or by lines around them.
#pragma once
#include <vector>

#include <opencv2/core.hpp>

namespace marketgen::drawing {

struct FloorPart {
  cv::Vec2d ab{};   // colour, Lab without its lightness; of pencilled and bare parts 0, 0
  cv::Vec3b bgr{};  // as it looks
  int pixels = 0;
  bool bare = false;  // neither coloured nor hatched, on a floor where others are
};

struct Segments {
  static constexpr int outside = -1;
  cv::Mat label;  // CV_32S: index of the part, or outside
  std::vector<FloorPart> parts;
  bool coloured = false, hatched = false;  // neither: lines divide the floor
};

// Lab's a and b of every pixel, CV_32FC2; paper is 0, 0.
cv::Mat colours_of(const cv::Mat& bgr);
// `floor`: CV_8UC1, where there is floor. `longer_side`: its, in pixels.
Segments segments_of(const cv::Mat& bgr,
                     const cv::Mat& ink,
                     const cv::Mat& floor,
                     double longer_side);

// A small square of one colour beside the plan.
struct Swatch {
  cv::Rect box;
  cv::Vec2d ab{};
};
std::vector<Swatch> swatches_of(const cv::Mat& bgr, const cv::Rect& plan, double longer_side);

}  // namespace marketgen::drawing
