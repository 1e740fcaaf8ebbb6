#include <algorithm>
#include <cmath>

#include "assets/shapes/archetypes/body.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/foliage.h"
#include "assets/shapes/archetypes/fruit.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"
#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr int berry_segments = 12, berry_bands = 8;
constexpr int berry_count = 52;
constexpr double golden_turn = 0.381966;  // of a circle, between neighbours on the spiral

constexpr BodyForm berry_body{
    .outline = {{{0, 0}, {0.4, 0.04}, {0.85, 0.24}, {1, 0.5}, {0.85, 0.76}, {0.4, 0.96}, {0, 1}}},
    .lumps = 0.03};

// Radius of the cluster, in its greatest, at share t from the tip to the stem: a cone with
// shoulders.
float cluster_radius(float t) {
  const float rise = std::min(1.0F, 0.25F + 1.35F * t);
  return t < 0.82F ? rise : rise * std::sqrt(std::max(0.0F, 1 - 16 * (t - 0.82F) * (t - 0.82F)));
}

}  // namespace

Result<ProductModel> make_grapes(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const Seed seed = growth_seed(product);
  Stream draw = seed.stream();
  const PlantFrame frame = plant_frame(pack, lies_along_x(product));
  const std::uint16_t skin = pack.add_print(0.3F);
  const std::uint16_t twig = pack.add_surface(plant({0.20F, 0.20F, 0.05F}));
  const float half_x = 0.5F * frame.across, half_y = 0.5F * frame.thick;
  const float body = 0.9F * frame.length;  // the rest is the stem
  const float berry = std::min({0.30F * half_x, 0.36F * half_y, 0.1F * frame.length});
  for (int i = 0; i < berry_count; ++i) {
    const float t = (static_cast<float>(i) + 0.5F) / berry_count;
    const float along = 1 - (1 - t) * (1 - t) * 0.35F - (1 - t) * 0.65F;  // denser at the shoulders
    const float ring = cluster_radius(along);
    const Vec2 out = unit_circle(i * golden_turn);
    const auto in = static_cast<float>(draw.uniform(0.8, 1.0));
    const Vec3f middle{(half_x * ring - berry) * in * static_cast<float>(out.x),
                       (half_y * ring - berry) * in * static_cast<float>(out.y),
                       berry + (body - 2 * berry) * along};
    const float size = berry * static_cast<float>(draw.uniform(0.88, 1.08));
    const GrownBody own(berry_body,
                        {size, size, 1.08F * size},
                        seed.child("berry", static_cast<std::uint64_t>(i)).stream());
    add_shell(
        pack, {skin}, {berry_segments, even_stations(berry_bands)}, [&](double turn, double up) {
          return frame.place(middle + own.point(turn, up) - Vec3f{0, 0, size});
        });
  }
  const std::size_t mark = pack.triangle_count();
  add_stalk(pack,
            twig,
            {.foot = {0, 0, 0.6F * body},
             .length = frame.length - 0.6F * body,
             .radius = 0.16F * berry,
             .lean = {0.2F, 0.1F},
             .flare = 1.0F,
             .knob = 1.6F},
            frame.place);
  pack.add_part_feature(FeatureKind::stem, mark);
  return pack.finish(0.2F);
}

CollisionPrimitive collision_grapes(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
