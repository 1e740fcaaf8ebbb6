// Whether a plan is what was asked for: the judge of every planner, which knows nothing of how they
// plan.
#pragma once
#include "base/result.h"
#include "shopping/shopping_plan.h"

namespace marketgen::shopping {

// The first fault, as error shopping.bad_plan with the line or part:
//
//   - a line's product is not sold in the store, sold out, or not what the request allows;
//   - its price or the total is not that of the rows, or the total is above the budget;
//   - a line answers nothing, or not with what it buys; it buys too few packs or too many;
//   - something else is bought where what the words say is there;
//   - an item, or a food that a menu needs, is neither bought nor at home nor named as unmet;
//   - it is named as not sold though it is there, or as over the budget though it would fit;
//   - a substitute is not there to be bought.
Result<void> check_shopping(const ShoppingPlan& plan,
                            const ShoppingRequest& request,
                            const Assortment& assortment,
                            const ShoppingKnowledge& knowledge);

}  // namespace marketgen::shopping
