#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/foliage.h"
#include "assets/shapes/archetypes/fruit.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"
#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr float shaft_share = 0.62F;   // of the length; the leaves have the rest
constexpr float shaft_radius = 0.62F;  // of the greatest radius, which the leaves take

void add_shaft(PackBuilder& pack, std::uint16_t skin, const PlantFrame& frame, float radius) {
  const float end = shaft_share * frame.length;
  TubeForm shaft;
  shaft.up = plant_front;
  shaft.knots = {{{0, 0, 0.012F * frame.length}, 0.9F * radius, 0.9F * radius},
                 {{0, 0, 0.05F * frame.length}, 1.12F * radius, 1.12F * radius},
                 {{0, 0, 0.12F * frame.length}, radius, radius},
                 {{0, 0, 0.6F * end}, radius, radius},
                 {{0, 0, end}, 1.2F * radius, 0.8F * radius}};
  shaft.low_round_m = 0.03F * frame.length;
  add_tube(pack, {skin, 1 - shaft_share, 1}, 28, 14, shaft, frame.place);
}

void add_roots(PackBuilder& pack, const PlantFrame& frame, float radius, Stream draw) {
  const std::uint16_t root = pack.add_surface(plant({0.62F, 0.55F, 0.38F}));
  constexpr int roots = 9;
  for (int i = 0; i < roots; ++i) {
    const Vec2 out = unit_circle(static_cast<double>(i) / roots);
    const float off = i % 2 == 0 ? 0.5F * radius : 0.2F * radius;
    const auto ox = static_cast<float>(out.x), oy = static_cast<float>(out.y);
    TubeForm hair;
    hair.up = plant_front;
    const float reach = static_cast<float>(draw.uniform(0.6, 1.0)) * radius;
    const float thin = 0.05F * radius;
    hair.knots = {{{off * ox, off * oy, 0.03F * frame.length}, thin, thin},
                  {{1.1F * off * ox, 1.1F * off * oy, -0.3F * reach}, thin, thin},
                  {{1.5F * off * ox, 1.4F * off * oy, -reach}, 0.4F * thin, 0.4F * thin}};
    add_tube(pack, {root}, 5, 3, hair, frame.place);
  }
}

void add_leaves(
    PackBuilder& pack, std::uint16_t skin, const PlantFrame& frame, float radius, Stream draw) {
  constexpr int pairs = 4;
  const float from = (shaft_share - 0.12F) * frame.length;
  for (int i = 0; i < 2 * pairs; ++i) {
    const float side = i % 2 == 0 ? -1.0F : 1.0F;
    const int pair = i / 2;
    const float rank = static_cast<float>(pair) / (pairs - 1);  // 0 outermost
    const auto stray = static_cast<float>(draw.uniform(-0.12, 0.12));
    LeafForm leaf;
    leaf.foot = {side * 0.25F * radius * (1 - rank), side * 0.1F * radius, from};
    leaf.tip = {side * (0.46F - 0.3F * rank + stray) * frame.across,
                (0.5F - rank) * 0.5F * frame.thick,
                frame.length * (0.90F + 0.10F * static_cast<float>(draw.uniform()))};
    leaf.up = plant_front;
    leaf.half_width = 0.95F * radius;
    leaf.arch = 0.03F;
    leaf.curl = static_cast<float>(draw.uniform(-0.05, 0.1));
    leaf.fold = 0.22F;
    leaf.stalk = 0.75F;
    leaf.outline = LeafOutline::strap;
    leaf.bands = 8;
    add_leaf(pack, {skin, 0, 1 - shaft_share + 0.12F}, leaf, frame.place);
  }
}

}  // namespace

Result<ProductModel> make_leek(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const Seed seed = growth_seed(product);
  const PlantFrame frame = plant_frame(pack, lies_along_x(product));
  const std::uint16_t skin = pack.add_print(0.5F);
  const float radius = shaft_radius * 0.5F * std::min(frame.across, frame.thick);
  add_shaft(pack, skin, frame, radius);
  add_roots(pack, frame, radius, seed.child("roots").stream());
  add_leaves(pack, skin, frame, radius, seed.child("leaves").stream());
  return pack.finish(0.2F);
}

CollisionPrimitive collision_leek(const catalog::Product& product) {
  return grown_cylinder_around(product);
}

}  // namespace marketgen::assets
