#include <algorithm>

#include "assets/shapes/archetypes/body.h"
#include "assets/shapes/archetypes/bunch.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/foliage.h"
#include "assets/shapes/archetypes/fruit.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"
#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

// With its tail, which points away from the leaves.
constexpr BodyForm radish_body{.outline = {{{0, 0},
                                            {0.025, 0.01},
                                            {0.04, 0.22},
                                            {0.12, 0.33},
                                            {0.6, 0.42},
                                            {0.95, 0.58},
                                            {1, 0.70},
                                            {0.85, 0.88},
                                            {0.5, 0.98},
                                            {0.2, 1},
                                            {0, 0.995}}},
                               .lumps = 0.05,
                               .lean = 0.1};
constexpr int radishes = 9;
constexpr float tie_share = 0.42F;   // of the length, where the leaf stalks are tied
constexpr float head_share = 0.17F;  // middle of the radishes

void add_leaf_of(PackBuilder& pack,
                 std::uint16_t green,
                 const PlantFrame& frame,
                 Vec3f foot,
                 float fan,
                 Stream draw) {
  const Vec3f tie{0.1F * fan * frame.across,
                  0.1F * static_cast<float>(draw.uniform(-1, 1)) * frame.thick,
                  tie_share * frame.length};
  TubeForm stalk;
  stalk.up = plant_front;
  const float thin = 0.012F * frame.across;
  stalk.knots = {{foot, 1.4F * thin, 1.4F * thin}, {tie, thin, thin}};
  add_tube(pack, {green}, 6, 2, stalk, frame.place);
  LeafForm leaf;
  leaf.foot = tie;
  leaf.tip = {0.40F * fan * frame.across,
              static_cast<float>(draw.uniform(-0.3, 0.4)) * frame.thick,
              frame.length * static_cast<float>(draw.uniform(0.86, 1.0))};
  leaf.up = plant_front;
  leaf.half_width = 0.085F * frame.length;
  leaf.outline = LeafOutline::spoon;
  leaf.ruffle = 0.3F;
  leaf.ruffles = 5;
  leaf.fold = 0.3F;
  leaf.curl = static_cast<float>(draw.uniform(0, 0.12));
  leaf.stalk = 0.1F;
  leaf.bands = 9;
  add_leaf(pack, {green}, leaf, frame.place);
}

}  // namespace

Result<ProductModel> make_radish_bunch(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const Seed seed = growth_seed(product);
  Stream draw = seed.stream();
  const PlantFrame frame = plant_frame(pack, lies_along_x(product));
  const std::uint16_t skin = pack.add_print(0.35F);
  const std::uint16_t green = pack.add_surface(plant(leaf_green));
  const float size = std::min({0.17F * frame.across, 0.26F * frame.thick, 0.1F * frame.length});
  for (int i = 0; i < radishes; ++i) {
    const float fan = 2 * static_cast<float>(i) / (radishes - 1) - 1;
    const bool upper = i % 2 == 1;
    const Vec3f middle{fan * (0.5F * frame.across - 1.05F * size),
                       (upper ? -1.0F : 1.0F) * (0.5F * frame.thick - 1.05F * size) *
                           static_cast<float>(draw.uniform(0.6, 1)),
                       frame.length * (head_share + static_cast<float>(draw.uniform(-0.04, 0.05)))};
    // The radish hangs on the line from the tie through its middle.
    const Vec3f z = normalized(Vec3f{0, 0, tie_share * frame.length} - middle);
    const Vec3f x = normalized(cross(Vec3f{0, -1, 0.01F}, z));
    const Seed own = seed.child("radish", static_cast<std::uint64_t>(i));
    const float length = 2.6F * size;  // with its tail
    const PartFrame root{middle - z * (0.62F * length), x, cross(z, x), z};
    const GrownBody body(radish_body, {size, size, 0.5F * length}, own.child("body").stream());
    constexpr int segments = 16, bands = 14;
    add_shell(pack, {skin}, {segments, even_stations(bands)}, [&](double turn, double along) {
      return frame.place(root(body.point(turn, along)));
    });
    add_leaf_of(pack, green, frame, root(body.top()), fan, own.child("leaf").stream());
  }
  const Vec3f band_red{0.45F, 0.03F, 0.03F};
  add_rubber_band(pack,
                  band_red,
                  (tie_share - 0.02F) * frame.length,
                  {0.11F * frame.across, 0.13F * frame.thick},
                  0.012F * frame.length,
                  frame.place);
  return pack.finish(0.2F);
}

CollisionPrimitive collision_radish_bunch(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
