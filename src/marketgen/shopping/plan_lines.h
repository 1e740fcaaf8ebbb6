// From chosen answers to a plan's lines.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "shopping/shopping_parts.h"
#include "shopping/shopping_plan.h"

namespace marketgen::shopping {

struct ChosenAnswer {
  const Part* part = nullptr;
  Answer answer;
};

// What they cost together, in coins.
std::int64_t coins_of(const std::vector<ChosenAnswer>& chosen);

// One line for each product, in the order of the parts; a product that answers two parts is bought
// as often as both together want it. With substitutes, of those `allowed`.
std::vector<ShoppingLine> lines_of(const std::vector<ChosenAnswer>& chosen,
                                   const std::vector<const catalog::Product*>& allowed);

// A plan without lines: the request, its money, and what rows do not tell of its diets.
ShoppingPlan empty_plan(const ShoppingRequest& request,
                        const Assortment& assortment,
                        const ShoppingKnowledge& knowledge);

// "breakfast for 2: cereal with milk".
std::string menu_text(const MealWish& wish, std::string_view menu);

// Why the part is not bought: the store has nothing for it, or it costs too much. `least`: what all
// that is asked for costs at least.
UnmetPart unmet_part(const Part& part, double least, const Assortment& assortment);

}  // namespace marketgen::shopping
