// Where an accessory may stand: spots to try, best first. Whether the floor bears one is for
// layout/floor_guard.h.
#pragma once
#include <vector>

#include "base/seed.h"
#include "layout/accessories.h"
#include "layout/empty_floor.h"
#include "layout/zone_build.h"

namespace marketgen::layout {

struct Spot {
  RectMm rect;
  Side front;
  int height_mm;    // of its top
  int foot_mm = 0;  // of its lowest part over the floor, of what the wall carries
};

// What stands together: all of them or none.
using SpotGroup = std::vector<Spot>;

struct SpotSearch {
  const Build& build;
  const ZoneBuild& zone;
  const Doorway* door;  // of what stands at one, else null
  const ModuleSpec& spec;
  const EmptyFloor& empty;
  Seed seed;
};

// Free floor that it needs before its front.
int clear_before_mm(const SpotSearch& search);

std::vector<SpotGroup> find_spots(const SpotSearch& search, AccessoryPlace place);

}  // namespace marketgen::layout
