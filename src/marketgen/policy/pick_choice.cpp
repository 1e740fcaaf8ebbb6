#include "policy/pick_choice.h"

#include <algorithm>
#include <functional>
#include <limits>

#include <fmt/format.h>

#include "base/progress.h"

namespace marketgen::policy {
namespace {

double min_intrusion_m(const std::vector<perception::SeenGrasp>& grasps) {
  double least = std::numeric_limits<double>::infinity();
  for (const perception::SeenGrasp& grasp : grasps)
    least = std::min(least, grasp.intrusion_m);
  return least;
}

}  // namespace

DueTargets due_targets(const SoughtGoals& goals,
                       const Sight& sight,
                       const agent::WorkArea& unloading,
                       int max_tries) {
  DueTargets due;
  for (std::size_t goal = 0; goal < goals.size(); ++goal) {
    if (goals.is_there(sight, goal, unloading)) continue;
    due.all_there = false;
    if (goals.tries(goal) >= max_tries * goals.count(goal)) continue;
    for (const perception::FoundProduct* found : goals.found_of(sight, goal))
      if (!goals.is_unloaded(*found, unloading))
        due.found.push_back({&goals.look_of(*found),
                             goal,
                             found->pose.base_from_product,
                             found->pose.evidence.seen,
                             found->pose.evidence.likeness()});
  }
  std::ranges::stable_sort(due.found, std::greater<>{}, &PickChoice::seen);
  return due;
}

std::vector<PickChoice> others_near(const std::vector<PickChoice>& targets,
                                    const SoughtGoals& goals,
                                    const Sight& sight,
                                    const agent::Workplace& place,
                                    const Recognition& recognition,
                                    std::size_t max_others) {
  std::optional<Vec3> near;
  if (!targets.empty()) near = middle_of(*targets[0].look, targets[0].base_from_product);
  std::vector<PickChoice> others;
  for (const RecognisedProduct& other :
       others_in_basket(sight, goals, place, recognition, near, max_others))
    others.push_back({other.look, {}, other.pose.base_from_product, other.pose.evidence.seen});
  return others;
}

Result<void> find_grasps(PickChoice& choice,
                         agent::KnownProducts& products,
                         const perception::GraspSource& source,
                         const Sight& sight,
                         const agent::Workplace& place) {
  MARKETGEN_TRY(choice.known, products.product(choice.look->sku()));
  choice.others = perception::other_points(sight.points, *choice.look, choice.base_from_product);
  MARKETGEN_TRY(choice.grasps,
                source.grasps({*choice.known,
                               choice.base_from_product,
                               place.base_from_basket,
                               choice.others,
                               {&sight.views}}));
  log_debug(fmt::format("{}: {} grasps, {:.0f} mm least in the way",
                        choice.look->sku(),
                        choice.grasps.size(),
                        1000 * min_intrusion_m(choice.grasps)));
  return {};
}

}  // namespace marketgen::policy
