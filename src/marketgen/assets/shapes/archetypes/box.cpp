#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/panel_box.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr float carton_fold_radius_m = 0.0012F;  // outer radius of a crease in 400 g/m2 board

}  // namespace

Result<ProductModel> make_box(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const std::uint16_t print = pack.add_print(gloss_paper_roughness);
  const Vec3f size{pack.width(), pack.depth(), pack.height()};
  add_plain_box(pack, size, carton_fold_radius_m, print, PartFrame{});
  return pack.finish();
}

CollisionPrimitive collision_box(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
