#include "assets/shapes/archetypes/plate.h"

#include <algorithm>
#include <array>
#include <vector>

#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr int corner_chords = 4;
constexpr float bevel_share = 0.25F;  // of the thickness

// A rounded rectangle as points in matching order: counter-clockwise from the right lower corner.
std::vector<Vec2f> rounded_loop(Vec2f middle, Vec2f size, float radius) {
  const float r = std::min(radius, 0.499F * std::min(size.x, size.y));
  std::vector<Vec2f> loop;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const float side_x = quarter == 0 || quarter == 1 ? 1.0F : -1.0F;
    const float side_z = quarter == 1 || quarter == 2 ? 1.0F : -1.0F;
    const Vec2f center{middle.x + side_x * (size.x / 2 - r), middle.y + side_z * (size.y / 2 - r)};
    for (int i = 0; i <= corner_chords; ++i) {
      const Vec2 d = unit_circle(-0.25 + 0.25 * quarter + 0.25 * i / corner_chords);
      loop.push_back(center + Vec2f{static_cast<float>(d.x), static_cast<float>(d.y)} * r);
    }
  }
  return loop;
}

// The plate is a closed ring of rings: front edge of the outline, its bevels, back, and through the
// hole again.
struct Ring {
  std::vector<Vec2f> loop;
  float y;
};

std::vector<Ring> rings_of(const PlateForm& form) {
  const float bevel =
      std::min({bevel_share * form.size.y, 0.05F * form.hole_size.x, 0.05F * form.hole_size.y});
  const auto outline = [&](float inset) {
    return rounded_loop(
        {0, form.size.z / 2}, {form.size.x - 2 * inset, form.size.z - 2 * inset}, form.corner_m);
  };
  const auto hole = [&](float inset) {
    return rounded_loop(form.hole_middle,
                        {form.hole_size.x + 2 * inset, form.hole_size.y + 2 * inset},
                        form.hole_corner_m + inset);
  };
  const float back = form.size.y;
  return {{outline(bevel), 0},
          {outline(0), bevel},
          {outline(0), back - bevel},
          {outline(bevel), back},
          {hole(bevel), back},
          {hole(0), back - bevel},
          {hole(0), bevel},
          {hole(bevel), 0}};
}

}  // namespace

void add_holed_plate(PackBuilder& pack,
                     const PlateForm& form,
                     std::uint16_t surface,
                     const Placement& place) {
  const std::vector<Ring> rings = rings_of(form);
  const std::size_t count = rings.front().loop.size();
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const Ring &here = rings[r], &next = rings[(r + 1) % rings.size()];
    for (std::size_t k = 0; k < count; ++k) {
      const auto corner = [&](const Ring& ring, std::size_t at) {
        const Vec2f p = ring.loop[at % count];
        return Corner{place({p.x, ring.y, p.y}),
                      {std::clamp(0.5F + p.x / form.size.x, 0.0F, 1.0F),
                       std::clamp(1 - p.y / form.size.z, 0.0F, 1.0F)}};
      };
      pack.add_quad(
          corner(here, k + 1), corner(here, k), corner(next, k), corner(next, k + 1), surface);
    }
  }
}

void add_sticker(PackBuilder& pack,
                 const Panel* panel,
                 Vec3f size,
                 std::uint16_t print,
                 std::uint16_t edge,
                 const Placement& place) {
  const auto corner = [&](float u, float v, float y, const Panel* on) {
    return Corner{place({(u - 0.5F) * size.x, y, (1 - v) * size.z}), uv_in(on, u, v)};
  };
  constexpr std::array<Vec2f, 4> around{{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
  const auto at = [&](std::size_t i, float y, const Panel* on) {
    return corner(around[i % 4].x, around[i % 4].y, y, on);
  };
  pack.add_quad(at(0, 0, panel), at(1, 0, panel), at(2, 0, panel), at(3, 0, panel), print);
  pack.add_quad(at(3, size.y, nullptr),
                at(2, size.y, nullptr),
                at(1, size.y, nullptr),
                at(0, size.y, nullptr),
                edge);
  for (std::size_t i = 0; i < 4; ++i) {
    pack.add_quad(at(i + 1, 0, nullptr),
                  at(i, 0, nullptr),
                  at(i, size.y, nullptr),
                  at(i + 1, size.y, nullptr),
                  edge);
  }
}

}  // namespace marketgen::assets
