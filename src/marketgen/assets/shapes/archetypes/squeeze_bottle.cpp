#include <algorithm>

#include "assets/contents.h"
#include "assets/shapes/archetypes/bottle_parts.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {

// Ketchup, mayonnaise, honey: an oval bottle head down on its flip cap, so that what is left runs
// to the nozzle.
Result<ProductModel> make_squeeze_bottle(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  MARKETGEN_TRY(const Surface wall,
                contents_wall(product, plastic_wall_roughness, clear_plastic(colors.primary)));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t bottle = pack.add_surface(wall);
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t cap = pack.add_surface(plastic(colors.accent));
  const float h = pack.height(), cap_high = std::min(0.030F, 0.55F * zone.low_m);
  const float hinge = 0.62F * cap_high, groove = 0.02F * cap_high;

  Profile profile(pack, zone.roundness);
  profile.use(cap).pole(0.001F).body(0.001F, 0.78F).body(0, 0.83F);
  profile.curve_to_body(Curve::swell, 0.18F * cap_high, 0.93F, 4);
  // The lid closes on the base with a fine groove.
  profile.body(hinge - groove, 0.935F).body(hinge, 0.915F).body(hinge + groove, 0.935F);
  profile.body(0.90F * cap_high, 0.93F).curve_to_body(Curve::dome, cap_high, 0.89F, 3);
  profile.use(bottle).body(cap_high, 0.84F).body(1.03F * cap_high, 0.84F);
  profile.curve_to_body(Curve::slope, zone.low_m, 1, 7);
  profile.use(print).body(zone.high_m, 1).use(bottle);
  profile.body(zone.high_m + 0.25F * (h - zone.high_m), 0.995F);
  profile.curve_to_body(Curve::dome, h, 0.62F, 8).body(h - 0.006F * h, 0.50F).pole(h - 0.012F * h);
  add_loft(pack, profile.sections(), labelled_style(zone, bottle));
  pack.add_surface_feature(FeatureKind::cap, cap);
  return pack.finish();
}

CollisionPrimitive collision_squeeze_bottle(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
