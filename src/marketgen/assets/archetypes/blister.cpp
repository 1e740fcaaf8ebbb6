#include <algorithm>

#include "assets/archetypes/collision.h"
#include "assets/archetypes/loft.h"
#include "assets/archetypes/pack_faces.h"
#include "assets/archetypes/panel_box.h"
#include "assets/archetypes/plate.h"
#include "assets/archetypes/registry.h"
#include "assets/archetypes/shell.h"
#include "assets/archetypes/surfaces.h"
#include "base/text.h"

namespace marketgen {
namespace {

constexpr float greatest_card_m = 0.0012F;  // thickness
constexpr float blister_label_m = 0.00015F;
constexpr float greatest_cell_m = 0.00725F;  // radius of an AA cell
constexpr Vec3f tray_grey{0.62F, 0.64F, 0.66F};

struct BlisterSurfaces {
  std::uint16_t card, edge, print, clear, goods, metal;
};

bool holds(const Product& product, std::string_view word) {
  return lower_ascii(product.name + " " + product.subcategory).find(word) != std::string::npos;
}

// The card with its hole for the peg, and the print on both sides.
void add_card(PackBuilder& pack, float thick, const BlisterSurfaces& s) {
  const float w = pack.width(), h = pack.height(), back = pack.depth() / 2;
  PlateForm card;
  card.size = {w, thick, h};
  card.corner_m = std::min(0.006F, 0.08F * w);
  card.hole_middle = {0, 0.93F * h};
  card.hole_size = {std::min(0.030F, 0.34F * w), std::min(0.009F, 0.05F * h)};
  card.hole_corner_m = 0.5F * card.hole_size.y;
  add_holed_plate(pack, card, s.card, PartFrame{.origin = {0, back - thick - blister_label_m, 0}});
  const Vec3f hole{card.hole_middle.x, back - blister_label_m - thick / 2, card.hole_middle.y};
  const Vec3f half{card.hole_size.x / 2, thick / 2, card.hole_size.y / 2};
  pack.add_feature(FeatureKind::hang_hole, {hole - half, hole + half});
  const float low = blister_bubble_high * h;
  const Vec3f size{w, blister_label_m, (blister_print_high - blister_bubble_high) * h};
  const float inset = 0.002F * w;  // bleeds to the card's edge, short of its bevel
  const Vec3f printed{w - 2 * inset, size.y, size.z};
  const PartFrame front{.origin = {0, back - thick - 2 * blister_label_m, low}};
  add_sticker(pack, pack.panel(PanelKind::front), printed, s.print, s.edge, front);
  const PartFrame behind{.origin = {0, back, low}, .x = {-1, 0, 0}, .y = {0, -1, 0}};
  add_sticker(pack, pack.panel(PanelKind::back), printed, s.print, s.edge, behind);
}

// A thermoformed hood: a flat flange, then a rounded block with tapering walls.
void add_hood(PackBuilder& pack, float wall_y, Vec3f size, float low, std::uint16_t surface) {
  const float flange = std::min(0.0006F, 0.04F * size.y);
  const auto section = [&](float z, float inset, float roundness) {
    return Section{.z = z,
                   .half_width = size.x / 2 - inset,
                   .half_depth = size.z / 2 - inset,
                   .surface = surface,
                   .roundness = roundness};
  };
  const float least = std::min(size.x, size.z);
  const float rim = 0.05F * least, round = std::min(0.30F * size.y, 0.16F * least);
  std::vector<Section> sections{section(0, 0, 0.12F),
                                section(flange, 0, 0.12F),
                                section(flange, rim, 0.22F),
                                section(size.y - round, 1.5F * rim, 0.30F)};
  for (const Vec2f step : {Vec2f{0.10F, 0.45F}, {0.32F, 0.78F}, {0.62F, 0.95F}, {1.0F, 1.0F}})
    sections.push_back(
        section(size.y - round + round * step.y, 1.5F * rim + round * step.x, 0.34F));
  // The loft's axis points at the reader, its front upwards.
  const PartFrame frame{
      .origin = {0, wall_y, low + size.z / 2}, .x = {1, 0, 0}, .y = {0, 0, 1}, .z = {0, -1, 0}};
  add_loft(pack, sections, {.triangles = 900, .most_chords = 7}, frame);
}

// Batteries lie side by side, poles up; nothing hides them but the film.
void add_batteries(
    PackBuilder& pack, float wall_y, Vec3f room, float low, const BlisterSurfaces& s) {
  constexpr int count = 4;
  const float radius = std::min({greatest_cell_m, 0.46F * room.x / count, 0.5F * room.y});
  const float pitch = std::min(2.5F * radius, room.x / count);
  const float length = std::min(7.0F * radius, 0.92F * room.z);  // AA and AAA alike
  const float foot = low + (room.z - length) / 2;
  for (int i = 0; i < count; ++i) {
    const float x = (static_cast<float>(i) + 0.5F - 0.5F * count) * pitch;
    const auto ring = [&](float z, float share, std::uint16_t surface) {
      return Section{.z = z * length,
                     .half_width = share * radius,
                     .half_depth = share * radius,
                     .surface = surface};
    };
    add_loft(pack,
             {ring(0, 0.94F, s.goods),
              ring(0.012F, 1, s.goods),
              ring(0.66F, 1, s.metal),
              ring(0.955F, 1, s.metal),
              ring(0.965F, 0.93F, s.metal),
              ring(0.965F, 0.38F, s.metal),
              ring(0.995F, 0.36F, s.metal),
              ring(1, 0.30F, s.metal)},
             {.triangles = 420, .most_chords = 6},
             PartFrame{.origin = {x, wall_y - room.y + radius, foot}});
  }
}

// A handle with a head across its upper end: a razor, or with `bristles` a brush.
void add_handle(PackBuilder& pack,
                float wall_y,
                Vec3f room,
                float low,
                bool bristles,
                const BlisterSurfaces& s) {
  const float front = wall_y - room.y, middle = wall_y - 0.5F * room.y;
  const float thick = 0.15F * room.y, wide = 0.075F * room.x, high = low + 0.96F * room.z;
  const float head = (bristles ? 0.22F : 0.13F) * room.z;
  TubeForm handle;
  handle.up = {0, 1, 0};
  handle.low_round_m = 1.2F * wide;
  const auto knot = [&](float share, float y, float width) {
    return TubeKnot{{0, y, low + 0.03F * room.z + share * (high - head - low)}, width, thick};
  };
  handle.knots = {knot(0, middle, 0.9F * wide),
                  knot(0.3F, middle - thick, 1.25F * wide),
                  knot(0.55F, middle - 0.8F * thick, 0.9F * wide),
                  knot(0.8F, middle + 0.3F * thick, 0.6F * wide),
                  knot(1, middle, 0.7F * wide)};
  add_tube(pack, {.surface = s.goods}, 14, 18, handle);
  const float across = (bristles ? 0.17F : 0.50F) * room.x, deep = 0.5F * room.y;
  const PartFrame base{.origin = {0, front + 0.75F * deep, high - head}};
  add_plain_box(pack, {across, deep, head}, 0.18F * std::min(deep, head), s.goods, base);
  const PartFrame face{.origin = {0, front + 0.25F * deep, high - 0.88F * head}};
  const Vec3f blades{0.86F * across, 0.5F * deep, 0.76F * head};
  add_plain_box(pack, blades, 0.1F * head, s.metal, face);
}

}  // namespace

// Batteries, razors, brushes, small hardware: a card that hangs from a peg, the goods under a hood.
Result<ProductModel> make_blister(const Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  BlisterSurfaces s{};
  s.card = pack.add_surface({.color = colors.primary, .roughness = gloss_paper_roughness});
  s.edge = pack.add_surface(paper({0.8F, 0.79F, 0.76F}));
  s.print = pack.add_print(gloss_paper_roughness);
  const float w = pack.width(), d = pack.depth(), h = pack.height();
  const float thick = std::min(greatest_card_m, 0.08F * d),
              wall_y = d / 2 - thick - blister_label_m;
  const Vec3f hood{0.86F * w, d - thick - 2 * blister_label_m, (blister_bubble_high - 0.07F) * h};
  const float low = 0.04F * h;
  const bool batteries = holds(product, "batter"), brush = holds(product, "brush");
  if (batteries || brush || holds(product, "razor")) {
    s.metal = pack.add_surface(brush ? plastic(colors.secondary) : aluminium());
    s.goods = pack.add_surface(plastic(colors.accent));
    s.clear = pack.add_surface(plastic(tray_grey));
    add_hood(pack, wall_y, {hood.x, 0.12F * hood.y, hood.z}, low, s.clear);
    const Vec3f room{0.92F * hood.x, hood.y, hood.z};
    if (batteries)
      add_batteries(pack, wall_y, room, low, s);
    else
      add_handle(pack, wall_y, room, low, brush, s);
  } else {
    s.goods = pack.add_surface(filled_plastic(colors.accent));
    add_hood(pack, wall_y, hood, low, s.goods);
  }
  add_card(pack, thick, s);
  return pack.finish();
}

CollisionPrimitive collision_blister(const Product& product) {
  return box_around(product);
}

}  // namespace marketgen
