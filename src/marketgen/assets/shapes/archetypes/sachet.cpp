#include <algorithm>
#include <cmath>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/film_bag.h"
#include "assets/shapes/archetypes/pack_faces.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr float sachet_seal_m = 0.007F;

// Lens-shaped between the four seals, powder lower down.
float sachet_thickness(float x, float z, float side, float end) {
  const float across = std::min(std::abs(x) / (1 - side), 1.0F);
  const float up = std::min(std::abs(2 * z - 1) / (1 - end), 1.0F);
  const float lens = (1 - across * across * across * across) * (1 - up * up * up * up);
  return lens * (1 - 0.22F * (2 * z - 1));
}

std::vector<float> sealed_lines(float seal, int cells) {
  std::vector<float> lines{0};
  for (const float line : rounded_lines(1, 0.24F, 3, cells))
    lines.push_back(seal / 2 + (1 - seal) * line);
  lines.push_back(1);
  return lines;
}

}  // namespace

// Soup, yeast, sauce powder: two films sealed on all four sides.
Result<ProductModel> make_sachet(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t edge = pack.add_surface(film(colors.primary));
  const FlatForm form = flat_form_of(product);
  const float side = std::min(2 * sachet_seal_m / form.size.x, 0.15F);
  const float end = std::min(2 * sachet_seal_m / form.size.z, 0.15F);
  const auto thickness = [&](float x, float z) {
    return sachet_thickness(x, z, side, end) / 1.22F;
  };
  add_bag(pack,
          print,
          edge,
          {form.size, sealed_lines(side, 7), sealed_lines(end, 9), 0.012F, thickness},
          form.frame);
  pack.add_band_feature(
      FeatureKind::seam, -pack.width() / 2, (side - 1) * pack.width() / 2, PackAxis::x);
  return pack.finish(0.3F);
}

CollisionPrimitive collision_sachet(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
