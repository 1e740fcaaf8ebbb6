#include "episodes/aisle/studied_grasps.h"

#include "assets/product_model.h"
#include "grasping/grasp_study.h"

namespace marketgen {

Result<std::vector<GraspCandidate>> studied_grasps(const Product& product,
                                                   const GraspTool& tool,
                                                   const std::vector<FrictionRow>& frictions,
                                                   const std::vector<int>& numbers) {
  MARKETGEN_TRY(const ProductBody body, make_product_body(product));
  MARKETGEN_TRY(
      GraspCandidates all,
      grasp_candidates(
          product,
          body,
          tool,
          grasp_query(GraspSetting::stocked, product, rubber_friction(frictions, product))));
  if (all.found.empty()) return Error{"motion.no_grasp", product.sku, all.reason};
  if (numbers.empty()) return std::move(all.found);
  std::vector<GraspCandidate> chosen;
  for (const int number : numbers) {
    const auto at = static_cast<std::size_t>(number);
    if (number >= 0 && at < all.found.size()) chosen.push_back(all.found[at]);
  }
  if (chosen.empty())
    return Error{"motion.no_grasp", product.sku, "the study gives no grasp these numbers"};
  return chosen;
}

}  // namespace marketgen
