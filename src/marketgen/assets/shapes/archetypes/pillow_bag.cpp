#include <algorithm>
#include <cmath>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/film_bag.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"
#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr float pillow_seal_share = 0.05F;  // of the height, each end
constexpr float pillow_waist = 0.07F;       // the width a blown-up bag loses

// Round across (the sides are folds, not seals), closing steadily to the two end seals.
float pillow_thickness(float x, float z) {
  const float along = std::min(std::abs(2 * z - 1) / (1 - 2 * pillow_seal_share), 1.0F);
  const float square = along * along;
  const float middle = 0.45F * std::sqrt(1 - square) + 0.55F * (1 - square * square);
  return middle * std::sqrt(std::max(0.0F, 1 - x * x));
}

// Equal steps of the round cross-section.
std::vector<float> lines_around(int cells) {
  std::vector<float> lines;
  for (int i = 0; i <= cells; ++i) {
    lines.push_back(static_cast<float>(0.5 - 0.5 * unit_circle(0.5 * i / cells).x));
  }
  return lines;
}

}  // namespace

Result<ProductModel> make_pillow_bag(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t edge = pack.add_surface(film(colors.primary));

  std::vector<float> up{0};
  for (const float line : lines_around(14))
    up.push_back(pillow_seal_share + (1 - 2 * pillow_seal_share) * line);
  up.push_back(1);
  const Vec3f size{pack.width(), pack.depth(), pack.height()};
  add_bag(pack, print, edge, {size, lines_around(14), up, pillow_waist, pillow_thickness});
  pack.add_band_feature(FeatureKind::seam, 0, pillow_seal_share * size.z);
  pack.add_band_feature(FeatureKind::seam, (1 - pillow_seal_share) * size.z, size.z);
  return pack.finish(0.5F);
}

CollisionPrimitive collision_pillow_bag(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
