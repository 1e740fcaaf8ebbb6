#include <algorithm>
#include <cmath>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/film_bag.h"
#include "assets/shapes/archetypes/pack_faces.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr float greatest_rim_m = 0.014F;  // flat film around the product

// 1 over the product, falling to 0 in a short slope at its edge; `t` from 0 in the middle to 1.
float plateau(float t, float rim) {
  const float slope = 0.16F;
  const float outside = std::clamp((t - (1 - rim - slope)) / slope, 0.0F, 1.0F);
  return std::sqrt(std::max(0.0F, 1 - outside * outside));
}

// Lines close together where the film slopes.
std::vector<float> slope_lines(float rim) {
  std::vector<float> lines{0, rim / 2};
  for (const float step : {0.02F, 0.10F, 0.25F, 0.45F, 0.70F, 1.0F})
    lines.push_back(rim / 2 + 0.08F * step);
  constexpr int inner = 4;
  const float from = lines.back();
  for (int i = 1; i < inner; ++i)
    lines.push_back(from + (1 - 2 * from) * static_cast<float>(i) / inner);
  const std::size_t half = 8;
  for (std::size_t i = 0; i < half; ++i)
    lines.push_back(1 - lines[half - 1 - i]);
  return lines;
}

}  // namespace

// Bacon, salmon, sliced sausage: two films drawn onto the product, a flat rim around it.
Result<ProductModel> make_vacuum_pack(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t edge = pack.add_surface(film(colors.primary));
  const FlatForm form = flat_form_of(product);
  const float rim_x = std::min(2 * greatest_rim_m / form.size.x, 0.2F);
  const float rim_z = std::min(2 * greatest_rim_m / form.size.z, 0.2F);
  const auto thickness = [&](float x, float z) {
    const float across = plateau(std::abs(x), rim_x), up = plateau(std::abs(2 * z - 1), rim_z);
    // The product's own face is not flat either.
    return across * up * (0.94F + 0.06F * (1 - x * x) * (4 * z * (1 - z)));
  };
  add_bag(pack,
          print,
          edge,
          {form.size, slope_lines(rim_x), slope_lines(rim_z), 0, thickness},
          form.frame);
  pack.add_band_feature(
      FeatureKind::seam, -pack.width() / 2, (rim_x - 1) * pack.width() / 2, PackAxis::x);
  return pack.finish(0.3F);
}

CollisionPrimitive collision_vacuum_pack(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
