#include "assets/shapes/archetypes/surfaces.h"

#include "assets/print/color.h"

namespace marketgen::assets {
namespace {

// The colour of one label field; an error names the field.
Result<Vec3f> label_color(const catalog::Product& product,
                          std::string_view field,
                          const std::string& text) {
  Result<Vec3f> color = linear_from_hex(text);
  if (color.ok()) return color;
  return Error{
      color.error().code, product.sku + "/label/" + std::string(field), color.error().message};
}

}  // namespace

Result<PackColors> pack_colors(const catalog::Product& product) {
  PackColors colors;
  MARKETGEN_TRY(colors.primary, label_color(product, "primary", product.label.primary));
  MARKETGEN_TRY(colors.secondary, label_color(product, "secondary", product.label.secondary));
  MARKETGEN_TRY(colors.accent, label_color(product, "accent", product.label.accent));
  return colors;
}

Surface aluminium() {
  return {.color = {0.80F, 0.81F, 0.82F}, .roughness = 0.30F, .metallic = 1.0F};
}
Surface tinplate() {
  return {.color = {0.68F, 0.68F, 0.66F}, .roughness = 0.35F, .metallic = 1.0F};
}
Surface lacquered_metal(Vec3f color) {
  return {.color = color, .roughness = lacquer_roughness, .metallic = 0.3F};
}
Surface plastic(Vec3f color) {
  return {.color = color, .roughness = 0.40F};
}
Surface paper(Vec3f color) {
  return {.color = color, .roughness = matt_paper_roughness};
}
Surface film(Vec3f color) {
  return {.color = color, .roughness = film_roughness};
}
Surface clear_plastic(Vec3f color) {
  return {.color = color, .roughness = plastic_wall_roughness};
}
Surface dark_glass() {
  return {.color = {0.0103F, 0.0176F, 0.0060F}, .roughness = glass_roughness};  // #1a2412
}

}  // namespace marketgen::assets
