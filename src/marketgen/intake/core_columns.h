// The core of a store: gondola zones side by side in columns of parallel runs, sized so that runs
// and aisles alternate without leftover floor.
#pragma once
#include <vector>

#include "intake/slices.h"
#include "intake/store_program.h"

namespace marketgen::intake {

struct CoreRoom {
  int width_mm = 0, depth_mm = 0;
  int run_aisle_mm = 0;
  bool wall_west = false,
       wall_east = false;  // the room reaches to the store's wall, which will be lined with shelves
};

struct Core {
  Slice slice;
  int run_aisle_mm = 0;  // as it came out
  int runs = 0;
  double crowding = 0;  // metres that columns lack
};

constexpr int min_cell_mm = 2600;  // of a zone in a column: two sections of a gondola

// `zones` from west to east. `stacked`: two zones a column where that leaves each deep enough.
// Precondition: zones not empty.
Core make_core(const std::vector<int>& zones,
               const StoreProgram& program,
               const CoreRoom& room,
               bool stacked);

}  // namespace marketgen::intake
