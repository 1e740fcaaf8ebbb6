#include "photo/lamps.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "drawing/picture.h"

namespace marketgen::photo {
namespace {

constexpr std::size_t ceiling_part = 2;
static_assert(part_names[ceiling_part] == "ceiling");
constexpr double min_ceiling = 0.35;
constexpr int min_spot_px = 5, brightest = 254;
constexpr int min_lamp_lightness = 205;  // of OpenCV's 255: a lamp is about white in any exposure

// Squares of the ceiling: CV_8UC1, 255 there.
cv::Mat ceiling_mask(const Looked& photo,
                     const Cells& cells,
                     const std::vector<PartShares>& parts) {
  cv::Mat mask(photo.lightness.size(), CV_8UC1, cv::Scalar(0));
  for (int row = 0; row < cells.rows; ++row) {
    for (int column = 0; column < cells.columns; ++column) {
      const std::size_t cell = static_cast<std::size_t>(row) * cells.columns + column;
      if (parts[cell][ceiling_part] < min_ceiling) continue;
      const cv::Rect at(column * cell_px, row * cell_px, cell_px, cell_px);
      mask(at & cv::Rect({0, 0}, mask.size())) = 255;
    }
  }
  return mask;
}

// The lightness that the brightest hundredth of the masked pixels has.
int bright_enough(const cv::Mat& lightness, const cv::Mat& mask) {
  const std::array<int, 256> pixels = drawing::masked_histogram(lightness, mask);
  const int all = std::accumulate(pixels.begin(), pixels.end(), 0);
  int level = 255;
  for (int above = pixels[255]; level > 0 && above < all / 100;)
    above += pixels[--level];
  return std::clamp(level - 8, min_lamp_lightness, brightest);
}

// Longer over shorter axis of a spot's ellipse of inertia.
double elongation_of(const cv::Mat& spot) {
  const cv::Moments m = cv::moments(spot, true);
  if (m.m00 < 1) return 1;
  const double xx = m.mu20 / m.m00 + 1.0 / 12, yy = m.mu02 / m.m00 + 1.0 / 12, xy = m.mu11 / m.m00;
  const double mid = 0.5 * (xx + yy), off = std::hypot(0.5 * (xx - yy), xy);
  return std::sqrt((mid + off) / std::max(1e-3, mid - off));
}

// A picture just above a spot, as high and wide as the spot; empty at the upper rim. What hangs has
// a shade there, what lies in the ceiling has none.
cv::Rect above(const cv::Rect& spot, const cv::Mat& picture) {
  const int height = std::max(4, spot.height);
  return cv::Rect(spot.x, spot.y - height, spot.width, height) &
         cv::Rect(0, 0, picture.cols, picture.rows);
}

// How colourful a part of a Lab picture is, in the unit of cells.
double chroma_of(const cv::Mat& lab) {
  const cv::Scalar mean = cv::mean(lab);
  return std::hypot(mean[1] - 128, mean[2] - 128) / chroma_unit;
}

std::vector<double> spots_in(const Looked& photo, const cv::Mat& mask) {
  const cv::Mat& lightness = photo.lightness;
  const cv::Scalar ground = cv::mean(photo.lab, mask);
  const int level = bright_enough(lightness, mask);
  const cv::Mat bright = (lightness >= level) & mask;
  cv::Mat labels, stats, middles;
  const int count = cv::connectedComponentsWithStats(bright, labels, stats, middles);
  double area = 0, longness = 0, fullness = 0, size = 0, longest = 0, height = 0;
  double shade = 0, shade_chroma = 0, width = 0, shaded = 1e-9;
  int spots = 0;
  for (int i = 1; i < count; ++i) {
    const double px = stats.at<int>(i, cv::CC_STAT_AREA);
    if (px < min_spot_px) continue;
    const cv::Rect box(stats.at<int>(i, cv::CC_STAT_LEFT),
                       stats.at<int>(i, cv::CC_STAT_TOP),
                       stats.at<int>(i, cv::CC_STAT_WIDTH),
                       stats.at<int>(i, cv::CC_STAT_HEIGHT));
    const double elongation = elongation_of(labels(box) == i);
    ++spots;
    area += px;
    longness += px * std::log(elongation);
    longest = std::max(longest, std::log(elongation));
    fullness += px * px / box.area();
    size += std::sqrt(px);
    height += px * middles.at<double>(i, 1) / lightness.rows;
    width += px * std::log(static_cast<double>(box.width) / box.height);
    const cv::Rect over = above(box, lightness);
    if (over.empty()) continue;
    shaded += px;
    shade += px * (cv::mean(lightness(over))[0] - ground[0]) / 64;
    shade_chroma += px * chroma_of(photo.lab(over));
  }
  const double pixels = static_cast<double>(lightness.total()), own = std::max(area, 1.0);
  const double masked = cv::countNonZero(mask) + 1.0;
  return {std::log(1.0 + spots),
          100 * area / pixels,
          area / masked,
          longness / own,
          longest,
          fullness / own,
          size / std::max(1, spots) / 30,
          height / own,
          level / 255.0,
          ground[0] / 255,
          width / own,
          shade / shaded,
          shade_chroma / shaded};
}

}  // namespace

std::vector<double> lamp_features(const Looked& photo,
                                  const Cells& cells,
                                  const std::vector<PartShares>& parts) {
  std::vector<double> features = spots_in(photo, ceiling_mask(photo, cells, parts));
  cv::Mat upper(photo.lightness.size(), CV_8UC1, cv::Scalar(0));
  upper(cv::Rect(0, 0, upper.cols, upper.rows / 2)) = 255;
  const std::vector<double> above = spots_in(photo, upper);
  features.insert(features.end(), above.begin(), above.end());
  return features;
}

}  // namespace marketgen::photo
