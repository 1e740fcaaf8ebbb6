#include <algorithm>

#include "assets/shapes/archetypes/bunch.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/fruit.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"
#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr int spears = 16;

TubeForm spear(Vec2f at, float radius, float tip, const PlantFrame& frame) {
  const auto knot = [&](float t, float share) {
    return TubeKnot{{at.x * frame.across, at.y * frame.thick, t * frame.length},
                    share * radius,
                    share * radius};
  };
  TubeForm form;
  form.up = plant_front;
  form.knots = {knot(0, 0.98F),
                knot(0.3F, 1),
                knot(0.6F, 0.86F),
                knot(tip - 0.22F, 0.76F),
                knot(tip - 0.13F, 0.86F),
                knot(tip - 0.06F, 0.62F),
                knot(tip, 0.15F)};
  form.high_round_m = 0.01F * frame.length;
  return form;
}

}  // namespace

Result<ProductModel> make_asparagus_bunch(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  Stream draw = growth_seed(product).stream();
  const PlantFrame frame = plant_frame(pack, lies_along_x(product));
  const std::uint16_t skin = pack.add_print(0.5F);
  const float radius = 0.105F * std::min(frame.across, frame.thick);
  constexpr double golden_turn = 0.381966;
  for (int i = 0; i < spears; ++i) {
    // Packed in a round bundle: a sunflower's order.
    const float ring = 0.385F * static_cast<float>(std::sqrt((i + 0.5) / spears));
    const Vec2 out = unit_circle(i * golden_turn);
    const Vec2f at{ring * static_cast<float>(out.x), ring * static_cast<float>(out.y)};
    const float tip = static_cast<float>(draw.uniform(0.93, 1.0));
    const float own = radius * static_cast<float>(draw.uniform(0.9, 1.15));
    add_tube(pack, {skin}, 14, 12, spear(at, own, tip, frame), frame.place);
  }
  const Vec3f band_violet{0.16F, 0.05F, 0.30F};
  for (const float z : {0.16F, 0.66F}) {
    add_rubber_band(pack,
                    band_violet,
                    z * frame.length,
                    {0.455F * frame.across, 0.455F * frame.thick},
                    0.016F * frame.length,
                    frame.place);
  }
  return pack.finish(0.3F);
}

CollisionPrimitive collision_asparagus_bunch(const catalog::Product& product) {
  return product.size_mm[0] > product.size_mm[2] ? lying_cylinder_around(product)
                                                 : cylinder_around(product);
}

}  // namespace marketgen::assets
