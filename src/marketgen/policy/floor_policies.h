// Policies that know nothing of what is asked for: what they reach is chance, the floor under every
// score.
//
// random: each joint takes a small step to one side, the gripper opens and closes. stop: says at
// once that it has done. highest: lifts the highest thing out of a basket, as often as there are
// goods to be brought, and puts it on the area (policy/highest_first.h).
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

class StopPolicy : public agent::Policy {
 public:
  Result<void> begin(const agent::Task&, const agent::Observation&) override { return {}; }
  Result<agent::Action> act(const agent::Observation& now) override;
  std::string failure() const override { return "Unknown"; }
};

}  // namespace marketgen::policy
