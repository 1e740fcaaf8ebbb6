// What a product is worth to the shelf it stands on: what it earns there, and how many packs of it
// the shelf should take.
#pragma once
#include <string_view>
#include <vector>

#include "catalog/catalog.h"
#include "plan/plan.h"

namespace marketgen::scene {

struct Margin {
  std::string_view category;
  double share = 0;  // of the price
};
const std::vector<Margin>& margins();  // scene/margins.inc; one for each category

// The brand that the most categories have, which is the shop's own; ties by name. Empty where no
// brand has two.
std::string_view own_brand_of(const catalog::Catalog& catalog);

// Share of the price that is left of it: its category's, by its brand's own factor (0.85 to 1.15,
// drawn once for the brand's name), or by 1.3 of the shop's own brand. The same for a product in
// every store with these rows. The factors have no source.
double margin_of(const catalog::Product& product, std::string_view own_brand);

// Earnings beside those of others on shelves of equal room: asked for (scene/demand.h) x price x
// margin.
double earnings_of(const catalog::Product& product, std::string_view own_brand);

// Packs in a delivery case: the most of 24, 12, 10, 8, 6, 4, 2 that weigh no more than 13 kg and
// take no more than 40 litres; else 1. A case is what one person lifts (HSE INDG143: 16 kg at the
// waist, for women) and what stands on a quarter of a Euro pallet's layer.
int case_packs(const catalog::Product& product);

// The fewest packs that the shelf should have room for, beside others that are usually given
// `usual_packs`: one case, and what is sold from one filling to the next with as much again, at the
// category's turnover (scene/sales.h) and the product's own (scene/demand.h).
int min_packs(const catalog::Product& product, double usual_packs);

}  // namespace marketgen::scene
