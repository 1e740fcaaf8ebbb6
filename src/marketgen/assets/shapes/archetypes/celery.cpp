#include <algorithm>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/foliage.h"
#include "assets/shapes/archetypes/fruit.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"
#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr int outer_stalks = 7, inner_stalks = 3;
constexpr float stalk_share = 0.76F;  // of the length; leaves beyond

struct Rib {
  Vec3f tip;
  Vec3f outward;
};

// A ribbed gutter from the foot of the head to its leaves.
Rib add_rib(PackBuilder& pack,
            std::uint16_t skin,
            const PlantFrame& frame,
            double turn,
            float out,
            Stream draw) {
  const Vec2 c = unit_circle(turn);
  const Vec3f outward{static_cast<float>(c.x), static_cast<float>(c.y), 0};
  const Vec3f half{0.5F * frame.across, 0.5F * frame.thick, 0};
  const float radius = std::min(half.x, half.y);
  const auto at = [&](float off, float t) {
    return Vec3f{outward.x * half.x * off, outward.y * half.y * off, t * frame.length};
  };
  const float tip = stalk_share * static_cast<float>(draw.uniform(0.9, 1.0));
  TubeForm rib;
  rib.up = outward;
  rib.fold = -0.45F;  // edges towards the heart
  const float wide = 0.36F * radius, flat = 0.11F * radius;
  rib.knots = {{at(0.42F * out, 0.0F), 1.05F * wide, 1.6F * flat},
               {at(0.62F * out, 0.06F), 1.25F * wide, 1.5F * flat},
               {at(0.70F * out, 0.25F), 1.0F * wide, 1.2F * flat},
               {at(0.66F * out, 0.5F), 0.8F * wide, flat},
               {at(0.72F * out, tip), 0.45F * wide, 0.8F * flat}};
  rib.low_round_m = 0.03F * frame.length;
  add_tube(pack, {skin, 1 - stalk_share, 1}, 14, 9, rib, frame.place);
  return {at(0.72F * out, tip), outward};
}

void add_leaflets(
    PackBuilder& pack, std::uint16_t green, const PlantFrame& frame, const Rib& rib, Stream draw) {
  constexpr int leaflets = 4;
  for (int i = 0; i < leaflets; ++i) {
    const float side = i == 0 ? 0.0F : i % 2 == 0 ? -1.0F : 1.0F;
    const Vec3f across = cross(Vec3f{0, 0, 1}, rib.outward);
    const float reach = (frame.length - rib.tip.z) * static_cast<float>(draw.uniform(0.7, 1.0));
    LeafForm leaf;
    const float down = 0.15F + 0.1F * static_cast<float>(i);  // each from its own place
    leaf.foot = rib.tip - Vec3f{0, 0, down * reach};
    leaf.tip = rib.tip + across * (side * 0.55F * reach) +
               Vec3f{0, 0, side == 0 ? reach : 0.6F * reach} + rib.outward * (0.12F * reach);
    leaf.up = -rib.outward;
    leaf.half_width = 0.4F * reach;
    leaf.outline = LeafOutline::spoon;
    leaf.ruffle = 0.35F;
    leaf.ruffles = 4;
    leaf.stalk = 0.1F;
    leaf.bands = 7;
    add_leaf(pack, {green}, leaf, frame.place);
  }
}

}  // namespace

Result<ProductModel> make_celery(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const Seed seed = growth_seed(product);
  const PlantFrame frame = plant_frame(pack, lies_along_x(product));
  const std::uint16_t skin = pack.add_print(0.4F);
  const std::uint16_t green = pack.add_surface(plant({0.13F, 0.30F, 0.04F}));
  for (int i = 0; i < outer_stalks + inner_stalks; ++i) {
    const bool outer = i < outer_stalks;
    const double turn = outer ? static_cast<double>(i) / outer_stalks
                              : static_cast<double>(i - outer_stalks) / inner_stalks + 0.1;
    const Seed own = seed.child("stalk", static_cast<std::uint64_t>(i));
    const Rib rib =
        add_rib(pack, skin, frame, turn, outer ? 1.0F : 0.35F, own.child("rib").stream());
    add_leaflets(pack, green, frame, rib, own.child("leaves").stream());
  }
  return pack.finish(0.2F);
}

CollisionPrimitive collision_celery(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
