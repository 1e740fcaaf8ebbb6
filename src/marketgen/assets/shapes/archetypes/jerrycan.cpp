#include <algorithm>

#include "assets/contents.h"
#include "assets/shapes/archetypes/bottle_parts.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/shell.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr BodyLevel jerrycan_levels[]{{0.000F, 0.88F, 0.88F, 0.86F},
                                      {0.008F, 0.95F, 0.95F, 0.94F},
                                      {0.030F, 1.00F, 1.00F, 1.00F},
                                      {0.680F, 1.00F, 1.00F, 1.00F},
                                      {0.735F, 0.985F, 0.985F, 0.97F},
                                      {0.770F, 0.94F, 0.92F, 0.88F},
                                      {0.795F, 0.84F, 0.78F, 0.72F},
                                      {0.812F, 0.66F, 0.52F, 0.50F}};
constexpr float spout_x = -0.46F;  // share of the half width

// From beside the spout over the top to the right end.
void add_can_handle(PackBuilder& pack, std::uint16_t surface) {
  const float w = pack.width() / 2, h = pack.height();
  const float across = std::min(0.12F * w, 0.036F * h);
  const float thick = std::min(0.22F * pack.depth() / 2, 0.06F * h);
  TubeForm handle;
  handle.up = {0, 1, 0};
  handle.knots = {{{-0.08F * w, 0, 0.775F * h}, 1.6F * across, 1.8F * thick},
                  {{-0.03F * w, 0, 0.855F * h}, 1.1F * across, 1.2F * thick},
                  {{0.12F * w, 0, 0.935F * h}, across, thick},
                  {{0.40F * w, 0, 0.958F * h}, across, thick},
                  {{0.66F * w, 0, 0.925F * h}, across, thick},
                  {{0.79F * w, 0, 0.835F * h}, 1.15F * across, 1.25F * thick},
                  {{0.80F * w, 0, 0.735F * h}, 1.7F * across, 1.9F * thick}};
  add_tube(pack, {.surface = surface}, 14, 28, handle);
}

void add_spout(PackBuilder& pack, std::uint16_t body, std::uint16_t cap) {
  const float w = pack.width() / 2, h = pack.height();
  const float radius = std::min({0.024F, 0.27F * w, 0.34F * pack.depth() / 2});
  const auto ring = [&](float z, float share, std::uint16_t surface) {
    return Section{
        .z = z * h, .half_width = share * radius, .half_depth = share * radius, .surface = surface};
  };
  add_loft(pack,
           {ring(0.74F, 1.25F, body),
            ring(0.79F, 1.15F, body),
            ring(0.815F, 0.95F, body),
            ring(0.835F, 0.90F, body),
            ring(0.838F, 0.90F, body),
            ring(0.838F, 1.04F, cap),
            ring(0.842F, 1.07F, cap),
            ring(0.895F, 1.05F, cap),
            ring(0.903F, 0.99F, cap),
            ring(0.906F, 0.88F, cap)},
           {.triangles = 620},
           PartFrame{.origin = {spout_x * w, 0, 0}});
}

}  // namespace

// Five litres of water, oil or cleaner: a straight body, the handle moulded over its top.
Result<ProductModel> make_jerrycan(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  MARKETGEN_TRY(const Surface wall,
                contents_wall(product, plastic_wall_roughness, clear_plastic(colors.primary)));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t body = pack.add_surface(wall);
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t cap = pack.add_surface(plastic(colors.accent));
  const std::vector<Section> sections = blown_body(pack, jerrycan_levels, zone, body, print);
  add_loft(pack, sections, labelled_style(zone, body, 1500));
  add_spout(pack, body, cap);
  const std::size_t handle = pack.triangle_count();
  add_can_handle(pack, body);
  pack.add_part_feature(FeatureKind::handle, handle);
  pack.add_surface_feature(FeatureKind::cap, cap);
  return pack.finish();
}

CollisionPrimitive collision_jerrycan(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
