#include "assets/materials/material_pattern.h"

#include <array>

#include "assets/materials/pattern_sheet.h"

namespace marketgen::assets {
namespace {

struct PatternEntry {
  int periods;
  void (*draw)(PatternSheet&);
};
constexpr PatternEntry patterns[] = {
#define MATERIAL_PATTERN(name, periods, description) {periods, draw_##name},
#include "catalog/material_patterns.inc"
#undef MATERIAL_PATTERN
};

}  // namespace

int periods_in_texture(catalog::MaterialPattern pattern) {
  return patterns[static_cast<std::size_t>(pattern)].periods;
}

MaterialLook material_look(const catalog::MaterialRow& material, int size_px, const Seed& seed) {
  PatternSheet sheet(material, size_px, seed);
  patterns[static_cast<std::size_t>(material.pattern)].draw(sheet);
  for (float& height : sheet.look.height_mm.values)
    height *= static_cast<float>(material.relief);
  return std::move(sheet.look);
}

}  // namespace marketgen::assets
