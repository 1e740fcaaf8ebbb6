#include "assets/shapes/archetypes/tray_parts.h"

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {

Result<ProductModel> make_tray(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t body = pack.add_surface(plastic(colors.secondary));
  const TrayForm form;
  add_tray(pack, form, print, body);
  pack.add_band_feature(
      FeatureKind::rim, form.flange_low * pack.height(), form.flange_high * pack.height());
  return pack.finish();
}

CollisionPrimitive collision_tray(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
