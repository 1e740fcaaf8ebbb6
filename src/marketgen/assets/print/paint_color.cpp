#include "assets/print/paint_color.h"

#include <algorithm>
#include <string>

namespace marketgen::assets {
namespace {

// Relative luminance, with a square instead of the 2.4 power.
double luminance(const Color& c) {
  return 0.2126 * c.r * c.r + 0.7152 * c.g * c.g + 0.0722 * c.b * c.b;
}

}  // namespace

Result<Color> parse_color(std::string_view text, std::string_view where) {
  const bool six_digits =
      text.size() == 7 && text[0] == '#' &&
      std::all_of(text.begin() + 1, text.end(), [](char c) { return hex_digit(c) >= 0; });
  if (!six_digits) {
    return Error{
        "assets.bad_row",
        std::string(where),
        "\"" + std::string(text) + "\" is not a colour; write it as #rrggbb, like #cc3300"};
  }
  const auto component = [&](std::size_t i) {
    return (hex_digit(text[i]) * 16 + hex_digit(text[i + 1])) / 255.0;
  };
  return Color{component(1), component(3), component(5)};
}

Color blend(const Color& a, const Color& b, double share_of_b) {
  const auto between = [&](double x, double y) { return x + (y - x) * share_of_b; };
  return {between(a.r, b.r), between(a.g, b.g), between(a.b, b.b), between(a.a, b.a)};
}

Color lighter(const Color& c, double by) {
  return blend(c, {1, 1, 1, c.a}, by);
}

Color darker(const Color& c, double by) {
  return {c.r * (1 - by), c.g * (1 - by), c.b * (1 - by), c.a};
}

Color faded(const Color& c, double alpha) {
  return {c.r, c.g, c.b, alpha};
}

double contrast(const Color& a, const Color& b) {
  const double first = luminance(a);
  const double second = luminance(b);
  return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

Color readable_on(const Color& ground, const Color& preferred) {
  constexpr double large_type = 3.0;
  if (contrast(ground, preferred) >= large_type) return preferred;
  const Color dark = darker(ground, 0.78);
  const Color light = lighter(ground, 0.94);
  return contrast(ground, dark) > contrast(ground, light) ? dark : light;
}

Rgb8 to_rgb8(const Color& c) {
  return {byte_of(static_cast<float>(c.r)),
          byte_of(static_cast<float>(c.g)),
          byte_of(static_cast<float>(c.b))};
}

}  // namespace marketgen::assets
