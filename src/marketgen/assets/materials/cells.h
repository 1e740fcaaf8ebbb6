// Random cells that tile the texture (Worley noise): crystals, granules, broken slabs.
#pragma once
#include <vector>

#include "assets/materials/pattern_sheet.h"

namespace marketgen::assets {

// The cell under a texel.
struct Cell {
  std::uint32_t id = 0;
  float border_mm = 0;  // to the nearest point of the cell's border
  float middle_mm = 0;  // to the cell's own point
};

// Cells of about `size_mm`; `jitter` 0 is a square grid, 1 as random as it gets; borders wander by
// `bend_mm`. Row-major, one a texel.
std::vector<Cell> scatter_cells(const PatternSheet& sheet,
                                std::string_view name,
                                float size_mm,
                                float jitter = 0.9F,
                                float bend_mm = 0);

}  // namespace marketgen::assets
