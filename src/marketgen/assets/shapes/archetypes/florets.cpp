#include "assets/shapes/archetypes/florets.h"

#include <algorithm>
#include <cmath>

#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

struct Knob {
  Vec3f toward;  // unit
  float size;
};

// Spread evenly by the golden angle, each a little off its place.
std::vector<Knob> spread_knobs(int count, Stream draw) {
  constexpr double golden_turn = 0.381966;
  std::vector<Knob> knobs;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double ring = std::sqrt(1 - z * z);
    const Vec2 out = unit_circle(i * golden_turn);
    const double jitter = 0.25 / std::sqrt(static_cast<double>(count));
    const Vec3 at{out.x * ring + draw.uniform(-jitter, jitter),
                  out.y * ring + draw.uniform(-jitter, jitter),
                  z + draw.uniform(-jitter, jitter)};
    knobs.push_back({to_float(normalized(at)), static_cast<float>(draw.uniform(0.75, 1.2))});
  }
  return knobs;
}

// Height of the knobs in direction `d`: balls of which the highest shows.
float knob_height(const std::vector<Knob>& knobs, Vec3f d) {
  const float reach = 3.3F / static_cast<float>(knobs.size());  // of 1 - cos, over a knob's share
  float height = 0;
  for (const Knob& knob : knobs) {
    const float off = (1 - dot(d, knob.toward)) / (reach * knob.size);
    if (off < 1) height = std::max(height, knob.size * std::sqrt(1 - off));
  }
  return height;
}

}  // namespace

void add_floret_dome(PackBuilder& pack,
                     const ShellSkin& skin,
                     const FloretDome& form,
                     Stream draw,
                     const Placement& place) {
  const std::vector<Knob> knobs = spread_knobs(form.knobs, draw);
  constexpr int segments = 52, bands = 28;
  const ShellPoint point = [&](double turn, double along) {
    const double polar = form.low + (1 - form.low) * along;
    const Vec2 around = unit_circle(0.25 + turn), rise = unit_circle(-0.25 + 0.5 * polar);
    const Vec3f d = to_float({rise.x * around.x, rise.x * around.y, rise.y});
    // The underside is drawn in to the stalk.
    if (along <= 0)
      return place(form.middle + Vec3f{0, 0, static_cast<float>(rise.y) + 0.25F} * form.half);
    const float off = 1 - form.relief + form.relief * knob_height(knobs, d);
    return place(form.middle + d * form.half * off);
  };
  add_shell(pack, skin, {segments, even_stations(bands)}, point);
}

}  // namespace marketgen::assets
