#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/loft.h"
#include "assets/shapes/archetypes/pack_faces.h"
#include "assets/shapes/archetypes/panel_box.h"
#include "assets/shapes/archetypes/plate.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/shell.h"
#include "assets/shapes/archetypes/surfaces.h"
#include "base/text.h"

namespace marketgen::assets {
namespace {

constexpr float greatest_card_m = 0.0012F;  // thickness
constexpr float blister_label_m = 0.00015F;
constexpr Vec3f tray_grey{0.62F, 0.64F, 0.66F};

struct BlisterSurfaces {
  std::uint16_t card, edge, print, clear, goods, metal;
};

bool holds(const catalog::Product& product, std::string_view word) {
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
  add_loft(pack, sections, {.triangles = 900, .max_chords = 7}, frame);
}

// A battery as IEC 60086-2 has it: greatest radius and length; `block`: 9 V, half its width across.
struct Cell {
  std::string_view name;
  float radius_m, length_m;
  bool block = false, coin = false;
};
constexpr Cell cells[] = {{"AA", 0.00725F, 0.0505F},
                          {"AAA", 0.00525F, 0.0445F},
                          {"C", 0.0131F, 0.0500F},
                          {"D", 0.0171F, 0.0615F},
                          {"9 V", 0.01325F, 0.0485F, true},
                          {"CR2032", 0.0100F, 0.0032F, false, true}};

Cell cell_of(const catalog::Product& product) {
  const auto found = std::ranges::find(cells, product.variant, &Cell::name);
  return found == std::end(cells) ? cells[0] : *found;
}

// How many the pack says it holds ("4 pieces").
int cells_in(const catalog::Product& product) {
  return std::clamp(std::atoi(product.net.c_str()), 1, 8);
}

// A ring of a round cell: at a share of its length, with a share of its radius.
Section ring_of(const Cell& cell, float z, float share, std::uint16_t surface) {
  return {.z = z * cell.length_m,
          .half_width = share * cell.radius_m,
          .half_depth = share * cell.radius_m,
          .surface = surface};
}

void add_round_cell(PackBuilder& pack, const Cell& cell, Vec3f foot, const BlisterSurfaces& s) {
  add_loft(pack,
           {ring_of(cell, 0, 0.94F, s.goods),
            ring_of(cell, 0.012F, 1, s.goods),
            ring_of(cell, 0.66F, 1, s.metal),
            ring_of(cell, 0.955F, 1, s.metal),
            ring_of(cell, 0.965F, 0.93F, s.metal),
            ring_of(cell, 0.965F, 0.38F, s.metal),
            ring_of(cell, 0.995F, 0.36F, s.metal),
            ring_of(cell, 1, 0.30F, s.metal)},
           {.triangles = 420, .max_chords = 6},
           PartFrame{.origin = foot});
}

// Flat against the card, its pole to the reader.
void add_coin_cell(PackBuilder& pack, const Cell& cell, Vec3f middle, const BlisterSurfaces& s) {
  add_loft(pack,
           {ring_of(cell, 0, 1, s.metal),
            ring_of(cell, 0.8F, 1, s.metal),
            ring_of(cell, 1, 0.92F, s.metal)},
           {.triangles = 300, .max_chords = 5},
           PartFrame{.origin = middle, .x = {1, 0, 0}, .y = {0, 0, 1}, .z = {0, -1, 0}});
}

void add_block_cell(
    PackBuilder& pack, const Cell& cell, Vec3f foot, float deep, const BlisterSurfaces& s) {
  const float wide = 2 * cell.radius_m, body = 0.93F * cell.length_m;
  add_plain_box(pack, {wide, deep, body}, 0.001F, s.goods, PartFrame{.origin = foot});
  for (const float side : {-0.25F, 0.25F})
    add_plain_box(pack,
                  {0.3F * wide, 0.4F * deep, cell.length_m - body},
                  0.0005F,
                  s.metal,
                  PartFrame{.origin = foot + Vec3f{side * wide, 0, body}});
}

// Batteries lie side by side, poles up; nothing hides them but the film.
void add_batteries(PackBuilder& pack,
                   const catalog::Product& product,
                   float wall_y,
                   Vec3f room,
                   float low,
                   const BlisterSurfaces& s) {
  Cell cell = cell_of(product);
  const int count = cells_in(product);
  cell.radius_m = std::min({cell.radius_m,
                            0.5F * room.x / static_cast<float>(count),
                            cell.coin ? cell.radius_m : 0.5F * room.y});
  cell.length_m = std::min(cell.length_m, cell.coin ? 0.5F * room.y : 0.96F * room.z);
  const float pitch = std::min(2.5F * cell.radius_m, room.x / static_cast<float>(count));
  for (int i = 0; i < count; ++i) {
    const float x = (static_cast<float>(i) + 0.5F - 0.5F * static_cast<float>(count)) * pitch;
    const float foot = low + (room.z - cell.length_m) / 2;
    if (cell.coin)
      add_coin_cell(pack, cell, {x, wall_y - 0.3F * room.y, low + room.z / 2}, s);
    else if (cell.block)
      add_block_cell(pack, cell, {x, wall_y - 0.5F * room.y, foot}, 0.9F * room.y, s);
    else
      add_round_cell(pack, cell, {x, wall_y - room.y + cell.radius_m, foot}, s);
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
Result<ProductModel> make_blister(const catalog::Product& product) {
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
    const float tray = batteries ? w - 0.002F : hood.x;
    add_hood(pack, wall_y, {tray, 0.12F * hood.y, hood.z}, low, s.clear);
    const Vec3f room{batteries ? tray : 0.92F * hood.x, hood.y, hood.z};
    if (batteries)
      add_batteries(pack, product, wall_y, room, low, s);
    else
      add_handle(pack, wall_y, room, low, brush, s);
  } else {
    s.goods = pack.add_surface(clear_plastic(colors.accent));
    add_hood(pack, wall_y, hood, low, s.goods);
  }
  add_card(pack, thick, s);
  return pack.finish();
}

CollisionPrimitive collision_blister(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
