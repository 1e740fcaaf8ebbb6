#include <algorithm>

#include "assets/archetypes/collision.h"
#include "assets/archetypes/label_zone.h"
#include "assets/archetypes/panel_box.h"
#include "assets/archetypes/profile.h"
#include "assets/archetypes/registry.h"
#include "assets/archetypes/surfaces.h"

namespace marketgen {
namespace {

constexpr float tin_body_share = 0.985F;    // the seams stand out by 0.6 mm on a 75 mm tin
constexpr float tin_bead_depth = 0.010F;    // share of the radius
constexpr float tin_bead_pitch_m = 0.009F;  // one bead a pitch, over the middle of the wall
constexpr float beaded_from_m = 0.07F;      // lower tins are stiff without beads

// The wall under its paper label: straight, with beads over the middle half of tall tins.
void add_tin_wall(Profile& profile, const LabelZone& zone) {
  const float span = zone.high_m - zone.low_m;
  const int beads =
      span < beaded_from_m ? 0 : std::min(4, static_cast<int>(0.5F * span / tin_bead_pitch_m));
  const float first =
      zone.low_m + 0.5F * span - 0.5F * static_cast<float>(beads) * tin_bead_pitch_m;
  for (int i = 0; i < beads; ++i) {
    const float z = first + static_cast<float>(i) * tin_bead_pitch_m;
    profile.body(z, tin_body_share);
    profile.body(z + 0.5F * tin_bead_pitch_m, tin_body_share - tin_bead_depth);
  }
  if (beads > 0) profile.body(first + static_cast<float>(beads) * tin_bead_pitch_m, tin_body_share);
  profile.body(zone.high_m, tin_body_share);
}

}  // namespace

Result<ProductModel> make_food_tin(const Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t metal = pack.add_surface(tinplate());
  const std::uint16_t print = pack.add_print(gloss_paper_roughness);
  const float h = pack.height(), seam = 0.75F * zone.low_m, recess = h - 0.7F * seam;

  Profile profile(pack, zone.roundness);
  profile.use(metal)
      .pole(0.5F * seam)
      .body(0.5F * seam, 0.94F)
      .body(0, 0.97F)
      .body(0.15F * seam, 1)
      .body(seam, 1)
      .body(zone.low_m, tin_body_share);
  profile.use(print);
  add_tin_wall(profile, zone);
  profile.use(metal)
      .body(h - seam, 1)
      .body(h - 0.15F * seam, 1)
      .body(h, 0.97F)
      .body(h - 0.1F * seam, 0.94F);
  profile.body(recess, 0.92F)
      .body(recess, 0.80F)
      .body(recess + 0.2F * seam, 0.77F)
      .pole(recess + 0.2F * seam);
  add_loft(pack, profile.sections(), {.triangles = pack_triangles - plain_box_triangles});

  const float r = profile.least_half();
  add_plain_box(pack,
                {0.34F * r, 0.70F * r, 0.5F * seam},
                0.2F * seam,
                metal,
                PartFrame{.origin = {0, -0.40F * r, recess + 0.1F * seam}});  // the ring pull
  return pack.finish();
}

CollisionPrimitive collision_food_tin(const Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen
