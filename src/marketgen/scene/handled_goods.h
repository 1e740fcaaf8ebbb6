// How shoppers leave the packs that stand behind those they take.
//
// Whoever takes a pack leaves the next one of its column out of line with the chance `jitter` of
// the zone's stock. Of the columns of which n packs were taken since staff last faced the shelf up,
//
//   1 - (1 - jitter)^n
//
// are out of line: turnover and hour make n. Of these, 3 in 100 are topped by a product of another
// shelf that somebody put down there; 8 in 100 of what is more than 2.2 times as high as deep lie
// on their face, where they have room for it; 25 in 100 of what is more than 3.3 times as high as
// deep lean on the pack behind them; all others, and those without room, were pulled forward and
// turned, boxes by 25 degrees at most and what is round by any angle. No source has these shares;
// what is usual. Nothing of it where jitter is 0.
#pragma once
#include <vector>

#include "base/seed.h"
#include "catalog/catalog.h"
#include "scene/planogram.h"
#include "scene/shelf_fill.h"
#include "scene/sold_goods.h"

namespace marketgen::scene {

// What was sold of one shelf: by block, as its blocks list their columns.
using SoldOfShelf = std::vector<TakenInFront>;

// Moves foremost packs of the columns that shoppers took from; every other pack stays where it is.
// Packs keep at least 1 mm from one another, but for one that leans, and stay within the shelf.
// `certain` blocks of `planned` are never topped by another product. Seeds are the shelf's:
// `handled` of how packs stand, `strange` of which were put down there.
void handle_goods(std::vector<FilledBlock>& blocks,
                  const SoldOfShelf& sold,
                  const PlannedShelf& planned,
                  const ShelfRoom& room,
                  double jitter,
                  const catalog::Catalog& catalog,
                  Seed handled,
                  Seed strange);

}  // namespace marketgen::scene
