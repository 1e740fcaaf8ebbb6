#include "policy/goal_skus.h"

namespace marketgen::policy {

Result<std::vector<std::string>> goal_skus(const agent::TaskGoal& goal,
                                           const perception::GoalReader* reader) {
  if (!goal.sku.empty()) return std::vector<std::string>{goal.sku};
  if (reader != nullptr) return reader->read(goal.text);
  return Error{"episode.impossible",
               goal.text,
               "it is asked for in words, and the agent has nothing that reads them"};
}

}  // namespace marketgen::policy
