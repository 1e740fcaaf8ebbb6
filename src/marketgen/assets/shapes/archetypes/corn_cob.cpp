#include <algorithm>

#include "assets/shapes/archetypes/body.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/foliage.h"
#include "assets/shapes/archetypes/fruit.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"
#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

// From the tip to the stalk.
constexpr BodyForm cob_body{.outline = {{{0, 0},
                                         {0.3, 0.01},
                                         {0.55, 0.05},
                                         {0.85, 0.2},
                                         {1, 0.5},
                                         {1, 0.85},
                                         {0.8, 0.97},
                                         {0.4, 1},
                                         {0, 1}}},
                            .lobes = 14,  // rows of kernels
                            .lobe_low = 0.035,
                            .lobe_high = 0.035,
                            .lumps = 0.02};
constexpr float cob_share = 0.88F;  // of the length, the stalk has the rest

// The husk, peeled back: long leaves that hug the cob's lower half.
void add_husk(PackBuilder& pack, const PlantFrame& frame, Vec3f half, Stream draw) {
  const std::uint16_t husk = pack.add_surface(plant({0.36F, 0.47F, 0.15F}));
  constexpr int leaves = 5;
  constexpr double down_turn = 0.5;  // the upper side stays bare
  for (int i = 0; i < leaves; ++i) {
    WrapLeaf leaf;
    const double step = (static_cast<double>(i) - 0.5 * (leaves - 1)) / leaves;
    leaf.turn = down_turn + 0.72 * step;
    leaf.half_turn = 0.13;
    // Wraps grow upwards from the stalk: the head is upside down.
    leaf.middle = {0, 0, half.z};
    leaf.half = half;
    leaf.high = draw.uniform(0.6, 0.85);
    leaf.off = 0.03F + 0.02F * static_cast<float>(i % 2);
    leaf.flare = static_cast<float>(draw.uniform(0.02, 0.1));
    leaf.ruffle = 0.01F;
    leaf.fullness = 0.9F;
    const Placement upside_down = [&frame](Vec3f p) {
      return frame.place({p.x, -p.y, frame.length * cob_share - p.z});
    };
    add_wrap_leaf(pack, {husk}, leaf, 12, 10, upside_down);
  }
  const float radius = 0.36F * std::min(half.x, half.y);
  add_stalk(pack,
            husk,
            {.foot = {0, 0, (cob_share - 0.04F) * frame.length},
             .length = (1 - cob_share + 0.04F) * frame.length,
             .radius = radius,
             .flare = 1.6F},
            frame.place);
}

}  // namespace

Result<ProductModel> make_corn_cob(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const Seed seed = growth_seed(product);
  const PlantFrame frame = plant_frame(pack, lies_along_x(product));
  const std::uint16_t skin = pack.add_print(0.35F);
  const Vec3f half{0.44F * frame.across, 0.46F * frame.thick, 0.5F * cob_share * frame.length};
  const GrownBody body(cob_body, half, seed.child("cob").stream());
  constexpr int segments = 56, bands = 22;
  add_shell(pack, {skin}, {segments, even_stations(bands)}, [&](double turn, double along) {
    return frame.place(body.point(turn, along));
  });
  add_husk(pack, frame, half, seed.child("husk").stream());
  return pack.finish(0.2F);
}

CollisionPrimitive collision_corn_cob(const catalog::Product& product) {
  return grown_cylinder_around(product);
}

}  // namespace marketgen::assets
