// What `classical` tells of its decisions at a counter.
#pragma once
#include "agent/decision.h"
#include "policy/pick_choice.h"
#include "policy/sought_goals.h"

namespace marketgen::policy {

// What each goal may mean.
void log_readings(const SoughtGoals& goals, agent::DecisionLog& log);
// What a look shows of the goals.
void log_look(const Sight& sight, const SoughtGoals& goals, agent::DecisionLog& log);
// To be told what came of it.
agent::Decision reach_decision(const PickChoice& choice);

}  // namespace marketgen::policy
