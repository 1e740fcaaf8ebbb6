#include "evaluation/goods_rows.h"

#include <algorithm>

#include "evaluation/evaluation_summary.h"

namespace marketgen::evaluation {

std::map<std::string, GoodsRow> goods_rows(const std::vector<episodes::EpisodeResult>& results,
                                           const catalog::Catalog& catalog,
                                           const NameOfGoods& name) {
  std::map<std::string, GoodsRow> rows;
  for (const episodes::EpisodeResult& result : results) {
    if (!result.error.empty()) continue;
    for (const episodes::GoalOutcome& goal : result.goals) {
      const catalog::Product* product = catalog.product(goal.sku);
      GoodsRow& row = rows[product == nullptr ? "unknown" : name(*product)];
      const int reached = std::min(goal.reached, goal.count);
      row.asked += goal.count;
      row.reached += reached;
      row.skus.insert(goal.sku);
      row.scores.push_back(
          {store_of(result), static_cast<double>(reached), static_cast<double>(goal.count)});
    }
  }
  return rows;
}

}  // namespace marketgen::evaluation
