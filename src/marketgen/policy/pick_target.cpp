#include "policy/pick_target.h"

namespace marketgen::policy {
namespace {

constexpr double other_reach_m = 0.35;  // of a product, measured points that its grasps mind

}  // namespace

Result<PickTarget> pick_target(const agent::KnownProduct& known,
                               const perception::ProductLook& look,
                               const Pose& store_from_product,
                               const robots::GraspTool& tool,
                               const perception::ShelfGraspSource& grasps,
                               const PickSight& sight) {
  std::vector<Vec3f> near;
  for (const Vec3f& point : sight.points)
    if (length(to_double(point) - store_from_product.position) < other_reach_m)
      near.push_back(point);
  const std::vector<Vec3f> others = perception::other_points(near, look, store_from_product);
  MARKETGEN_TRY(const auto seen,
                grasps.grasps({known, store_from_product, others, sight.seen_in, sight.walls}));
  PickTarget target{&known, store_from_product, {}, tool.id};
  for (const perception::SeenGrasp& grasp : seen)
    target.grasps.push_back(
        {inverse(store_from_product) * grasp.base_from_tip, grasp.opening_m, grasp.force_n});
  return target;
}

}  // namespace marketgen::policy
