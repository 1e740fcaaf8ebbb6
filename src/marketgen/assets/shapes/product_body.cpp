#include "assets/own_pack.h"
#include "assets/print/label_sheet.h"
#include "assets/product_model.h"
#include "assets/shapes/contact_pieces.h"
#include "assets/shapes/pack_shape.h"
#include "base/shared_objects.h"
#include "io/json.h"

namespace marketgen::assets {
namespace {

constexpr int solid_columns = 160;  // volume within 0.2 % of a round pack, 2 % of a card of 0.6 mm
// Volume of contact against volume of the pack, see ProductBody.
constexpr double pack_tolerance = 0.05, grown_tolerance = 0.15;
// Liquids leave a head space: of a bottle's brimful volume 3 to 5 % are free, its closure, foot and
// walls are about as much again.
constexpr double liquid_fill = 0.92;

// The pack is taken for a body of one density, up to where a liquid reaches; a wall's own mass is
// little beside the contents'.
MassProperties filled(const catalog::Product& product, const Solid& solid) {
  if (product.unit_of_measure != "l") return solid.mass_properties();
  return solid.mass_properties(solid.fill_height(liquid_fill));
}

}  // namespace

Result<std::shared_ptr<const ProductBody>> product_body(const catalog::Product& product) {
  using Body = std::shared_ptr<const ProductBody>;
  static SharedObjects made;
  return made.get<const ProductBody>(io::write_json_line(product), [&]() -> Result<Body> {
    MARKETGEN_TRY(ProductBody body, make_product_body(product));
    return std::make_shared<const ProductBody>(std::move(body));
  });
}

Result<ProductBody> make_product_body(const catalog::Product& product) {
  if (has_own_mesh(product)) return own_pack_body(product);
  MARKETGEN_TRY(ProductModel model, make_pack_shape(product));
  MARKETGEN_TRY(const SheetKind sheet, sheet_kind_of(product.archetype));
  const Solid solid(model.mesh, solid_columns);
  PieceLimits limits;
  limits.tolerance = sheet == SheetKind::skin ? grown_tolerance : pack_tolerance;
  limits.stands = product.orientation != catalog::Orientation::any;

  ProductBody body;
  body.pieces = contact_pieces(model.mesh, solid, limits);
  body.features = std::move(model.features);
  const MassProperties mass = filled(product, solid);
  body.center_of_mass = to_float(mass.centroid);
  const double density = product.mass_kg / mass.volume;
  for (std::size_t i = 0; i < mass.inertia.size(); ++i)
    body.inertia_kg_m2[i] = static_cast<float>(density * mass.inertia[i]);
  return body;
}

}  // namespace marketgen::assets
