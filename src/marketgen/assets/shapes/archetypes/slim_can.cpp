#include "assets/shapes/archetypes/can_parts.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {

// After the 250 ml slim can: 53 mm body, 50 mm end, foot ring 45 mm.
Result<ProductModel> make_slim_can(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t metal = pack.add_surface(aluminium());
  const std::uint16_t print = pack.add_print(lacquer_roughness);
  const float h = pack.height();

  Profile profile(pack, zone.roundness);
  profile.use(metal).pole(0.04F * h).body(0.028F * h, 0.50F).body(0, 0.80F);
  profile.body(0.003F * h, 0.85F).curve_to_body(Curve::swell, zone.low_m, 1, 5);
  return finish_can(pack, profile, {metal, print, zone.high_m, 0.885F}, smooth_style);
}

CollisionPrimitive collision_slim_can(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
