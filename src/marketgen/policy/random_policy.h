// The policy that knows nothing: each joint takes a small step to one side, the gripper opens and
// closes. What it reaches is chance, the floor under every score.
#pragma once
#include "agent/policy.h"
#include "base/seed.h"

namespace marketgen {

class RandomPolicy : public Policy {
 public:
  RandomPolicy(Seed seed, bool drives) : draw_(seed.stream()), drives_(drives) {}
  Result<void> begin(const Task& task, const Observation& first) override;
  Result<Action> act(const Observation& now) override;
  // It never says that it has done.
  std::string failure() const override { return "Timeout"; }

 private:
  Stream draw_;
  bool drives_;
  std::vector<double> target_;
};

}  // namespace marketgen
