#include "layout/neighbours.h"

#include <algorithm>
#include <array>

namespace marketgen::layout {

bool is_raw_beside_ready(std::string_view type_a, std::string_view type_b) {
  constexpr std::array<std::string_view, 3> ready{"deli", "bakery", "cafe"};
  return type_a == "meat_fish" && std::ranges::find(ready, type_b) != ready.end();
}

bool is_chemical_beside_food(std::string_view type_a,
                             std::string_view type_b,
                             const catalog::Catalog& catalog) {
  const catalog::ZoneTypeRow* b = catalog.zone_type(type_b);
  return type_a == "household" && b != nullptr && b->food && !b->categories.empty() &&
         b->type != "checkout";
}

bool kept_apart(std::string_view type_a, std::string_view type_b, const catalog::Catalog& catalog) {
  return is_raw_beside_ready(type_a, type_b) || is_raw_beside_ready(type_b, type_a) ||
         is_chemical_beside_food(type_a, type_b, catalog) ||
         is_chemical_beside_food(type_b, type_a, catalog);
}

}  // namespace marketgen::layout
