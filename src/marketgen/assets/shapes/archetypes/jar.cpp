#include <algorithm>

#include "assets/contents.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/profile.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {

// Lids follow the twist-off caps TO 63 to TO 82: 10 to 14 mm high, somewhat narrower than the jar.
Result<ProductModel> make_jar(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  MARKETGEN_TRY(const Surface wall,
                contents_wall(product, glass_roughness, clear_plastic(colors.primary)));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t glass = pack.add_surface(wall);
  const std::uint16_t print = pack.add_print(gloss_paper_roughness);
  const std::uint16_t lid = pack.add_surface(lacquered_metal(colors.accent));
  const float h = pack.height(), lid_low = h - std::min(0.013F, 0.16F * h);
  const float above = zone.high_m + 0.15F * (lid_low - zone.high_m);

  Profile profile(pack, zone.roundness);
  profile.use(glass).pole(0.02F * h).body(0, 0.80F).curve_to_body(
      Curve::swell, 0.7F * zone.low_m, 1, 4);
  profile.body(zone.low_m, 1).use(print).body(zone.high_m, 1).use(glass).body(above, 1);
  profile.curve_to_body(Curve::dome, above + 0.65F * (lid_low - above), 0.86F, 4)
      .body(lid_low, 0.85F);
  // The lid: rolled edge, skirt, and a panel that the vacuum draws in.
  profile.use(lid).body(lid_low, 0.93F).body(lid_low + 0.06F * (h - lid_low), 0.945F);
  profile.body(h - 0.3F * (h - lid_low), 0.945F)
      .body(h - 0.08F * (h - lid_low), 0.925F)
      .body(h, 0.88F);
  profile.body(h - 0.05F * (h - lid_low), 0.80F)
      .body(h - 0.10F * (h - lid_low), 0.76F)
      .pole(h - 0.10F * (h - lid_low));
  add_loft(pack, profile.sections());
  pack.add_surface_feature(FeatureKind::lid, lid);
  return pack.finish();
}

CollisionPrimitive collision_jar(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
