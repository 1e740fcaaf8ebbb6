// How one copy of a product differs from the next on the shelf: its print batch, and how long it
// has been handled. Deterministic: the same item looks the same in every picture, in both modes.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "render/sensor/float8.h"
#include "render/shading_math.h"

namespace marketgen::render::raytrace {

struct ItemLook {
  Vec3f tint{1, 1, 1};  // multiplies the colour
  float wear = 0;       // 0 as new, 1 long on the shelf and often handled
};

// What an item is made of decides how it varies: printed packs by batch and age, grown goods each
// for itself.
enum class ItemKind { packed, grown };
// `item` and `sku` are rows of the scene's products and its catalogue.
ItemLook look_of_item(std::size_t item, std::uint32_t sku, ItemKind kind);

// Share of wear that a fold or rim shows, 0..1: some edges are knocked, others are not. The two
// triangles of a quad share theirs.
inline float knock_of(std::uint32_t id, std::uint32_t primitive) {
  const std::uint32_t mixed = id * 0x85EBCA6BU + (primitive >> 1) * 0x9E3779B1U;
  return static_cast<float>(mixed >> 24) * (1.0F / 255);
}
inline Float8 knock_of(Int8 id, Int8 primitive) {
  const auto factor = [](std::uint32_t bits) { return Int8(static_cast<std::int32_t>(bits)); };
  const Int8 mixed = id * factor(0x85EBCA6BU) + (primitive >> 1) * factor(0x9E3779B1U);
  return to_float(mixed >> 24) * (1.0F / 255);
}

// Where wear shows, of one surface or of eight side by side.
template <class Number>
struct WornPlace {
  Number wear;
  Number flatness;  // cosine between the triangle's face and its first corner's normal: folds and
                    // rims are rounded by normals that differ
  Number knock;     // see knock_of()
  Number up;        // z of the normal: dust lies on tops
};

// Inks fade, lacquer dulls, edges are scuffed down to the paper, dust settles.
template <class Number>
void wear_off(const WornPlace<Number>& place, Vector3<Number>& albedo, Number& roughness) {
  using std::clamp, std::min;
  constexpr float sharp_from = 0.95F, per_sharpness = 6;  // a fold of 45 degrees wears in full
  constexpr float max_fade = 0.3F, max_scuff = 0.85F, max_dust = 0.4F;
  constexpr float max_dulling = 0.18F, rough_scuff = 0.3F;
  const Vector3<Number> paper{0.7F, 0.68F, 0.64F}, dust_color{0.42F, 0.4F, 0.37F};
  const Number none = 0.0F, all_of_it = 1.0F;
  const Number sharp = clamp((sharp_from - place.flatness) * per_sharpness, none, all_of_it);
  const Number scuff = sharp * place.knock * place.wear * max_scuff;
  const Number dust = clamp(place.up * 2.0F - 1.0F, none, all_of_it) * place.wear * max_dust;
  const Number grey = luminance(albedo);
  albedo = albedo + (Vector3<Number>{grey, grey, grey} - albedo) * (place.wear * max_fade);
  albedo = albedo + (paper - albedo) * scuff;
  albedo = albedo + (dust_color - albedo) * dust;
  const Number dulled = place.wear * max_dulling + (scuff + dust) * rough_scuff;
  roughness = min(roughness + dulled, all_of_it);
}

}  // namespace marketgen::render::raytrace
