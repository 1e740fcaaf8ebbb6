#include "assets/contents.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/profile.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
// After the Bordeaux bottle: 75 mm by 300 mm, straight to 0.6 of the height, shoulder to 0.7, 28 mm
// neck with a capsule.
Result<ProductModel> make_wine_bottle(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  // White and rose wine stand in light glass, which shows them: their rows say so.
  MARKETGEN_TRY(const Surface wall, contents_wall(product, glass_roughness, dark_glass()));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t glass = pack.add_surface(wall);
  const std::uint16_t print = pack.add_print(matt_paper_roughness);
  const std::uint16_t capsule = pack.add_surface(lacquered_metal(colors.accent));
  const float h = pack.height();

  Profile profile(pack, zone.roundness);
  const float neck = 0.38F * profile.min_half();
  profile.use(glass)
      .pole(0.06F * h)
      .body(0.03F * h, 0.5F)
      .body(0, 0.86F)
      .curve_to_body(Curve::swell, 0.02F * h, 1, 2);
  profile.body(zone.low_m, 1).use(print).body(zone.high_m, 1).use(glass).body(0.59F * h, 1);
  profile.curve_to_body(Curve::dome, 0.68F * h, 0.62F, 4)
      .curve_to_neck(Curve::swell, 0.76F * h, neck, 3);
  profile.use(capsule).neck(0.965F * h, 0.96F * neck).neck(0.968F * h, 1.08F * neck);
  profile.neck(0.995F * h, 1.06F * neck).neck(h, 0.95F * neck).pole(h);
  add_loft(pack, profile.sections());
  pack.add_surface_feature(FeatureKind::cap, capsule);
  pack.add_band_feature(FeatureKind::neck, 0.76F * h, h);
  return pack.finish();
}

CollisionPrimitive collision_wine_bottle(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
