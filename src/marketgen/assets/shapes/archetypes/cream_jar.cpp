#include <algorithm>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/profile.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {

// Face cream, balm, hair wax: a low jar with a lid of its own width.
Result<ProductModel> make_cream_jar(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t body = pack.add_surface(plastic(colors.primary));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t lid = pack.add_surface(plastic(colors.accent));
  const float h = pack.height(), wall = 0.97F;
  const float lid_low = zone.high_m + std::min(0.0012F, 0.06F * (h - zone.high_m));
  const float round = std::min(0.0030F, 0.14F * (h - lid_low));

  Profile profile(pack, zone.roundness);
  profile.use(body).pole(0.3F * zone.low_m).body(0.3F * zone.low_m, 0.70F).body(0, 0.76F);
  profile.curve_to_body(Curve::swell, zone.low_m, wall, 5);
  profile.use(print)
      .body(zone.high_m, wall)
      .use(body)
      .body(zone.high_m, 0.93F)
      .body(lid_low, 0.93F);
  profile.use(lid).body(lid_low, 0.988F).body(lid_low + 0.25F * round, 1);
  profile.body(h - round, 1).curve_to_body(Curve::dome, h, 0.94F, 4);
  profile.body(h, zone.lid_share + 0.01F).body(h - 0.0004F, zone.lid_share).use(print);
  add_loft(pack, profile.sections(), smooth_style);
  pack.add_surface_feature(FeatureKind::lid, lid);
  return pack.finish();
}

CollisionPrimitive collision_cream_jar(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
