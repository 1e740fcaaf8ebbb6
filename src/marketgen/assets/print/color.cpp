#include "assets/print/color.h"

#include <array>
#include <optional>
#include <string>

#include "assets/print/paint_color.h"

namespace marketgen::assets {
namespace {

// Newton's method from above, which falls monotonically: x is in (0, 1], so 60 rounds reach the
// last bit. std::pow may differ in that bit between libraries; this cannot.
constexpr double fifth_root(double x) {
  double root = 1.0;
  for (int round = 0; round < 60; ++round) {
    const double fourth = root * root * root * root;
    root = (4.0 * root + x / fourth) / 5.0;
  }
  return root;
}

// IEC 61966-2-1: linear below 0.04045, then ((c + 0.055) / 1.055) ^ 2.4, with 2.4 = 2 + 2/5.
constexpr float decode(double c) {
  if (c <= 0.04045) return static_cast<float>(c / 12.92);
  const double base = (c + 0.055) / 1.055;
  const double root = fifth_root(base);
  return static_cast<float>(base * base * root * root);
}

constexpr std::array<float, 256> make_table() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = decode(static_cast<double>(i) / 255.0);
  return table;
}
constexpr std::array<float, 256> linear_table = make_table();

// The channel written at text[at], text[at + 1].
std::optional<float> channel_at(std::string_view text, std::size_t at) {
  const int high = hex_digit(text[at]);
  const int low = hex_digit(text[at + 1]);
  if (high < 0 || low < 0) return std::nullopt;
  return linear_from_srgb(static_cast<std::uint8_t>(high * 16 + low));
}

}  // namespace

float linear_from_srgb(std::uint8_t channel) {
  return linear_table[channel];
}

Result<Vec3f> linear_from_hex(std::string_view text) {
  if (text.size() == 7 && text[0] == '#') {
    const auto red = channel_at(text, 1);
    const auto green = channel_at(text, 3);
    const auto blue = channel_at(text, 5);
    if (red && green && blue) return Vec3f{*red, *green, *blue};
  }
  return Error{
      "assets.bad_row",
      "color",
      "\"" + std::string(text) + "\" is not a colour; write # and six hex digits, like #2e7d32"};
}

}  // namespace marketgen::assets
