#include <algorithm>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/profile.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"
#include "assets/shapes/archetypes/tin_parts.h"

namespace marketgen::assets {
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

Result<ProductModel> make_food_tin(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t metal = pack.add_surface(tinplate());
  const std::uint16_t print = pack.add_print(gloss_paper_roughness);
  const float h = pack.height(), seam = 0.75F * zone.low_m;

  Profile profile(pack, zone.roundness);
  add_tin_foot(profile, seam, zone.low_m, tin_body_share, metal);
  profile.use(print);
  add_tin_wall(profile, zone);
  const float lid = add_tin_lid(profile, h, seam, 0.77F, metal);
  profile.pole(lid);
  add_loft(pack, profile.sections(), {.triangles = 2400, .max_chords = smooth_style.max_chords});
  const std::size_t tab = pack.triangle_count();
  add_ring_pull(pack, lid, 0.77F * profile.min_half(), metal);
  pack.add_part_feature(FeatureKind::tab, tab);
  pack.add_band_feature(FeatureKind::rim, h - seam, h);
  return pack.finish();
}

CollisionPrimitive collision_food_tin(const catalog::Product& product) {
  return cylinder_around(product);
}

}  // namespace marketgen::assets
