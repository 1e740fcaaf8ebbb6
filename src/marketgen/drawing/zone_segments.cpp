#include "drawing/zone_segments.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace marketgen::drawing {
namespace {

constexpr float min_chroma = 9;  // less is paper
constexpr int unlabelled = -1;
constexpr double narrowest = 0.012;  // half a zone's width, of the floor's longer side

cv::Mat chroma_of(const cv::Mat& ab) {
  std::array<cv::Mat, 2> channels;
  cv::split(ab, channels.data());
  cv::Mat chroma;
  cv::magnitude(channels[0], channels[1], chroma);
  return chroma;
}

int odd(double px) {
  return std::max(3, 2 * static_cast<int>(std::lround(px / 2)) + 1);
}

cv::Mat square(int side) {
  return cv::Mat::ones(side, side, CV_8UC1);
}

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

// Colours that many pixels have: peaks of a histogram over a and b.
std::vector<cv::Vec2d> main_colours(const cv::Mat& ab, const cv::Mat& mask, double apart) {
  constexpr int size = 128, half = 64;  // bins of 2
  cv::Mat histogram = cv::Mat::zeros(size, size, CV_32F);
  int count = 0;
  for (int y = 0; y < ab.rows; ++y) {
    for (int x = 0; x < ab.cols; ++x) {
      if (mask.at<std::uint8_t>(y, x) == 0) continue;
      const cv::Vec2f& p = ab.at<cv::Vec2f>(y, x);
      const int a = std::clamp(cvRound(p[0] / 2) + half, 0, size - 1);
      const int b = std::clamp(cvRound(p[1] / 2) + half, 0, size - 1);
      histogram.at<float>(b, a) += 1;
      ++count;
    }
  }
  cv::GaussianBlur(histogram, histogram, {0, 0}, 1.7, 1.7, cv::BORDER_CONSTANT);
  constexpr double min_share = 0.0012;  // of the coloured pixels, in one bin
  constexpr std::size_t most = 24;
  std::vector<cv::Vec2d> peaks;
  while (peaks.size() < most) {
    double high = 0;
    cv::Point at;
    cv::minMaxLoc(histogram, nullptr, &high, nullptr, &at);
    if (high < min_share * count || count == 0) break;
    peaks.emplace_back(2.0 * (at.x - half), 2.0 * (at.y - half));
    cv::circle(histogram, at, static_cast<int>(std::lround(apart / 2)), 0, cv::FILLED);
  }
  return peaks;
}

// Peaks on the way from one colour to another at whose border both mix hold few pixels that lie
// amid their like: `core` keeps only such.
cv::Mat core_of(const cv::Mat& colours, const cv::Mat& coloured, int window) {
  cv::Mat low, high, spread;
  cv::erode(colours, low, square(window));
  cv::dilate(colours, high, square(window));
  spread = chroma_of(high - low);
  return (spread < 12) & coloured;
}

int nearest_colour(const std::vector<cv::Vec2d>& colours, const cv::Vec2d& to, double within) {
  int best = -1;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const double d = cv::norm(colours[i] - to);
    if (d < within) {
      within = d;
      best = static_cast<int>(i);
    }
  }
  return best;
}

// Every pixel of `where` that has no label takes that of the nearest that has one.
void fill_from_nearest(cv::Mat& label, const cv::Mat& where) {
  const cv::Mat free = label == unlabelled;
  if (cv::countNonZero(~free) == 0) return;
  cv::Mat depth, nearest;
  cv::distanceTransform(free, depth, nearest, cv::DIST_L2, 5, cv::DIST_LABEL_PIXEL);
  std::vector<int> of_seed(label.total() + 1, unlabelled);
  for (int y = 0; y < label.rows; ++y)
    for (int x = 0; x < label.cols; ++x)
      if (free.at<std::uint8_t>(y, x) == 0) of_seed[nearest.at<int>(y, x)] = label.at<int>(y, x);
  for (int y = 0; y < label.rows; ++y)
    for (int x = 0; x < label.cols; ++x)
      if (where.at<std::uint8_t>(y, x) != 0 && free.at<std::uint8_t>(y, x) != 0)
        label.at<int>(y, x) = of_seed[nearest.at<int>(y, x)];
}

constexpr double min_inked = 0.06;  // share of coloured pixels around one

cv::Mat share_around(const cv::Mat& mask, int window) {
  cv::Mat share;
  mask.convertTo(share, CV_32F, 1.0 / 255);
  cv::blur(share, share, {window, window});
  return share;
}

// The class with the most strokes around each pixel.
cv::Mat strongest_class(const cv::Mat& colours,
                        const cv::Mat& coloured,
                        const std::vector<cv::Vec2d>& classes,
                        int window) {
  cv::Mat own(colours.size(), CV_32S, cv::Scalar(unlabelled));
  for (int y = 0; y < colours.rows; ++y) {
    for (int x = 0; x < colours.cols; ++x) {
      if (coloured.at<std::uint8_t>(y, x) == 0) continue;
      const cv::Vec2f& p = colours.at<cv::Vec2f>(y, x);
      own.at<int>(y, x) = nearest_colour(classes, {p[0], p[1]}, 30);
    }
  }
  cv::Mat best = cv::Mat(colours.size(), CV_32F, cv::Scalar(min_inked));
  cv::Mat label(colours.size(), CV_32S, cv::Scalar(unlabelled));
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const cv::Mat density = share_around(own == static_cast<int>(i), window);
    const cv::Mat stronger = density > best;
    density.copyTo(best, stronger);
    label.setTo(static_cast<int>(i), stronger);
  }
  return label;
}

// How far a piece's innermost pixel is from what is not of it.
std::vector<float> half_widths(const cv::Mat& mask, const cv::Mat& pieces, int count) {
  cv::Mat framed, depth;
  cv::copyMakeBorder(mask, framed, 1, 1, 1, 1, cv::BORDER_CONSTANT, 0);
  cv::distanceTransform(framed, depth, cv::DIST_L2, 3);
  std::vector<float> half(count);
  for (int y = 0; y < pieces.rows; ++y) {
    for (int x = 0; x < pieces.cols; ++x) {
      float& most = half[pieces.at<int>(y, x)];
      most = std::max(most, depth.at<float>(y + 1, x + 1));
    }
  }
  return half;
}

// Connected parts of each value of `label`; those too small and those too narrow lose it.
cv::Mat connected_parts(
    const cv::Mat& label, int values, double min_px, double half_px, int& count) {
  cv::Mat parts(label.size(), CV_32S, cv::Scalar(unlabelled));
  count = 0;
  for (int value = 0; value < values; ++value) {
    const cv::Mat mask = label == value;
    cv::Mat pieces, stats, centres;
    const int found = cv::connectedComponentsWithStats(mask, pieces, stats, centres, 4, CV_32S);
    std::vector<int> number(found, unlabelled);
    const std::vector<float> half = half_widths(mask, pieces, found);
    for (int i = 1; i < found; ++i)
      if (stats.at<int>(i, cv::CC_STAT_AREA) >= min_px && half[i] >= half_px) number[i] = count++;
    for (int y = 0; y < label.rows; ++y) {
      for (int x = 0; x < label.cols; ++x) {
        const int piece = pieces.at<int>(y, x);
        if (piece > 0) parts.at<int>(y, x) = number[piece];
      }
    }
  }
  return parts;
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
  // Floor that is wide enough to be meant bare, not a gap between strokes or the place of a name.
  cv::Mat bare = (share_around(inked, window) < min_inked) & floor;
  const int wide = odd(0.065 * side);
  cv::Mat framed;
  cv::copyMakeBorder(bare, framed, wide, wide, wide, wide, cv::BORDER_CONSTANT, 0);
  // Names on it and lines of walls make no holes in it.
  cv::morphologyEx(framed, framed, cv::MORPH_CLOSE, square(odd(0.01 * side)));
  cv::morphologyEx(framed, framed, cv::MORPH_OPEN, square(wide));
  bare = framed(cv::Rect(wide, wide, bare.cols, bare.rows)) & bare;
  const int bare_value = static_cast<int>(classes.size());
  label.setTo(bare_value, bare);
  const double min_px = 0.006 * cv::countNonZero(floor);
  int count = 0;
  cv::Mat parts = connected_parts(label, bare_value + 1, min_px, narrowest * side, count);
  cv::Mat value_of(1, std::max(1, count), CV_32S, cv::Scalar(unlabelled));
  for (int y = 0; y < parts.rows; ++y)
    for (int x = 0; x < parts.cols; ++x)
      if (parts.at<int>(y, x) >= 0) value_of.at<int>(parts.at<int>(y, x)) = label.at<int>(y, x);
  Segments segments = finished(parts, count, floor);
  segments.coloured = true;
  for (int i = 0; i < count; ++i)
    segments.parts[i].bare = value_of.at<int>(i) == bare_value;
  add_colours(segments, bgr, hatched ? ab : colours, inked);
  segments.hatched = hatched;
  return segments;
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

Segments by_lines(const cv::Mat& bgr, const cv::Mat& ink, const cv::Mat& floor, double side) {
  cv::Mat grey, faint;
  cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
  cv::GaussianBlur(grey, grey, {3, 3}, 0);
  cv::adaptiveThreshold(
      grey, faint, 255, cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY_INV, odd(0.03 * side), 14);
  cv::Mat lines = without_letters((faint | ink) & floor, side);
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
  return by_lines(bgr, ink, floor, longer_side);
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
