#include "assets/materials/material_texture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "assets/materials/material_pattern.h"
#include "assets/print/paint_color.h"
#include "base/hash.h"

namespace marketgen::assets {
namespace {

// sRGB bytes of albedo 0.02 (fresh asphalt, black rubber) and 0.9 (fresh snow): nothing in a shop
// is darker or whiter.
constexpr std::uint8_t darkest = 39, whitest = 243;
// Steeper flanks cannot be told from each other at the size of a texel.
constexpr float steepest = 1.5F;
constexpr float min_roughness = 0.02F;

using Components = std::array<float, 3>;

// A row's colour; mid grey when it is not written as #rrggbb, which check_catalog reports.
Components components(const std::string& text) {
  const Result<Color> color = parse_color(text, "material");
  const Color c = color.ok() ? *color : Color{0.5, 0.5, 0.5};
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

Image color_of(const catalog::MaterialRow& material, const MaterialLook& look) {
  const Components first = components(material.color);
  const Components second = components(material.second_color);
  const Components third =
      components(material.third_color.empty() ? material.second_color : material.third_color);
  Image image(look.mark.width, look.mark.height);
  std::uint8_t* to = image.pixels.data();
  for (std::size_t i = 0; i < look.mark.values.size(); ++i, to += 3) {
    for (std::size_t c = 0; c < 3; ++c) {
      float value = first[c] + (second[c] - first[c]) * look.mark.values[i];
      value += (third[c] - value) * look.third.values[i];
      to[c] = std::clamp(byte_of(value * look.light.values[i]), darkest, whitest);
    }
  }
  return image;
}

// Slopes by central differences over the wrapped field.
Image normals_of(const TextureField& height_mm, float mm_per_px) {
  const int width = height_mm.width, height = height_mm.height;
  Image image(width, height);
  const float scale = 1 / (2 * mm_per_px);
  for (int y = 0; y < height; ++y) {
    const float* above = height_mm.row((y + height - 1) % height);
    const float* here = height_mm.row(y);
    const float* below = height_mm.row((y + 1) % height);
    for (int x = 0; x < width; ++x) {
      const float along = (here[(x + 1) % width] - here[(x + width - 1) % width]) * scale;
      const float up = (above[x] - below[x]) * scale;
      const float steep = std::sqrt(along * along + up * up);
      const float limit = steep > steepest ? steepest / steep : 1;
      const float nx = -along * limit, ny = -up * limit;
      const float unit = 1 / std::sqrt(nx * nx + ny * ny + 1);
      std::uint8_t* to = image.at(x, y);
      to[0] = byte_of(0.5F + 0.5F * nx * unit);
      to[1] = byte_of(0.5F + 0.5F * ny * unit);
      to[2] = byte_of(0.5F + 0.5F * unit);
    }
  }
  return image;
}

MaterialLook look_of(const catalog::MaterialRow& material, int side) {
  return material_look(material, side, Seed(hash64(material.id)).child("material"));
}

int side_of(int size_px) {
  return std::clamp(size_px, 16, 4096);
}

}  // namespace

MaterialMaps draw_material_maps(const catalog::MaterialRow& material, int size_px) {
  const int side = side_of(size_px);
  const MaterialLook look = look_of(material, side);
  const auto mm_per_px =
      static_cast<float>(material_extent_m(material) * 1000) / static_cast<float>(side);
  MaterialMaps maps{color_of(material, look),
                    normals_of(look.height_mm, mm_per_px),
                    Image(side, side, 1),
                    Image(side, side, 1)};
  const auto roughness = static_cast<float>(material.roughness);
  const auto metallic = static_cast<float>(material.metallic);
  for (std::size_t i = 0; i < look.roughness.values.size(); ++i) {
    maps.roughness.pixels[i] =
        byte_of(std::max(roughness + look.roughness.values[i], min_roughness));
    maps.metallic.pixels[i] = byte_of(metallic * look.metal.values[i]);
  }
  return maps;
}

Image draw_material(const catalog::MaterialRow& material, int size_px) {
  return color_of(material, look_of(material, side_of(size_px)));
}

double material_extent_m(const catalog::MaterialRow& material) {
  return material.period_mm * periods_in_texture(material.pattern) * 1e-3;
}

}  // namespace marketgen::assets
