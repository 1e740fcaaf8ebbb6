#include "assets/contents.h"
#include "assets/print/color.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/profile.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr std::string_view amber_glass = "#3a1c08";

}  // namespace

// After the long-neck bottle: 61 mm by 230 mm, 26 mm neck under a 32 mm crown cork.
Result<ProductModel> make_beer_bottle(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  MARKETGEN_TRY(const Vec3f amber, linear_from_hex(amber_glass));
  const LabelZone zone = label_zone_of(product);
  MARKETGEN_TRY(
      const Surface wall,
      contents_wall(product, glass_roughness, {.color = amber, .roughness = glass_roughness}));
  const std::uint16_t glass = pack.add_surface(wall);
  const std::uint16_t print = pack.add_print(gloss_paper_roughness);
  const std::uint16_t foil = pack.add_surface(lacquered_metal(colors.secondary));
  const std::uint16_t crown = pack.add_surface(lacquered_metal(colors.accent));
  const float h = pack.height();

  Profile profile(pack, zone.roundness);
  const float neck = 0.44F * profile.min_half();
  profile.use(glass).pole(0.02F * h).body(0, 0.84F).curve_to_body(Curve::swell, 0.025F * h, 1, 3);
  profile.body(zone.low_m, 1).use(print).body(zone.high_m, 1).use(glass).body(0.52F * h, 1);
  profile.curve_to_neck(Curve::slope, 0.74F * h, 1.06F * neck, 6);
  profile.use(foil).neck(0.90F * h, 0.94F * neck).use(glass).neck(0.93F * h, 0.92F * neck);
  profile.neck(0.935F * h, 1.05F * neck).neck(0.967F * h, 1.05F * neck);
  profile.use(crown).neck(0.967F * h, 1.24F * neck).neck(0.985F * h, 1.14F * neck);
  profile.neck(0.997F * h, 1.0F * neck).neck(h, 0.85F * neck).pole(h);
  add_loft(pack, profile.sections());
  pack.add_surface_feature(FeatureKind::cap, crown);
  pack.add_band_feature(FeatureKind::neck, 0.74F * h, 0.967F * h);
  return pack.finish();
}

CollisionPrimitive collision_beer_bottle(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
