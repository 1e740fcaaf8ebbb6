#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/leaf_head.h"
#include "assets/shapes/archetypes/registry.h"

namespace marketgen::assets {

Result<ProductModel> make_lettuce_head(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const std::uint16_t skin = pack.add_print(0.55F);
  LeafHead head;
  head.heart = 0.66F;
  head.leaves = 9;
  head.half_turn = 0.13;
  head.low_edge = 0.5;
  head.high_edge = 0.97;
  head.flare_outer = 0.5F;
  head.flare_inner = 0.22F;
  head.ruffle = 0.09F;
  head.ruffles = 12;
  head.segments = 16;
  head.bands = 9;
  if (has_word(product, "iceberg")) {
    head.heart = 0.84F;
    head.ruffle = 0.045F;
    head.flare_outer = 0.28F;
    head.flare_inner = 0.08F;
  }
  add_leaf_head(pack, skin, head, plant_frame(pack, false), growth_seed(product));
  return pack.finish(0.1F);
}

CollisionPrimitive collision_lettuce_head(const catalog::Product& product) {
  return ellipsoid_around(product);
}

}  // namespace marketgen::assets
