#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/profile.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {

// Yoghurt cups, ice cream tubs, margarine: the wall tapers by a tenth so that empty ones nest; the
// lid overlaps the rim.
Result<ProductModel> make_tub(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t body = pack.add_surface(plastic(colors.secondary));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t lid = pack.add_surface(plastic(colors.primary));
  const float h = pack.height(), lid_low = zone.high_m + 0.35F * (h - zone.high_m),
              step = 0.12F * (h - lid_low);

  Profile profile(pack, zone.roundness);
  profile.use(body).pole(0.4F * zone.low_m).body(0.4F * zone.low_m, 0.78F).body(0, 0.80F);
  profile.body(0.15F * zone.low_m, 0.84F).body(zone.low_m, 0.86F);
  profile.use(print).body(zone.high_m, 0.955F).use(body).body(lid_low, 0.96F);
  profile.use(lid)
      .body(lid_low, 0.99F)
      .body(lid_low + step, 1)
      .body(h - 2 * step, 1)
      .body(h - step, 0.99F);
  profile.body(h, 0.96F).body(h - step, 0.92F).body(h - 2 * step, 0.90F).use(print);
  add_loft(pack, profile.sections());
  pack.add_surface_feature(FeatureKind::lid, lid);
  return pack.finish();
}

CollisionPrimitive collision_tub(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
