// What `classical` may take next at a counter: what is asked for and was found, and what lies in
// its way.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "agent/known_products.h"
#include "perception/grasp_source.h"
#include "policy/basket_others.h"
#include "policy/sought_goals.h"

namespace marketgen::policy {

// What may be taken, and how.
struct PickChoice {
  const perception::ProductLook* look = nullptr;
  std::optional<std::size_t> goal;  // none: it is in the way
  Pose base_from_product;
  double seen = 0;                             // share of it that nothing hides
  double likeness = 0;                         // PoseEvidence::likeness()
  const agent::KnownProduct* known = nullptr;  // null: its grasps were not looked for yet
  std::vector<perception::SeenGrasp> grasps = {};
  std::vector<Vec3f> others = {};  // measured points that are not its own
};

// Goals that are not there yet.
struct DueTargets {
  bool all_there = true;
  std::vector<PickChoice> found;  // what lies open first; goals that were tried enough left out
};
DueTargets due_targets(const SoughtGoals& goals,
                       const Sight& sight,
                       const agent::WorkArea& unloading,
                       int max_tries);

// Goods in the basket that are not asked for, `max_others` of them: nearest to the first target, or
// highest when there is none.
std::vector<PickChoice> others_near(const std::vector<PickChoice>& targets,
                                    const SoughtGoals& goals,
                                    const Sight& sight,
                                    const agent::Workplace& place,
                                    const Recognition& recognition,
                                    std::size_t max_others);

// Its row and grasps, by what is seen. Errors: those of KnownProducts::product and of the source.
Result<void> find_grasps(PickChoice& choice,
                         agent::KnownProducts& products,
                         const perception::GraspSource& source,
                         const Sight& sight,
                         const agent::Workplace& place);

}  // namespace marketgen::policy
