#include <algorithm>

#include "assets/contents.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/profile.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {

// Glass is slender with a long neck and a small cap, squeeze plastic has round shoulders under a
// wide flip cap.
Result<ProductModel> make_sauce_bottle(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const bool glass = product.material == "glass";
  MARKETGEN_TRY(const Surface wall,
                contents_wall(product,
                              glass ? glass_roughness : plastic_wall_roughness,
                              clear_plastic(colors.primary)));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t bottle = pack.add_surface(wall);
  const std::uint16_t print = pack.add_print(gloss_paper_roughness);
  const std::uint16_t cap = pack.add_surface(plastic(colors.accent));
  const float h = pack.height();

  Profile profile(pack, zone.roundness);
  const float r = profile.min_half();
  const float cap_radius = glass ? std::min(0.016F, 0.55F * r) : std::min(0.022F, 0.68F * r);
  const float cap_low = h - (glass ? 0.10F : 0.15F) * h;
  const float shoulder = zone.high_m + 0.03F * h;
  profile.use(bottle).pole(0.015F * h).body(0, 0.82F).curve_to_body(Curve::swell, 0.04F * h, 1, 3);
  profile.body(zone.low_m, 1).use(print).body(zone.high_m, 1).use(bottle).body(shoulder, 1);
  if (glass) {
    profile.curve_to_neck(
        Curve::slope, shoulder + 0.6F * (cap_low - shoulder), 0.92F * cap_radius, 5);
  } else {
    profile.curve_to_body(Curve::dome, cap_low - 0.01F * h, 0.55F, 5);
  }
  profile.neck(cap_low, 0.88F * cap_radius).use(cap).neck(cap_low, cap_radius);
  profile.neck(h - 0.02F * h, (glass ? 0.98F : 0.84F) * cap_radius)
      .neck(h, (glass ? 0.88F : 0.74F) * cap_radius)
      .pole(h);
  add_loft(pack, profile.sections());
  if (glass) {
    pack.add_band_feature(FeatureKind::neck, shoulder + 0.6F * (cap_low - shoulder), cap_low);
  }
  pack.add_surface_feature(FeatureKind::cap, cap);
  return pack.finish();
}

CollisionPrimitive collision_sauce_bottle(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
