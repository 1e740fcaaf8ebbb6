#include "assets/shapes/archetypes/panel_box.h"

#include <algorithm>

#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

// One face of the box: which share runs to the right and which down as seen from outside, and which
// stands still.
struct BoxSide {
  PanelKind kind;
  int right_axis, down_axis, fixed_axis;
  bool right_mirrored, down_mirrored;  // the share falls along that direction
  float fixed;
};

constexpr BoxSide box_sides[] = {
    {PanelKind::front, 0, 2, 1, false, true, 0},
    {PanelKind::right, 1, 2, 0, false, true, 1},
    {PanelKind::back, 0, 2, 1, true, true, 1},
    {PanelKind::left, 1, 2, 0, true, true, 0},
    {PanelKind::top, 0, 1, 2, false, true, 1},
    {PanelKind::bottom, 0, 1, 2, false, false, 0},
};

std::uint16_t surface_of(const BoxSurfaces& surfaces, PanelKind kind) {
  switch (kind) {
    case PanelKind::right:
      return surfaces.right;
    case PanelKind::back:
      return surfaces.back;
    case PanelKind::left:
      return surfaces.left;
    case PanelKind::top:
      return surfaces.top;
    case PanelKind::bottom:
      return surfaces.bottom;
    default:
      return surfaces.front;
  }
}

const std::vector<float>& lines_along(const BoxGrid& grid, int axis) {
  return axis == 0 ? grid.x : axis == 1 ? grid.y : grid.z;
}

void set_share(Vec3f& share, int axis, float value) {
  (axis == 0 ? share.x : axis == 1 ? share.y : share.z) = value;
}

// Shares of the lines in reading direction.
std::vector<float> reading_lines(const std::vector<float>& lines, bool mirrored) {
  std::vector<float> ordered = lines;
  if (mirrored) std::reverse(ordered.begin(), ordered.end());
  return ordered;
}

}  // namespace

void add_panel_box(PackBuilder& pack,
                   const BoxGrid& grid,
                   const BoxSurfaces& surfaces,
                   const BoxShape& shape,
                   const Placement& place) {
  for (const BoxSide& side : box_sides) {
    const std::uint16_t surface = surface_of(surfaces, side.kind);
    const Panel* panel = pack.is_print(surface) ? pack.panel(side.kind) : nullptr;
    const std::vector<float> across =
        reading_lines(lines_along(grid, side.right_axis), side.right_mirrored);
    const std::vector<float> down =
        reading_lines(lines_along(grid, side.down_axis), side.down_mirrored);
    const auto corner = [&](std::size_t i, std::size_t j) {
      Vec3f share;
      set_share(share, side.fixed_axis, side.fixed);
      set_share(share, side.right_axis, across[i]);
      set_share(share, side.down_axis, down[j]);
      const float u = side.right_mirrored ? 1 - across[i] : across[i];
      const float v = side.down_mirrored ? 1 - down[j] : down[j];
      return Corner{place(shape(share)), uv_in(panel, u, v)};
    };
    for (std::size_t i = 0; i + 1 < across.size(); ++i) {
      for (std::size_t j = 0; j + 1 < down.size(); ++j) {
        pack.add_quad(
            corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j), corner(i, j), surface);
      }
    }
  }
}

std::vector<float> rounded_lines(float length, float radius, int arc, int inner) {
  const float r = std::min(radius / length, 0.49F);
  std::vector<float> lines;
  for (int i = 0; i <= arc; ++i) {  // equal angles: 45 degrees at the edge down to 0
    const Vec2 direction = unit_circle(0.125 * (arc - i) / arc);
    lines.push_back(r * (1.0F - static_cast<float>(direction.y / direction.x)));
  }
  for (int i = 1; i < inner; ++i) {
    lines.push_back(r + (1 - 2 * r) * static_cast<float>(i) / static_cast<float>(inner));
  }
  const auto half = static_cast<std::size_t>(arc);
  for (std::size_t i = 0; i <= half; ++i)
    lines.push_back(1.0F - lines[half - i]);
  return lines;
}

std::vector<float> even_lines(int cells) {
  std::vector<float> lines;
  for (int i = 0; i <= cells; ++i)
    lines.push_back(static_cast<float>(i) / static_cast<float>(cells));
  return lines;
}

Vec3f rounded_box_point(Vec3f share, Vec3f size, float radius) {
  const float r = std::min(radius, 0.49F * std::min({size.x, size.y, size.z}));
  const Vec3f on_box = share * size;
  const Vec3f core{std::clamp(on_box.x, r, size.x - r),
                   std::clamp(on_box.y, r, size.y - r),
                   std::clamp(on_box.z, r, size.z - r)};
  const Vec3f rounded = core + normalized(on_box - core) * r;
  return rounded - Vec3f{size.x / 2, size.y / 2, 0};
}

void add_plain_box(
    PackBuilder& pack, Vec3f size, float radius, std::uint16_t surface, const Placement& place) {
  const BoxGrid grid{rounded_lines(size.x, radius, 1, 1),
                     rounded_lines(size.y, radius, 1, 1),
                     rounded_lines(size.z, radius, 1, 1)};
  add_panel_box(
      pack,
      grid,
      {surface, surface, surface, surface, surface, surface},
      [&](Vec3f share) { return rounded_box_point(share, size, radius); },
      place);
}

}  // namespace marketgen::assets
