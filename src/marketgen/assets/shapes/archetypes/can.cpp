#include "assets/shapes/archetypes/can_parts.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/panel_box.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {

// Drawn after a 330 ml can: foot ring 48 mm of 66 mm, neck 54 mm, lid a little below the rim.
Result<ProductModel> make_can(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t metal = pack.add_surface(aluminium());
  const std::uint16_t print = pack.add_print(lacquer_roughness);
  const float h = pack.height();

  Profile profile(pack, zone.roundness);
  // The dome pressed in from below, the foot ring, the wall.
  profile.use(metal).pole(0.045F * h).body(0.03F * h, 0.45F).body(0, 0.72F);
  profile.body(0.004F * h, 0.78F).curve_to_body(Curve::swell, zone.low_m, 1, 4);
  return finish_can(pack,
                    profile,
                    {metal, print, zone.high_m, 0.82F},
                    {.triangles = pack_triangles - plain_box_triangles});
}

CollisionPrimitive collision_can(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
