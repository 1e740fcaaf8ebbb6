// What a robot that collects does, one action at a time: drives, looks, takes from a shelf, lets
// down into its basket. It plans against the map and the points it is given; of the world it knows
// nothing else.
//
// Store frame where nothing else is said; SI units.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "agent/aisle_map.h"
#include "policy/pick_target.h"
#include "skills/aisle_executor.h"
#include "skills/drop_plan.h"
#include "skills/shelf_pick.h"

namespace marketgen::policy {

// Robot and map must outlive it.
struct AisleBodySetup {
  const robots::Robot* robot = nullptr;
  const agent::AisleMap* map = nullptr;
  skills::CarriedBasket basket;
  std::vector<double> driving;  // its state while it drives, on the origin
  std::vector<int> commanded;   // degrees of freedom of an action's positions
};

class AisleBody {
 public:
  AisleBody(AisleBodySetup setup, Seed seed);

  void start(const agent::Observation& now);
  void sense(const agent::Observation& now) { now_ = now; }
  bool idle() const { return executor_.idle(); }
  bool take_stop() { return executor_.take_stop(); }        // as BodyExecutor
  bool take_held_up() { return executor_.take_held_up(); }  // likewise
  agent::Action next() { return executor_.next(now_); }
  agent::Subtask subtask() const { return executor_.subtask(); }  // as BodyExecutor

  // ---- The robot as it is. ----
  std::vector<double> state() const;  // base on the origin
  // Boxes of the map about a product, in its frame: boards and panels that a hand keeps off.
  std::vector<motion::GraspObstacle> walls_about(const Pose& store_from_product) const;
  // By the fingers alone: shut on nothing they come together.
  bool holds_it() const;

  // ---- Each queues motions, or returns an error and queues nothing. ----
  Result<void> drive_to(const robots::BasePlace& place);
  // On to where it drove when people held it up, round them or later; then it looks as it was to.
  Result<void> make_way();
  // The head: to the left and down, rad.
  Result<void> look(double pan, double tilt);
  void wait(double seconds) { executor_.wait(seconds); }
  // A place to stand and the arm's ways. `points`: measured. Queues nothing.
  Result<skills::ShelfPick> plan_pick(const PickTarget& item,
                                      const std::vector<Vec3f>& points,
                                      std::optional<robots::BasePlace> from);
  Result<void> take(const PickTarget& item,
                    skills::ShelfPick pick);  // from where it stands: up to the grip
  Result<void> pull_out();  // with what it holds; back along its way when that is nothing
  Result<void> back_off();  // from the shelf; with something held also to the lift's height
  // Tried from one lift height after another: true when it is on its way into the basket, false
  // when the lift moves first. Error: collect.no_drop when all were tried; then the first is next.
  Result<bool> drop(const std::vector<Vec3f>& points);
  // When it is down: false when it came upon something so high over the basket's floor that it may
  // roll off it and fall; then it goes up again, and drop() is next, which tries another place.
  // Else true: it is let go. A robot that does not feel what it meets has let go before.
  Result<bool> lowered();
  // Stopped on its way down: up again, over the rim. Nothing where it is not in the basket.
  Result<void> rise(const std::vector<Vec3f>& points);
  // From where it was let go, home.
  Result<void> leave_basket(const std::vector<Vec3f>& points);
  Result<void> go_home(const std::vector<Vec3f>& points);  // the empty arm, to its stowed posture

 private:
  motion::Configuration stowed_arm(const std::string& group) const;
  motion::Obstacles around(const std::vector<Vec3f>& points) const;
  skills::StowQuestion stow_question(const std::vector<Vec3f>& points) const;
  Result<void> let_down(const skills::DropQuestion& question);
  agent::ToolCommand letting_go() const;
  bool is_felt() const { return down_.joints() > 0; }  // the way down
  skills::TurnedBox box_where_it_is() const;
  Result<motion::JointTrajectory> way_up() const;
  Result<void> go_home_from_above(const std::vector<Vec3f>& points);
  double room_behind_m() const;
  Result<void> may_stand(const robots::BasePlace& place) const;
  Result<void> may_hold(const assets::ProductBody& body, const skills::ShelfPick& pick) const;
  Seed next_seed();

  AisleBodySetup setup_;
  robots::BasePlace goes_to_;  // the last way of its base
  bool waited_ = false;        // for people on that way
  std::optional<std::pair<double, double>> looks_there_ = {};
  Seed seed_;
  skills::AisleExecutor executor_;
  agent::Observation now_;
  skills::ShelfPick pick_;
  assets::ProductBody carried_;              // what it takes, as one solid
  double put_n_ = 0;                         // that presses where it comes to lie
  motion::JointTrajectory down_;             // into the basket, felt; empty: there was none
  std::vector<skills::CarriedItem> inside_;  // of the basket, as let down
  std::vector<skills::CarriedItem> met_;     // there, by what is being let down
  bool anywhere_ = false;                    // wherever that comes to lie
  Pose let_go_;                              // base_from_tip, where nothing is felt
  std::size_t lift_tried_ = 0;
  std::uint64_t moves_ = 0;
};

}  // namespace marketgen::policy
