#include <algorithm>

#include "assets/shapes/archetypes/bunch.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/foliage.h"
#include "assets/shapes/archetypes/fruit.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"

namespace marketgen::assets {
namespace {

constexpr int onions = 7;
constexpr float fork_share = 0.5F;  // of the length, where the green parts

// The stalk of one onion from its root to the fork.
void add_onion(PackBuilder& pack,
               std::uint16_t skin,
               const PlantFrame& frame,
               Vec2f at,
               float radius,
               Stream draw) {
  const float length = frame.length;
  const auto start = static_cast<float>(draw.uniform(0.0, 0.05));
  const auto place_at = [&](float t, float spread) {
    return Vec3f{at.x * spread, at.y * spread, t * length};
  };
  TubeForm bulb;
  bulb.up = plant_front;
  bulb.knots = {{place_at(start, 1.15F), 0.9F * radius, 0.9F * radius},
                {place_at(start + 0.04F, 1.15F), 1.25F * radius, 1.25F * radius},
                {place_at(start + 0.10F, 1.05F), 0.85F * radius, 0.85F * radius},
                {place_at(0.3F, 0.9F), 0.75F * radius, 0.75F * radius},
                {place_at(fork_share, 0.9F), 0.8F * radius, 0.7F * radius}};
  bulb.low_round_m = 0.03F * length;
  add_tube(pack, {skin, 1 - fork_share, 1}, 12, 8, bulb, frame.place);
  constexpr int leaves = 2;
  for (int i = 0; i < leaves; ++i) {
    const float side = i == 0 ? -1.0F : 1.0F;
    TubeForm leaf;
    leaf.up = plant_front;
    const float tip = static_cast<float>(draw.uniform(0.9, 1.0));
    const Vec2f end{
        at.x * 1.1F + side * static_cast<float>(draw.uniform(0.05, 0.16)) * frame.across,
        at.y * 1.1F + static_cast<float>(draw.uniform(-0.1, 0.1)) * frame.thick};
    const Vec3f foot = place_at(fork_share - 0.06F, 0.9F) + Vec3f{0.12F * side * radius, 0, 0};
    const Vec3f last{end.x, end.y, tip * length};
    const float wide = 0.62F * radius, flat = 0.4F * radius;
    leaf.knots = {{foot, wide, flat},
                  {foot + (last - foot) * 0.35F + Vec3f{-0.3F * side * radius, 0, 0}, wide, flat},
                  {foot + (last - foot) * 0.7F, 0.8F * wide, 0.8F * flat},
                  {last, 0.12F * wide, 0.12F * flat}};
    add_tube(pack, {skin, 0, 1 - fork_share + 0.06F}, 10, 8, leaf, frame.place);
  }
}

}  // namespace

Result<ProductModel> make_spring_onions(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const Seed seed = growth_seed(product);
  Stream draw = seed.stream();
  const PlantFrame frame = plant_frame(pack, lies_along_x(product));
  const std::uint16_t skin = pack.add_print(0.4F);
  const float radius = std::min(0.19F * frame.thick, 0.105F * frame.across);
  for (int i = 0; i < onions; ++i) {
    const bool upper = i % 2 == 1;
    const Vec2f at{(static_cast<float>(i) / (onions - 1) - 0.5F) * 0.62F * frame.across,
                   (upper ? -0.2F : 0.2F) * frame.thick};
    add_onion(pack,
              skin,
              frame,
              at,
              radius * static_cast<float>(draw.uniform(0.85, 1.1)),
              seed.child("onion", static_cast<std::uint64_t>(i)).stream());
  }
  const Vec3f band_blue{0.05F, 0.12F, 0.45F};
  add_rubber_band(pack,
                  band_blue,
                  0.36F * frame.length,
                  {0.37F * frame.across, 0.37F * frame.thick},
                  0.012F * frame.length,
                  frame.place);
  return pack.finish(0.2F);
}

CollisionPrimitive collision_spring_onions(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
