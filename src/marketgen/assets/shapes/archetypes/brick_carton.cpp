#include <algorithm>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/loft.h"
#include "assets/shapes/archetypes/panel_box.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr int brick_cap_triangles = 200;
constexpr float brick_fold_radius_m = 0.002F;
constexpr float brick_bulge_share = 0.03F;  // of the depth: a full carton's walls are not flat
constexpr float brick_cap_from_m =
    0.15F;  // litre packs have a screw cap, portion packs a straw hole

// A closed carton's walls swell in their middle.
Vec3f brick_point(Vec3f share, Vec3f size) {
  Vec3f p = rounded_box_point(share, size, brick_fold_radius_m);
  const float across = 2 * share.x - 1, up = 2 * share.z - 1;
  p.y *= 1 - brick_bulge_share * (1 - (1 - across * across) * (1 - up * up));
  return p;
}

void add_brick_cap(PackBuilder& pack, float low, float radius, std::uint16_t surface) {
  const float high = pack.height();
  const auto ring = [&](float z, float share) {
    return Section{
        .z = z, .half_width = share * radius, .half_depth = share * radius, .surface = surface};
  };
  const float sunk = low - 0.002F;
  add_loft(pack,
           {ring(sunk, 1), ring(high - 0.15F * (high - low), 1), ring(high, 0.85F)},
           {.triangles = brick_cap_triangles},
           PartFrame{.origin = {0, -0.20F * pack.depth(), 0}});
}

}  // namespace

Result<ProductModel> make_brick_carton(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const std::uint16_t print = pack.add_print(gloss_paper_roughness);
  const std::uint16_t cap = pack.add_surface(plastic(colors.accent));
  const std::uint16_t board = pack.add_surface(film(colors.primary));
  const float h = pack.height();
  const bool capped = h >= brick_cap_from_m;
  const float fin = 0.0015F;
  const Vec3f size{pack.width(), pack.depth(), capped ? h - std::min(0.010F, 0.05F * h) : h - fin};

  const BoxGrid grid{rounded_lines(size.x, brick_fold_radius_m, 1, 4),
                     rounded_lines(size.y, brick_fold_radius_m, 1, 1),
                     rounded_lines(size.z, brick_fold_radius_m, 1, 6)};
  add_panel_box(pack, grid, {print, print, print, print, print, print}, [&](Vec3f share) {
    return brick_point(share, size);
  });
  // The sealed fin is folded flat onto the top.
  add_plain_box(pack,
                {0.94F * size.x, 0.10F * size.y, 2 * fin},
                0.4F * fin,
                board,
                PartFrame{.origin = {0, 0.22F * size.y, size.z - fin}});
  pack.add_surface_feature(FeatureKind::seam, board);
  if (capped) add_brick_cap(pack, size.z, std::min({0.013F, 0.22F * size.y, 0.22F * size.x}), cap);
  pack.add_surface_feature(FeatureKind::cap, cap);
  return pack.finish();
}

CollisionPrimitive collision_brick_carton(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
