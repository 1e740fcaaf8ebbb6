// Which goods each bay of a zone has, and how much room on its shelves: plan::ShelfPitch::fitted.
//
// The front of all bays of a zone (of one temperature) is shared out among its kinds of goods by
// scene/shelf_shares.h, and a kind's front among its goods by how much they are asked for: those
// that are asked for least find no room. Kinds follow one another along the bays in the order of
// the assortment; a bay has those of its stretch.
#pragma once
#include <cstdint>
#include <set>
#include <vector>

#include "base/seed.h"
#include "catalog/catalog.h"
#include "plan/plan.h"
#include "scene/planogram.h"

namespace marketgen::scene {

// A product and how much of the bay's front it has, all boards together.
struct RangedGoods {
  std::uint32_t product = 0;  // row of catalog.products
  double front_m = 0;
};
using BayRange = std::vector<RangedGoods>;  // in the assortment's order

// On boards for heaps no block is narrower: fewer pieces across make a row, not a heap.
double min_heap_front_m(const catalog::Product& product);

// What a zone's bays are given.
struct RangeWish {
  const std::vector<std::uint32_t>& assortment;  // rows of catalog.products, in their order
  const plan::StockSpec& stock;
  bool small_shop = false;
  std::set<std::uint32_t> certain;  // rows of catalog.products that must be among them
};

// One range for each of `bays`, which follow one another as shoppers meet them. `fronts_m`: of each
// bay, all boards together. Only goods that a bay of the zone holds are given out. Which of the
// goods that are asked for nearly as much find room is drawn from `seed`.
std::vector<BayRange> ranges_of(const std::vector<const Bay*>& bays,
                                const std::vector<double>& fronts_m,
                                const RangeWish& wish,
                                const catalog::Catalog& catalog,
                                Seed seed);

}  // namespace marketgen::scene
