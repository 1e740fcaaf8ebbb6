// Items that do not follow the planogram: those put in the wrong place, and those the plan pins to
// an exact pose.
//
// Both work on a scene whose SKU columns still hold rows of the whole catalogue.
#pragma once
#include "base/result.h"
#include "base/seed.h"
#include "catalog/catalog.h"
#include "plan/plan.h"
#include "scene/scene.h"

namespace marketgen::scene {

// Facing of an item that stands in no block.
constexpr std::uint32_t no_facing = 0xFFFFFFFF;

// Row of a product of another subcategory that is kept as that of `row` is and takes no more room;
// `row` itself where there is none.
std::uint32_t stranger_for(std::uint32_t row, const catalog::Catalog& catalog, Stream& draw);

// Swaps the product of some front items (stock.misplaced of each zone) for another that fits into
// their place.
void misplace_items(Scene& scene,
                    const plan::Plan& plan,
                    const catalog::Catalog& catalog,
                    Seed seed);

// Adds the plan's placements; generated items in their way are left out. Error: catalog.unknown_sku
// with the nearest name.
Result<void> add_placements(Scene& scene, const plan::Plan& plan, const catalog::Catalog& catalog);

}  // namespace marketgen::scene
