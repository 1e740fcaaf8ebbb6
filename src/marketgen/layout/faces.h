// Stocked fronts: the unbroken lines of modules that shoppers stand before.
#pragma once
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "layout/layout.h"
#include "layout/side.h"

namespace marketgen::layout {

struct Face {
  std::string run;
  std::string zone;
  RectMm rect;  // footprint of the line
  Side front;
  int door_swing_mm = 0;  // of the widest door on it
  catalog::FixtureRole role = catalog::FixtureRole::shelving;
  bool endcap = false;
};

// Whether `high` follows on `low` in one line, with no more than a joint between them.
bool stand_together(const Fixture& low, const Fixture& high);

// One per front: a double-sided line gives two. A gap of more than a joint begins a new line.
// Sorted by run, then place.
std::vector<Face> faces_of(const std::vector<Fixture>& fixtures, const catalog::Catalog& catalog);

// Sets run_start and run_end by what really stands beside each module.
void mark_run_ends(std::vector<Fixture>& fixtures);

}  // namespace marketgen::layout
