#include <algorithm>

#include "assets/contents.h"
#include "assets/shapes/archetypes/bottle_parts.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr float rib_depth_share = 0.035F;  // of the radius

// `ribs` grooves between two heights, the wall full at both ends.
void add_ribs(Profile& profile, float low, float high, int ribs) {
  const float pitch = (high - low) / static_cast<float>(ribs);
  profile.body(low, 1);
  for (int i = 0; i < ribs; ++i) {
    const float z = low + static_cast<float>(i) * pitch;
    profile.body(z + 0.5F * pitch, 1 - rib_depth_share).body(z + pitch, 1);
  }
}

}  // namespace

Result<ProductModel> make_water_bottle(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  MARKETGEN_TRY(const Surface wall,
                contents_wall(product, plastic_wall_roughness, clear_plastic(colors.primary)));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t bottle = pack.add_surface(wall);
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t cap = pack.add_surface(plastic(colors.accent));
  const float h = pack.height();

  Profile profile(pack, zone.roundness);
  const float cap_radius = std::min(0.015F, 0.50F * profile.min_half());
  const float neck_low = h - std::min(0.030F, 0.14F * h), shoulder = zone.high_m + 0.12F * h;
  profile.use(bottle).pole(0.02F * h).body(0, 0.70F).curve_to_body(Curve::swell, 0.05F * h, 1, 2);
  add_ribs(profile, 0.09F * h, zone.low_m - 0.02F * h, 3);
  profile.body(zone.low_m, 0.965F).use(print).body(zone.high_m, 0.965F).use(bottle);
  add_ribs(profile, zone.high_m + 0.02F * h, shoulder, 1);
  profile.curve_to_neck(Curve::dome, neck_low - 0.03F * h, 1.1F * cap_radius, 3);
  add_screw_cap(profile, neck_low, h, cap_radius, bottle, cap);
  add_loft(pack, profile.sections());
  pack.add_band_feature(FeatureKind::cap, cap_low_of(neck_low, h), h);
  pack.add_band_feature(FeatureKind::neck, neck_low, cap_low_of(neck_low, h));
  return pack.finish(0.4F);
}

CollisionPrimitive collision_water_bottle(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
