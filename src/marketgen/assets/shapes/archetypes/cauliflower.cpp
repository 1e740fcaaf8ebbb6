#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/florets.h"
#include "assets/shapes/archetypes/foliage.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"

namespace marketgen::assets {

Result<ProductModel> make_cauliflower(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const Seed seed = growth_seed(product);
  const PlantFrame frame = plant_frame(pack, false);
  const std::uint16_t skin = pack.add_print(0.85F);
  const std::uint16_t green = pack.add_surface(plant({0.26F, 0.40F, 0.13F}));
  const Vec3f half{0.5F * frame.across, 0.5F * frame.thick, 0.5F * frame.length};
  const Vec3f middle{0, 0, half.z};
  FloretDome dome;
  dome.middle = {0, 0, 1.06F * half.z};
  dome.half = {0.88F * half.x, 0.88F * half.y, 0.94F * half.z};
  dome.low = 0.12;
  dome.knobs = 44;
  dome.relief = 0.2F;
  add_floret_dome(pack, {skin}, dome, seed.child("florets").stream(), frame.place);

  Stream draw = seed.child("leaves").stream();
  constexpr int leaves = 7;
  for (int i = 0; i < leaves; ++i) {
    WrapLeaf leaf;
    leaf.middle = middle;
    leaf.half = half * 0.92F;
    leaf.turn = (i + draw.uniform(-0.15, 0.15)) / leaves;
    leaf.half_turn = 0.095;
    leaf.low = 0.0;
    leaf.high = draw.uniform(0.52, 0.66);
    leaf.off = 0.01F + 0.01F * static_cast<float>(i % 2);
    leaf.flare = static_cast<float>(draw.uniform(0.05, 0.14));
    leaf.ruffle = 0.02F;
    add_wrap_leaf(pack, {green}, leaf, 12, 8, frame.place);
  }
  return pack.finish(0.2F);
}

CollisionPrimitive collision_cauliflower(const catalog::Product& product) {
  return ellipsoid_around(product);
}

}  // namespace marketgen::assets
