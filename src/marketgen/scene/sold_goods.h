// Goods that shoppers took, off a block as staff left it.
#pragma once
#include <vector>

#include "base/seed.h"
#include "scene/sales.h"
#include "scene/shelf_fill.h"

namespace marketgen::scene {

// Packs that it holds when full; a heap, which has no rows to count, what lies in it.
int capacity_of(const FilledBlock& block, bool heaped);

// Packs taken of each column since staff last faced it up: of those that still hold something, as
// the block lists them. None of a heap.
using TakenInFront = std::vector<int>;

// Takes what is wanted of it away, as far as it is there: a column's foremost pack first, the upper
// one of a stack before the lower; of a heap the topmost pieces. Where goods were pulled forward
// since, the rear packs are missing. Of what is left nothing moves. `leaves_one`: the last one
// stays.
TakenInFront take_sold(
    FilledBlock& block, UnitsWanted wanted, bool heaped, bool leaves_one, Stream draw);

}  // namespace marketgen::scene
