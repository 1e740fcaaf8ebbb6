// What `classical` tells of its decisions in a store.
#pragma once
#include <string_view>
#include <vector>

#include "agent/decision.h"
#include "policy/aisle_sight.h"
#include "policy/shelf_goals.h"

namespace marketgen::policy {

// What each goal is taken to mean.
void log_readings(const std::vector<ShelfGoal>& goals, agent::DecisionLog& log);
// What looks from one place show of the goals.
void log_look(const ShelfSight& sight,
              const std::vector<ShelfFind>& finds,
              const std::vector<ShelfGoal>& goals,
              agent::DecisionLog& log);
agent::Decision find_decision(agent::DecisionKind kind,
                              const ShelfGoal& goal,
                              const ShelfFind& find,
                              std::string_view outcome);

}  // namespace marketgen::policy
