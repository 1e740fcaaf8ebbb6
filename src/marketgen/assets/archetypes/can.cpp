#include "assets/archetypes/collision.h"
#include "assets/archetypes/label_zone.h"
#include "assets/archetypes/panel_box.h"
#include "assets/archetypes/profile.h"
#include "assets/archetypes/registry.h"
#include "assets/archetypes/surfaces.h"

namespace marketgen {

// Drawn after a 330 ml can: foot ring 48 mm of 66 mm, neck 54 mm, lid a little below the rim.
Result<ProductModel> make_can(const Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t metal = pack.add_surface(aluminium());
  const std::uint16_t print = pack.add_print(lacquer_roughness);
  const float h = pack.height(), lid = 0.975F * h;

  Profile profile(pack, zone.roundness);
  // The dome pressed in from below, the foot ring, the wall.
  profile.use(metal).pole(0.045F * h).body(0.03F * h, 0.45F).body(0, 0.72F);
  profile.body(0.004F * h, 0.78F).curve_to_body(Curve::swell, zone.low_m, 1, 4);
  profile.use(print).body(zone.high_m, 1);
  // The neck, the rolled rim, the lid.
  profile.use(metal).curve_to_body(Curve::slope, h - 0.022F * h, 0.82F, 5);
  profile.body(h - 0.016F * h, 0.855F)
      .body(h - 0.004F * h, 0.855F)
      .body(h, 0.84F)
      .body(h - 0.004F * h, 0.82F);
  profile.body(lid, 0.795F).body(lid + 0.001F, 0.72F).pole(lid + 0.001F);
  add_loft(pack, profile.sections(), {.triangles = pack_triangles - plain_box_triangles});

  const float r = profile.least_half();
  add_plain_box(pack,
                {0.36F * r, 0.62F * r, 0.0012F},
                0.0005F,
                metal,
                PartFrame{.origin = {0, -0.12F * r, lid + 0.0008F}});  // the tab
  return pack.finish();
}

CollisionPrimitive collision_can(const Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen
