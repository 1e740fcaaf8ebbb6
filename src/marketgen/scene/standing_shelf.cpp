#include "scene/standing_shelf.h"

#include <algorithm>
#include <cmath>

#include "plan/shelf_key.h"
#include "scene/bays.h"
#include "scene/shelf_fill.h"

namespace marketgen::scene {

plan::ShelfBlock said_block(plan::ShelfBlock standing, const catalog::Catalog& catalog) {
  const catalog::Product& product = *catalog.product(standing.sku);
  standing.facings = facings_as_wide(product, catalog, standing.facings);
  if (!lies_in_a_heap(product)) return standing;
  standing.facings_high.reset();
  standing.facings_deep.reset();
  return standing;
}

bool is_at(int x_mm, double metres) {
  constexpr double half_mm = 0.51;
  return std::abs(x_mm - metres * 1e3) <= half_mm;
}

std::vector<plan::ShelfBlock> least_pinned(std::vector<plan::ShelfBlock> blocks,
                                           const ShelfPlace& place,
                                           const plan::StockSpec& stock,
                                           const catalog::Catalog& catalog) {
  PlannedShelf spread = stocked_shelf(blocks, place, catalog).shelf;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const catalog::Product& product = catalog.products[spread[i].product];
    plan::ShelfBlock& block = blocks[i];
    if (block.facings_high == stack_height(product, place.room)) block.facings_high.reset();
    if (block.facings_deep == rows_that_fit(product, place.room, stock.depth_fill))
      block.facings_deep.reset();
    spread[i].x_m.reset();
  }
  const std::vector<double> starts = block_starts(spread, place.room, catalog);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (blocks[i].x_mm && !is_at(*blocks[i].x_mm, starts[i] + place.left_m)) return blocks;
  }
  for (plan::ShelfBlock& block : blocks)
    block.x_mm.reset();
  return blocks;
}

const plan::StockSpec& stock_of(const Scene& scene, std::uint32_t shelf, const plan::Plan& plan) {
  const layout::Fixture& fixture = scene.layout.fixtures[scene.shelves[shelf].fixture];
  return zone_or_usual(plan, fixture.zone).stock;
}

plan::StockedShelf standing_shelf(const Scene& scene,
                                  std::uint32_t shelf,
                                  const ShelfPlace& place,
                                  const plan::Plan& plan,
                                  const catalog::Catalog& catalog) {
  const SceneShelf& row = scene.shelves[shelf];
  std::vector<plan::ShelfBlock> blocks;
  for (const Facing& facing : scene.facings) {
    if (facing.shelf != shelf) continue;
    const double left_m = facing.x_m + place.left_m;
    blocks.push_back(said_block({scene.catalog[facing.sku].sku,
                                 facing.facings,
                                 static_cast<int>(std::lround(left_m * 1e3)),
                                 facing.stack,
                                 facing.rows_deep},
                                catalog));
  }
  return {scene.layout.fixtures[row.fixture].id,
          plan::shelf_side(row.side),
          row.level + 1,
          least_pinned(std::move(blocks), place, stock_of(scene, shelf, plan), catalog)};
}

}  // namespace marketgen::scene
