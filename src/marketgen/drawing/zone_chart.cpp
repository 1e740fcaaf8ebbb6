#include "drawing/zone_chart.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <opencv2/imgproc.hpp>

#include "drawing/picture.h"
#include "drawing/zone_classes.h"

namespace marketgen::drawing {
namespace {

constexpr float min_chroma_of_slices = 12;

// The largest area of colour, its gaps of thin lines closed.
std::vector<cv::Point> coloured_outline(const cv::Mat& ab, double side) {
  cv::Mat coloured = chroma_of(ab) > min_chroma_of_slices;
  cv::morphologyEx(coloured, coloured, cv::MORPH_CLOSE, square(odd(0.015 * side)));
  cv::morphologyEx(coloured, coloured, cv::MORPH_OPEN, square(odd(0.01 * side)));
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(coloured, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  if (contours.empty()) return {};
  return *std::ranges::max_element(
      contours, {}, [](const std::vector<cv::Point>& c) { return cv::contourArea(c); });
}

// Every point lies where the ellipse has it.
bool follows(const std::vector<cv::Point>& outline, const cv::RotatedRect& ellipse) {
  constexpr double off = 0.03, max_off = 0.04;  // of the radius; of the points
  const double angle = ellipse.angle * CV_PI / 180;
  int away = 0;
  for (const cv::Point& p : outline) {
    const cv::Point2d d = cv::Point2d(p) - cv::Point2d(ellipse.center);
    const double u = (d.x * std::cos(angle) + d.y * std::sin(angle)) / (ellipse.size.width / 2);
    const double v = (d.y * std::cos(angle) - d.x * std::sin(angle)) / (ellipse.size.height / 2);
    if (std::abs(std::hypot(u, v) - 1) > off) ++away;
  }
  return away < max_off * static_cast<double>(outline.size());
}

// How often the colour changes on the way round, at that part of the radius.
int changes_around(const cv::Mat& ab, const cv::RotatedRect& ellipse, double part) {
  constexpr int samples = 180;
  constexpr double other = 15;
  const double angle = ellipse.angle * CV_PI / 180;
  std::vector<cv::Vec2f> seen;
  for (int i = 0; i < samples; ++i) {
    const double t = 2 * CV_PI * i / samples;
    const double u = part * std::cos(t) * ellipse.size.width / 2;
    const double v = part * std::sin(t) * ellipse.size.height / 2;
    const cv::Point at(cvRound(ellipse.center.x + u * std::cos(angle) - v * std::sin(angle)),
                       cvRound(ellipse.center.y + u * std::sin(angle) + v * std::cos(angle)));
    if (!at.inside(cv::Rect(0, 0, ab.cols, ab.rows))) return 0;
    seen.push_back(ab.at<cv::Vec2f>(at));
  }
  int changes = 0;
  constexpr int step = 3;  // across a line between two slices
  for (int i = 0; i < samples; i += step)
    if (cv::norm(seen[i] - seen[(i + step) % samples]) > other) ++changes;
  return changes;
}

bool is_number(const std::string& words) {
  return !words.empty() && words.find_first_not_of("0123456789.,%- ") == std::string::npos;
}

// So many as an axis has, each as far from the next.
bool are_ticks(std::vector<int> places) {
  constexpr std::size_t least = 4;
  constexpr double even = 0.15;
  if (places.size() < least) return false;
  std::ranges::sort(places);
  const double step =
      1.0 * (places.back() - places.front()) / static_cast<double>(places.size() - 1);
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    if (std::abs(places[i + 1] - places[i] - step) > even * step) return false;
  return step > 0;
}

cv::Point middle_of(const WrittenLine& line) {
  return (line.box.tl() + line.box.br()) / 2;
}

// Numbers one below the other left of the frame, or side by side below it.
bool has_axis(const std::vector<WrittenLine>& lines, const cv::Rect& floor) {
  std::vector<int> left, below;
  for (const WrittenLine& line : lines) {
    if (!is_number(line.words)) continue;
    const cv::Point at = middle_of(line);
    if (at.x < floor.x) left.push_back(at.y);
    if (at.y > floor.y + floor.height) below.push_back(at.x);
  }
  return are_ticks(std::move(left)) || are_ticks(std::move(below));
}

bool has_legend(const std::vector<WrittenLine>& lines, const cv::Rect& floor) {
  return std::ranges::any_of(lines, [&](const WrittenLine& line) {
    return middle_of(line).x > floor.x + floor.width && !line.words.empty() &&
           !is_number(line.words);
  });
}

// Somebody wrote on one of them what it is.
bool are_named(const std::vector<cv::Rect>& bars, const std::vector<WrittenLine>& lines) {
  constexpr double sure = 0.6;
  return std::ranges::any_of(lines, [&](const WrittenLine& line) {
    const bool on_bar = std::ranges::any_of(
        bars, [&](const cv::Rect& bar) { return bar.contains(middle_of(line)); });
    return on_bar && line.confidence > sure && !line.words.empty() && !is_number(line.words);
  });
}

struct Bar {
  cv::Rect box{};
  int pixels = 0;
};

std::vector<Bar> boxes_of(const Segments& segments) {
  std::vector<Bar> bars(segments.parts.size());
  for (int y = 0; y < segments.label.rows; ++y) {
    for (int x = 0; x < segments.label.cols; ++x) {
      const int i = segments.label.at<int>(y, x);
      if (i < 0) continue;
      bars[i].box =
          bars[i].pixels++ == 0 ? cv::Rect(x, y, 1, 1) : bars[i].box | cv::Rect(x, y, 1, 1);
    }
  }
  return bars;
}

// From the side on which bars stand: 0 the lower one, 1 the left one.
bool stands_on(const cv::Rect& bar, const cv::Rect& floor, int side) {
  const double near = 0.02 * std::max(floor.width, floor.height);
  constexpr double free_end = 0.04;
  if (side == 0)
    return std::abs(bar.y + bar.height - floor.y - floor.height) < near &&
           bar.y - floor.y > free_end * floor.height;
  return std::abs(bar.x - floor.x) < near &&
         floor.x + floor.width - bar.x - bar.width > free_end * floor.width;
}

bool are_apart(std::vector<cv::Rect> bars, int side) {
  const auto from = [&](const cv::Rect& b) { return side == 0 ? b.x : b.y; };
  const auto size = [&](const cv::Rect& b) { return side == 0 ? b.width : b.height; };
  std::ranges::sort(bars, {}, from);
  for (std::size_t i = 0; i + 1 < bars.size(); ++i)
    if (from(bars[i + 1]) - from(bars[i]) - size(bars[i]) < 0.1 * size(bars[i])) return false;
  return true;
}

}  // namespace

bool is_pie_chart(const cv::Mat& picture) {
  constexpr int large_enough_px = 500;
  cv::Mat bgr = picture;
  shrink(bgr, large_enough_px);
  constexpr std::size_t min_points = 60;
  constexpr int min_slices = 3;
  const double side = std::max(bgr.cols, bgr.rows);
  const cv::Mat ab = colours_of(bgr);
  const std::vector<cv::Point> outline = coloured_outline(ab, side);
  if (outline.size() < min_points ||
      cv::contourArea(outline) < 0.03 * static_cast<double>(bgr.total()))
    return false;
  const cv::RotatedRect ellipse = cv::fitEllipse(outline);
  if (!follows(outline, ellipse)) return false;
  const int outer = changes_around(ab, ellipse, 0.8), inner = changes_around(ab, ellipse, 0.35);
  return outer >= min_slices && inner >= min_slices && std::abs(outer - inner) <= 2;
}

bool is_bar_chart(const Segments& segments,
                  const cv::Rect& floor,
                  const std::vector<WrittenLine>& lines) {
  constexpr std::size_t min_bars = 3;
  constexpr double full = 0.85;  // of its box
  if (!segments.coloured || segments.hatched) return false;
  std::vector<cv::Rect> bars;
  const std::vector<Bar> parts = boxes_of(segments);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (segments.parts[i].bare) continue;
    if (parts[i].pixels < full * parts[i].box.area()) return false;
    bars.push_back(parts[i].box);
  }
  if (bars.size() < min_bars || are_named(bars, lines)) return false;
  const bool axis = has_axis(lines, floor);
  if (!axis && has_legend(lines, floor)) return false;
  for (const int side : {0, 1}) {
    const bool all =
        std::ranges::all_of(bars, [&](const cv::Rect& bar) { return stands_on(bar, floor, side); });
    if (all && (axis || are_apart(bars, side))) return true;
  }
  return false;
}

}  // namespace marketgen::drawing
