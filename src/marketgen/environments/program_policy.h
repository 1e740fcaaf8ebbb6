// A policy of the program that acts in an Environment, in the numbers of the environment's actions.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "environments/environment.h"

namespace marketgen::environments {

// Looks at the environment's world whenever it is asked, and begins anew after each reset. Of what
// it would do, the environment's actions leave out the force of its tools. Not thread-safe.
class ProgramPolicy {
 public:
  // `environment` must outlive it.
  ProgramPolicy(Environment& environment, std::string name)
      : environment_(environment), name_(std::move(name)) {}

  // The numbers of the next action. Errors: episode.bad_action, no episode runs; those of
  // Arena::policy, of the policy, and of Environment::numbers_of.
  Result<std::vector<double>> act();
  // What kept it from its goals, as it says: a name of FailureCode.
  std::string failure() const { return policy_ ? policy_->failure() : "None"; }
  // What its last action was for.
  agent::Subtask subtask() const { return policy_ ? policy_->subtask() : agent::Subtask::none; }

 private:
  Result<void> begin();

  Environment& environment_;
  std::string name_;
  std::unique_ptr<agent::Policy> policy_;  // of the episode that runs
  std::uint64_t reset_ = 0;                // which one that is
};

}  // namespace marketgen::environments
