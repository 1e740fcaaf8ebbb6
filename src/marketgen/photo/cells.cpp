#include "photo/cells.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace marketgen::photo {
namespace {

constexpr int nearly_white = 245, nearly_black = 30;

struct Textures {
  std::array<cv::Mat, grain_scales> dx, dy;  // CV_16S, of the photo at 1, 1/2 and 1/4 of its size
  std::array<cv::Mat, pattern_scales> patterns{};  // CV_8U, bin of each pixel
};

// The bin of a pixel that is not at the rim: how many of its 8 neighbours are lighter where those
// lie side by side, else the last bin.
int pattern_of(const cv::Mat& lightness, int y, int x) {
  constexpr std::array<std::array<int, 2>, 8> ring = {
      {{-1, -1}, {-1, 0}, {-1, 1}, {0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}}};
  constexpr int min_lighter = 3;  // less is noise
  const int own = lightness.at<std::uint8_t>(y, x) + min_lighter;
  std::array<bool, ring.size()> lighter{};
  for (std::size_t i = 0; i < ring.size(); ++i)
    lighter[i] = lightness.at<std::uint8_t>(y + ring[i][0], x + ring[i][1]) >= own;
  int changes = 0, count = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    changes += lighter[i] != lighter[(i + 1) % ring.size()] ? 1 : 0;
    count += lighter[i] ? 1 : 0;
  }
  return changes <= 2 ? count : pattern_bins - 1;
}

cv::Mat patterns_of(const cv::Mat& lightness) {
  cv::Mat patterns(lightness.size(), CV_8UC1, cv::Scalar(0));
  for (int y = 1; y + 1 < lightness.rows; ++y) {
    for (int x = 1; x + 1 < lightness.cols; ++x)
      patterns.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(pattern_of(lightness, y, x));
  }
  return patterns;
}

Textures textures_of(const cv::Mat& lightness) {
  Textures found;
  cv::Mat small = lightness;
  for (std::size_t scale = 0; scale < grain_scales; ++scale) {
    if (scale > 0) cv::resize(small, small, {}, 0.5, 0.5, cv::INTER_AREA);
    cv::Sobel(small, found.dx[scale], CV_16S, 1, 0);
    cv::Sobel(small, found.dy[scale], CV_16S, 0, 1);
    if (scale < pattern_scales) found.patterns[scale] = patterns_of(small);
  }
  return found;
}

// Eighth of the circle from the direction of a, turning towards b.
int octant_of(double a, double b) {
  const bool steep = std::abs(b) > std::abs(a);
  if (b >= 0) return a > 0 ? (steep ? 1 : 0) : (steep ? 2 : 3);
  return a < 0 ? (steep ? 5 : 4) : (steep ? 6 : 7);
}

// Nearest of level, falling, upright and rising gradients.
int orientation_of(double dx, double dy) {
  constexpr double eighth = 0.41421356;  // tangent of 22.5 degrees
  if (std::abs(dy) < eighth * std::abs(dx)) return 0;
  if (std::abs(dx) < eighth * std::abs(dy)) return 2;
  return dx * dy > 0 ? 1 : 3;
}

void add_colors(CellNumbers& cell, const cv::Mat& lab) {
  std::array<double, 3> sum{}, squares{};
  for (int y = 0; y < lab.rows; ++y) {
    const auto* row = lab.ptr<cv::Vec3b>(y);
    for (int x = 0; x < lab.cols; ++x) {
      const double l = row[x][0] / 255.0, a = (row[x][1] - 128) / chroma_unit,
                   b = (row[x][2] - 128) / chroma_unit;
      const std::array<double, 3> color = {l, a, b};
      for (std::size_t c = 0; c < 3; ++c) {
        sum[c] += color[c];
        squares[c] += color[c] * color[c];
      }
      const double chroma = std::sqrt(a * a + b * b);
      cell[number::chroma] += chroma;
      cell[number::hue + octant_of(a, b)] += chroma;
      cell[number::lightness + row[x][0] * lightness_bins / 256] += 1;
      cell[number::white] += row[x][0] > nearly_white ? 1 : 0;
      cell[number::dark] += row[x][0] < nearly_black ? 1 : 0;
    }
  }
  const double pixels = static_cast<double>(lab.total());
  for (std::size_t i = number::hue; i <= number::dark; ++i)
    cell[i] /= pixels;
  for (std::size_t c = 0; c < 3; ++c) {
    const double mean = sum[c] / pixels;
    cell[number::mean + c] = mean;
    cell[number::spread + c] = std::sqrt(std::max(0.0, squares[c] / pixels - mean * mean));
  }
}

// The same square of a picture that is smaller by a power of two.
cv::Rect shrunk(cv::Rect at, std::size_t scale, const cv::Mat& picture) {
  const int shift = static_cast<int>(scale);
  return cv::Rect(at.x >> shift,
                  at.y >> shift,
                  std::max(1, at.width >> shift),
                  std::max(1, at.height >> shift)) &
         cv::Rect(0, 0, picture.cols, picture.rows);
}

void add_patterns(CellNumbers& cell, const Textures& textures, cv::Rect at) {
  for (std::size_t scale = 0; scale < pattern_scales; ++scale) {
    const cv::Mat& patterns = textures.patterns[scale];
    const cv::Rect here = shrunk(at, scale, patterns);
    for (int y = here.y; y < here.br().y; ++y) {
      for (int x = here.x; x < here.br().x; ++x)
        cell[number::pattern + scale * pattern_bins + patterns.at<std::uint8_t>(y, x)] +=
            1.0 / here.area();
    }
  }
}

void add_grain(CellNumbers& cell, const Textures& textures, cv::Rect at) {
  for (std::size_t scale = 0; scale < grain_scales; ++scale) {
    const cv::Mat &all_x = textures.dx[scale], &all_y = textures.dy[scale];
    const cv::Rect here = shrunk(at, scale, all_x);
    if (here.empty()) continue;
    double along_x = 0, along_y = 0;
    for (int y = here.y; y < here.br().y; ++y) {
      for (int x = here.x; x < here.br().x; ++x) {
        const double dx = all_x.at<short>(y, x), dy = all_y.at<short>(y, x);
        along_x += std::abs(dx);
        along_y += std::abs(dy);
        if (scale == 0 && (dx != 0 || dy != 0))
          cell[number::orientation + orientation_of(dx, dy)] += std::sqrt(dx * dx + dy * dy);
      }
    }
    constexpr double unit = 256;
    cell[number::grain + 2 * scale] = along_x / here.area() / unit;
    cell[number::grain + 2 * scale + 1] = along_y / here.area() / unit;
  }
  double edges = 1e-9;
  for (int i = 0; i < orientation_bins; ++i)
    edges += cell[number::orientation + i];
  for (int i = 0; i < orientation_bins; ++i)
    cell[number::orientation + i] /= edges;
}

}  // namespace

Cells cells_of(const Looked& photo) {
  const Textures textures = textures_of(photo.lightness);
  Cells cells;
  cells.columns = (photo.lab.cols + cell_px - 1) / cell_px;
  cells.rows = (photo.lab.rows + cell_px - 1) / cell_px;
  const cv::Rect whole(0, 0, photo.lab.cols, photo.lab.rows);
  for (int row = 0; row < cells.rows; ++row) {
    for (int column = 0; column < cells.columns; ++column) {
      const cv::Rect at = cv::Rect(column * cell_px, row * cell_px, cell_px, cell_px) & whole;
      CellNumbers& cell = cells.numbers.emplace_back();
      cell.fill(0);
      add_colors(cell, photo.lab(at));
      add_grain(cell, textures, at);
      add_patterns(cell, textures, at);
      for (std::size_t i = 0; i < cell.size(); ++i)
        cells.whole[i] += cell[i];
    }
  }
  for (double& sum : cells.whole)
    sum /= static_cast<double>(cells.numbers.size());
  return cells;
}

}  // namespace marketgen::photo
