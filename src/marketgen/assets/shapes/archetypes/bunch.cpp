#include "assets/shapes/archetypes/bunch.h"

#include <algorithm>

#include "assets/shapes/archetypes/loft.h"
#include "geometry/circle.h"

namespace marketgen::assets {

void add_rubber_band(
    PackBuilder& pack, Vec3f color, float z, Vec2f half, float thick, const Placement& place) {
  const std::uint16_t rubber = pack.add_surface({.color = color, .roughness = 0.6F});
  const ShellPoint ring = [&](double turn, double along) {
    const Vec2 around = unit_circle(turn);
    const Vec2 section = unit_circle(along - 0.25);
    const float out = 1 + 0.02F * static_cast<float>(section.x);
    return place({half.x * out * static_cast<float>(around.x),
                  half.y * out * static_cast<float>(around.y),
                  z + thick * static_cast<float>(section.y)});
  };
  constexpr int around = 28, bands = 8;
  add_shell(pack, {rubber}, {around, even_stations(bands), true}, ring);
}

void add_punnet(PackBuilder& pack, std::uint16_t surface, float height) {
  constexpr float usual_wall_m = 0.0015F, usual_rim_m = 0.004F;
  constexpr float widest_rim = 0.06F;  // of the lesser side, for toy punnets
  constexpr float foot_share = 0.86F;  // of the rim's width: punnets nest
  const float w = pack.width() / 2, d = pack.depth() / 2;
  const float rim_m = std::min(usual_rim_m, 2 * widest_rim * std::min(w, d));
  const float wall_m = usual_wall_m * rim_m / usual_rim_m;
  const auto section = [&](float z, float share, float inset) {
    return Section{.z = z,
                   .half_width = w * share - inset,
                   .half_depth = d * share - inset,
                   .surface = surface,
                   .roundness = 0.22F};
  };
  const float inner = rim_m + wall_m;
  add_loft(pack,
           {section(0, foot_share - 0.03F, 0),
            section(0.02F * height, foot_share, 0),
            section(0.9F * height, 0.985F, rim_m),
            section(0.91F * height, 1, 0),
            section(height, 1, 0),
            section(height, 0.99F, inner),
            section(0.1F * height, foot_share, inner)},
           {.triangles = 900});
}

}  // namespace marketgen::assets
