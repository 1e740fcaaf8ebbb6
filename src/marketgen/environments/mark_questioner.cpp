#include "environments/mark_questioner.h"

#include <algorithm>

#include "episodes/episode_origin.h"

namespace marketgen::environments {

Result<std::shared_ptr<perception::MarkQuestioner>> mark_questioner(const PolicyName& name,
                                                                    Arena& arena) {
  if (name.model.empty()) return std::shared_ptr<perception::MarkQuestioner>();
  MARKETGEN_TRY(const auto model, arena.model(name.model));
  return std::make_shared<perception::MarkQuestioner>(*model);
}

perception::ProductWords product_words(std::shared_ptr<const std::vector<catalog::Product>> stock) {
  return [stock = std::move(stock)](const std::string& sku) {
    const auto row = std::ranges::find(*stock, sku, &catalog::Product::sku);
    return row == stock->end() ? sku : episodes::spoken_product(*row);
  };
}

}  // namespace marketgen::environments
