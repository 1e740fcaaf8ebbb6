#include <algorithm>

#include "assets/contents.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/profile.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {

// Gin, whisky, vodka: thick clear glass, a shoulder that turns at once, a short neck under a long
// cap.
Result<ProductModel> make_spirit_bottle(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  MARKETGEN_TRY(const Surface wall, contents_wall(product, glass_roughness, dark_glass()));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t glass = pack.add_surface(wall);
  const std::uint16_t print = pack.add_print(matt_paper_roughness);
  const std::uint16_t cap = pack.add_surface(lacquered_metal(colors.accent));
  const float h = pack.height();

  Profile profile(pack, zone.roundness);
  const float r = profile.min_half(), neck = std::min(0.0145F, 0.40F * r);
  const float shoulder = 0.635F * h, cap_low = 0.775F * h;
  profile.use(glass).pole(0.05F * h).body(0.02F * h, 0.6F).body(0, 0.88F);
  profile.curve_to_body(Curve::swell, 0.022F * h, 1, 4).body(zone.low_m, 1);
  profile.use(print).body(zone.high_m, 1).use(glass).body(shoulder - 0.05F * h, 1);
  profile.curve_to_body(Curve::dome, shoulder, 0.72F, 6);
  profile.curve_to_neck(Curve::swell, 0.715F * h, neck, 5).neck(cap_low - 0.012F * h, neck);
  profile.neck(cap_low - 0.010F * h, 1.12F * neck).neck(cap_low - 0.003F * h, 1.12F * neck);
  profile.neck(cap_low, neck).use(cap).neck(cap_low, 1.16F * neck);
  profile.neck(cap_low + 0.035F * h, 1.16F * neck).neck(cap_low + 0.037F * h, 1.11F * neck);
  profile.neck(cap_low + 0.041F * h, 1.11F * neck).neck(cap_low + 0.043F * h, 1.16F * neck);
  profile.neck(h - 0.006F * h, 1.16F * neck).neck(h - 0.001F * h, 1.10F * neck);
  profile.neck(h, 0.98F * neck).pole(h);
  add_loft(pack, profile.sections(), smooth_style);
  pack.add_band_feature(FeatureKind::neck, 0.715F * h, cap_low);
  pack.add_surface_feature(FeatureKind::cap, cap);
  return pack.finish();
}

CollisionPrimitive collision_spirit_bottle(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
