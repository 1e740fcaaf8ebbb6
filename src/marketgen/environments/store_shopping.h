// From a request in words to what to buy in a store.
#pragma once
#include <string>

#include "base/result.h"
#include "catalog/catalog.h"
#include "planners/make_planner.h"
#include "shopping/assortment.h"
#include "shopping/shopping_plan.h"

namespace marketgen::environments {

struct ShoppingOptions {
  std::string planner = "offline";  // or a language model, as of planners::make_planner()
  planners::PlannerAccess access;
};

// The plan for `words` of what the store has (store_assortment.h). `rows`: the catalogue, with the
// store's own products. No model is opened before the words are understood; one that fails, or has
// used its limits, leaves the offline plan, which says so. Errors: those of read_request(),
// plan_shopping(), ShoppingKnowledge::load() and open_planner_model().
Result<shopping::ShoppingPlan> shop(const std::string& words,
                                    const shopping::Assortment& assortment,
                                    const catalog::Catalog& rows,
                                    const ShoppingOptions& options = {});

}  // namespace marketgen::environments
