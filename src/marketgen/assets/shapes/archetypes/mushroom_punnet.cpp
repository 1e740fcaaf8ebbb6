#include <algorithm>

#include "assets/shapes/archetypes/body.h"
#include "assets/shapes/archetypes/bunch.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"
#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

// Stalk below, cap above, drawn in one line over the gills.
constexpr BodyForm mushroom_body{.outline = {{{0, 0},
                                              {0.34, 0.01},
                                              {0.4, 0.06},
                                              {0.36, 0.3},
                                              {0.5, 0.42},
                                              {0.86, 0.38},
                                              {0.98, 0.44},
                                              {1, 0.55},
                                              {0.9, 0.75},
                                              {0.62, 0.92},
                                              {0.3, 0.99},
                                              {0, 1}}},
                                 .lumps = 0.04,
                                 .lean = 0.05};
constexpr float tray_share = 0.6F;  // of the height

}  // namespace

Result<ProductModel> make_mushroom_punnet(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const Seed seed = growth_seed(product);
  Stream draw = seed.stream();
  const std::uint16_t skin = pack.add_print(0.75F);
  const std::uint16_t tray = pack.add_surface({.color = {0.03F, 0.10F, 0.30F}, .roughness = 0.35F});
  add_punnet(pack, tray, tray_share * pack.height());
  const float w = pack.width(), d = pack.depth();
  constexpr int columns = 4, rows = 3;
  const float size = std::min({0.5F * w / columns, 0.5F * d / rows, 0.42F * pack.height()});
  for (int i = 0; i < columns * rows; ++i) {
    const int column = i % columns, row = i / columns;
    const Vec3f middle{(static_cast<float>(column) - 0.5F * (columns - 1)) * 0.82F * w / columns,
                       (static_cast<float>(row) - 0.5F * (rows - 1)) * 0.82F * d / rows,
                       pack.height() - size * static_cast<float>(draw.uniform(0.85, 1.2))};
    // Caps look up and a little outwards; each is tilted its own way.
    const Vec2 tilt = unit_circle(draw.uniform());
    const auto steep = static_cast<float>(draw.uniform(0.1, 0.5));
    const Vec3f z = normalized(
        Vec3f{steep * static_cast<float>(tilt.x), steep * static_cast<float>(tilt.y), 1});
    const Vec3f x = normalized(cross({0, 1, 0.01F}, z));
    const float own = size * static_cast<float>(draw.uniform(0.88, 1.1));
    const PartFrame place{middle - z * (0.9F * own), x, cross(z, x), z};
    const GrownBody body(mushroom_body,
                         {own, own, 0.85F * own},
                         seed.child("cap", static_cast<std::uint64_t>(i)).stream());
    constexpr int segments = 20, bands = 16;
    add_shell(pack, {skin}, {segments, even_stations(bands)}, [&](double turn, double along) {
      return place(body.point(turn, along));
    });
  }
  return pack.finish(0.3F);
}

CollisionPrimitive collision_mushroom_punnet(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
