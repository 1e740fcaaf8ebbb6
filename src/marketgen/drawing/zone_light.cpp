// Even light on a picture of a drawing: what is paper, and what on it is ink.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "drawing/picture.h"
#include "drawing/zone_picture.h"

namespace marketgen::drawing {
namespace {

// The sheet of paper: the largest bright part with all that lies in it. Everything when it nearly
// fills the picture.
cv::Mat sheet_of(const cv::Mat& bgr) {
  cv::Mat bright, value = brightest_channel(bgr);
  cv::GaussianBlur(value, value, {5, 5}, 0);
  cv::threshold(value, bright, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(bright, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
  cv::Mat all(bgr.size(), CV_8UC1, cv::Scalar(255));
  if (contours.empty()) return all;
  const auto largest = std::ranges::max_element(
      contours, {}, [](const std::vector<cv::Point>& c) { return cv::contourArea(c); });
  const double share = cv::contourArea(*largest) / static_cast<double>(bgr.total());
  constexpr double nearly_all = 0.97, least = 0.15;
  if (share > nearly_all || share < least) return all;
  std::vector<cv::Point> hull;
  cv::convexHull(*largest, hull);
  cv::Mat sheet = cv::Mat::zeros(bgr.size(), CV_8UC1);
  cv::fillConvexPoly(sheet, hull, 255);
  const int rim = std::max(3, std::max(bgr.rows, bgr.cols) / 150);
  cv::copyMakeBorder(sheet, sheet, rim, rim, rim, rim, cv::BORDER_CONSTANT, 0);
  cv::erode(sheet, sheet, cv::Mat::ones(2 * rim + 1, 2 * rim + 1, CV_8UC1));
  return sheet(cv::Rect(rim, rim, bgr.cols, bgr.rows)).clone();
}

// What that share of the masked pixels is darker than.
double low_value(const cv::Mat& value, const cv::Mat& mask, double share) {
  const std::array<int, 256> counts = masked_histogram(value, mask);
  const int all = std::accumulate(counts.begin(), counts.end(), 0);
  int below = 0, at = 0;
  while (at < 255 && below + counts[at] < share * all)
    below += counts[at++];
  return at;
}

struct Sample {
  double x, y;
  cv::Vec3d value;
};

cv::Mat powers(const std::vector<Sample>& samples, int terms) {
  cv::Mat rows(static_cast<int>(samples.size()), terms, CV_64F);
  for (int i = 0; i < rows.rows; ++i) {
    const double x = samples[i].x, y = samples[i].y;
    const std::array<double, 6> all{1, x, y, x * x, x * y, y * y};
    for (int k = 0; k < terms; ++k)
      rows.at<double>(i, k) = all[k];
  }
  return rows;
}

// Per channel a smooth surface through the samples.
cv::Mat surface(const std::vector<Sample>& samples, int terms) {
  cv::Mat values(static_cast<int>(samples.size()), 3, CV_64F), found;
  for (int i = 0; i < values.rows; ++i)
    for (int k = 0; k < 3; ++k)
      values.at<double>(i, k) = samples[i].value[k];
  cv::solve(powers(samples, terms), values, found, cv::DECOMP_SVD);
  return found;
}

std::vector<Sample> near_surface(const std::vector<Sample>& samples, const cv::Mat& fit) {
  constexpr double within = 0.08;
  const cv::Mat expected = powers(samples, fit.rows) * fit;
  std::vector<Sample> near;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    bool paper = true;
    for (int k = 0; k < 3; ++k) {
      const double paper_here = expected.at<double>(static_cast<int>(i), k);
      paper = paper && std::abs(samples[i].value[k] - paper_here) < within * paper_here;
    }
    if (paper) near.push_back(samples[i]);
  }
  return near;
}

std::vector<Sample> samples_of(const cv::Mat& bgr, const cv::Mat& mask) {
  cv::Mat smooth;
  cv::GaussianBlur(bgr, smooth, {7, 7}, 0);
  const int step = std::max(2, std::max(bgr.rows, bgr.cols) / 120);
  std::vector<Sample> samples;
  for (int y = step / 2; y < bgr.rows; y += step) {
    for (int x = step / 2; x < bgr.cols; x += step) {
      if (mask.at<std::uint8_t>(y, x) == 0) continue;
      const cv::Vec3b& p = smooth.at<cv::Vec3b>(y, x);
      samples.push_back({2.0 * x / bgr.cols - 1,
                         2.0 * y / bgr.rows - 1,
                         {double(p[0]), double(p[1]), double(p[2])}});
    }
  }
  return samples;
}

// Inside the sheet along its edge.
cv::Mat ring_of(const cv::Mat& sheet) {
  cv::Mat framed, depth;
  cv::copyMakeBorder(sheet, framed, 1, 1, 1, 1, cv::BORDER_CONSTANT, 0);
  cv::distanceTransform(framed, depth, cv::DIST_L2, 3);
  depth = depth(cv::Rect(1, 1, sheet.cols, sheet.rows));
  const double width = 0.07 * std::min(sheet.cols, sheet.rows);
  return (depth > 0) & (depth < width);
}

}  // namespace

cv::Mat brightest_channel(const cv::Mat& bgr) {
  std::array<cv::Mat, 3> channels;
  cv::split(bgr, channels.data());
  return cv::max(cv::max(channels[0], channels[1]), channels[2]);
}

cv::Mat flattened(const cv::Mat& bgr) {
  const cv::Mat sheet = sheet_of(bgr);
  const std::vector<Sample> all = samples_of(bgr, sheet);
  const std::vector<Sample> ring = samples_of(bgr, ring_of(sheet));
  if (ring.size() < 20 || all.size() < 20) return bgr;
  cv::Mat fit = surface(ring, 3);
  for (int round = 0; round < 5; ++round) {
    const std::vector<Sample> near = near_surface(round < 3 ? ring : all, fit);
    if (near.size() < 20) break;
    fit = surface(near, round < 3 ? 3 : 6);
  }
  cv::Mat flat(bgr.size(), CV_8UC3);
  for (int y = 0; y < bgr.rows; ++y) {
    const double v = 2.0 * y / bgr.rows - 1;
    for (int x = 0; x < bgr.cols; ++x) {
      const double u = 2.0 * x / bgr.cols - 1;
      const std::array<double, 6> terms{1, u, v, u * u, u * v, v * v};
      const cv::Vec3b& from = bgr.at<cv::Vec3b>(y, x);
      cv::Vec3b& to = flat.at<cv::Vec3b>(y, x);
      for (int k = 0; k < 3; ++k) {
        double paper_here = 0;
        for (int i = 0; i < fit.rows; ++i)
          paper_here += fit.at<double>(i, k) * terms[i];
        to[k] = cv::saturate_cast<std::uint8_t>(from[k] * paper_value / std::max(20.0, paper_here));
      }
    }
  }
  flat.setTo(cv::Scalar::all(paper_value), sheet == 0);
  return flat;
}

cv::Mat dark_ink(const cv::Mat& flat) {
  constexpr double grey_share = 0.4;  // of the brightest channel, between it and the darkest one
  std::array<cv::Mat, 3> channels;
  cv::split(flat, channels.data());
  const cv::Mat high = cv::max(cv::max(channels[0], channels[1]), channels[2]);
  const cv::Mat low = cv::min(cv::min(channels[0], channels[1]), channels[2]);
  cv::Mat colourful;
  cv::Mat difference = high - low, limit;
  high.convertTo(limit, CV_8U, grey_share, 8);
  cv::compare(difference, limit, colourful, cv::CMP_GT);
  constexpr int faintest = 165;
  const cv::Mat dark = (high < faintest) & ~colourful;
  // Where walls are black, what is much lighter is a coloured pen whose colour the picture lost.
  constexpr double towards_paper = 0.42;
  const double darkest = low_value(high, dark, 0.1);
  return dark &
         (high < std::min<double>(faintest, darkest + towards_paper * (paper_value - darkest)));
}

}  // namespace marketgen::drawing
