#include "assets/shapes/archetypes/surfaces.h"

#include "assets/print/color.h"
#include "base/text.h"

namespace marketgen::assets {
namespace {

struct ContentRow {
  std::string_view word, color;
  float refraction;
};
constexpr ContentRow content_rows[] = {
#define CONTENT(word, color, refraction) {word, color, refraction},
#include "assets/shapes/archetypes/contents.inc"
#undef CONTENT
};

// Everything the row says about what is inside, in small letters.
std::string words_of(const catalog::Product& product) {
  std::string words = product.name + " " + product.variant + " " + product.subcategory;
  for (const std::string& keyword : product.keywords)
    words += " " + keyword;
  return lower_ascii(words);
}

// The first row whose word the product's contain, or null.
const ContentRow* content_row(const catalog::Product& product) {
  const std::string words = words_of(product);
  for (const ContentRow& row : content_rows) {
    if (words.find(row.word) != std::string::npos) return &row;
  }
  return nullptr;
}

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

Result<Vec3f> contents_color(const catalog::Product& product) {
  if (const ContentRow* row = content_row(product)) return linear_from_hex(row->color);
  return label_color(product, "primary", product.label.primary);
}

float contents_refraction(const catalog::Product& product) {
  const ContentRow* row = content_row(product);
  return row == nullptr ? 0 : row->refraction;
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
Surface filled_plastic(Vec3f contents, float refraction) {
  return {.color = contents, .roughness = 0.12F, .refraction = refraction};
}
Surface dark_glass() {
  return filled_glass({0.0103F, 0.0176F, 0.0060F});  // #1a2412
}
Surface filled_glass(Vec3f contents, float refraction) {
  return {.color = contents, .roughness = 0.06F, .refraction = refraction};
}

}  // namespace marketgen::assets
