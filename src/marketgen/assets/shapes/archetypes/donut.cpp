#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/shell.h"
#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr float hole_share = 0.32F;   // of the outer radius
constexpr float glaze_thick = 0.07F;  // of the ring's half height
// Of the skin: the glaze above, the dough below.
constexpr float glaze_low_v = 0.58F, dough_high_v = 0.62F;

}  // namespace

Result<ProductModel> make_donut(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  Stream draw = growth_seed(product).stream();
  const std::uint16_t skin = pack.add_print(0.35F);
  const Vec3f half = Vec3f{pack.width(), pack.depth(), pack.height()} * 0.5F;
  const float ring = 0.5F * (1 + hole_share), thick = 0.5F * (1 - hole_share);
  // Across the ring: from the foot outwards, up, inwards and down again. `swell` in the ring's
  // thickness.
  const auto at = [&](double turn, double section, float swell) {
    const Vec2 around = unit_circle(0.25 + turn), across = unit_circle(section - 0.25);
    const float out = ring + thick * swell * static_cast<float>(across.x);
    const auto up = static_cast<float>(across.y);
    return Vec3f{half.x * out * static_cast<float>(around.x),
                 half.y * out * static_cast<float>(around.y),
                 half.z * swell * (up < 0 ? 0.92F * up : up)};
  };
  constexpr int around = 48, bands = 20;
  add_shell(pack,
            {skin, dough_high_v, 1},
            {around, even_stations(bands), true},
            [&](double turn, double along) { return at(turn, along, 1); });
  if (!has_word(product, "sugar|plain|cinnamon|bagel")) {
    const double drip_turn = draw.uniform();
    constexpr int glaze_bands = 16;
    add_shell(pack,
              {skin, 0, glaze_low_v},
              {around, even_stations(glaze_bands), true},
              [&](double turn, double along) {
                // Out along the upper side, back beneath it; the outer rim runs down in drops.
                const double drop = 0.018 * unit_circle(5 * turn + drip_turn).x +
                                    0.012 * unit_circle(8 * turn - drip_turn).x;
                const double low = 0.27 + drop, high = 0.70 + 0.4 * drop;
                const bool outside = along < 0.75;
                const double share = outside ? along / 0.75 : (1 - along) / 0.25;
                const double edge = 4 * share * (1 - share);
                const float swell =
                    outside
                        ? 1 + glaze_thick * static_cast<float>(0.35 + 0.65 * (edge < 1 ? edge : 1))
                        : 1 - glaze_thick;
                return at(turn, low + (high - low) * share, swell);
              });
  }
  return pack.finish(0.2F);
}

CollisionPrimitive collision_donut(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
