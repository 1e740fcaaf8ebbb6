#include "assets/shapes/archetypes/body.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"
#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

// The dough over the cup's rim, and a little of it inside.
constexpr BodyForm dome_body{.outline = {{{0, 0},
                                          {0.6, 0.0},
                                          {0.74, 0.06},
                                          {0.78, 0.16},
                                          {0.96, 0.26},
                                          {1, 0.38},
                                          {0.92, 0.62},
                                          {0.68, 0.86},
                                          {0.34, 0.98},
                                          {0, 1}}},
                             .lumps = 0.09};
constexpr float cup_share = 0.62F;    // of the height
constexpr float dome_from = 0.48F;    // the dough reaches down to here
constexpr float foot_radius = 0.70F;  // of the rim's
constexpr int pleats = 24;

}  // namespace

Result<ProductModel> make_muffin(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const Seed seed = growth_seed(product);
  const std::uint16_t skin = pack.add_print(0.75F);
  const Vec3f half = Vec3f{pack.width(), pack.depth(), pack.height()} * 0.5F;
  const Vec3f brown_paper{0.16F, 0.075F, 0.03F}, white_paper{0.75F, 0.73F, 0.68F};
  const std::uint16_t cup = pack.add_surface(
      {.color = has_word(product, "chocolate") ? brown_paper : white_paper, .roughness = 0.8F});
  constexpr int cup_segments = 4 * pleats, cup_bands = 6;
  add_shell(pack, {cup}, {cup_segments, even_stations(cup_bands)}, [&](double turn, double along) {
    const bool pole = along <= 0 || along >= 1;
    const float rise = static_cast<float>(along <= 0.2    ? 0.0
                                          : along >= 0.85 ? 1.0
                                                          : (along - 0.2) / 0.65);
    const float pleat =
        1 - 0.035F * (0.5F + 0.5F * static_cast<float>(unit_circle(pleats * turn).x));
    const float share = pole ? 0 : 0.84F * pleat * (foot_radius + (1 - foot_radius) * rise);
    const Vec2 c = unit_circle(0.25 + turn);
    return Vec3f{half.x * share * static_cast<float>(c.x),
                 half.y * share * static_cast<float>(c.y),
                 rise * cup_share * 2 * half.z};
  });
  const float height = (1 - dome_from) * 2 * half.z;
  const GrownBody dome(dome_body, {half.x, half.y, 0.5F * height}, seed.child("dome").stream());
  constexpr int segments = 40, bands = 24;
  add_shell(pack, {skin}, {segments, even_stations(bands)}, [&](double turn, double along) {
    return dome.point(turn, along) + Vec3f{0, 0, dome_from * 2 * half.z};
  });
  return pack.finish(0.2F);
}

CollisionPrimitive collision_muffin(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
