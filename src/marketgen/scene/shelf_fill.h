// Single items: a planned shelf made into packs that stand beside, behind and on one another
// without touching sideways.
#pragma once
#include <cstdint>
#include <vector>

#include "base/seed.h"
#include "catalog/catalog.h"
#include "geometry/pose.h"
#include "plan/plan.h"
#include "scene/planogram.h"

namespace marketgen::scene {

// Of a scene: a shop of 200 x 200 m holds five million. build_scene refuses more (scene.too_large).
constexpr std::uint64_t max_scene_products = 8'000'000;

// An item in the shelf frame.
struct ShelfItem {
  std::uint32_t product = 0;  // row of catalog.products
  Vec3 position;              // shelf frame
  Quaternion rotation;
  std::uint32_t flags = 0;  // product_front_row
  int layer = 0;            // of a heap: what lies on others is of a higher one
};

// A block as it really stands.
struct FilledBlock {
  std::uint32_t product = 0;
  double x_m = 0, width_m = 0;  // left edge and width on the shelf
  int facings = 1, rows_deep = 1, stack = 1;
  std::vector<ShelfItem> items;  // empty when out of stock
};

// Loose goods that are heaped rather than stacked in rows.
bool lies_in_a_heap(const catalog::Product& product);

// Those of them that lie as balls do, any way round: they have settled heaps (catalog/heap.h).
bool lies_as_balls(const catalog::Product& product);

// The most items that the block could be of: what is sold, and what lies loose, only makes it less.
std::uint64_t max_items(const PlannedBlock& block,
                        const ShelfRoom& room,
                        const plan::StockSpec& stock,
                        const catalog::Catalog& catalog);

// Rows of packs one behind another that fill this share of the depth; at least one.
int rows_that_fit(const catalog::Product& product, const ShelfRoom& room, double depth_fill);

// How wide a block is, gaps between its packs included; metres.
double block_width_m(const PlannedBlock& block, const catalog::Catalog& catalog);

// The fewest facings whose block has `columns` packs side by side: of loose goods that settled in
// no heap, more or fewer lie beside one another than packs would stand there.
int facings_as_wide(const catalog::Product& product, const catalog::Catalog& catalog, int columns);

// Left edges of the blocks, from the shelf's left end: where the planogram has them, or spread so
// that the shelf looks evenly filled.
std::vector<double> block_starts(const PlannedShelf& plan,
                                 const ShelfRoom& room,
                                 const catalog::Catalog& catalog);

// Fills one shelf. Every item lies inside the shelf's width, depth and clearance, and keeps at
// least 1 mm from items of other columns and rows; stacked items rest on one another. Heaps (loose
// produce) lie in layers, each in the pockets of the one below.
std::vector<FilledBlock> fill_shelf(const PlannedShelf& plan,
                                    const ShelfRoom& room,
                                    const plan::StockSpec& stock,
                                    const catalog::Catalog& catalog,
                                    Stream draw);

}  // namespace marketgen::scene
