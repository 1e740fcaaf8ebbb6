#include "assets/material_texture.h"

#include <algorithm>
#include <array>

#include "assets/material_pattern.h"
#include "assets/paint_color.h"
#include "base/hash.h"

namespace marketgen {
namespace {

// A row's colour; mid grey when it is not written as #rrggbb, which check_catalog reports.
std::array<float, 3> components(const std::string& text) {
  const Result<Color> color = parse_color(text, "material");
  const Color c = color.ok() ? *color : Color{0.5, 0.5, 0.5};
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

}  // namespace

Image draw_material(const MaterialRow& material, int size_px) {
  const int side = std::clamp(size_px, 16, 4096);
  const MaterialLook look =
      material_look(material, side, Seed(hash64(material.id)).child("material"));
  const std::array<float, 3> first = components(material.color);
  const std::array<float, 3> second = components(material.second_color);
  Image image(side, side);
  std::uint8_t* to = image.pixels.data();
  for (std::size_t i = 0; i < look.mark.values.size(); ++i, to += 3) {
    for (std::size_t c = 0; c < 3; ++c) {
      const float value =
          (first[c] + (second[c] - first[c]) * look.mark.values[i]) * look.light.values[i];
      to[c] = byte_of(value);
    }
  }
  return image;
}

double material_extent_m(const MaterialRow& material) {
  return material.period_mm * periods_in_texture(material.pattern) * 1e-3;
}

}  // namespace marketgen
