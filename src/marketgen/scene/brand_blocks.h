// Bays that are stocked in brand blocks: plan::BlockPattern::brand_columns and brand_horizontal.
//
// A shopper who looks for a brand finds it in one place. brand_columns gives each brand of a bay a
// column over all boards, as wide as its share of the goods; brand_horizontal gives it boards of
// its own, heavy brands low. In a column what earns most stands at eye level, what is heavy low. A
// product has the more facings the more it is asked for (scene/demand.h); in columns, where the
// board has the room, no fewer than take a delivery case and what is sold between two fillings
// (scene/shelf_worth.h).
#pragma once
#include <cstdint>
#include <vector>

#include "catalog/catalog.h"
#include "plan/plan.h"
#include "scene/planogram.h"

namespace marketgen::scene {

// Where an adult looks without bending or stretching, over the floor. Planogram practice puts eye
// level at 1.2 to 1.6 m.
constexpr double eye_level_m = 1.4;

// Whether the bay is stocked so: the plan asks for it, and goods stand on its boards. What hangs,
// lies in heaps or is on offer is stocked by plan_bay() in any pattern.
bool has_brand_blocks(const Bay& bay, const plan::StockSpec& stock);

// Orders what assortment_of() has as the zone's pattern wants it: within each subcategory brands by
// how much they are asked for, the most first, and the shop's own, which is that of the most
// categories, right after the first; a brand's goods keep their order. `mixed`: goods by how much
// they are asked for, whatever their brand. brand_vertical: nothing changes.
void order_by_demand(std::vector<std::uint32_t>& assortment,
                     const plan::StockSpec& stock,
                     const catalog::Catalog& catalog);

// As plan_bay(), whose parameters these are and which stocks the bay where the columns have no room
// for all that is certain and it has. Every block has its place (PlannedBlock::x_m).
std::vector<PlannedShelf> plan_brand_blocks(const Bay& bay,
                                            const std::vector<std::uint32_t>& assortment,
                                            const plan::StockSpec& stock,
                                            const catalog::Catalog& catalog,
                                            AssortmentCursor& cursor,
                                            Stream draw,
                                            const std::vector<std::uint32_t>& certain);

}  // namespace marketgen::scene
