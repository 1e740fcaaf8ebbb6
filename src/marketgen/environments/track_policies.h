// Who acts in a world of each track of episodes/tracks.inc: defined in the track's own folder.
#pragma once
#include <memory>
#include <optional>

#include "agent/policy.h"
#include "base/seed.h"
#include "environments/arena.h"
#include "environments/policy_name.h"
#include "oracle/oracle_search.h"

namespace marketgen::environments {

// A policy that needs things that live as long as it does.
class WrappedPolicy : public agent::Policy {
 public:
  Result<void> begin(const agent::Task& task, const agent::Observation& first) override {
    return policy_->begin(task, first);
  }
  Result<agent::Action> act(const agent::Observation& now) override { return policy_->act(now); }
  std::string failure() const override { return policy_->failure(); }
  std::optional<agent::ModelUse> model_use() const override { return policy_->model_use(); }
  std::optional<agent::PartsUse> parts_use() const override { return policy_->parts_use(); }
  agent::Subtask subtask() const override { return policy_->subtask(); }
  agent::DecisionLog* decisions() override { return policy_->decisions(); }

 protected:
  std::unique_ptr<agent::Policy> policy_;
};

// The oracle, which knows everything, searching as it is told; `classical`, which sees pictures,
// with the truth in place of those modules that `name` says, and with its model as `vlm`; and
// `highest`, which sees heights alone. Arena and world must outlive them. Errors: those of their
// tools' rows, and of Arena::stock; usage.bad_flag where a track has no such policy.
#define MARKETGEN_TRACK(name, Type)                                                          \
  Result<std::unique_ptr<agent::Policy>> make_oracle(Arena& arena,                           \
                                                     const episodes::Type##World& world,     \
                                                     const oracle::OracleSearch& search,     \
                                                     Seed seed);                             \
  Result<std::unique_ptr<agent::Policy>> make_classical(                                     \
      Arena& arena, const episodes::Type##World& world, const PolicyName& asked, Seed seed); \
  Result<std::unique_ptr<agent::Policy>> make_highest(                                       \
      Arena& arena, const episodes::Type##World& world, Seed seed);
#include "episodes/tracks.inc"
#undef MARKETGEN_TRACK

}  // namespace marketgen::environments
