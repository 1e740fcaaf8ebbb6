// The policy that knows nothing: each joint takes a small step to one side, the gripper opens and
// closes. What it reaches is chance, the floor under every score.
#pragma once
#include "agent/policy.h"
#include "base/seed.h"

namespace marketgen::policy {

class RandomPolicy : public agent::Policy {
 public:
  RandomPolicy(Seed seed, bool drives) : draw_(seed.stream()), drives_(drives) {}
  Result<void> begin(const agent::Task& task, const agent::Observation& first) override;
  Result<agent::Action> act(const agent::Observation& now) override;
  // It never says that it has done.
  std::string failure() const override { return "Timeout"; }

 private:
  Stream draw_;
  bool drives_;
  std::vector<double> target_;
};

}  // namespace marketgen::policy
