#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/profile.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {

// Cookies, tea, sweets: a printed body under a slip lid whose rolled skirt stands out by a wall's
// thickness.
Result<ProductModel> make_round_tin(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t metal = pack.add_surface(tinplate());
  const std::uint16_t print = pack.add_print(lacquer_roughness);
  const std::uint16_t lid = pack.add_surface(lacquered_metal(colors.primary));
  const float h = pack.height(), roll = 0.035F * (h - zone.high_m) + 0.0006F;

  Profile profile(pack, zone.roundness);
  const float wall = 0.985F;
  profile.use(metal).pole(zone.low_m).body(zone.low_m, 0.95F).body(0, 0.965F);
  profile.body(0.2F * zone.low_m, 0.982F).body(zone.low_m, wall);
  profile.use(print).body(zone.high_m, wall);
  // The skirt's rolled edge, the skirt, the shoulder, and the raised panel with the picture.
  profile.use(lid).body(zone.high_m, 0.993F).body(zone.high_m + 0.4F * roll, 1);
  profile.body(zone.high_m + 1.6F * roll, 1).body(zone.high_m + 2 * roll, 0.994F);
  profile.body(h - 0.004F - roll, 0.994F).curve_to_body(Curve::dome, h - 0.5F * roll, 0.965F, 4);
  profile.body(h - roll, zone.lid_share + 0.015F).body(h, zone.lid_share).use(print);
  add_loft(pack, profile.sections(), smooth_style);
  pack.add_surface_feature(FeatureKind::lid, lid);
  return pack.finish();
}

CollisionPrimitive collision_round_tin(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
