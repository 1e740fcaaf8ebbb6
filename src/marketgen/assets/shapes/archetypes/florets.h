// Heads of florets: a dome of round knobs that press against one another.
#pragma once
#include "assets/shapes/archetypes/shell.h"
#include "base/seed.h"

namespace marketgen::assets {

struct FloretDome {
  Vec3f middle, half;    // of the ellipsoid that the knobs stand out of
  double low = 0.3;      // the dome begins at this share of the way from pole to pole
  int knobs = 60;        // over the whole ellipsoid
  float relief = 0.13F;  // height of a knob, in radii
};
void add_floret_dome(PackBuilder& pack,
                     const ShellSkin& skin,
                     const FloretDome& form,
                     Stream draw,
                     const Placement& place = PartFrame{});

}  // namespace marketgen::assets
