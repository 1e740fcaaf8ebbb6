#include <algorithm>

#include "assets/shapes/archetypes/bottle_parts.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/shell.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

// The left shoulder runs straight to the neck; the right one is scooped out for the hand.
constexpr BodyLevel detergent_levels[]{{0.000F, 0.90F, 0.90F, 0.84F},
                                       {0.008F, 0.96F, 0.96F, 0.93F},
                                       {0.030F, 1.00F, 1.00F, 1.00F},
                                       {0.500F, 1.00F, 1.00F, 1.00F},
                                       {0.535F, 0.995F, 0.95F, 1.00F},
                                       {0.565F, 0.985F, 0.66F, 0.98F},
                                       {0.600F, 0.96F, 0.34F, 0.95F},
                                       {0.660F, 0.89F, 0.20F, 0.86F},
                                       {0.720F, 0.75F, 0.12F, 0.76F},
                                       {0.770F, 0.56F, 0.10F, 0.66F},
                                       {0.800F, 0.48F, 0.08F, 0.60F}};
constexpr float neck_x = -0.20F;  // share of the half width

void add_detergent_handle(PackBuilder& pack, std::uint16_t surface) {
  const float w = pack.width() / 2, h = pack.height();
  const float across = std::min(0.135F * w, 0.055F * h);
  const float thick = std::min(0.36F * pack.depth() / 2, 0.075F * h);
  TubeForm handle;
  handle.up = {0, 1, 0};
  handle.knots = {{{0.74F * w, 0, 0.475F * h}, 1.9F * across, 1.7F * thick},
                  {{0.81F * w, 0, 0.535F * h}, 1.25F * across, 1.3F * thick},
                  {{0.84F * w, 0, 0.60F * h}, across, thick},
                  {{0.78F * w, 0, 0.675F * h}, across, thick},
                  {{0.60F * w, 0, 0.735F * h}, across, thick},
                  {{0.30F * w, 0, 0.765F * h}, 1.05F * across, 1.1F * thick},
                  {{-0.08F * w, 0, 0.765F * h}, 1.2F * across, 1.25F * thick}};
  add_tube(pack, {.surface = surface}, 16, 28, handle);
}

}  // namespace

// Laundry detergent, softener: a flat bottle whose handle is a part of its outline; the cap doses.
Result<ProductModel> make_detergent_bottle(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t body = pack.add_surface(plastic(colors.primary));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t cap = pack.add_surface(plastic(colors.accent));
  const float w = pack.width() / 2, h = pack.height();

  std::vector<Section> sections = blown_body(pack, detergent_levels, zone, body, print);
  const float neck = std::min(0.28F * w, 0.60F * pack.depth() / 2);
  const auto add_ring = [&](float z, float share, std::uint16_t surface) {
    sections.push_back({.z = z * h,
                        .half_width = share * neck,
                        .half_depth = share * neck,
                        .surface = surface,
                        .x = neck_x * w});
  };
  add_ring(0.815F, 1, body);
  add_ring(0.815F, 1.14F, cap);
  add_ring(0.820F, 1.18F, cap);
  add_ring(0.848F, 1.17F, cap);
  add_ring(0.852F, 1.10F, cap);
  add_ring(0.975F, 1.04F, cap);
  add_ring(0.990F, 1.00F, cap);
  add_ring(0.998F, 0.92F, cap);
  add_ring(1.000F, 0.84F, cap);
  add_loft(pack, sections, labelled_style(zone, body, 2000));
  const std::size_t handle = pack.triangle_count();
  add_detergent_handle(pack, body);
  pack.add_part_feature(FeatureKind::handle, handle);
  pack.add_surface_feature(FeatureKind::cap, cap);
  return pack.finish();
}

CollisionPrimitive collision_detergent_bottle(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
