#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/profile.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {

// A drawn aluminium can with a domed shoulder; the cap covers valve and spray head.
Result<ProductModel> make_aerosol(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t metal = pack.add_surface(aluminium());
  const std::uint16_t print = pack.add_print(lacquer_roughness);
  const std::uint16_t cap = pack.add_surface(plastic(colors.accent));
  const float h = pack.height(), above = h - zone.high_m, foot = zone.low_m;

  Profile profile(pack, zone.roundness);
  const float wall = 0.98F, cap_low = zone.high_m + 0.16F * above;
  profile.use(metal).pole(0.9F * foot).body(0.7F * foot, 0.5F).body(0, 0.92F);
  profile.body(0.1F * foot, 0.985F).body(0.55F * foot, 1).body(0.8F * foot, 0.995F);
  profile.body(foot, wall).use(print).body(zone.high_m, wall);
  profile.use(metal).curve_to_body(Curve::dome, cap_low, 0.86F, 4);
  profile.use(cap).body(cap_low, 0.90F).body(cap_low + 0.02F * above, 0.915F);
  profile.body(h - 0.20F * above, 0.905F).curve_to_body(Curve::dome, h, 0.55F, 7).pole(h);
  add_loft(pack, profile.sections(), smooth_style);
  pack.add_surface_feature(FeatureKind::cap, cap);
  return pack.finish();
}

CollisionPrimitive collision_aerosol(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
