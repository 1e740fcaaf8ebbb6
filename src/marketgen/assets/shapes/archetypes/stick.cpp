#include "assets/shapes/archetypes/bottle_parts.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {

// Deodorant stick or roll-on: an oval sleeve on its dial, under a tall domed cap.
Result<ProductModel> make_stick(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t body = pack.add_surface(plastic(colors.primary));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t cap = pack.add_surface(plastic(colors.accent));
  const float h = pack.height(), above = h - zone.high_m;
  const float dial = 0.40F * zone.low_m, cap_low = zone.high_m + 0.14F * above;
  const float line = 0.012F * above;

  Profile profile(pack, zone.roundness);
  profile.use(cap).pole(0.002F * h).body(0.002F * h, 0.78F).body(0, 0.84F);
  profile.body(0.15F * dial, 0.90F).body(0.85F * dial, 0.90F).body(dial, 0.87F);
  profile.use(body).body(dial, 0.955F).curve_to_body(Curve::swell, 1.25F * dial, 1, 3);
  profile.body(zone.low_m, 1).use(print).body(zone.high_m, 1).use(body);
  profile.body(cap_low - line, 1).body(cap_low, 0.985F).use(cap).body(cap_low, 0.975F);
  profile.body(cap_low + line, 0.99F).body(h - 0.42F * above, 0.975F);
  profile.curve_to_body(Curve::dome, h, 0.45F, 9).pole(h);
  add_loft(pack, profile.sections(), labelled_style(zone, body));
  pack.add_band_feature(FeatureKind::cap, cap_low, h);
  return pack.finish();
}

CollisionPrimitive collision_stick(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
