#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"
#include "assets/shapes/archetypes/tray_parts.h"

namespace marketgen::assets {

// Mince, steaks, chicken, fish: a deep tray with a broad flange, its film domed by what is inside.
Result<ProductModel> make_meat_tray(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t body =
      pack.add_surface({.color = {0.035F, 0.035F, 0.04F}, .roughness = 0.5F});
  const TrayForm form{.foot_scale = 0.80F,
                      .wall_scale = 0.90F,
                      .foot_high = 0.12F,
                      .flange_low = 0.83F,
                      .flange_high = 0.86F,
                      .greatest_corner_m = 0.026F,
                      .dome_flat = 1.05F};
  add_tray(pack, form, print, body);
  pack.add_band_feature(
      FeatureKind::rim, form.flange_low * pack.height(), form.flange_high * pack.height());
  return pack.finish();
}

CollisionPrimitive collision_meat_tray(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
