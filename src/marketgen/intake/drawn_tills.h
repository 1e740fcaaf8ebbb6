// Where tills stand that a drawing of zones does not have.
#pragma once
#include <optional>

#include "intake/store_program.h"

namespace marketgen::intake {

struct TillPlace {
  RectMm squares;  // of the map
  int giver = 0;   // zone whose floor it is, or ZoneMap::bare
  int lanes = 1;   // that have room there
};

// The end of a zone, or of bare floor, near `door` (in squares of the map), that costs the drawing
// little and has room for the program's tills; for fewer lanes where nobody asked for so many.
// `map` is in terms of the program's zones. Nothing when no zone has room for one lane.
std::optional<TillPlace> place_for_tills(const drawing::ZoneMap& map,
                                         const StoreProgram& program,
                                         std::size_t tills,
                                         PointMm door,
                                         bool lanes_asked);

}  // namespace marketgen::intake
