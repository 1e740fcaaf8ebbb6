#include "assets/shapes/archetypes/tin_parts.h"

#include <algorithm>

#include "assets/shapes/archetypes/panel_box.h"
#include "assets/shapes/archetypes/shell.h"
#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr float greatest_ring_radius_m = 0.0115F;  // takes a finger tip

// A ring in the plane z = 0 about `middle`.
TubeForm ring_form(Vec3f middle, float radius, float across, float thick) {
  TubeForm ring;
  ring.closed = true;
  constexpr int knots = 8;
  for (int i = 0; i < knots; ++i) {
    const Vec2 direction = unit_circle(static_cast<double>(i) / knots);
    const Vec3f at{radius * static_cast<float>(direction.x),
                   1.15F * radius * static_cast<float>(direction.y),
                   0};
    ring.knots.push_back({middle + at, across, thick});
  }
  return ring;
}

}  // namespace

void add_tin_foot(Profile& profile, float seam, float wall_low, float wall, std::uint16_t metal) {
  profile.use(metal)
      .pole(0.5F * seam)
      .body(0.5F * seam, 0.94F)
      .body(0, 0.97F)
      .body(0.15F * seam, 1)
      .body(seam, 1)
      .body(wall_low, wall);
}

float add_tin_lid(Profile& profile, float height, float seam, float panel, std::uint16_t metal) {
  const float h = height, recess = h - 0.7F * seam;
  profile.use(metal)
      .body(h - seam, 1)
      .body(h - 0.15F * seam, 1)
      .body(h, 0.97F)
      .body(h - 0.1F * seam, 0.94F);
  profile.body(recess, 0.92F).body(recess, panel + 0.03F).body(recess + 0.2F * seam, panel);
  return recess + 0.2F * seam;
}

void add_ring_pull(
    PackBuilder& pack, float lid, float radius_m, std::uint16_t metal, const PartFrame& tin) {
  const float ring = std::min(greatest_ring_radius_m, 0.27F * radius_m);
  const float thick = 0.055F * ring, z = lid + 2.2F * thick;
  const float middle = -0.30F * radius_m, tongue = 1.7F * ring;
  add_tube(
      pack, {.surface = metal}, 8, 20, ring_form({0, middle, z}, ring, 0.19F * ring, thick), tin);
  PartFrame nose = tin;
  nose.origin = tin({0, middle + 0.95F * ring + 0.5F * tongue, lid});
  add_plain_box(pack, {1.15F * ring, tongue, 3.2F * thick}, thick, metal, nose);
}

}  // namespace marketgen::assets
