#include "evaluation/decision_judge.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace marketgen::evaluation {
namespace {

using agent::DecisionKind;

struct Fault {
  PolicyModule module = PolicyModule::unknown;
  std::string why;
  double time_s = 0;
};

std::string in_mm(double metres) {
  return fmt::format("{:.0f} mm", 1000 * metres);
}

// Follows one goal through the decisions.
class GoalStory {
 public:
  GoalStory(int goal, std::string sku) : goal_(goal), sku_(std::move(sku)) {}

  void hear(const DecisionRecord& decision) {
    switch (decision.kind) {
      case DecisionKind::look:
        return look(decision);
      case DecisionKind::stop:
        stopped_ = &decision;
        return;
      default:
        break;
    }
    if (decision.goal != goal_) return;
    switch (decision.kind) {
      case DecisionKind::read:
        return read(decision);
      case DecisionKind::reach:
        return reach(decision);
      case DecisionKind::hold:
        return hold(decision);
      case DecisionKind::place:
        return place(decision);
      case DecisionKind::contact:
        return blame(decision, PolicyModule::motion, "it met something on its way");
      default:
        return;
    }
  }

  Fault fault() const {
    if (fault_) return *fault_;
    if (placed_)
      return {PolicyModule::place, "it was let go, and is not in place", placed_->time_s};
    const double end_s = stopped_ != nullptr ? stopped_->time_s : 0;
    if (!seen_) return {PolicyModule::search, "no picture showed it to the policy", end_s};
    if (stopped_ == nullptr || stopped_->outcome == "Timeout")
      return {PolicyModule::time, "the time was over", end_s};
    return {PolicyModule::unknown, "it was found, and never reached for", end_s};
  }

 private:
  void blame(const DecisionRecord& decision, PolicyModule module, std::string why) {
    if (!fault_) fault_ = {module, std::move(why), decision.time_s};
  }
  // Parts up to that one have done their work.
  void right(PolicyModule up_to) {
    if (fault_ && fault_->module <= up_to) fault_.reset();
  }

  void read(const DecisionRecord& decision) {
    if (decision.readings.empty())
      return blame(decision, PolicyModule::language, "its words were not understood");
    if (std::ranges::find(decision.readings, sku_) == decision.readings.end())
      return blame(decision,
                   PolicyModule::language,
                   fmt::format("its words were read as {}", decision.readings.front()));
    right(PolicyModule::language);
  }

  void look(const DecisionRecord& decision) {
    seen_ = seen_ || std::ranges::any_of(decision.found, [&](const FoundRecord& found) {
              return found.goal == goal_;
            });
  }

  // Whether it goes to where such a product is.
  bool goes_right(const DecisionRecord& decision) {
    if (decision.sku != sku_) {
      blame(decision, PolicyModule::target, fmt::format("it went for {}", decision.sku));
      return false;
    }
    if (!decision.truth) return true;
    const TruthThere& truth = *decision.truth;
    if (is_right(truth)) return true;
    if (!truth.sku.empty() && truth.sku != sku_ && truth.off_m <= right_place_m)
      blame(decision, PolicyModule::target, fmt::format("what it went for is {}", truth.sku));
    else
      blame(decision,
            PolicyModule::pose,
            truth.own_m
                ? fmt::format("the nearest is {} off where it was taken to be", in_mm(*truth.own_m))
                : std::string("there is none of it"));
    return false;
  }

  void reach(const DecisionRecord& decision) {
    seen_ = true;
    if (!goes_right(decision)) return;
    right(PolicyModule::pose);
    if (decision.outcome == "None") return right(PolicyModule::motion);
    if (decision.outcome == "NotFound")
      return blame(decision, PolicyModule::search, "from near by it was not seen any more");
    if (decision.outcome == "NoGrasp")
      return blame(decision, PolicyModule::grasp, "no grasp had room");
    blame(decision, PolicyModule::motion, fmt::format("no way to it: {}", decision.outcome));
  }

  void hold(const DecisionRecord& decision) {
    if (decision.outcome != "None")
      return blame(decision, PolicyModule::grasp, "the hand shut, and did not hold it");
    if (decision.truth && !decision.truth->sku.empty() && decision.truth->sku != sku_)
      return blame(
          decision, PolicyModule::target, fmt::format("what it holds is {}", decision.truth->sku));
    right(PolicyModule::motion);
  }

  void place(const DecisionRecord& decision) {
    if (decision.outcome == "Slipped")
      return blame(decision, PolicyModule::carry, "it was lost on its way");
    if (decision.outcome != "None")
      return blame(decision,
                   PolicyModule::place,
                   fmt::format("no way to where it was to be put down: {}", decision.outcome));
    placed_ = decision;
    right(PolicyModule::place);
  }

  int goal_;
  std::string sku_;
  bool seen_ = false;
  const DecisionRecord* stopped_ = nullptr;
  std::optional<DecisionRecord> placed_;
  std::optional<Fault> fault_;
};

}  // namespace

std::vector<JudgedGoal> judged_goals(const std::vector<DecisionRecord>& decisions,
                                     const episodes::EpisodeResult& result) {
  std::vector<JudgedGoal> judged;
  for (std::size_t i = 0; i < result.goals.size(); ++i) {
    const episodes::GoalOutcome& goal = result.goals[i];
    JudgedGoal& row = judged.emplace_back();
    row.sku = goal.sku, row.count = goal.count, row.reached = goal.reached;
    if (goal.reached >= goal.count) continue;
    GoalStory story(static_cast<int>(i), goal.sku);
    for (const DecisionRecord& decision : decisions)
      story.hear(decision);
    Fault fault = decisions.empty() ? Fault{PolicyModule::unknown, "the policy tells nothing", 0}
                                    : story.fault();
    if (!result.detail.empty() && fault.module >= PolicyModule::time)
      fault = {PolicyModule::error, result.detail, result.simulated_s};
    row.module = fault.module, row.why = std::move(fault.why), row.time_s = fault.time_s;
  }
  return judged;
}

}  // namespace marketgen::evaluation
