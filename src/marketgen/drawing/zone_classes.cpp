#include "drawing/zone_classes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace marketgen::drawing {
namespace {

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

}  // namespace

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

cv::Mat core_of(const cv::Mat& colours, const cv::Mat& coloured, int window) {
  cv::Mat low, high, spread;
  cv::erode(colours, low, square(window));
  cv::dilate(colours, high, square(window));
  spread = chroma_of(high - low);
  return (spread < 12) & coloured;
}

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

cv::Mat share_around(const cv::Mat& mask, int window) {
  cv::Mat share;
  mask.convertTo(share, CV_32F, 1.0 / 255);
  cv::blur(share, share, {window, window});
  return share;
}

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

}  // namespace marketgen::drawing
