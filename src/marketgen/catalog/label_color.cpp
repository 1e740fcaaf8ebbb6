#include "catalog/label_color.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace marketgen::catalog {
namespace {

struct HueRange {
  std::string_view term;
  double from_deg, to_deg;   // of hue; past 360 goes on at 0
  double darkest, lightest;  // of lightness, 0..1
};

// Between two of them there is room in which neither is said.
constexpr HueRange hue_ranges[] = {{"red", 348, 368, 0.25, 0.58},
                                   {"orange", 22, 36, 0.42, 0.65},
                                   {"yellow", 45, 60, 0.45, 0.75},
                                   {"green", 90, 160, 0.18, 0.60},
                                   {"blue", 198, 240, 0.22, 0.75},
                                   {"purple", 262, 295, 0.20, 0.60},
                                   {"pink", 318, 344, 0.60, 0.90}};
constexpr double whitest = 0.94, blackest = 0.12, grey_below = 0.08, coloured_from = 0.35;
constexpr double grey_from = 0.35, grey_to = 0.75;  // of lightness

std::optional<std::array<double, 3>> channels_of(std::string_view hex) {
  if (hex.size() != 7 || hex.front() != '#') return std::nullopt;
  std::array<double, 3> channels{};
  for (std::size_t i = 0; i < 3; ++i) {
    unsigned value = 0;
    const char* const from = hex.data() + 1 + 2 * i;
    const auto read = std::from_chars(from, from + 2, value, 16);
    if (read.ec != std::errc{} || read.ptr != from + 2) return std::nullopt;
    channels[i] = value / 255.0;
  }
  return channels;
}

double hue_deg(const std::array<double, 3>& c, double most, double spread) {
  if (most == c[0]) return 60 * std::fmod((c[1] - c[2]) / spread + 6, 6);
  if (most == c[1]) return 60 * ((c[2] - c[0]) / spread + 2);
  return 60 * ((c[0] - c[1]) / spread + 4);
}

}  // namespace

std::optional<std::string_view> label_color_term(std::string_view hex) {
  const auto channels = channels_of(hex);
  if (!channels) return std::nullopt;
  const auto [least, most] = std::ranges::minmax(*channels);
  const double lightness = (least + most) / 2, spread = most - least;
  if (lightness >= whitest && spread < grey_below) return "white";
  if (lightness <= blackest && spread < grey_below) return "black";
  if (spread < grey_below / 2)
    return lightness >= grey_from && lightness <= grey_to ? std::optional<std::string_view>("grey")
                                                          : std::nullopt;
  const double saturation = spread / (1 - std::abs(2 * lightness - 1));
  if (saturation < coloured_from) return std::nullopt;
  const double hue = hue_deg(*channels, most, spread);
  for (const HueRange& range : hue_ranges) {
    const bool within = (hue >= range.from_deg && hue <= range.to_deg) ||
                        (hue + 360 >= range.from_deg && hue + 360 <= range.to_deg);
    if (within && lightness >= range.darkest && lightness <= range.lightest) return range.term;
  }
  return std::nullopt;
}

}  // namespace marketgen::catalog
