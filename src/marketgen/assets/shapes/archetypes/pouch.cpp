#include <algorithm>
#include <cmath>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/film_bag.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr float pouch_seal_m = 0.006F;         // width of side seals
constexpr float pouch_top_seal_share = 0.07F;  // of the height
constexpr float pouch_fullest_share = 0.20F;   // height at which it is thickest
constexpr float pouch_foot_share = 0.86F;      // thickness on the ground, where the gusset opens

// Full from the foot gusset up, thinning to the top seal, lens-shaped across.
float pouch_thickness(float x, float z, float side_seal) {
  const float across = std::min(std::abs(x) / (1 - side_seal), 1.0F);
  const float lens = 0.6F * std::sqrt(1 - across * across) + 0.4F * (1 - across * across);
  const float up = std::min(z / (1 - pouch_top_seal_share), 1.0F);
  if (up < pouch_fullest_share) {
    const float below = 1 - up / pouch_fullest_share;
    return lens * (1 - (1 - pouch_foot_share) * below * below);
  }
  const float above = (up - pouch_fullest_share) / (1 - pouch_fullest_share);
  return lens * (1 - above) * (1 + 0.85F * above);
}

}  // namespace

Result<ProductModel> make_pouch(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t edge = pack.add_surface(film(colors.primary));
  const float side_seal = std::min(2 * pouch_seal_m / pack.width(), 0.15F);

  // Closer towards the seals, where the lens is steep.
  std::vector<float> across{0};
  constexpr int cells = 12;
  for (const float line : rounded_lines(1, 0.3F, 3, cells - 6)) {
    across.push_back(side_seal / 2 + (1 - side_seal) * line);
  }
  across.push_back(1);
  std::vector<float> up;
  for (const float line : even_lines(12))
    up.push_back((1 - pouch_top_seal_share) * line);
  up.push_back(1);
  const auto thickness = [&](float x, float z) { return pouch_thickness(x, z, side_seal); };
  const Vec3f size{pack.width(), pack.depth(), pack.height()};
  add_bag(pack, print, edge, {size, across, up, 0.03F, thickness});
  pack.add_band_feature(FeatureKind::seam, (1 - pouch_top_seal_share) * size.z, size.z);
  return pack.finish(0.5F);
}

CollisionPrimitive collision_pouch(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
