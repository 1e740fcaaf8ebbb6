// Floor where only staff goes: behind counters and desks, and in back rooms.
//
// The cashier's side of a checkout lane is part of the lane's footprint.
#pragma once
#include <string>
#include <vector>

#include "layout/layout.h"

namespace marketgen::layout {

// Behind a service counter, up to a wall or the back of another one: one person working, another
// passing (Neufert).
constexpr int staff_aisle_mm = 1000;
constexpr int desk_staff_mm = 800;  // behind a desk, for one person at work (Neufert)

// Staff serves from behind it.
bool is_counter(const catalog::FixtureKind& kind);

// How far its staff's floor reaches behind it; 0 without staff.
int staff_depth_mm(const catalog::FixtureKind& kind);

struct StaffFloor {
  std::string of;        // id of the fixture or zone
  PolygonMm polygon_mm;  // counter-clockwise; fixtures and walls may stand in it
};

// In the order of fixtures, then of zones. Kinds that the catalogue lacks have no staff.
std::vector<StaffFloor> staff_floor(const Layout& layout, const catalog::Catalog& catalog);

}  // namespace marketgen::layout
