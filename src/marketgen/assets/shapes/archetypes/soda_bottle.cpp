#include <algorithm>

#include "assets/contents.h"
#include "assets/shapes/archetypes/bottle_parts.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {

// Caps follow the PCO 1881 finish: 28 mm thread, about 30 mm over the cap, 33 mm over the support
// ring.
Result<ProductModel> make_soda_bottle(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  MARKETGEN_TRY(const Surface wall,
                contents_wall(product, plastic_wall_roughness, clear_plastic(colors.primary)));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t bottle = pack.add_surface(wall);
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t cap = pack.add_surface(plastic(colors.accent));
  const float h = pack.height();

  Profile profile(pack, zone.roundness);
  const float cap_radius = std::min(0.015F, 0.50F * profile.min_half());
  const float neck_low = h - std::min(0.032F, 0.15F * h), above = zone.high_m + 0.015F * h;
  profile.use(bottle)
      .pole(0.03F * h)
      .wavy_body(0, 0.56F, 0.16F)
      .wavy_body(0.015F * h, 0.76F, 0.13F);
  profile.wavy_body(0.055F * h, 0.90F, 0.08F).wavy_body(0.11F * h, 0.97F, 0.03F).body(0.16F * h, 1);
  profile.body(zone.low_m - 0.012F * h, 1).body(zone.low_m, 0.975F);
  profile.use(print).body(zone.high_m, 0.975F);
  profile.use(bottle).body(above, 1).curve_to_neck(Curve::slope, neck_low, 0.86F * cap_radius, 6);
  add_screw_cap(profile, neck_low, h, cap_radius, bottle, cap);
  add_loft(pack, profile.sections(), {.lobes = 5});
  pack.add_band_feature(FeatureKind::cap, cap_low_of(neck_low, h), h);
  pack.add_band_feature(FeatureKind::neck, neck_low, cap_low_of(neck_low, h));
  return pack.finish(0.4F);
}

CollisionPrimitive collision_soda_bottle(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
