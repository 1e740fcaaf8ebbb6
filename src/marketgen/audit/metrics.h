// The smaller metrics of a store; docs/metrics.md defines them.
#pragma once
#include <cstddef>
#include <vector>

#include "catalog/catalog.h"
#include "scene/scene.h"

namespace marketgen::audit {

// What stands on some of the fixtures.
struct StockCount {
  std::size_t items = 0, misplaced = 0, blocks = 0, empty_blocks = 0;
  // Blocks on shelves with a price rail; of these without a tag, with a tag that says a price that
  // does not hold, with one of another product, with more than one tag.
  std::size_t tagged_blocks = 0, no_tag = 0, wrong_price = 0, wrong_product = 0, two_tags = 0;
  double front_m = 0, stocked_m = 0;  // width of their shelves, and of the blocks with goods
};
// `fixtures`: which ones count, by row of scene.fixtures.
StockCount stock_on(const scene::Scene& scene, const std::vector<bool>& fixtures);

// Width of the stocked blocks over the usable width of all shelves.
double shelf_fill(const scene::Scene& scene);
// Floor open to shoppers: the room without backroom, checkout, customer-service and cafe zones.
double selling_area_m2(const scene::Scene& scene);
// Aisles as shoppers count them: the most gaps between stocked fixtures that a straight line across
// the free-standing runs crosses.
int shopping_aisles(const scene::Scene& scene);

}  // namespace marketgen::audit
