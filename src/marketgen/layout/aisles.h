// Aisles: the walkable strips before fronts, between run ends and between lanes, and how wide they
// really are.
//
// Used by the rules (AISLE_TOO_NARROW), the picture and the signs.
#pragma once
#include <vector>

#include "layout/design.h"
#include "layout/layout.h"

namespace marketgen::layout {

constexpr int open_floor_mm = 6000;  // what is farther away borders no aisle
// An aisle is tight that is narrower than this share of what the profile has (AISLE_TIGHT).
constexpr double tight_aisle_share = 0.8;

// The narrowest that is lawful and not tight.
int min_untight_aisle_mm(const Design& design);

// Every aisle, sorted by id. Two strips that meet at a crossing are two aisles; strips split only
// by a joint are one. `width_mm` is the narrowest free width, doors of both sides standing open;
// open floor counts as open_floor_mm.
std::vector<Aisle> find_aisles(const Design& design, const std::vector<Fixture>& fixtures);

// Shoppers walk it from west to east: its width is measured along y.
bool runs_along_x(const Aisle& aisle);

}  // namespace marketgen::layout
