#include "assets/archetypes/soft_pack.h"

namespace marketgen {

void add_bag(PackBuilder& pack,
             std::uint16_t front_and_back,
             std::uint16_t edges,
             const std::vector<float>& across,
             const std::vector<float>& up,
             float waist,
             const BagThickness& thickness) {
  const float half = pack.depth() / 2 - seal_half_thickness_m;
  const auto shape = [&](Vec3f share) {
    const float x = 2 * share.x - 1;
    const float blown = thickness(x, share.z), middle = thickness(0, share.z);
    const float y = seal_half_thickness_m + half * blown;
    return Vec3f{x * pack.width() / 2 * (1 - waist * middle),
                 share.y < 0.5F ? -y : y,
                 share.z * pack.height()};
  };
  add_panel_box(pack,
                {across, {0, 1}, up},
                {front_and_back, edges, front_and_back, edges, edges, edges},
                shape);
}

}  // namespace marketgen
