#include <algorithm>

#include "assets/shapes/archetypes/body.h"
#include "assets/shapes/archetypes/bunch.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/foliage.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"

namespace marketgen::assets {
namespace {

constexpr BodyForm berry_body{.outline = {{{0, 0},
                                           {0.2, 0.015},
                                           {0.55, 0.18},
                                           {0.9, 0.52},
                                           {1, 0.74},
                                           {0.85, 0.93},
                                           {0.45, 1},
                                           {0.15, 0.97},
                                           {0, 0.95}}},
                              .lobes = 3,
                              .lobe_low = 0.02,
                              .lobe_high = 0.08,
                              .lumps = 0.08};
constexpr float tray_share = 0.62F;  // of the height; the berries heap over it

// A berry that lies with its tip pointing along `tip`.
Placement lying_towards(Vec3f middle, Vec3f tip) {
  const Vec3f z = normalized(-tip);
  const Vec3f x = normalized(cross({0.2F, 0.3F, 1}, z));
  return PartFrame{middle, x, cross(z, x), z};
}

void add_berry(PackBuilder& pack,
               std::uint16_t skin,
               std::uint16_t green,
               const Placement& place,
               float size,
               const Seed& seed) {
  const GrownBody body(berry_body, {size, size, 1.15F * size}, seed.child("body").stream());
  constexpr int segments = 14, bands = 11;
  add_shell(pack, {skin}, {segments, even_stations(bands)}, [&](double turn, double along) {
    return place(body.point(turn, along) - Vec3f{0, 0, 1.15F * size});
  });
  add_calyx(pack,
            green,
            {.middle = body.top() - Vec3f{0, 0, 1.1F * size},
             .sepals = 5,
             .reach = 0.75F * size,
             .half_width = 0.2F * size,
             .drop = 0.15F * size,
             .stalk_length = 0.3F * size,
             .stalk_radius = 0.06F * size},
            seed.child("calyx").stream(),
            place);
}

}  // namespace

Result<ProductModel> make_strawberry_punnet(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const Seed seed = growth_seed(product);
  Stream draw = seed.stream();
  const std::uint16_t skin = pack.add_print(0.35F);
  const std::uint16_t green = pack.add_surface(plant(sepal_green));
  const std::uint16_t tray = pack.add_surface({.color = {0.62F, 0.66F, 0.66F}, .roughness = 0.25F});
  const float height = tray_share * pack.height();
  add_punnet(pack, tray, height);
  const float w = pack.width(), d = pack.depth();
  constexpr int columns = 4, rows = 3;
  const float size = std::min({0.44F * w / columns, 0.46F * d / rows, 0.34F * pack.height()});
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto i = static_cast<std::uint64_t>(row * columns + column);
      const float x = (static_cast<float>(column) - 0.5F * (columns - 1)) * 0.84F * w / columns;
      const float y = (static_cast<float>(row) - 0.5F * (rows - 1)) * 0.84F * d / rows;
      const auto up = static_cast<float>(draw.uniform(0.0, 0.25));
      const Vec3f middle{x, y, pack.height() - size * (1.15F + up)};
      const Vec3f tip{static_cast<float>(draw.uniform(-1, 1)),
                      static_cast<float>(draw.uniform(-1, 0.8)),
                      static_cast<float>(draw.uniform(-0.9, 0.3))};
      add_berry(pack, skin, green, lying_towards(middle, tip), size, seed.child("berry", i));
    }
  }
  return pack.finish(0.3F);
}

CollisionPrimitive collision_strawberry_punnet(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
