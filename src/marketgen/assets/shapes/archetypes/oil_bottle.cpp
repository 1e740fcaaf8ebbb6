#include <algorithm>

#include "assets/contents.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/profile.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {

// After the Dorica bottle for olive oil and vinegar: slender, a long shoulder, an aluminium cap
// over the pourer.
Result<ProductModel> make_oil_bottle(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  // Olive oil is kept from light.
  MARKETGEN_TRY(const Surface wall, contents_wall(product, glass_roughness, dark_glass()));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t glass = pack.add_surface(wall);
  const std::uint16_t print = pack.add_print(matt_paper_roughness);
  const std::uint16_t cap = pack.add_surface(lacquered_metal(colors.accent));
  const float h = pack.height();

  Profile profile(pack, zone.roundness);
  const float r = profile.min_half(), neck = std::min(0.0135F, 0.42F * r);
  const float cap_low = h - std::min(0.048F, 0.17F * h), span = h - cap_low;
  profile.use(glass).pole(0.05F * h).body(0.02F * h, 0.55F).body(0, 0.86F);
  profile.curve_to_body(Curve::swell, 0.022F * h, 0.99F, 4).body(zone.low_m, 1);
  profile.use(print).body(zone.high_m, 1).use(glass).body(0.545F * h, 1);
  profile.curve_to_body(Curve::dome, 0.63F * h, 0.66F, 6);
  profile.curve_to_neck(Curve::swell, 0.745F * h, neck, 6).neck(cap_low - 0.02F * h, neck);
  profile.neck(cap_low - 0.015F * h, 1.14F * neck).neck(cap_low - 0.004F * h, 1.14F * neck);
  profile.neck(cap_low, neck);
  // The skirt, the break-off ring, the knurled cap.
  profile.use(cap).neck(cap_low, 1.13F * neck).neck(cap_low + 0.42F * span, 1.13F * neck);
  profile.neck(cap_low + 0.44F * span, 1.07F * neck).neck(cap_low + 0.47F * span, 1.07F * neck);
  profile.neck(cap_low + 0.49F * span, 1.15F * neck).neck(h - 0.06F * span, 1.15F * neck);
  profile.neck(h - 0.01F * span, 1.09F * neck).neck(h, 0.97F * neck).pole(h);
  add_loft(pack, profile.sections(), smooth_style);
  pack.add_band_feature(FeatureKind::neck, 0.745F * h, cap_low);
  pack.add_surface_feature(FeatureKind::cap, cap);
  return pack.finish();
}

CollisionPrimitive collision_oil_bottle(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
