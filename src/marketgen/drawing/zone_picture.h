// A picture of a shop's zones made straight: even light, white paper, the floor seen from above.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <opencv2/core.hpp>

#include "base/result.h"

namespace marketgen::drawing {

struct Gap {
  int side = 0;             // 0 south, 1 east, 2 north, 3 west
  double from = 0, to = 0;  // pixels from the side's western or southern end
};

struct ZonePicture {
  cv::Mat bgr;  // CV_8UC3; paper is about 250 in every channel
  cv::Mat ink;  // CV_8UC1, 255 where something dark without colour is drawn: walls, letters, pencil
  // Inner faces of the walls, pixels. For a floor that is no rectangle the box around the walls.
  cv::Rect2d floor;
  bool rectangle = false;     // four straight walls were found, and the picture made square by them
  std::vector<Gap> gaps;      // in the walls of a rectangle
  double seen_aspect = 0;     // width over depth of a rectangle, as the picture shows it
  double px_of_file = 1;      // pixels of the file in one of this picture
  double longer_side = 1000;  // of `floor`, pixels: what sizes on the picture are told by
};

constexpr double paper_value = 250;
cv::Mat brightest_channel(const cv::Mat& bgr);
// Light and paper evened out: paper becomes 250, 250, 250, what is no sheet of paper too.
cv::Mat flattened(const cv::Mat& bgr);
cv::Mat dark_ink(const cv::Mat& flat);
// Corners of the inner and outer faces of four straight walls, from the north-west clockwise.
struct FourWalls {
  std::array<cv::Point2d, 4> inner, outer;
};
std::optional<FourWalls> four_walls(const cv::Mat& ink);
// Width over depth of a rectangle that is seen as these corners in a picture of that size.
double aspect_of(const std::array<cv::Point2d, 4>& corners, cv::Size picture);

// `aspect`: width over depth where it is known, else 0. Errors: drawing.bad_file, image.bad_file,
// input.too_large, drawing.no_outline, drawing.chart.
Result<ZonePicture> zone_picture(std::string_view bytes, const std::string& where, double aspect);

}  // namespace marketgen::drawing
