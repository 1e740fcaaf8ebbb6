// The oracle's decisions at the counter: what to take next (checkout_choice.cpp), and how it is
// taken and put down (oracle_checkout.cpp).
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "agent/policy.h"
#include "episodes/checkout/checkout_world.h"
#include "episodes/episode_result.h"
#include "oracle/oracle_grasps.h"
#include "oracle/oracle_scene.h"
#include "oracle/oracle_search.h"
#include "oracle/oracle_tries.h"
#include "skills/arm_executor.h"
#include "skills/place_search.h"

namespace marketgen::oracle {

class CheckoutOracle : public agent::Policy {
 public:
  // `world` must outlive it.
  CheckoutOracle(const episodes::CheckoutWorld& world,
                 robots::GraspTool tool,
                 skills::ArmExecutor arm,
                 Seed seed,
                 const OracleSearch& search = {});

  Result<void> begin(const agent::Task& task, const agent::Observation& first) override;
  Result<agent::Action> act(const agent::Observation& now) override;
  std::string failure() const override { return std::string(name_of(memory_.failure)); }
  agent::Subtask subtask() const override { return memory_.arm.subtask(); }

 private:
  enum class Phase { choose, closed, lifted, over_place, released };
  // clear: nothing is in the way of the hand, nor lies over the item. free: of the hand only.
  enum class Ease { clear, free, any };

  struct LoneGrasps {
    Pose pose;  // of the item, when they were looked for
    std::vector<motion::GraspCandidate> found;
  };

  // Of what it is doing.
  struct Memory {
    skills::ArmExecutor arm;
    Phase phase = Phase::choose;
    OracleTries tried = {};
    std::size_t item = 0;  // that is being taken
    double force_n = 0;
    Pose product_from_tip = {};                  // as it was to be grasped
    std::vector<skills::FreePlace> places = {};  // of the item in the hand
    std::size_t next_place = 0;  // first with what is held looked at, then again without
    bool in_area = false;        // the places are where the item belongs
    bool placed = false;         // it was put down on the place that was sought
    int moves = 0;
    bool escaped = false;  // since the last grasp
    bool done = false;
    episodes::FailureCode failure = episodes::FailureCode::none;
  };

  // One that carries out in the twin what `other` has begun, and decides no further.
  explicit CheckoutOracle(const CheckoutOracle& other);

  Result<void> recover();
  Result<void> decide();

  // ---- What to take next: checkout_choice.cpp ----
  bool is_due(std::size_t item) const;
  Result<void> choose();
  Result<const ItemGrasps*> grasps_of(std::size_t item);
  Result<void> take_first(std::vector<std::size_t> due);
  Result<bool> take_any(const std::vector<std::size_t>& due);
  void give_up(const std::vector<std::size_t>& due);
  bool escape();
  Result<bool> take_if(std::size_t item, Ease how);
  std::vector<std::size_t> blockers_of(const std::vector<std::size_t>& due) const;
  std::vector<std::size_t> nearest_to(const std::vector<std::size_t>& due) const;
  Result<bool> take(std::size_t item);
  Result<bool> take(std::size_t item, bool to_be_placed);
  bool may_rehearse(std::size_t item) const;
  void close_on(std::size_t item, const Pose& tip, const GraspChoice& choice);
  Result<bool> goes_well(std::size_t item, const Memory& before);
  Result<int> rehearse();
  int harm() const;

  // ---- Taking it ----
  bool holds_it() const { return world_->watched(memory_.item).held_by >= 0; }
  Result<void> lift();
  Result<void> let_go_for_good(episodes::FailureCode why);
  Result<void> let_go(episodes::FailureCode why);
  bool back_off(double opening_m);  // whether the hand gets up

  // ---- Putting it down ----
  Result<void> put_down();
  Result<void> go_over_place();
  Result<void> lower();
  Result<void> put_back();

  void note(episodes::FailureCode why) { memory_.failure = why; }
  Seed next_seed(std::string_view of) {
    return seed_.child(of, static_cast<std::uint64_t>(memory_.moves++));
  }
  void say(const std::string& what) const;
  void say_failed(std::string_view motion, const Result<void>& planned) const;
  std::string called(std::size_t item) const;

  const episodes::CheckoutWorld* world_;
  // Of the same episode: what it has begun is rehearsed there. None for a rehearsal itself, and for
  // one that does not rehearse.
  std::unique_ptr<episodes::CheckoutWorld> twin_;
  bool is_rehearsal_ = false;
  robots::GraspTool tool_;
  Seed seed_;
  OracleSearch search_;
  agent::Task task_;
  std::unique_ptr<OracleScene> scene_;
  agent::Observation now_;
  Pose home_;  // of the tip, at the start
  Memory memory_;
  std::map<std::size_t, LoneGrasps> lone_;

  // Of this decision.
  std::map<std::size_t, ItemGrasps> grasps_;
  std::set<std::size_t> refused_;  // no way to them was found
  // How many grasps were rehearsed, and of those that did not go well the one that did least
  // harm, begun.
  struct Rehearsed {
    Memory begun;
    int harm = 0;
  };
  std::map<std::size_t, int> rehearsals_;  // by item
  std::optional<Rehearsed> best_;
};

}  // namespace marketgen::oracle
