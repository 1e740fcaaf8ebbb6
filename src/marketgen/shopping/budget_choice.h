// Which answers to buy: a multiple-choice knapsack, solved exactly.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "shopping/shopping_parts.h"

namespace marketgen::shopping {

constexpr int nothing_chosen = -1;

struct Choice {
  std::int64_t coins = 0;
  int missing_items = 0, missing_needs = 0, missing_extras = 0;
  std::vector<int> menus;  // of each meal
  // Of each item, then of each part of the chosen menu of each meal: its answer, or nothing_chosen.
  std::vector<int> answers;
};

struct Choices {
  Choice best;                 // within the budget
  std::int64_t min_coins = 0;  // that buy as many items and needs as the store has
};

// Of all choices within `budget` (coins; none: any) that with the fewest items missing, then the
// fewest needs of meals, then the more usual menus, then the fewest extras, then the best
// preferences, then the least cost. A meal without any of its needs has no extras. Every part is
// counted by itself. Exact: states are kept unless another costs no more and is worth more.
Choices choose(const ShoppingParts& parts, std::optional<std::int64_t> budget);

}  // namespace marketgen::shopping
