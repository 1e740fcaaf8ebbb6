#include <algorithm>
#include <cmath>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/loft.h"
#include "assets/shapes/archetypes/panel_box.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr float gable_edge_radius_m = 0.0015F;
constexpr int gable_cap_triangles = 300;
constexpr float fin_half_thickness_m = 0.0009F;
// Shares of the top face, front to back: where the slope ends and the fin's two upper edges lie
// (assets/print/label.h).
constexpr float slope_end = 0.45F, fin_front = 0.49F;
// Shares of the walls' height: the wall ends here, then the gable is folded in, then comes the
// roof's own edge.
constexpr float wall_end = 0.996F, gable_fold = 0.998F;

struct Gable {
  Vec3f size;
  GableRoof roof;
};

// Height and depth of the roof's line over a share of the depth.
Vec2f roof_line(const Gable& gable, float share_y) {
  const float side = share_y < 0.5F ? -1.0F : 1.0F;
  const float from_eave = std::min(share_y, 1 - share_y);
  const float half = gable.size.y / 2;
  if (from_eave <= slope_end) {
    const float t = from_eave / slope_end;
    return {side * (half + (fin_half_thickness_m - half) * t),
            gable.roof.body_m + gable.roof.rise_m * t};
  }
  const float t = std::min(1.0F, (from_eave - slope_end) / (fin_front - slope_end));
  return {side * fin_half_thickness_m,
          gable.roof.body_m + gable.roof.rise_m + gable.roof.fin_m * t};
}

// Draws corner and bottom edges in, so that the rows of the grid beside them become bevels.
Vec3f bevelled(Vec3f p, Vec3f share) {
  const auto at_end = [](float s) { return s <= 0 || s >= 1; };
  const int ends = (at_end(share.x) ? 1 : 0) + (at_end(share.y) ? 1 : 0) + (share.z <= 0 ? 1 : 0);
  if (ends < 2) return p;
  constexpr float drawn = 0.29F * gable_edge_radius_m;  // 1 - sqrt(1/2)
  if (at_end(share.x)) p.x -= std::copysign(drawn, p.x);
  if (at_end(share.y)) p.y -= std::copysign(drawn, p.y);
  if (share.z <= 0) p.z += drawn;
  return p;
}

Vec3f gable_point(const Gable& gable, Vec3f share) {
  const float x = (share.x - 0.5F) * gable.size.x;
  const float wall_y = (share.y - 0.5F) * gable.size.y;
  if (share.z <= wall_end)
    return bevelled({x, wall_y, gable.roof.body_m * share.z / wall_end}, share);
  const Vec2f roof = roof_line(gable, share.y);
  if (share.z >= 1) return bevelled({x, roof.x, roof.y}, share);
  const float ridge = 1 - std::abs(2 * share.y - 1);  // 0 at the eaves, 1 under the ridge
  const float inward = 0.55F * gable.roof.rise_m * ridge;
  const Vec3f middle{
      x - std::copysign(inward, x),
      (wall_y + roof.x) / 2,
      (gable.roof.body_m + std::min(roof.y, gable.roof.body_m + gable.roof.rise_m)) / 2};
  return bevelled(middle, share);
}

// Sits on the middle of the front slope, square to it.
void add_gable_cap(PackBuilder& pack, const Gable& gable, std::uint16_t surface) {
  const float half = gable.size.y / 2, slope = gable.roof.slope_m;
  const float radius = std::min({0.013F, 0.28F * slope, 0.25F * gable.size.x});
  const Vec3f up_slope{0, half / slope, gable.roof.rise_m / slope};
  const Vec3f out{0, -gable.roof.rise_m / slope, half / slope};
  const Vec3f eave{0, -half, gable.roof.body_m};
  const auto ring = [&](float z, float share) {
    return Section{
        .z = z, .half_width = share * radius, .half_depth = share * radius, .surface = surface};
  };
  const float high = 0.65F * radius;
  add_loft(pack,
           {ring(-0.002F, 1.15F),
            ring(0.12F * high, 1.15F),
            ring(0.14F * high, 1),
            ring(0.85F * high, 1),
            ring(high, 0.86F)},
           {.triangles = gable_cap_triangles},
           PartFrame{.origin = eave + 0.56F * slope * up_slope, .y = up_slope, .z = out});
}

}  // namespace

Result<ProductModel> make_gable_carton(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const std::uint16_t print = pack.add_print(gloss_paper_roughness);
  const std::uint16_t cap = pack.add_surface(plastic(colors.accent));
  const Gable gable{{pack.width(), pack.depth(), pack.height()}, gable_roof_of(product)};

  const float edge = gable_edge_radius_m / gable.size.y;
  const BoxGrid grid{rounded_lines(gable.size.x, gable_edge_radius_m, 1, 4),
                     {0,
                      edge,
                      slope_end / 2,
                      slope_end,
                      fin_front,
                      1 - fin_front,
                      1 - slope_end,
                      1 - slope_end / 2,
                      1 - edge,
                      1},
                     {0, gable_edge_radius_m / gable.roof.body_m, 0.5F, wall_end, gable_fold, 1}};
  add_panel_box(pack, grid, {print, print, print, print, print, print}, [&](Vec3f share) {
    return gable_point(gable, share);
  });
  add_gable_cap(pack, gable, cap);
  pack.add_surface_feature(FeatureKind::cap, cap);
  pack.add_band_feature(FeatureKind::seam, gable.roof.body_m + gable.roof.rise_m, pack.height());
  return pack.finish(0.7F);
}

CollisionPrimitive collision_gable_carton(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
