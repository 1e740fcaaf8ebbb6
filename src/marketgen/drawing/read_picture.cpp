// PNG and JPEG floor plans: ink is told from paper, walls from thin lines, and their edges become
// straight lines again. OpenCV does the work on pixels.
#include <algorithm>
#include <cmath>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "drawing/line.h"
#include "drawing/picture.h"
#include "drawing/polygons.h"
#include "drawing/sketch.h"
#include "geometry/image.h"
#include "io/picture_file.h"

namespace marketgen::drawing {
namespace {

constexpr int longest_side_px = 3000;  // larger pictures are read at this size
constexpr double stub_px = 6;          // what is left of a thin line at a corner of a wall
constexpr double specks_px = 12;       // ink of less area is dirt

cv::Mat grey_of(const Image& image) {
  cv::Mat grey(image.height, image.width, CV_8UC1);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* p = image.at(x, y);
      const int value = image.channels >= 3 ? (299 * p[0] + 587 * p[1] + 114 * p[2]) / 1000 : p[0];
      const bool see_through = image.channels == 4 || image.channels == 2;
      const int alpha = see_through ? p[image.channels - 1] : 255;
      grey.at<std::uint8_t>(y, x) =
          static_cast<std::uint8_t>((value * alpha + 255 * (255 - alpha)) / 255);
    }
  }
  return grey;
}

// White where there is ink.
cv::Mat ink_of(const cv::Mat& grey) {
  cv::Mat ink;
  cv::threshold(grey, ink, 0, 255, cv::THRESH_BINARY_INV | cv::THRESH_OTSU);
  if (cv::countNonZero(ink) * 2 > ink.rows * ink.cols) cv::bitwise_not(ink, ink);  // a blueprint
  return ink;
}

// Pixels of parts as long as a wall.
int long_pixels(const cv::Mat& mask, int min_px) {
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(mask, labels, stats, centres, 8, CV_32S);
  int pixels = 0;
  for (int i = 1; i < count; ++i) {
    const int side =
        std::max(stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT));
    if (side >= min_px) pixels += stats.at<int>(i, cv::CC_STAT_AREA);
  }
  return pixels;
}

// Half the thickness of the thickest lines that go on for as long as walls do.
int half_thickness(const cv::Mat& depth, const cv::Mat& ink) {
  constexpr int most = 60;
  const cv::Rect box = cv::boundingRect(ink);
  const int around = box.width + box.height;
  int best = 1;
  for (int half = 2; half <= most; ++half) {
    const cv::Mat inner = depth >= half;
    if (long_pixels(inner, around / 20) < around / 2) break;
    best = half;
  }
  return best;
}

// What is at least half as thick as walls are.
cv::Mat thick_parts(const cv::Mat& ink, int half) {
  cv::Mat thick;
  const int side = std::max(3, half);
  cv::morphologyEx(ink, thick, cv::MORPH_OPEN, cv::Mat::ones(side, side, CV_8UC1));
  return thick;
}

// Least squares through the contour's points between two corners, but for those near the corners.
std::optional<Line> fitted(const std::vector<cv::Point>& contour,
                           std::size_t from,
                           std::size_t to) {
  const std::size_t n = contour.size();
  const std::size_t count = (to + n - from) % n;
  constexpr std::size_t least = 10;
  if (count < least) return std::nullopt;
  std::vector<cv::Point2f> points;
  for (std::size_t i = count / 8 + 1; i < count - count / 8; ++i) {
    const cv::Point& p = contour[(from + i) % n];
    points.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
  }
  cv::Vec4f line;
  cv::fitLine(points, line, cv::DIST_HUBER, 0, 0.01, 0.01);
  return Line{{line[2], line[3]}, {line[0], line[1]}};
}

// The contour's corners, where the lines between them meet.
std::vector<cv::Point2d> corners_of(const std::vector<cv::Point>& contour, double within_px) {
  std::vector<cv::Point> rough;
  cv::approxPolyDP(contour, rough, within_px, true);
  std::vector<std::size_t> at;
  std::size_t from = 0;
  for (const cv::Point& corner : rough) {
    while (from < contour.size() && contour[from] != corner)
      ++from;
    at.push_back(from < contour.size() ? from : 0);
  }
  std::vector<cv::Point2d> corners;
  const std::size_t n = rough.size();
  std::vector<std::optional<Line>> lines;
  for (std::size_t i = 0; i < n; ++i)
    lines.push_back(fitted(contour, at[i], at[(i + 1) % n]));
  for (std::size_t i = 0; i < n; ++i) {
    const auto& before = lines[(i + n - 1) % n];
    const auto& after = lines[i];
    const cv::Point2d corner(rough[i].x, rough[i].y);
    const auto met = before && after ? meeting(*before, *after, 0.1) : std::nullopt;
    const bool near = met && cv::norm(*met - corner) < 4 * within_px;
    corners.push_back(near ? *met : corner);
  }
  return corners;
}

class Tracer {
 public:
  explicit Tracer(double px) : px_(px) {}

  // Edges of ink lie half a pixel outside the middles of its pixels.
  void trace(const cv::Mat& mask, double within_px, Role role) {
    std::vector<std::vector<cv::Point>> contours;
    std::vector<cv::Vec4i> tree;
    cv::findContours(mask.clone(), contours, tree, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
    for (std::size_t i = 0; i < contours.size(); ++i) {
      const bool hole = tree[i][3] >= 0;
      const double area = cv::contourArea(contours[i]);
      if (area < specks_px) continue;
      Polygon polygon;
      for (const cv::Point2d& p : corners_of(contours[i], within_px))
        polygon.push_back({p.x + 0.5, -(p.y + 0.5)});
      polygon = sharpened(grown(polygon, hole ? -0.5 : 0.5), stub_px);
      if (polygon.size() >= 3) add(std::move(polygon), role);
    }
  }

  // Small solid shapes, and hollow ones with four corners: letters are neither.
  void trace_columns(const cv::Mat& ink, int max_px) {
    std::vector<std::vector<cv::Point>> all;
    cv::findContours(ink.clone(), all, cv::RETR_LIST, cv::CHAIN_APPROX_NONE);
    for (const std::vector<cv::Point>& contour : all) {
      const cv::Rect box = cv::boundingRect(contour);
      const double area = cv::contourArea(contour);
      if (area < specks_px || std::max(box.width, box.height) > max_px) continue;
      std::vector<cv::Point> rough;
      cv::approxPolyDP(
          contour, rough, std::max(1.5, 0.08 * cv::arcLength(contour, true) / 4), true);
      cv::Mat filled = cv::Mat::zeros(box.size(), CV_8UC1);
      cv::drawContours(filled,
                       std::vector<std::vector<cv::Point>>{contour},
                       0,
                       255,
                       cv::FILLED,
                       cv::LINE_8,
                       cv::noArray(),
                       0,
                       -box.tl());
      const double inked = cv::countNonZero(filled & ink(box));
      const bool solid = inked > 0.9 * cv::countNonZero(filled);
      if (!solid && rough.size() != 4) continue;
      Polygon polygon;
      for (const cv::Point& p : solid ? contour : rough)
        polygon.push_back({p.x + 0.5, -(p.y + 0.5)});
      polygon = grown(polygon, 0.5);
      if (polygon.size() >= 4) add(std::move(polygon), Role::unknown);
    }
  }

  std::vector<Stroke> take() { return std::move(strokes_); }

 private:
  void add(Polygon polygon, Role role) {
    for (Vec2& p : polygon)
      p = p * px_;
    Stroke stroke;
    stroke.points = std::move(polygon);
    stroke.closed = true;
    stroke.role = role;
    strokes_.push_back(std::move(stroke));
  }

  double px_;  // pixels of the file in one of the picture that is looked at
  std::vector<Stroke> strokes_;
};

Sketch sketch_of(const Image& image) {
  cv::Mat grey = grey_of(image);
  const int longer = std::max(grey.cols, grey.rows);
  const double px = shrink(grey, longest_side_px);
  const cv::Mat ink = ink_of(grey);
  cv::Mat depth;
  cv::distanceTransform(ink, depth, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  const int half = half_thickness(depth, ink);
  Tracer tracer(px);
  tracer.trace(half >= 3 ? thick_parts(ink, half) : ink, 1.6, Role::wall);
  tracer.trace_columns(ink, longer / 12);
  Sketch sketch;
  sketch.strokes = tracer.take();
  sketch.picture = true;
  sketch.precision = px;
  return sketch;
}

}  // namespace

Result<Sketch> read_picture(std::string_view bytes, const std::string& where) {
  MARKETGEN_TRY(const Image image, io::decoded_picture(bytes, where));
  constexpr int min_px = 60;
  if (std::min(image.width, image.height) < min_px)
    return Error{"drawing.bad_file",
                 where,
                 "the picture has " + std::to_string(image.width) + " x " +
                     std::to_string(image.height) + " pixels; a floor plan needs at least 60 x 60"};
  try {
    return sketch_of(image);
  } catch (const cv::Exception& fault) {
    return Error{
        "drawing.bad_file", where, std::string("the picture cannot be looked at: ") + fault.what()};
  }
}

}  // namespace marketgen::drawing
