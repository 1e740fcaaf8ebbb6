// Checkout Unloading in physics: reset to an episode, act, be judged.
//
// Physics 500 Hz, control 20 Hz. Station frame (episodes/checkout_station.h), SI units. A
// CheckoutWorld is a function of its episode and its actions: bit for bit, in any process. Not
// thread-safe; one a thread.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "agent/policy.h"
#include "episodes/checkout_watch.h"
#include "physics/mujoco_moment.h"
#include "physics/robot_actor.h"

namespace marketgen {

constexpr double control_step_s = 0.05;

// A moment; may be restored by a world that was reset to the same episode.
struct CheckoutSnapshot {
  MujocoMoment physics;
  std::vector<double> target;
  CheckoutWatch watch;
  int steps = 0;
  bool done = false;
};

class CheckoutWorld {
 public:
  // Errors: those of load_station_robot.
  static Result<CheckoutWorld> create(const std::filesystem::path& data,
                                      std::vector<FrictionRow> frictions);

  // Errors: catalog.unknown_sku for an item without a row in `products`; robot.unknown when the
  // episode is for another robot; assets.*, physics.failed.
  Result<void> reset(const EpisodeSpec& spec, const std::vector<Product>& products);

  Observation observe() const;
  // One control step. Error episode.bad_action: not finite, another number of values, or after the
  // end; the world is then as before. physics.failed.
  Result<Observation> step(const Action& action);
  bool done() const { return done_; }  // the agent stopped, or the time is over
  double time_s() const;
  int steps() const { return steps_; }

  // Waits for the judgement, and judges. Names, times and failure code are the caller's to add.
  Result<EpisodeResult> finish();

  CheckoutSnapshot save() const;
  Result<void> restore(const CheckoutSnapshot& moment);  // error physics.bad_command
  std::string state_hash() const;                        // 32 hex digits over the physics

  // ---- The truth: for the oracle, pictures and tests; no policy may look. ----

  const EpisodeSpec& spec() const { return spec_; }
  const CheckoutStation& station() const { return station_; }
  const Robot& robot() const { return *robot_; }
  const CheckoutGoods& goods(std::size_t item) const { return *item_goods_[item]; }
  std::size_t item_count() const { return item_goods_.size(); }
  Pose item_pose(std::size_t item) const;  // station_from_product
  Pose basket_pose() const;                // station_from_container
  const CheckoutWatch& watch() const { return watch_; }
  std::vector<double> robot_state() const;
  double deepest_overlap_m() const;  // between any two things but the arm's own

 private:
  explicit CheckoutWorld(std::vector<FrictionRow> frictions) : frictions_(std::move(frictions)) {}
  Result<void> check(const Action& action) const;
  Result<void> move(const std::vector<double>& target, double opening_m, double force_n);
  std::vector<ItemState> item_states() const;
  SideEffects side_effects(const CheckoutOutcome& outcome) const;

  CheckoutStation station_;
  std::unique_ptr<Robot> robot_;
  std::vector<int> arm_;  // degrees of freedom
  std::vector<FrictionRow> frictions_;

  EpisodeSpec spec_;
  std::vector<SharedGoods> item_goods_;
  CheckoutModel model_;
  MujocoData data_{nullptr, mj_deleteData};
  RobotActor actor_;
  std::vector<double> target_;  // of the arm, at the end of the last step
  CheckoutWatch watch_;
  int steps_ = 0;
  bool done_ = true;
};

}  // namespace marketgen
