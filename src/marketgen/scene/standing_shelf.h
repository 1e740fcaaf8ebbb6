// A shelf as it stands, said as a planogram says it.
#pragma once
#include <vector>

#include "catalog/catalog.h"
#include "plan/plan.h"
#include "scene/scene.h"
#include "scene/stocked_shelf.h"

namespace marketgen::scene {

// A block whose facings are packs, or loose pieces, that stand side by side, as a plan says it. Of
// loose goods counts above and behind one another are how they came to lie: they are left out.
plan::ShelfBlock said_block(plan::ShelfBlock standing, const catalog::Catalog& catalog);

// Rounded to millimetres; places of the scene are floats, which are off by micrometres.
bool is_at(int x_mm, double metres);

// Without what the stocker does of itself on that shelf. The blocks fit it.
std::vector<plan::ShelfBlock> least_pinned(std::vector<plan::ShelfBlock> blocks,
                                           const ShelfPlace& place,
                                           const plan::StockSpec& stock,
                                           const catalog::Catalog& catalog);

// What the shelf holds, block by block, and no more than the stocker would do otherwise. `plan` is
// the scene's.
plan::StockedShelf standing_shelf(const Scene& scene,
                                  std::uint32_t shelf,
                                  const ShelfPlace& place,
                                  const plan::Plan& plan,
                                  const catalog::Catalog& catalog);

// How its zone stocks the shelf.
const plan::StockSpec& stock_of(const Scene& scene, std::uint32_t shelf, const plan::Plan& plan);

}  // namespace marketgen::scene
