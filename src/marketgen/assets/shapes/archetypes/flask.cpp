#include <algorithm>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/profile.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {

Result<ProductModel> make_flask(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t body = pack.add_surface(plastic(colors.primary));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t cap = pack.add_surface(plastic(colors.accent));
  const float h = pack.height();

  Profile profile(pack, zone.roundness);
  const float cap_radius = std::min(0.020F, 0.72F * profile.min_half());
  const float cap_low = h - std::min(0.034F, 0.16F * h);
  profile.use(body).pole(0.01F * h).body(0, 0.86F).curve_to_body(
      Curve::swell, 0.035F * h, 0.97F, 3);
  profile.body(zone.low_m, 1)
      .use(print)
      .body(0.5F * (zone.low_m + zone.high_m), 1)
      .body(zone.high_m, 1);
  profile.use(body).curve_to_body(Curve::dome, cap_low - 0.025F * h, 0.50F, 5);
  profile.neck(cap_low - 0.015F * h, 0.9F * cap_radius).neck(cap_low, 0.9F * cap_radius);
  profile.use(cap).neck(cap_low, cap_radius).neck(h - 0.012F * h, 0.97F * cap_radius);
  profile.neck(h, 0.86F * cap_radius).pole(h);
  add_loft(pack, profile.sections());
  pack.add_surface_feature(FeatureKind::cap, cap);
  return pack.finish();
}

CollisionPrimitive collision_flask(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
