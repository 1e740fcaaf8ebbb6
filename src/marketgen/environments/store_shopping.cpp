#include "environments/store_shopping.h"

#include <filesystem>

#include "catalog/country.h"
#include "io/file.h"
#include "planners/budget.h"
#include "shopping/request.h"
#include "shopping/shopping_planner.h"

namespace marketgen::environments {

Result<shopping::ShoppingPlan> shop(const std::string& words,
                                    const shopping::Assortment& assortment,
                                    const catalog::Catalog& rows,
                                    const ShoppingOptions& options) {
  const catalog::LocalCatalog local(rows, std::string(shopping::country_of(assortment).id));
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const auto knowledge, shopping::ShoppingKnowledge::load(local.get(), data));
  MARKETGEN_TRY(const shopping::ShoppingRequest request, shopping::read_request(words, knowledge));
  MARKETGEN_TRY(const auto model, planners::open_planner_model(options.planner, options.access));
  if (!model) return shopping::OfflineShoppingPlanner(knowledge).plan(request, assortment);
  const planners::Budget budget(*model, options.access.limits);
  return shopping::ModelShoppingPlanner(knowledge, budget.model()).plan(request, assortment);
}

}  // namespace marketgen::environments
