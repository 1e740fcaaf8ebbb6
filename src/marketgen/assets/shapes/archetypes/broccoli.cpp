#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/florets.h"
#include "assets/shapes/archetypes/foliage.h"
#include "assets/shapes/archetypes/fruit.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"
#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr float dome_middle = 0.62F;  // height, in the length

void add_stem(PackBuilder& pack, const PlantFrame& frame, Stream draw) {
  const std::uint16_t pale = pack.add_surface(plant({0.27F, 0.38F, 0.12F}));
  const float radius = 0.17F * std::min(frame.across, frame.thick);
  TubeForm stem;
  stem.up = plant_front;
  stem.knots = {{{0, 0, 0}, 0.9F * radius, 0.9F * radius},
                {{0, 0, 0.2F * frame.length}, radius, radius},
                {{0, 0, 0.4F * frame.length}, 1.25F * radius, 1.25F * radius},
                {{0, 0, 0.6F * frame.length}, 1.8F * radius, 1.8F * radius}};
  add_tube(pack, {pale}, 18, 8, stem, frame.place);
  constexpr int branches = 7;
  for (int i = 0; i < branches; ++i) {
    const Vec2 out = unit_circle((i + draw.uniform(-0.2, 0.2)) / branches);
    const auto ox = static_cast<float>(out.x), oy = static_cast<float>(out.y);
    const auto at = [&](float off, float t) {
      return Vec3f{ox * off * frame.across, oy * off * frame.thick, t * frame.length};
    };
    TubeForm branch;
    branch.up = plant_front;
    branch.knots = {{at(0.08F, 0.16F), 0.35F * radius, 0.35F * radius},
                    {at(0.19F, 0.30F), 0.38F * radius, 0.38F * radius},
                    {at(0.33F, 0.52F), 0.55F * radius, 0.55F * radius}};
    add_tube(pack, {pale}, 8, 4, branch, frame.place);
  }
}

}  // namespace

Result<ProductModel> make_broccoli(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const Seed seed = growth_seed(product);
  const PlantFrame frame = plant_frame(pack, lies_along_x(product));
  const std::uint16_t skin = pack.add_print(0.9F);
  add_stem(pack, frame, seed.child("stem").stream());
  FloretDome dome;
  dome.middle = {0, 0, dome_middle * frame.length};
  dome.half = {0.5F * frame.across, 0.5F * frame.thick, (1 - dome_middle) * frame.length};
  dome.low = 0.27;
  dome.knobs = 46;
  dome.relief = 0.24F;
  add_floret_dome(pack, {skin}, dome, seed.child("florets").stream(), frame.place);
  return pack.finish(0.2F);
}

CollisionPrimitive collision_broccoli(const catalog::Product& product) {
  return ellipsoid_around(product);
}

}  // namespace marketgen::assets
