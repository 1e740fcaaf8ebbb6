// A layout as a model can read it: a picture with marks, and the same in letters for models that
// see no pictures. Zone i of Layout::zones is called by the same letter in both.
#pragma once
#include <cstddef>
#include <string>

#include "catalog/catalog.h"
#include "geometry/image.h"
#include "layout/layout.h"

namespace marketgen::layout {

constexpr int visual_prompt_px = 1024;

// 'A', 'B' … At most 24 zones stand in a plan.
char mark_of_zone(std::size_t index);

// 1024 x 1024, orthographic, north up, of the parts of draw_layout: zones in their palette with
// lettered marks, fixtures with front arrows, openings, aisle widths, the path from entrance to
// checkout to exit, violations numbered as in Layout::violations, and 5 x 5 dots that say where
// they are in metres east and north. Deterministic.
Image draw_visual_prompt(const Layout& layout, const catalog::Catalog& catalog);

// North up, one character a cell of at least 0.5 m: a zone's mark where its fixtures stand, the
// same letter small on its free floor, '.' other floor, 'o' columns, ' ' outside; on the border '#'
// walls,
// '=' entrances, '-' exits, '+' other doors, '~' windows. At most 100 cells wide and high, with a
// line that says how large a cell is.
std::string ascii_plan(const Layout& layout);

}  // namespace marketgen::layout
