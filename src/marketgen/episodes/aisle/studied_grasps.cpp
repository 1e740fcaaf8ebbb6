#include "episodes/aisle/studied_grasps.h"

#include "assets/product_model.h"
#include "grasping/grasp_study.h"

namespace marketgen::episodes {

Result<std::vector<motion::GraspCandidate>> studied_grasps(
    const catalog::Product& product,
    const robots::GraspTool& tool,
    const std::vector<catalog::FrictionRow>& frictions,
    const std::vector<int>& numbers) {
  MARKETGEN_TRY(const auto body, assets::product_body(product));
  MARKETGEN_TRY(motion::GraspCandidates all,
                motion::grasp_candidates(
                    product,
                    *body,
                    tool,
                    grasping::grasp_query(grasping::GraspSetting::stocked,
                                          product,
                                          grasping::rubber_friction(frictions, product))));
  if (all.found.empty()) return Error{"motion.no_grasp", product.sku, all.reason};
  if (numbers.empty()) return std::move(all.found);
  std::vector<motion::GraspCandidate> chosen;
  for (const int number : numbers) {
    const auto at = static_cast<std::size_t>(number);
    if (number >= 0 && at < all.found.size()) chosen.push_back(all.found[at]);
  }
  if (chosen.empty())
    return Error{"motion.no_grasp", product.sku, "the study gives no grasp these numbers"};
  return chosen;
}

}  // namespace marketgen::episodes
