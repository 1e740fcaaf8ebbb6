// Colours for drawing: sRGB-encoded components 0..1, as designers write them.
#pragma once
#include <string_view>

#include "base/result.h"
#include "geometry/image.h"

namespace marketgen::assets {

struct Color {
  double r = 0, g = 0, b = 0, a = 1;
  friend constexpr bool operator==(const Color&, const Color&) = default;
};

constexpr Color paper_white{1, 1, 1};
constexpr Color print_ink{0.10, 0.09, 0.11};  // the near black of small print

// Reads "#rrggbb". Errors: assets.bad_row, with `where` as the place.
Result<Color> parse_color(std::string_view text, std::string_view where);

// Value of a hexadecimal digit, or -1.
constexpr int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// For colours written in our own source, "#rrggbb"; a wrong one does not compile.
consteval Color rgb(std::string_view text) {
  const auto component = [&](std::size_t i) {
    const int value = hex_digit(text.at(i)) * 16 + hex_digit(text.at(i + 1));
    return value < 0 ? throw "not a colour" : value / 255.0;
  };
  return text.size() == 7 && text[0] == '#' ? Color{component(1), component(3), component(5)}
                                            : throw "write colours as #rrggbb";
}

Color blend(const Color& a, const Color& b, double share_of_b);
Color lighter(const Color& c, double by);   // towards white, 0..1
Color darker(const Color& c, double by);    // towards black, 0..1, hue kept
Color faded(const Color& c, double alpha);  // the same colour, `alpha` opaque

// Contrast ratio 1..21 as WCAG 2.1 defines it, except that sRGB is decoded by squaring: the same
// bits on every machine.
double contrast(const Color& a, const Color& b);

// `preferred` if it reads well on `ground` (contrast of 3 at least, WCAG's bound for large type),
// otherwise the better of a dark and a light tint of the ground.
Color readable_on(const Color& ground, const Color& preferred);

// A component 0..1 (clamped) as a byte, rounded. Inline: it runs for every component of every
// texel.
constexpr std::uint8_t byte_of(float component) {
  constexpr float rounding = 0.5F;
  const float inside = component < 0 ? 0 : component > 1 ? 1 : component;
  return static_cast<std::uint8_t>(inside * 255 + rounding);
}
Rgb8 to_rgb8(const Color& c);

}  // namespace marketgen::assets
