#include "assets/shapes/archetypes/film_bag.h"

namespace marketgen::assets {

void add_bag(PackBuilder& pack,
             std::uint16_t front_and_back,
             std::uint16_t edges,
             const BagForm& form,
             const Placement& place) {
  const float half = form.size.y / 2 - seal_half_thickness_m;
  const auto shape = [&](Vec3f share) {
    const float x = 2 * share.x - 1;
    const float blown = form.thickness(x, share.z), middle = form.thickness(0, share.z);
    const float y = seal_half_thickness_m + half * blown;
    return Vec3f{x * form.size.x / 2 * (1 - form.waist * middle),
                 share.y < 0.5F ? -y : y,
                 share.z * form.size.z};
  };
  add_panel_box(pack,
                {form.across, {0, 1}, form.up},
                {front_and_back, edges, front_and_back, edges, edges, edges},
                shape,
                place);
}

}  // namespace marketgen::assets
