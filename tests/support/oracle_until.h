// Does its task as it should until the moment for which somebody waits, then something else.
#pragma once
#include <functional>
#include <memory>

#include "agent/policy.h"

namespace marketgen {

// The oracle until a goal is where `now_` says; from then on what `cheat_` does.
class OracleUntil : public agent::Policy {
 public:
  using When = std::function<bool(const agent::Action& next, bool pressed)>;
  using Cheat = std::function<agent::Action(agent::Action last, int step)>;
  OracleUntil(std::unique_ptr<agent::Policy> oracle, When now, Cheat cheat)
      : oracle_(std::move(oracle)), now_(std::move(now)), cheat_(std::move(cheat)) {}

  Result<void> begin(const agent::Task& task, const agent::Observation& first) override {
    return oracle_->begin(task, first);
  }
  Result<agent::Action> act(const agent::Observation& now) override {
    if (steps_ == 0) {
      MARKETGEN_TRY(agent::Action next, oracle_->act(now));
      if (!now_(next, !last_.tools.empty() && last_.tools[0].opening_m <= 0)) {
        last_ = next;
        return next;
      }
    }
    return cheat_(last_, ++steps_);
  }
  bool has_cheated() const { return steps_ > 0; }

 private:
  std::unique_ptr<agent::Policy> oracle_;
  When now_;
  Cheat cheat_;
  agent::Action last_;
  int steps_ = 0;
};

}  // namespace marketgen
