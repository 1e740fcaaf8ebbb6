#include "drawing/zone_hatching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "drawing/zone_classes.h"

namespace marketgen::drawing {
namespace {

// Where strokes begin along rows and along columns: their number in an area is its strokes' length,
// or up to 1.4 times that, whatever their width.
cv::Mat stroke_beginnings(const cv::Mat& strokes) {
  cv::Mat count = cv::Mat::zeros(strokes.size(), CV_32F);
  for (int y = 1; y < strokes.rows; ++y) {
    for (int x = 1; x < strokes.cols; ++x) {
      if (strokes.at<std::uint8_t>(y, x) == 0) continue;
      count.at<float>(y, x) = (strokes.at<std::uint8_t>(y, x - 1) == 0 ? 1.F : 0.F) +
                              (strokes.at<std::uint8_t>(y - 1, x) == 0 ? 1.F : 0.F);
    }
  }
  return count;
}

// Around each pixel the direction of the strokes as a vector at twice their angle, as long as they
// agree: `strength` when they are parallel, 0 when they cross at right angles.
cv::Mat directions(const cv::Mat& strokes, int window, double strength) {
  cv::Mat grey, dx, dy;
  strokes.convertTo(grey, CV_32F, 1.0 / 255);
  cv::GaussianBlur(grey, grey, {0, 0}, 1.2);
  cv::Sobel(grey, dx, CV_32F, 1, 0);
  cv::Sobel(grey, dy, CV_32F, 0, 1);
  cv::Mat xx = dx.mul(dx), yy = dy.mul(dy), xy = dx.mul(dy);
  for (cv::Mat* one : {&xx, &yy, &xy})
    cv::blur(*one, *one, {window, window});
  const cv::Mat sum = xx + yy + 1e-6;
  cv::Mat a, b, both;
  cv::divide(xx - yy, sum, a, strength);
  cv::divide(xy, sum, b, 2 * strength);
  cv::merge(std::vector<cv::Mat>{a, b}, both);
  return both;
}

// Where two groups of values divide; 0 when there is one group.
double division(std::vector<float> values) {
  constexpr double clearly = 0.5;  // in logarithms
  constexpr double min_share = 0.08;
  if (values.size() < 100) return 0;
  std::ranges::sort(values);
  double low = values[values.size() / 20], high = values[values.size() * 19 / 20];
  double share = 0;
  for (int round = 0; round < 12; ++round) {
    const double middle = (low + high) / 2;
    double sums[2] = {0, 0};
    int counts[2] = {0, 0};
    for (const float v : values) {
      sums[v > middle ? 1 : 0] += v;
      ++counts[v > middle ? 1 : 0];
    }
    if (counts[0] == 0 || counts[1] == 0) return 0;
    low = sums[0] / counts[0];
    high = sums[1] / counts[1];
    share = 1.0 * std::min(counts[0], counts[1]) / (counts[0] + counts[1]);
  }
  return high - low > clearly && share > min_share ? (low + high) / 2 : 0;
}

// Strokes a pixel, as a logarithm, of hatching alone.
cv::Mat densities(const cv::Mat& strokes, const cv::Mat& area, int window) {
  cv::Mat count = stroke_beginnings(strokes), there, density;
  area.convertTo(there, CV_32F, 1.0 / 255);
  count = count.mul(there);
  cv::blur(count, count, {window, window});
  cv::blur(there, there, {window, window});
  cv::divide(count + 1e-5, there + 1e-3, density);
  cv::log(density, density);
  return density;
}

// A kind whose strokes lie now close together, now far apart, becomes two.
void split_by_distance(Hatching& hatching, const cv::Mat& density, const cv::Mat& core) {
  const int kinds = hatching.kinds;
  for (int kind = 0; kind < kinds; ++kind) {
    std::vector<float> values;
    const cv::Mat own = hatching.kind == kind;
    for (int y = 0; y < own.rows; ++y)
      for (int x = 0; x < own.cols; ++x)
        if (own.at<std::uint8_t>(y, x) != 0 && core.at<std::uint8_t>(y, x) != 0)
          values.push_back(density.at<float>(y, x));
    const double at = division(std::move(values));
    if (at == 0) continue;
    hatching.kind.setTo(hatching.kinds++, own & (density > at));
  }
}

// The patch that a name stands on may go through the whole of an area: it belongs to it.
void bridge_names(Hatching& hatching, double side) {
  constexpr double patch = 0.065;  // its height, of the longer side
  const cv::Mat square_patch = square(odd(patch * side));
  const cv::Mat free = hatching.kind == unlabelled;
  for (int kind = 0; kind < hatching.kinds; ++kind) {
    cv::Mat closed;
    const int rim = odd(patch * side);
    cv::copyMakeBorder(
        cv::Mat(hatching.kind == kind), closed, rim, rim, rim, rim, cv::BORDER_CONSTANT, 0);
    cv::morphologyEx(closed, closed, cv::MORPH_CLOSE, square_patch);
    closed = closed(cv::Rect(rim, rim, free.cols, free.rows)) & free;
    hatching.kind.setTo(kind, closed & (hatching.kind == unlabelled));
  }
}

bool is_stroke(const std::vector<cv::Point>& points, double side) {
  const cv::RotatedRect box = cv::minAreaRect(points);
  const double longer = std::max(box.size.width, box.size.height) + 1;
  const double shorter = std::min(box.size.width, box.size.height) + 1;
  return shorter < std::max(4.5, 0.0055 * side) || longer > 6 * shorter;
}

struct Mark {
  cv::Rect box;
  std::vector<cv::Point> points;
  bool stroke = false;
};

// Connected ink that is no larger than a letter.
std::vector<Mark> small_marks(const cv::Mat& ink, double side) {
  constexpr double largest = 0.075;
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(ink, labels, stats, centres, 8, CV_32S);
  std::vector<Mark> all(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    all[i].box = {stats.at<int>(i, cv::CC_STAT_LEFT),
                  stats.at<int>(i, cv::CC_STAT_TOP),
                  stats.at<int>(i, cv::CC_STAT_WIDTH),
                  stats.at<int>(i, cv::CC_STAT_HEIGHT)};
  const auto is_small = [&](const Mark& mark) {
    return std::max(mark.box.width, mark.box.height) <= largest * side;
  };
  for (int y = 0; y < ink.rows; ++y) {
    for (int x = 0; x < ink.cols; ++x) {
      const int i = labels.at<int>(y, x);
      if (i > 0 && is_small(all[i])) all[i].points.emplace_back(x, y);
    }
  }
  std::erase_if(all, [](const Mark& mark) { return mark.points.empty(); });
  for (Mark& mark : all)
    mark.stroke = is_stroke(mark.points, side);
  return all;
}

}  // namespace

cv::Mat stroke_density(const cv::Mat& strokes, double longer_side) {
  constexpr double window_share = 0.06;
  cv::Mat density;
  const int window = odd(window_share * longer_side);
  cv::blur(stroke_beginnings(strokes), density, {window, window});
  return density * longer_side;
}

cv::Mat hatched_area(const cv::Mat& strokes, double longer_side) {
  // At most a thirtieth of the side apart; a single line in the window is half as much.
  constexpr double least = 27;
  return stroke_density(strokes, longer_side) > least;
}

Hatching hatching_in(const cv::Mat& strokes, const cv::Mat& where, double longer_side) {
  constexpr double strength = 40, apart = 22;
  constexpr double half_gap = 0.014;  // farther from every stroke is where a name stands
  cv::Mat area;
  cv::dilate(strokes, area, square(odd(2 * half_gap * longer_side)));
  area &= where;
  const cv::Mat way = directions(strokes, odd(0.035 * longer_side), strength);
  const cv::Mat core = core_of(way, area, odd(0.02 * longer_side));
  std::vector<cv::Vec2d> ways = main_colours(way, core, apart);
  if (ways.empty()) ways = main_colours(way, area, apart);
  Hatching hatching;
  hatching.kind = strongest_class(way, area, ways, odd(0.022 * longer_side));
  hatching.kinds = static_cast<int>(ways.size());
  const cv::Mat density = densities(strokes, area, odd(0.06 * longer_side));
  split_by_distance(hatching, density, core);
  hatching.kind.setTo(unlabelled, area == 0);
  bridge_names(hatching, longer_side);
  return hatching;
}

cv::Mat strokes_among(const cv::Mat& ink, double longer_side) {
  cv::Mat strokes = ink.clone();
  for (const Mark& mark : small_marks(ink, longer_side))
    if (!mark.stroke)
      for (const cv::Point& p : mark.points)
        strokes.at<std::uint8_t>(p) = 0;
  return strokes;
}

cv::Mat letters_on_hatching(const cv::Mat& ink, double longer_side) {
  const std::vector<Mark> marks = small_marks(ink, longer_side);
  cv::Mat letters = cv::Mat::zeros(ink.size(), CV_8UC1), beside = letters.clone();
  for (const Mark& mark : marks) {
    if (mark.stroke) continue;
    for (const cv::Point& p : mark.points)
      letters.at<std::uint8_t>(p) = 255;
    const cv::Rect& box = mark.box;
    const int reach = box.height;  // a letter of one stroke may stand there
    beside(cv::Rect(box.x - reach, box.y - 2, box.width + 2 * reach, box.height + 4) &
           cv::Rect(0, 0, ink.cols, ink.rows)) = 255;
  }
  for (const Mark& mark : marks) {
    if (!mark.stroke || cv::countNonZero(beside(mark.box)) < mark.box.area()) continue;
    for (const cv::Point& p : mark.points)
      letters.at<std::uint8_t>(p) = 255;
  }
  return letters;
}

}  // namespace marketgen::drawing
