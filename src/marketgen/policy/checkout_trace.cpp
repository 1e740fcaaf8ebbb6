#include "policy/checkout_trace.h"

#include <utility>
#include <vector>

#include "policy/looked_at.h"

namespace marketgen::policy {

void log_readings(const SoughtGoals& goals, agent::DecisionLog& log) {
  for (std::size_t goal = 0; goal < goals.size(); ++goal)
    log.add({.kind = agent::DecisionKind::read,
             .goal = static_cast<int>(goal),
             .readings = goals.skus_of(goal)});
}

void log_look(const Sight& sight, const SoughtGoals& goals, agent::DecisionLog& log) {
  if (!log.keeps()) return;
  agent::Decision decision{.kind = agent::DecisionKind::look};
  std::vector<FoundShape> shapes;
  for (std::size_t goal = 0; goal < goals.size(); ++goal) {
    for (const perception::FoundProduct* found : goals.found_of(sight, goal)) {
      const perception::ProductLook& look = goals.look_of(*found);
      const Pose& pose = found->pose.base_from_product;
      decision.found.push_back(
          {goal, look.sku(), middle_of(look, pose), found->pose.evidence.score});
      shapes.push_back({static_cast<int>(goal), &look, pose});
    }
  }
  decision.pictures = looked_at(sight.views, sight.masked, shapes);
  log.add(std::move(decision));
}

agent::Decision reach_decision(const PickChoice& choice) {
  return {.kind = agent::DecisionKind::reach,
          .goal = choice.goal ? static_cast<int>(*choice.goal) : -1,
          .sku = choice.look->sku(),
          .middle = middle_of(*choice.look, choice.base_from_product)};
}

}  // namespace marketgen::policy
