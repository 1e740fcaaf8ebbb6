#include "geometry/ssim.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace marketgen {
inline namespace geometry {
namespace {

constexpr int window_reach = 5;  // 11 x 11
constexpr double window_deviation = 1.5;
constexpr double c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255;

using Values = std::vector<double>;

Values luma_of(const Image& image) {
  const auto channels = static_cast<std::size_t>(image.channels);
  Values luma(image.pixels.size() / channels);
  for (std::size_t i = 0; i < luma.size(); ++i) {
    const std::uint8_t* p = &image.pixels[i * channels];
    luma[i] = channels < 3 ? p[0] : 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2];
  }
  return luma;
}

std::array<double, 2 * window_reach + 1> window_weights() {
  std::array<double, 2 * window_reach + 1> weights{};
  for (int k = -window_reach; k <= window_reach; ++k)
    weights[static_cast<std::size_t>(k + window_reach)] =
        std::exp(-0.5 * k * k / (window_deviation * window_deviation));
  return weights;
}

// Weighted mean around every element of `count` lines of `length` elements.
Values blurred_lines(
    const Values& values, int length, int stride, int count, int line_stride, const auto& weights) {
  Values out(values.size());
  for (int line = 0; line < count; ++line) {
    const auto at = [&](int i) {
      return static_cast<std::size_t>(line * line_stride + i * stride);
    };
    for (int i = 0; i < length; ++i) {
      double sum = 0, total = 0;
      for (int k = std::max(-window_reach, -i); k <= std::min(window_reach, length - 1 - i); ++k) {
        const double weight = weights[static_cast<std::size_t>(k + window_reach)];
        sum += weight * values[at(i + k)];
        total += weight;
      }
      out[at(i)] = sum / total;
    }
  }
  return out;
}

Values blurred(const Values& values, int width, int height) {
  const auto weights = window_weights();
  return blurred_lines(
      blurred_lines(values, width, 1, height, width, weights), height, width, width, 1, weights);
}

Values product(const Values& a, const Values& b) {
  Values out(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    out[i] = a[i] * b[i];
  return out;
}

// How far from the border windows lie wholly in `length` pixels; 0 when none does.
int margin_of(int length) {
  return length > 2 * window_reach ? window_reach : 0;
}

}  // namespace

double ssim(const Image& a, const Image& b) {
  assert(a.width == b.width && a.height == b.height && a.width > 0 && a.height > 0);
  const int width = a.width, height = a.height;
  const Values x = luma_of(a), y = luma_of(b);
  const Values mean_x = blurred(x, width, height), mean_y = blurred(y, width, height);
  const Values xx = blurred(product(x, x), width, height),
               yy = blurred(product(y, y), width, height),
               xy = blurred(product(x, y), width, height);
  const int side = margin_of(width), top = margin_of(height);
  double sum = 0;
  for (int v = top; v < height - top; ++v) {
    for (int u = side; u < width - side; ++u) {
      const auto i = static_cast<std::size_t>(v * width + u);
      const double both = mean_x[i] * mean_y[i];
      const double squares = mean_x[i] * mean_x[i] + mean_y[i] * mean_y[i];
      const double variances = xx[i] + yy[i] - squares;
      sum += (2 * both + c1) * (2 * (xy[i] - both) + c2) / ((squares + c1) * (variances + c2));
    }
  }
  return sum / ((width - 2.0 * side) * (height - 2.0 * top));
}

}  // namespace geometry
}  // namespace marketgen
