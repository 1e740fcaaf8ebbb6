#include "assets/shapes/archetypes/film_wrap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr int corner_chords = 5;               // of half a corner
constexpr float greatest_dip_share = 0.11F;    // of a piece's radius: film is stretched, not slack
constexpr float dip_half_width_share = 0.62F;  // of a piece's radius

constexpr std::array<PanelKind, 4> sides{
    PanelKind::front, PanelKind::right, PanelKind::back, PanelKind::left};

Vec2f turned(Vec2f p, int quarters) {
  for (int i = 0; i < quarters; ++i)
    p = {-p.y, p.x};
  return p;
}

// How far the film sinks at a distance from the line where two pieces meet.
float dip_at(float distance, float radius) {
  const float t = std::max(0.0F, 1 - std::abs(distance) / (dip_half_width_share * radius));
  return greatest_dip_share * radius * t * t;
}

// One side of a rectangle of width w whose face lies at y = -half: from the middle of its left
// corner to the middle of its right one.
std::vector<OutlinePoint> front_side(float w, float half, float radius, int pieces) {
  std::vector<OutlinePoint> side;
  const auto add_corner = [&](float center_x, int i, double from_turn) {
    const Vec2 direction = unit_circle(from_turn + 0.125 * i / corner_chords);
    const Vec2f out{static_cast<float>(direction.x), static_cast<float>(direction.y)};
    side.push_back({Vec2f{center_x, radius - half} + out * radius, out});
  };
  for (int i = 0; i <= corner_chords; ++i)
    add_corner(radius - w / 2, i, 0.625);
  const float pitch = w / static_cast<float>(pieces);
  for (int p = 1; p < pieces; ++p) {
    const float middle = -w / 2 + pitch * static_cast<float>(p);
    for (const float step : {-1.0F, -0.66F, -0.36F, -0.12F, 0.12F, 0.36F, 0.66F, 1.0F}) {
      const float distance = step * dip_half_width_share * radius;
      side.push_back({{middle + distance, -half + dip_at(distance, radius)}, {0, -1}});
    }
  }
  for (int i = 0; i <= corner_chords; ++i)
    add_corner(w / 2 - radius, i, 0.75);
  return side;
}

std::vector<OutlineSide> outline_of(const PackBuilder& pack, const FilmForm& form) {
  std::vector<OutlineSide> outline;
  for (int quarters = 0; quarters < 4; ++quarters) {
    const bool wide = quarters % 2 == 0;
    OutlineSide side;
    side.panel = pack.panel(sides[static_cast<std::size_t>(quarters)]);
    side.points = front_side(wide ? pack.width() : pack.depth(),
                             (wide ? pack.depth() : pack.width()) / 2,
                             0.995F * form.piece_radius_m,
                             wide ? form.across : form.deep);
    for (OutlinePoint& p : side.points)
      p = {turned(p.at, quarters), turned(p.out, quarters)};
    measure(side);
    outline.push_back(std::move(side));
  }
  return outline;
}

}  // namespace

void add_film_wall(PackBuilder& pack, const FilmForm& form, const std::vector<WallLevel>& levels) {
  add_outline_wall(pack, outline_of(pack, form), levels);
}

Vec3f piece_place(const PackBuilder& pack, const FilmForm& form, int i, int k) {
  const auto middle = [](int at, int count, float length) {
    return ((static_cast<float>(at) + 0.5F) / static_cast<float>(count) - 0.5F) * length;
  };
  return {middle(i, form.across, pack.width()), middle(k, form.deep, pack.depth()), 0};
}

}  // namespace marketgen::assets
