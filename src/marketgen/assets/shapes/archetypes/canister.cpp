#include <algorithm>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/profile.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {

// Crisps, gravy, cocoa: a spiral-wound paper tube with a seamed metal foot and a snap-on lid.
Result<ProductModel> make_canister(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t metal = pack.add_surface(tinplate());
  const std::uint16_t print = pack.add_print(gloss_paper_roughness);
  const std::uint16_t lid = pack.add_surface(plastic(colors.accent));
  const float h = pack.height(), foot = zone.low_m, skirt = zone.high_m + 0.12F * (h - zone.high_m);
  const float step = std::min(0.0012F, 0.08F * (h - skirt));

  Profile profile(pack, zone.roundness);
  const float wall = 0.975F;
  profile.use(metal).pole(0.8F * foot).body(0.8F * foot, 0.90F).body(0, 0.945F);
  profile.body(0.12F * foot, 0.985F).body(0.75F * foot, 0.985F).body(foot, wall);
  profile.use(print).body(zone.high_m, wall);
  profile.use(metal).body(skirt, wall);
  profile.use(lid).body(skirt, 0.99F).body(skirt + step, 1).body(skirt + 3 * step, 1);
  profile.body(skirt + 4 * step, 0.988F).body(h - 2 * step, 0.982F).body(h - 0.6F * step, 0.972F);
  profile.body(h, 0.945F).body(h - 0.5F * step, 0.915F).body(h - 2 * step, 0.89F);
  profile.body(h - 2 * step, 0.62F).body(h - 1.2F * step, 0.60F).pole(h - 1.2F * step);
  add_loft(pack, profile.sections(), smooth_style);
  pack.add_surface_feature(FeatureKind::lid, lid);
  return pack.finish();
}

CollisionPrimitive collision_canister(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
