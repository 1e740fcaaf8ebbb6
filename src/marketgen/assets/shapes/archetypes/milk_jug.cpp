#include <algorithm>

#include "assets/shapes/archetypes/bottle_parts.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/shell.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr Vec3f natural_hdpe{0.86F, 0.86F, 0.82F};  // uncoloured, with milk behind it

// Right of the axis the body draws back over the label and leaves room for four fingers.
constexpr BodyLevel jug_levels[]{{0.000F, 0.86F, 0.86F, 0.86F},
                                 {0.010F, 0.94F, 0.94F, 0.94F},
                                 {0.035F, 1.00F, 1.00F, 1.00F},
                                 {0.480F, 1.00F, 1.00F, 1.00F},
                                 {0.530F, 1.00F, 0.93F, 1.00F},
                                 {0.565F, 1.00F, 0.62F, 1.00F},
                                 {0.610F, 0.98F, 0.36F, 0.97F},
                                 {0.700F, 0.85F, 0.28F, 0.83F},
                                 {0.790F, 0.60F, 0.28F, 0.60F},
                                 {0.850F, 0.40F, 0.32F, 0.40F},
                                 {0.885F, 0.32F, 0.32F, 0.32F}};

// From the upper edge of the lower body along the outer line up to the neck.
void add_jug_handle(PackBuilder& pack, std::uint16_t surface) {
  const float w = pack.width() / 2, h = pack.height();
  const float across = std::min(0.17F * w, 0.05F * h),
              thick = std::min(0.21F * pack.depth() / 2, 0.06F * h);
  TubeForm handle;
  handle.up = {0, 1, 0};
  handle.knots = {{{0.66F * w, 0, 0.485F * h}, 1.9F * across, 2.2F * thick},
                  {{0.78F * w, 0, 0.535F * h}, 1.25F * across, 1.4F * thick},
                  {{0.83F * w, 0, 0.60F * h}, across, thick},
                  {{0.80F * w, 0, 0.69F * h}, across, thick},
                  {{0.68F * w, 0, 0.775F * h}, across, thick},
                  {{0.46F * w, 0, 0.825F * h}, 1.15F * across, 1.15F * thick},
                  {{0.16F * w, 0, 0.825F * h}, 1.4F * across, 1.3F * thick}};
  add_tube(pack, {.surface = surface}, 14, 26, handle);
}

}  // namespace

// Milk, juice, laundry refills: blow-moulded with its handle in one piece, a snap cap of 38 mm.
Result<ProductModel> make_milk_jug(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t body = pack.add_surface(plastic(natural_hdpe));
  const std::uint16_t print = pack.add_print(gloss_paper_roughness);
  const std::uint16_t cap = pack.add_surface(plastic(colors.accent));
  const float h = pack.height();

  std::vector<Section> sections = blown_body(pack, jug_levels, zone, body, print);
  const float neck = 0.32F * std::min(pack.width(), pack.depth()) / 2;
  const auto add_ring = [&](float z, float radius, std::uint16_t surface) {
    sections.push_back(
        {.z = z * h, .half_width = radius, .half_depth = radius, .surface = surface});
  };
  add_ring(0.925F, neck, body);
  add_ring(0.925F, 1.12F * neck, cap);
  add_ring(0.930F, 1.15F * neck, cap);
  add_ring(0.990F, 1.14F * neck, cap);
  add_ring(0.998F, 1.09F * neck, cap);
  add_ring(1.000F, 0.98F * neck, cap);
  add_loft(pack, sections, labelled_style(zone, body, 2200));
  const std::size_t handle = pack.triangle_count();
  add_jug_handle(pack, body);
  pack.add_part_feature(FeatureKind::handle, handle);
  pack.add_surface_feature(FeatureKind::cap, cap);
  return pack.finish();
}

CollisionPrimitive collision_milk_jug(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
