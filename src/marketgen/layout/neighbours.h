// Goods that are kept apart: raw meat from food eaten as it is, household chemicals from any food.
#pragma once
#include <string_view>

#include "catalog/catalog.h"

namespace marketgen::layout {

// Floor between the fixtures of two such zones: half a module, a divider and a gap.
constexpr int apart_mm = 600;

// FDA Food Code 2022, 3-302.11 (A)(1). Not symmetric: `a` holds the raw food.
bool is_raw_beside_ready(std::string_view type_a, std::string_view type_b);
// FDA Food Code 2022, 7-201.11. `a` holds the chemicals.
bool is_chemical_beside_food(std::string_view type_a,
                             std::string_view type_b,
                             const catalog::Catalog& catalog);
// Either of them, either way round.
bool kept_apart(std::string_view type_a, std::string_view type_b, const catalog::Catalog& catalog);

}  // namespace marketgen::layout
