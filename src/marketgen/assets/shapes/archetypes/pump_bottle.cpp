#include <algorithm>

#include "assets/contents.h"
#include "assets/shapes/archetypes/bottle_parts.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/shell.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

// Heights of the pump, in shares of the bottle's.
constexpr float collar_low = 0.655F, collar_high = 0.755F, head_low = 0.885F;

// The nozzle leaves the head to the left and droops at its tip.
void add_nozzle(PackBuilder& pack, float head_radius, std::uint16_t surface) {
  const float h = pack.height(), reach = 0.47F * pack.width();
  const float z = head_low * h + 0.62F * (1 - head_low) * h, thick = 0.28F * (1 - head_low) * h;
  TubeForm nozzle;
  nozzle.up = {0, 1, 0};
  nozzle.high_round_m = 0.3F * thick;
  nozzle.knots = {{{0, 0, z}, thick, 0.62F * head_radius},
                  {{-0.5F * reach, 0, z}, 0.92F * thick, 0.50F * head_radius},
                  {{-0.82F * reach, 0, z - 0.10F * thick}, 0.75F * thick, 0.40F * head_radius},
                  {{-reach, 0, z - 0.9F * thick}, 0.58F * thick, 0.34F * head_radius}};
  add_tube(pack, {.surface = surface}, 14, 12, nozzle);
}

}  // namespace

// Soap, lotion, shampoo with a lotion pump, its head locked down for transport half way.
Result<ProductModel> make_pump_bottle(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  MARKETGEN_TRY(const Surface wall,
                contents_wall(product, plastic_wall_roughness, clear_plastic(colors.primary)));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t body = pack.add_surface(wall);
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t pump = pack.add_surface(plastic(colors.accent));
  const float h = pack.height(), step = 0.006F * h;

  Profile profile(pack, zone.roundness);
  const float collar = std::min(0.0165F, 0.56F * profile.min_half());
  profile.use(body).pole(0.01F * h).body(0.004F * h, 0.6F).body(0, 0.84F);
  profile.curve_to_body(Curve::swell, 0.03F * h, 1, 5).body(zone.low_m, 1);
  profile.use(print).body(zone.high_m, 1).use(body);
  profile.curve_to_body(Curve::dome, (collar_low - 0.02F) * h, 0.52F, 8);
  profile.neck((collar_low - 0.01F) * h, 0.86F * collar).neck(collar_low * h, 0.86F * collar);
  profile.use(pump).neck(collar_low * h, 0.97F * collar).neck(collar_low * h + step, collar);
  profile.neck(collar_high * h - 3 * step, 0.97F * collar);
  profile.curve_to_neck(Curve::dome, collar_high * h, 0.62F * collar, 3);
  profile.neck(collar_high * h + step, 0.58F * collar).neck(collar_high * h + step, 0.30F * collar);
  profile.neck(head_low * h - step, 0.30F * collar).neck(head_low * h, 0.34F * collar);
  const float head = 0.74F * collar;
  profile.neck(head_low * h, 0.94F * head).neck(head_low * h + 0.5F * step, head);
  profile.neck(h - 2 * step, head).curve_to_neck(Curve::dome, h, 0.72F * head, 4).pole(h - step);
  add_loft(pack, profile.sections(), labelled_style(zone, body));
  add_nozzle(pack, head, pump);
  pack.add_surface_feature(FeatureKind::pump, pump);
  return pack.finish();
}

CollisionPrimitive collision_pump_bottle(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
