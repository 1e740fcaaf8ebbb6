#include "photo/features.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "photo/lamps.h"
#include "photo/vanishing_point.h"

namespace marketgen::photo {
namespace {

constexpr int direction_bins = 12, ray_bins = 12;
constexpr int map_columns = 4, map_rows = 3;
constexpr std::size_t colors = 3;

// Weighted mean and spread of all numbers of the cells, and the share of the photo.
std::vector<double> part_features(const Cells& cells, const std::vector<double>& weights) {
  CellNumbers mean{};
  std::array<double, colors> squares{};
  double all = 1e-9;
  for (std::size_t cell = 0; cell < weights.size(); ++cell) {
    const CellNumbers& numbers = cells.numbers[cell];
    all += weights[cell];
    for (std::size_t i = 0; i < numbers.size(); ++i)
      mean[i] += weights[cell] * numbers[i];
    for (std::size_t c = 0; c < colors; ++c)
      squares[c] += weights[cell] * numbers[c] * numbers[c];
  }
  for (double& sum : mean)
    sum /= all;
  std::vector<double> features(mean.begin(), mean.end());
  for (std::size_t c = 0; c < colors; ++c)
    features.push_back(std::sqrt(std::max(0.0, squares[c] / all - mean[c] * mean[c])));
  for (std::size_t c = 0; c < colors; ++c)
    features.push_back(mean[c] - cells.whole[c]);
  features.push_back(all / static_cast<double>(weights.size()));
  return features;
}

std::vector<double> weights_of(const std::vector<PartShares>& parts, std::size_t part) {
  // Squared: half-sure squares, at the rims of things, say little.
  std::vector<double> weights;
  for (const PartShares& shares : parts)
    weights.push_back(shares[part] * shares[part]);
  return weights;
}

// Mean colour of the whole and of the brightest tenth of the squares, and how far light falls off.
std::vector<double> light_features(const Cells& cells) {
  std::vector<std::size_t> order(cells.numbers.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t cell) {
    return cells.numbers[cell][number::mean];
  });
  const std::size_t brightest = std::max<std::size_t>(1, order.size() / 10);
  std::array<double, colors> bright{};
  for (std::size_t i = 0; i < brightest; ++i)
    for (std::size_t c = 0; c < colors; ++c)
      bright[c] += cells.numbers[order[i]][c] / static_cast<double>(brightest);
  std::vector<double> features(cells.whole.begin(), cells.whole.begin() + colors);
  features.insert(features.end(), bright.begin(), bright.end());
  for (const int tenth : {1, 3, 5, 7, 9})
    features.push_back(cells.numbers[order[order.size() * tenth / 10]][number::mean]);
  features.push_back(cells.whole[number::white]);
  features.push_back(cells.whole[number::dark]);
  return features;
}

// Directions of all segments; which lead to the vanishing point, from where, and where that is.
std::vector<double> line_features(const Looked& photo) {
  const std::vector<Segment> segments = segments_of(photo.lightness);
  const VanishingPoint point = vanishing_point(segments, photo.lightness.size());
  std::vector<double> directions(direction_bins), rays(ray_bins);
  double all = 1e-9, slanted = 0, high = 0;
  for (const Segment& segment : segments) {
    const double angle = std::atan2(segment.b.y - segment.a.y, segment.b.x - segment.a.x);
    const double turn = angle / std::numbers::pi + 2;
    directions[static_cast<std::size_t>(turn * direction_bins + 0.5) % direction_bins] +=
        segment.length();
    all += segment.length();
    slanted += is_slanted(segment) ? segment.length() : 0;
    high += segment.middle().y < point.at.y ? segment.length() : 0;
  }
  for (const std::size_t i : point.leading) {
    const cv::Point2d from = segments[i].middle() - point.at;
    const double turn = std::atan2(from.y, from.x) / (2 * std::numbers::pi) + 1;
    rays[static_cast<std::size_t>(turn * ray_bins) % ray_bins] += segments[i].length();
  }
  std::vector<double> features;
  for (const double length : directions)
    features.push_back(length / all);
  for (const double length : rays)
    features.push_back(length / (point.length + 1));
  features.push_back(point.at.x / photo.lightness.cols - 0.5);
  features.push_back(std::abs(features.back()));
  features.push_back(point.at.y / photo.lightness.rows - 0.5);
  features.push_back(point.length / all);
  features.push_back(point.length / (slanted + 1));
  features.push_back(slanted / all);
  features.push_back(high / all);
  features.push_back(std::log(all) / 10);
  return features;
}

// How much of each part there is in each field of a coarse map, left and right taken together.
std::vector<double> room_features(const Cells& cells, const std::vector<PartShares>& parts) {
  constexpr int half = map_columns / 2;
  std::vector<double> features(map_rows * half * part_count);
  std::vector<double> seen(map_rows * half, 1e-9);
  for (int row = 0; row < cells.rows; ++row) {
    for (int column = 0; column < cells.columns; ++column) {
      const int across = std::min(column, cells.columns - 1 - column) * map_columns / cells.columns;
      const int field = row * map_rows / cells.rows * half + std::min(across, half - 1);
      const PartShares& shares = parts[static_cast<std::size_t>(row) * cells.columns + column];
      seen[field] += 1;
      for (std::size_t part = 0; part < part_count; ++part)
        features[field * part_count + part] += shares[part];
    }
  }
  for (std::size_t i = 0; i < features.size(); ++i)
    features[i] /= seen[i / part_count];
  features.push_back(static_cast<double>(cells.rows) / cells.columns);
  return features;
}

// Of all squares alike, and how sure the parts are: no shop, no parts.
std::vector<double> whole_features(const Cells& cells, const std::vector<PartShares>& parts) {
  std::vector<double> features = part_features(cells, std::vector<double>(parts.size(), 1.0));
  double sure = 0;
  PartShares mean{};
  for (const PartShares& shares : parts) {
    sure += *std::ranges::max_element(shares) / static_cast<double>(parts.size());
    for (std::size_t part = 0; part < part_count; ++part)
      mean[part] += shares[part] / static_cast<double>(parts.size());
  }
  features.push_back(sure);
  features.insert(features.end(), mean.begin(), mean.end());
  return features;
}

}  // namespace

Features features_of(const Looked& photo,
                     const Cells& cells,
                     const std::vector<PartShares>& parts) {
  Features features;
  for (std::size_t part = 0; part < part_count; ++part)
    features.groups[part] = part_features(cells, weights_of(parts, part));
  features.groups[part_count] = light_features(cells);
  features.groups[part_count + 1] = lamp_features(photo, cells, parts);
  features.groups[part_count + 2] = line_features(photo);
  features.groups[part_count + 3] = room_features(cells, parts);
  features.groups[part_count + 4] = whole_features(cells, parts);
  return features;
}

std::vector<double> Features::of(const std::vector<std::string>& names) const {
  std::vector<double> all;
  for (const std::string& name : names) {
    const auto at = std::ranges::find(group_names, name) - group_names.begin();
    all.insert(all.end(), groups[at].begin(), groups[at].end());
  }
  return all;
}

std::size_t feature_count(std::string_view group) {
  constexpr std::size_t of_part = number::count + 2 * colors + 1;
  if (std::ranges::find(part_names, group) != part_names.end()) return of_part;
  if (group == "light") return 2 * colors + 7;
  if (group == "lamps") return lamp_feature_count;
  if (group == "lines") return direction_bins + ray_bins + 8;
  if (group == "room") return map_rows * map_columns / 2 * part_count + 1;
  if (group == "whole") return of_part + 1 + part_count;
  return 0;
}

}  // namespace marketgen::photo
