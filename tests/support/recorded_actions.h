// What a policy did in one world, done again in another.
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "agent/policy.h"
#include "episodes/track_world.h"

namespace marketgen {

// What was done in a world, done again without looking.
class Recorded : public agent::Policy {
 public:
  explicit Recorded(const std::vector<agent::Action>& actions) : actions_(actions) {}
  Result<void> begin(const agent::Task&, const agent::Observation&) override { return {}; }
  Result<agent::Action> act(const agent::Observation& now) override {
    if (next_ < actions_.size()) return actions_[next_++];
    agent::Action still = episodes::still_action(now);
    still.stop = true;
    return still;
  }
  std::string failure() const override { return "Unknown"; }

 private:
  const std::vector<agent::Action>& actions_;
  std::size_t next_ = 0;
};

// Acts as the policy does, and keeps what it did.
class Recorder : public agent::Policy {
 public:
  explicit Recorder(std::unique_ptr<agent::Policy> policy) : policy_(std::move(policy)) {}
  Result<void> begin(const agent::Task& task, const agent::Observation& first) override {
    return policy_->begin(task, first);
  }
  Result<agent::Action> act(const agent::Observation& now) override {
    auto action = policy_->act(now);
    if (action.ok()) actions_.push_back(*action);
    return action;
  }
  std::string failure() const override { return policy_->failure(); }
  const std::vector<agent::Action>& actions() const { return actions_; }

 private:
  std::unique_ptr<agent::Policy> policy_;
  std::vector<agent::Action> actions_;
};

}  // namespace marketgen
