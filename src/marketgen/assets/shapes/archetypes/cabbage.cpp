#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/leaf_head.h"
#include "assets/shapes/archetypes/registry.h"

namespace marketgen::assets {

Result<ProductModel> make_cabbage(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const std::uint16_t skin = pack.add_print(0.5F);
  LeafHead head;
  if (has_word(product, "savoy")) {
    head.ruffle = 0.035F;
    head.flare_outer = 0.25F;
  }
  add_leaf_head(pack, skin, head, plant_frame(pack, false), growth_seed(product));
  return pack.finish(0.2F);
}

CollisionPrimitive collision_cabbage(const catalog::Product& product) {
  return ellipsoid_around(product);
}

}  // namespace marketgen::assets
