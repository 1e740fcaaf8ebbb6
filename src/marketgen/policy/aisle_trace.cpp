#include "policy/aisle_trace.h"

#include <cstddef>
#include <string>
#include <utility>

#include "perception/pose_source.h"
#include "policy/looked_at.h"

namespace marketgen::policy {

void log_readings(const std::vector<ShelfGoal>& goals, agent::DecisionLog& log) {
  for (std::size_t goal = 0; goal < goals.size(); ++goal) {
    agent::Decision decision{.kind = agent::DecisionKind::read, .goal = static_cast<int>(goal)};
    if (goals[goal].look != nullptr) decision.readings.push_back(goals[goal].sku);
    log.add(std::move(decision));
  }
}

void log_look(const ShelfSight& sight,
              const std::vector<ShelfFind>& finds,
              const std::vector<ShelfGoal>& goals,
              agent::DecisionLog& log) {
  if (!log.keeps()) return;
  agent::Decision decision{.kind = agent::DecisionKind::look};
  std::vector<FoundShape> shapes;
  for (const ShelfFind& find : finds) {
    const ShelfGoal& goal = goals[find.goal];
    const Pose& pose = find.store_from_product;
    decision.found.push_back(
        {find.goal, goal.sku, perception::middle_of(*goal.look, pose), find.score});
    shapes.push_back({static_cast<int>(find.goal), goal.look, pose});
  }
  decision.pictures = sight.looked_at(std::move(shapes));
  log.add(std::move(decision));
}

agent::Decision find_decision(agent::DecisionKind kind,
                              const ShelfGoal& goal,
                              const ShelfFind& find,
                              std::string_view outcome) {
  agent::Decision decision{.kind = kind,
                           .goal = static_cast<int>(find.goal),
                           .sku = goal.sku,
                           .outcome = std::string(outcome)};
  if (kind == agent::DecisionKind::reach)
    decision.middle = perception::middle_of(*goal.look, find.store_from_product);
  return decision;
}

}  // namespace marketgen::policy
