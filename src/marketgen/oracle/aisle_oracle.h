// The oracle's decisions in the aisles: what to fetch next (aisle_choice.cpp), and how it is taken
// off its shelf and let down into the basket (oracle_aisle.cpp); doors (aisle_doors.cpp).
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "agent/policy.h"
#include "collect/collect_plan.h"
#include "episodes/aisle/aisle_world.h"
#include "oracle/oracle_search.h"
#include "skills/aisle_executor.h"
#include "skills/drop_plan.h"

namespace marketgen::oracle {

class AisleOracle : public agent::Policy {
 public:
  // `world` must outlive it.
  AisleOracle(const episodes::AisleWorld& world,
              robots::GraspTool tool,
              Seed seed,
              const OracleSearch& search = {});

  Result<void> begin(const agent::Task& task, const agent::Observation& first) override;
  Result<agent::Action> act(const agent::Observation& now) override;
  std::string failure() const override;
  agent::Subtask subtask() const override { return memory_.executor.subtask(); }

 private:
  enum class Phase {
    choose,
    at_door,
    opening,
    arrived,
    pressed,
    out,
    away,
    dropped,
    at_leaf,
    shutting
  };

  // A door that it has opened, as it stood then, and the ways past it.
  struct OpenedDoor {
    std::uint32_t joint = 0;
    skills::HingedDoor door;
    double position_rad = 0;
    std::shared_ptr<const navigation::VisibilityGraph> ways;
  };

  // Of what it is doing.
  struct Memory {
    skills::AisleExecutor executor;
    Phase phase = Phase::choose;
    collect::CollectPlan plan = {};
    motion::FloorPlace goes_to = {};  // the last way of its base
    bool waited = false;              // for people on that way
    double force_n = 0;
    std::size_t drop_lift = 0;
    std::map<std::string, int> tries = {};                   // by SKU
    std::map<std::uint32_t, std::vector<Vec3>> missed = {};  // where the tip was in vain, product
                                                             // frame
    std::map<std::uint32_t, int> unreached = {};             // times that it came in vain
    std::uint32_t door = 0;                                  // that it goes to open
    std::optional<OpenedDoor> open = {};
    // Since it was last opened or shut: times that it was moved in vain, and that the robot stood
    // before it where no arm has a way.
    std::map<std::uint32_t, int> door_tries = {}, door_arrivals = {};
    int moves = 0;
    bool done = false;
    bool held = false;                                           // when the tool had closed
    std::map<std::string, episodes::FailureCode> failures = {};  // by SKU, the last one
  };
  struct Fetch {
    double way_m = 0;
    std::uint32_t product = 0;
  };

  Result<void> recover();
  Result<void> decide();
  void note(const std::string& sku, episodes::FailureCode why) { memory_.failures[sku] = why; }
  void note(episodes::FailureCode why) { note(sku_of(memory_.plan.product), why); }
  void note_plan(std::uint32_t product, const Error& error);
  void say(const std::string& what) const;
  Seed next_seed(std::string_view of) {
    return seed_.child(of, static_cast<std::uint64_t>(memory_.moves++));
  }

  // ---- What to fetch next: aisle_choice.cpp ----
  std::vector<std::string> unmet() const;
  std::vector<std::string> missing() const;
  const std::string& sku_of(std::uint32_t product) const;
  std::optional<double> way_to(std::uint32_t product) const;
  bool was_moved(std::uint32_t product) const;
  std::vector<Fetch> fetches(const std::vector<std::string>& skus) const;
  Result<void> choose();
  collect::GoodsNow goods_now() const;
  Result<collect::CollectOptions> collect_options(std::uint32_t product);
  Result<collect::CollectOptions> options_from_afar(std::uint32_t product);
  bool go_to(std::uint32_t product);
  Result<void> rise_and_open();
  Result<void> reach();
  Result<void> begin_taking();
  Result<int> rehearse();
  int harm() const;
  void come_in_vain(std::uint32_t product);

  // ---- Taking it ----
  agent::ToolCommand opened() const;
  agent::ToolCommand let_go() const;
  double lift_height() const;
  bool holds_it() const;
  Result<void> pull_out();
  Result<void> back_off();

  // ---- Doors: aisle_doors.cpp ----
  const navigation::VisibilityGraph& ways() const;  // past the door that is open
  std::optional<std::uint32_t> shut_door_before(std::uint32_t product) const;
  double time_for_doors_s() const;
  bool is_behind_open_door(std::uint32_t product) const;
  Result<OpenedDoor> opened_at(std::uint32_t joint, double position_rad) const;
  motion::FloorPlace axle_place(const Pose& world_from_base) const;
  Result<motion::BaseFollower> way_of(const Pose& world_from_base);
  Result<void> make_way();
  using DoorPlanning = Result<skills::DoorPlan> (*)(const robots::Robot&,
                                                    const skills::DoorQuestion&,
                                                    Seed);
  Result<void> drive_to_door(std::uint32_t joint, DoorPlanning plan_way, Seed seed);
  bool go_to_door(std::uint32_t joint, std::uint32_t product);
  Result<void> open_door();
  Result<void> check_opened();
  void give_up_door();
  Result<void> go_to_leaf();
  Result<void> shut_door();
  Result<void> check_shut();
  Result<void> fold_arms();

  // ---- Into the basket ----
  std::vector<double> state_now() const;
  Result<motion::Obstacles> around() const;
  Result<std::vector<skills::CarriedItem>> inside() const;
  Pose base_from_tip() const;
  Result<skills::StowQuestion> stow_question(const std::string& group) const;
  Result<void> drop();
  Result<void> try_other_lift();
  Result<void> go_home();
  Result<void> check();

  const episodes::AisleWorld* world_;
  // Of the same episode: what it has begun is rehearsed there. None for a rehearsal itself, and for
  // one that does not rehearse.
  std::shared_ptr<episodes::AisleWorld> twin_;
  bool is_rehearsal_ = false;
  const robots::Robot& robot_;
  robots::GraspTool tool_;
  Seed seed_;
  OracleSearch search_;
  collect::GoodsNow goods_;  // as they stood when the plan was made
  agent::Task task_;
  agent::Observation now_;
  Memory memory_;
  std::map<std::string, std::vector<motion::GraspCandidate>> grasps_;  // by SKU
  std::set<std::uint32_t> refused_;
  std::map<std::uint32_t, int> unplanned_;  // times that no way to one was found
  std::set<std::uint32_t> refused_doors_;
};

}  // namespace marketgen::oracle
