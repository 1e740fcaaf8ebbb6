#include <algorithm>

#include "assets/shapes/archetypes/body.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/foliage.h"
#include "assets/shapes/archetypes/fruit.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"

namespace marketgen::assets {
namespace {

constexpr BodyForm bulb_body{.outline = {{{0, 0},
                                          {0.3, 0},
                                          {0.6, 0.06},
                                          {0.93, 0.3},
                                          {1, 0.5},
                                          {0.86, 0.76},
                                          {0.6, 0.95},
                                          {0.3, 1},
                                          {0, 1}}},
                             .lobes = 5,
                             .lobe_low = 0.02,
                             .lobe_high = 0.1,
                             .lumps = 0.04};
constexpr float bulb_share = 0.55F;  // of the length; stalks and green have the rest

void add_sheaths(
    PackBuilder& pack, std::uint16_t skin, const PlantFrame& frame, Vec3f half, Stream draw) {
  constexpr int sheaths = 4;
  for (int i = 0; i < sheaths; ++i) {
    WrapLeaf leaf;
    leaf.middle = {0, 0, half.z};
    leaf.half = half;
    const int pair = i / 2;
    leaf.turn = 0.5 * i + 0.22 * pair + draw.uniform(-0.05, 0.05);
    leaf.half_turn = 0.2;
    leaf.high = draw.uniform(0.72, 0.86);
    leaf.off = 0.03F + 0.02F * static_cast<float>(sheaths - i);
    leaf.flare = 0.03F;
    leaf.ruffle = 0;
    add_wrap_leaf(pack, {skin, 1 - bulb_share, 1}, leaf, 16, 10, frame.place);
  }
}

void add_stalks(PackBuilder& pack, std::uint16_t skin, const PlantFrame& frame, Stream draw) {
  const std::uint16_t frond = pack.add_surface(plant({0.12F, 0.28F, 0.05F}));
  constexpr int stalks = 4;
  for (int i = 0; i < stalks; ++i) {
    const float fan = 2 * static_cast<float>(i) / (stalks - 1) - 1;
    const float radius = 0.085F * std::min(frame.across, frame.thick) * (i % 2 == 0 ? 1.0F : 1.3F);
    const float end = static_cast<float>(draw.uniform(0.82, 0.93)) * frame.length;
    const float deep = (i % 2 == 0 ? 0.08F : -0.08F) * frame.thick;
    TubeForm stalk;
    stalk.up = plant_front;
    stalk.knots = {
        {{0.1F * fan * frame.across, deep, (bulb_share - 0.14F) * frame.length},
         1.6F * radius,
         radius},
        {{0.2F * fan * frame.across, deep, (bulb_share + 0.08F) * frame.length}, radius, radius},
        {{0.34F * fan * frame.across, deep, end}, 0.9F * radius, 0.9F * radius}};
    add_tube(pack, {skin, 0.05F, 1 - bulb_share}, 14, 6, stalk, frame.place);
    constexpr int fronds = 4;
    for (int k = 0; k < fronds; ++k) {
      LeafForm leaf;
      leaf.foot = stalk.knots[1].at +
                  (stalk.knots[2].at - stalk.knots[1].at) * (0.45F + 0.15F * static_cast<float>(k));
      leaf.tip = leaf.foot +
                 Vec3f{(fan + static_cast<float>(draw.uniform(-1.2, 1.2))) * 0.11F * frame.across,
                       static_cast<float>(draw.uniform(-0.2, 0.2)) * frame.thick,
                       std::min(frame.length - leaf.foot.z, 0.2F * frame.length)};
      leaf.up = plant_front;
      leaf.half_width = 0.012F * frame.length;
      leaf.ruffle = 0.8F;
      leaf.ruffles = 6;
      leaf.segments = 6;
      add_leaf(pack, {frond}, leaf, frame.place);
    }
  }
}

}  // namespace

Result<ProductModel> make_fennel(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const Seed seed = growth_seed(product);
  const PlantFrame frame = plant_frame(pack, lies_along_x(product));
  const std::uint16_t skin = pack.add_print(0.45F);
  const Vec3f half{0.47F * frame.across, 0.47F * frame.thick, 0.5F * bulb_share * frame.length};
  const GrownBody bulb(bulb_body, half, seed.child("bulb").stream());
  constexpr int segments = 32, bands = 14;
  add_shell(pack,
            {skin, 1 - bulb_share, 1},
            {segments, even_stations(bands)},
            [&](double turn, double along) { return frame.place(bulb.point(turn, along)); });
  add_sheaths(pack, skin, frame, half, seed.child("sheaths").stream());
  add_stalks(pack, skin, frame, seed.child("stalks").stream());
  return pack.finish(0.2F);
}

CollisionPrimitive collision_fennel(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
