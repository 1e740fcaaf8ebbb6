#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"
#include "assets/shapes/archetypes/tin_parts.h"

namespace marketgen::assets {

// Tuna, pate, sweets: a drawn tin, printed on its wall and on its lid.
Result<ProductModel> make_flat_tin(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t metal = pack.add_surface(tinplate());
  const std::uint16_t print = pack.add_print(lacquer_roughness);
  const float h = pack.height(), seam = 0.75F * zone.low_m;

  Profile profile(pack, zone.roundness);
  // Drawn in one piece with its foot, so that it nests in the lid of the tin below.
  profile.use(metal).pole(0.6F * seam).body(0.6F * seam, 0.84F).body(0, 0.88F);
  profile.body(0.1F * seam, 0.92F).curve_to_body(Curve::swell, zone.low_m, 0.985F, 4);
  profile.use(print).body(zone.high_m, 0.985F);
  const float lid = add_tin_lid(profile, h, seam, zone.lid_share, metal);
  profile.use(print);
  add_loft(pack, profile.sections(), smooth_style);
  const std::size_t tab = pack.triangle_count();
  add_ring_pull(pack, lid, zone.lid_share * profile.min_half(), metal);
  pack.add_part_feature(FeatureKind::tab, tab);
  pack.add_band_feature(FeatureKind::rim, h - seam, h);
  return pack.finish();
}

CollisionPrimitive collision_flat_tin(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
