#include <algorithm>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/profile.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {

// A thermoformed cup: it widens to the rim under which the carton sleeve ends; the foil is sealed
// on the rim and stands out a little.
Result<ProductModel> make_yogurt_cup(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t cup = pack.add_surface(plastic(colors.secondary));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t foil = pack.add_surface(aluminium());
  const float h = pack.height(), rim = h - zone.high_m, thick = std::min(0.0012F, 0.25F * rim);

  Profile profile(pack, zone.roundness);
  profile.use(cup).pole(0.5F * zone.low_m).body(0.5F * zone.low_m, 0.60F).body(0, 0.64F);
  profile.curve_to_body(Curve::swell, 0.9F * zone.low_m, 0.735F, 4).body(zone.low_m, 0.745F);
  profile.use(print).body(zone.high_m, 0.915F).use(cup).body(zone.high_m + 0.15F * rim, 0.90F);
  profile.body(h - 2.2F * thick, 0.91F).body(h - 2 * thick, 0.985F).body(h - 0.5F * thick, 0.985F);
  profile.use(foil).body(h - 0.5F * thick, 1).body(h - 0.2F * thick, 1);
  profile.body(h, zone.lid_share).use(print);
  add_loft(pack, profile.sections(), smooth_style);
  pack.add_surface_feature(FeatureKind::lid, foil);
  return pack.finish();
}

CollisionPrimitive collision_yogurt_cup(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
