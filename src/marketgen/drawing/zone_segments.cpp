#include "drawing/zone_segments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <opencv2/imgproc.hpp>

#include "drawing/zone_classes.h"
#include "drawing/zone_hatching.h"
#include "drawing/zone_marks.h"

namespace marketgen::drawing {
namespace {

constexpr float min_chroma = 9;  // less is paper

// Mean colour around each pixel of what is coloured there: that of the pen, however far apart its
// strokes are.
cv::Mat pen_colours(const cv::Mat& ab, const cv::Mat& coloured, int window) {
  cv::Mat weight, weighted, sum, weights;
  coloured.convertTo(weight, CV_32F, 1.0 / 255);
  cv::merge(std::vector<cv::Mat>{weight, weight}, weights);
  cv::multiply(ab, weights, weighted);
  cv::blur(weighted, sum, {window, window});
  cv::blur(weights, weights, {window, window});
  cv::divide(sum, weights + cv::Scalar::all(1e-3), sum);
  return sum;
}

Segments finished(cv::Mat label, int count, const cv::Mat& floor) {
  fill_from_nearest(label, floor);
  label.setTo(Segments::outside, floor == 0);
  Segments result;
  result.label = label;
  result.parts.resize(count);
  return result;
}

// The mean colours of the parts.
void add_colours(Segments& segments,
                 const cv::Mat& bgr,
                 const cv::Mat& colours,
                 const cv::Mat& use) {
  std::vector<cv::Vec3d> sum(segments.parts.size());
  std::vector<cv::Vec2d> ab(segments.parts.size());
  std::vector<int> used(segments.parts.size());
  for (int y = 0; y < bgr.rows; ++y) {
    for (int x = 0; x < bgr.cols; ++x) {
      const int i = segments.label.at<int>(y, x);
      if (i < 0) continue;
      ++segments.parts[i].pixels;
      if (use.at<std::uint8_t>(y, x) == 0) continue;
      ++used[i];
      sum[i] += cv::Vec3d(bgr.at<cv::Vec3b>(y, x));
      ab[i] += cv::Vec2d(colours.at<cv::Vec2f>(y, x));
    }
  }
  for (std::size_t i = 0; i < segments.parts.size(); ++i) {
    if (used[i] == 0) continue;
    segments.parts[i].ab = segments.parts[i].bare ? cv::Vec2d{} : ab[i] / used[i];
    segments.parts[i].bgr = sum[i] / used[i];
  }
}

enum class Surface { even, strokes, hatched };

// Strokes of a pen lie apart, so closing what is coloured adds much to it; those of a marker do
// not, but differ from one another.
Surface surface_of(const cv::Mat& ab, const cv::Mat& coloured, const cv::Mat& floor, double side) {
  cv::Mat closed;
  cv::morphologyEx(coloured, closed, cv::MORPH_CLOSE, square(odd(0.02 * side)));
  const double filled =
      cv::countNonZero(coloured & floor) / std::max(1.0, double(cv::countNonZero(closed & floor)));
  if (filled < 0.75) return Surface::hatched;
  const cv::Mat fine = pen_colours(ab, coloured, odd(0.006 * side));
  const cv::Mat mean = pen_colours(ab, coloured, odd(0.03 * side));
  const cv::Mat off = chroma_of(fine - mean);
  std::vector<float> offs;
  for (int y = 0; y < off.rows; y += 3)
    for (int x = 0; x < off.cols; x += 3)
      if (coloured.at<std::uint8_t>(y, x) != 0) offs.push_back(off.at<float>(y, x));
  if (offs.empty()) return Surface::even;
  std::ranges::nth_element(offs, offs.begin() + static_cast<std::ptrdiff_t>(offs.size() / 2));
  constexpr float even = 1.2F;
  return offs[offs.size() / 2] < even ? Surface::even : Surface::strokes;
}

// How colourful the ink around each pixel is for its darkness: that of the pen, however densely it
// hatches and however much the picture is blurred.
cv::Mat ratio_colours(const cv::Mat& bgr, const cv::Mat& ab, const cv::Mat& use, int window) {
  cv::Mat grey, darkness, weights;
  cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
  grey.convertTo(darkness, CV_32F, -1, 250);
  darkness.setTo(0, ~use);
  cv::Mat part = ab.clone();
  part.setTo(cv::Scalar::all(0), ~use);
  cv::blur(part, part, {window, window});
  cv::blur(darkness, darkness, {window, window});
  darkness = cv::max(darkness, 2.0);
  cv::merge(std::vector<cv::Mat>{darkness, darkness}, weights);
  cv::divide(part, weights, part, 60);
  return part;
}

// Letters are small and no line goes on for long in them.
cv::Mat without_letters(const cv::Mat& lines, double side) {
  cv::Mat labels, stats, centres, left = lines.clone();
  const int count = cv::connectedComponentsWithStats(lines, labels, stats, centres, 8, CV_32S);
  std::vector<bool> letter(count);
  for (int i = 1; i < count; ++i) {
    const int w = stats.at<int>(i, cv::CC_STAT_WIDTH), h = stats.at<int>(i, cv::CC_STAT_HEIGHT);
    const double longer = std::max(w, h), shorter = std::min(w, h);
    const bool stroke = longer > 0.02 * side && shorter < std::max(4.0, 0.2 * longer);
    letter[i] = longer < 0.075 * side && !stroke;
  }
  for (int y = 0; y < lines.rows; ++y)
    for (int x = 0; x < lines.cols; ++x)
      if (letter[labels.at<int>(y, x)]) left.at<std::uint8_t>(y, x) = 0;
  return left;
}

// Lines that may divide areas of one colour.
cv::Mat long_lines(const cv::Mat& bgr, const cv::Mat& floor, double side) {
  cv::Mat lines = without_letters(mended(grey_marks(bgr, side)), side) & floor;
  cv::dilate(lines, lines, square(odd(0.006 * side)));
  return lines;
}

// Everything drawn that is darker than what is around it.
cv::Mat marks_on(const cv::Mat& bgr, const cv::Mat& ink, const cv::Mat& floor, double side) {
  cv::Mat grey, faint;
  cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
  cv::GaussianBlur(grey, grey, {3, 3}, 0);
  cv::adaptiveThreshold(
      grey, faint, 255, cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY_INV, odd(0.03 * side), 14);
  return (faint | ink) & floor;
}

// Floor that is wide enough to be meant bare, not a gap between strokes or the place of a name.
cv::Mat wide_parts(const cv::Mat& bare, double side) {
  const int wide = odd(0.065 * side);
  cv::Mat framed;
  cv::copyMakeBorder(bare, framed, wide, wide, wide, wide, cv::BORDER_CONSTANT, 0);
  // Names on it and lines of walls make no holes in it.
  cv::morphologyEx(framed, framed, cv::MORPH_CLOSE, square(odd(0.01 * side)));
  cv::morphologyEx(framed, framed, cv::MORPH_OPEN, square(wide));
  return framed(cv::Rect(wide, wide, bare.cols, bare.rows)) & bare;
}

// The only part that a part has borders with; -1 where there are several, or walls.
std::vector<int> only_neighbours(const Segments& segments) {
  constexpr int none = -2, several = -1;
  std::vector<int> neighbour(segments.parts.size(), none);
  const auto meet = [&](int i, int k) {
    if (i < 0 || i == k) return;
    neighbour[i] = k < 0 || (neighbour[i] != none && neighbour[i] != k) ? several : k;
  };
  const cv::Mat& label = segments.label;
  for (int y = 0; y + 1 < label.rows; ++y) {
    for (int x = 0; x + 1 < label.cols; ++x) {
      const int here = label.at<int>(y, x);
      for (const int other : {label.at<int>(y, x + 1), label.at<int>(y + 1, x)}) {
        meet(here, other);
        meet(other, here);
      }
    }
  }
  return neighbour;
}

// A small part within another one is where that one's name stands.
void take_in_islands(Segments& segments, double max_px) {
  const std::vector<int> around = only_neighbours(segments);
  std::vector<int> pixels(segments.parts.size());
  for (int y = 0; y < segments.label.rows; ++y)
    for (int x = 0; x < segments.label.cols; ++x)
      if (const int i = segments.label.at<int>(y, x); i >= 0) ++pixels[i];
  std::vector<int> number;
  std::vector<FloorPart> left;
  std::vector<bool> island;
  for (std::size_t i = 0; i < around.size(); ++i)
    island.push_back(around[i] >= 0 && pixels[i] < max_px);
  for (std::size_t i = 0; i < around.size(); ++i) {
    number.push_back(island[i] ? -1 : static_cast<int>(left.size()));
    if (!island[i]) left.push_back(segments.parts[i]);
  }
  for (int y = 0; y < segments.label.rows; ++y) {
    for (int x = 0; x < segments.label.cols; ++x) {
      int& i = segments.label.at<int>(y, x);
      if (i >= 0) i = number[island[i] ? around[i] : i];
    }
  }
  segments.parts = std::move(left);
}

// Connected parts of the classes 0 to `classes` - 1 in `label`, and of the bare floor.
Segments parts_of(
    cv::Mat label, int classes, const cv::Mat& bare, const cv::Mat& floor, double side) {
  label.setTo(classes, bare);
  const double min_px = 0.006 * cv::countNonZero(floor);
  int count = 0;
  cv::Mat parts = connected_parts(label, classes + 1, min_px, narrowest * side, count);
  cv::Mat value_of(1, std::max(1, count), CV_32S, cv::Scalar(unlabelled));
  for (int y = 0; y < parts.rows; ++y)
    for (int x = 0; x < parts.cols; ++x)
      if (parts.at<int>(y, x) >= 0) value_of.at<int>(parts.at<int>(y, x)) = label.at<int>(y, x);
  Segments segments = finished(parts, count, floor);
  for (int i = 0; i < count; ++i)
    segments.parts[i].bare = value_of.at<int>(i) == classes;
  take_in_islands(segments, 0.035 * cv::countNonZero(floor));
  return segments;
}

// What one pen hatches in several directions becomes several classes.
cv::Mat told_by_direction(const cv::Mat& label, int classes, const cv::Mat& lines, double side) {
  cv::Mat told(label.size(), CV_32S, cv::Scalar(unlabelled));
  int base = 0;
  const int rim = odd(0.04 * side);  // what windows around a pixel see
  for (int i = 0; i < classes; ++i) {
    const cv::Mat area = label == i;
    cv::Rect box = cv::boundingRect(area);
    if (box.empty()) continue;
    box = cv::Rect(box.x - rim, box.y - rim, box.width + 2 * rim, box.height + 2 * rim) &
          cv::Rect(0, 0, label.cols, label.rows);
    const Hatching hatching = hatching_in(lines(box) & area(box), area(box), side);
    cv::Mat part = told(box);
    for (int k = 0; k < hatching.kinds; ++k)
      part.setTo(base + k, hatching.kind == k);
    base += hatching.kinds;
  }
  return told;
}

Segments by_colour(const cv::Mat& bgr,
                   const cv::Mat& ab,
                   const cv::Mat& coloured,
                   const cv::Mat& ink,
                   const cv::Mat& floor,
                   double side) {
  const Surface surface = surface_of(ab, coloured, floor, side);
  const bool even = surface == Surface::even, hatched = surface == Surface::hatched;
  cv::Mat near_ink, inked = coloured;
  cv::dilate(ink, near_ink, square(5));
  cv::Mat colours;
  if (hatched) {
    const cv::Mat use = floor & ~near_ink;
    colours = ratio_colours(bgr, ab, use, odd(0.03 * side));
    cv::Mat grey;
    cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
    inked = ((grey < 225) | coloured) & use;
  } else {
    colours = pen_colours(ab, coloured, odd((even ? 0.006 : 0.03) * side));
  }
  const cv::Mat core = core_of(colours, inked, odd((even ? 0.008 : 0.03) * side));
  const double apart = surface == Surface::strokes ? 13 : 9;
  std::vector<cv::Vec2d> classes = main_colours(colours, core & floor, apart);
  if (classes.empty()) classes = main_colours(colours, inked & floor, apart);
  const int window = odd((even ? 0.006 : 0.022) * side);
  cv::Mat label = strongest_class(colours, hatched ? inked : core & floor, classes, window);
  label.setTo(unlabelled, floor == 0);
  const cv::Mat bare = wide_parts((share_around(inked, window) < min_inked) & floor, side);
  if (hatched)
    label = told_by_direction(label,
                              static_cast<int>(classes.size()),
                              strokes_among(marks_on(bgr, ink, floor, side), side),
                              side);
  else
    label.setTo(unlabelled, long_lines(bgr, floor, side));
  double most = 0;
  cv::minMaxLoc(label, nullptr, &most);
  Segments segments = parts_of(label, static_cast<int>(most) + 1, bare, floor, side);
  segments.coloured = true;
  segments.hatched = hatched;
  add_colours(segments, bgr, hatched ? ab : colours, inked);
  return segments;
}

// Zones that are hatched with one pen in several directions; nothing where little is hatched.
std::optional<Segments> by_hatching(const cv::Mat& bgr,
                                    const cv::Mat& marks,
                                    const cv::Mat& floor,
                                    double side) {
  constexpr double min_share = 0.3;
  const cv::Mat lines = strokes_among(marks, side);
  const cv::Mat area = hatched_area(lines, side) & floor;
  if (cv::countNonZero(area) < min_share * cv::countNonZero(floor)) return std::nullopt;
  const Hatching hatching = hatching_in(lines, area, side);
  const cv::Mat bare = wide_parts(floor & ~area, side);
  Segments segments = parts_of(hatching.kind, hatching.kinds, bare, floor, side);
  segments.hatched = true;
  add_colours(segments, bgr, cv::Mat::zeros(bgr.size(), CV_32FC2), lines);
  return segments;
}

Segments by_lines(const cv::Mat& bgr,
                  const cv::Mat& marks,
                  const cv::Mat& ink,
                  const cv::Mat& floor,
                  double side) {
  cv::Mat lines = without_letters(marks, side);
  // Lines that stop short of one another meet.
  cv::dilate(lines,
             lines,
             cv::getStructuringElement(cv::MORPH_ELLIPSE, {odd(0.012 * side), odd(0.012 * side)}));
  cv::Mat free(floor.size(), CV_32S, cv::Scalar(unlabelled));
  free.setTo(0, floor & ~lines);
  int count = 0;
  const cv::Mat parts =
      connected_parts(free, 1, 0.006 * cv::countNonZero(floor), narrowest * side, count);
  Segments segments = finished(parts, count, floor);
  add_colours(segments, bgr, cv::Mat::zeros(bgr.size(), CV_32FC2), ~ink);
  return segments;
}

}  // namespace

cv::Mat colours_of(const cv::Mat& bgr) {
  cv::Mat smooth, lab;
  cv::medianBlur(bgr, smooth, 3);
  smooth.convertTo(smooth, CV_32FC3, 1.0 / 255);
  cv::cvtColor(smooth, lab, cv::COLOR_BGR2Lab);
  std::array<cv::Mat, 3> channels;
  cv::split(lab, channels.data());
  cv::Mat ab;
  cv::merge(channels.data() + 1, 2, ab);
  return ab;
}

Segments segments_of(const cv::Mat& bgr,
                     const cv::Mat& ink,
                     const cv::Mat& floor,
                     double longer_side) {
  const cv::Mat ab = colours_of(bgr);
  cv::Mat near_ink, coloured = chroma_of(ab) > min_chroma;
  cv::dilate(ink, near_ink, square(3));
  coloured &= ~near_ink;
  cv::Mat dense;
  cv::morphologyEx(coloured, dense, cv::MORPH_OPEN, square(2));
  constexpr double min_share = 0.04;
  const double share =
      cv::countNonZero(dense & floor) / std::max(1.0, double(cv::countNonZero(floor)));
  if (share > min_share) return by_colour(bgr, ab, coloured & floor, ink, floor, longer_side);
  const cv::Mat marks = marks_on(bgr, ink, floor, longer_side);
  if (auto hatched = by_hatching(bgr, marks, floor, longer_side)) return *std::move(hatched);
  return by_lines(bgr, marks, ink, floor, longer_side);
}

std::vector<Swatch> swatches_of(const cv::Mat& bgr, const cv::Rect& plan, double longer_side) {
  const cv::Mat ab = colours_of(bgr);
  cv::Mat coloured = chroma_of(ab) > min_chroma;
  coloured(plan & cv::Rect(0, 0, bgr.cols, bgr.rows)) = 0;
  cv::morphologyEx(coloured, coloured, cv::MORPH_OPEN, square(5));
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(coloured, labels, stats, centres, 4, CV_32S);
  std::vector<Swatch> swatches;
  for (int i = 1; i < count; ++i) {
    const cv::Rect box(stats.at<int>(i, cv::CC_STAT_LEFT),
                       stats.at<int>(i, cv::CC_STAT_TOP),
                       stats.at<int>(i, cv::CC_STAT_WIDTH),
                       stats.at<int>(i, cv::CC_STAT_HEIGHT));
    const double shorter = std::min(box.width, box.height),
                 longer = std::max(box.width, box.height);
    const bool full = stats.at<int>(i, cv::CC_STAT_AREA) > 0.7 * box.area();
    if (shorter < 0.008 * longer_side || longer > 0.12 * longer_side || longer > 3 * shorter ||
        !full)
      continue;
    const cv::Rect middle(box.x + box.width / 4,
                          box.y + box.height / 4,
                          std::max(1, box.width / 2),
                          std::max(1, box.height / 2));
    const cv::Scalar mean = cv::mean(ab(middle));
    swatches.push_back({box, {mean[0], mean[1]}});
  }
  return swatches;
}

}  // namespace marketgen::drawing
