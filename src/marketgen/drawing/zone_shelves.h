// Shelves on a drawing of zones: strokes, bars and narrow boxes that stand free on the floor, side
// by side.
#pragma once
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

#include "drawing/zone_drawing.h"
#include "drawing/zone_segments.h"

namespace marketgen::drawing {

// Along its middle, from end to end, in pixels.
struct ShelfStroke {
  cv::Point2d from, to;
  double width = 0;
  bool along_x = false;  // nearer to the walls that lie east-west
};

// `floor`: CV_8UC1, where there is floor. `turned`: radians that walls are off the picture's rows.
// Strokes that reach from line to line divide the floor, and many close together are hatching:
// neither are shelves.
std::vector<ShelfStroke> shelf_strokes(const cv::Mat& bgr,
                                       const cv::Mat& floor,
                                       double longer_side,
                                       double turned);

// 255 where they stand.
cv::Mat places_of(const std::vector<ShelfStroke>& strokes, cv::Size size);

// The picture as if nothing stood on these places.
cv::Mat without_places(const cv::Mat& bgr, const cv::Mat& places);

// The runs on each part. Strokes in line with one another are one run; so are the two long sides of
// a shelf whose ends are open.
std::vector<std::optional<DrawnRuns>> runs_on(const Segments& segments,
                                              const std::vector<ShelfStroke>& strokes,
                                              double longer_side,
                                              double turned);

}  // namespace marketgen::drawing
