// In-Aisle Item Collection in physics: a robot with two arms in a whole stocked store. Store frame,
// SI units.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "episodes/aisle/aisle_store.h"
#include "episodes/aisle/people_in_world.h"
#include "episodes/aisle/studied_grasps.h"
#include "episodes/cup_commands.h"
#include "episodes/episode_goods.h"
#include "episodes/episode_watch.h"
#include "episodes/perturbation.h"
#include "episodes/track_world.h"
#include "motion/collision_world.h"

namespace marketgen::episodes {

constexpr double max_shut_rad = 0.035;  // two degrees: a gasket's lips still touch

class AisleWorld : public TrackWorld {
 public:
  AisleWorld(std::shared_ptr<const AisleStore> store, std::vector<catalog::FrictionRow> frictions)
      : stocked_(std::move(store)), store_(stocked_), frictions_(std::move(frictions)) {}

  // Errors: robot.unknown when the episode is for another robot or for other tools;
  // episode.impossible when its start is not free; catalog.unknown_sku for a goal that the store
  // does not have; assets.*, physics.failed. With a perturbation store() is perturbed_store().
  // `posture`: of every degree of freedom at the start, but the base's; as it drives when empty.
  Result<void> reset(const EpisodeSpec& spec,
                     const std::optional<Perturbation>& perturbation = {},
                     const Realism& realism = {},
                     std::vector<double> posture = {});

  const EpisodeSpec& spec() const override { return spec_; }
  const robots::Robot& robot() const override { return store_->robot; }
  Result<agent::Observation> step(const agent::Action& action) override;
  bool done() const override { return done_; }
  double time_s() const override;
  int steps() const override { return steps_; }
  Result<EpisodeResult> finish() override;
  std::string state_hash() const override { return world_->state_hash(); }
  Result<bool> goals_met() override;
  std::string save() const override;
  Result<void> restore(std::string_view moment) override;

  // As the map has the store that the agent is given; made anew at each call. Errors: those of
  // mapped_store.
  Result<std::shared_ptr<const AisleStore>> mapped() const;

  // ---- The truth: for the oracle, pictures and tests; no policy may look. ----

  const AisleStore& store() const { return *store_; }
  // The store as it was stocked, of which store() is a perturbed one, or the same.
  const AisleStore& stocked() const { return *stocked_; }
  const physics::World& world() const { return *world_; }
  const PeopleAround& people() const { return people_.around(); }
  Scenery scenery() const override;
  const physics::RobotController& controller() const override { return controller_; }
  const mjModel_& model() const override { return world_->model(); }
  const mjData_& data() const override { return world_->data(); }
  AnyWorld any() const override { return this; }
  std::vector<MovedThing> things() const override;
  MovedThing thing_of(std::uint32_t product) const override;
  std::vector<double> joint_positions() const override;
  Pose store_from_robot() const override { return {}; }
  Result<std::unique_ptr<TrackView>> open_view() const override;  // aisle_view.cpp
  const EpisodeWatch& watch() const override { return watch_; }
  std::vector<double> robot_state() const override;
  Pose world_from_base() const;
  Pose world_from_basket() const;  // middle of its inner floor
  std::vector<std::uint32_t> in_basket() const;
  Result<bool> in_place(std::uint32_t product);  // in the basket, let go, at rest
  SealedProducts sealed_products() const;
  double path_m() const { return path_m_; }
  // What lies outside the basket, farther from where it stood than a clean episode moves it.
  int strayed() const;
  // The ledger so far, but for doors_open(), which takes a look at every door.
  SideEffects side_effects() const;
  // Hinged doors that stand open by more than max_shut_rad.
  int doors_open() const;
  // Another world of the same episode, at its beginning: restore() brings it where this one is. Its
  // robot's sensors and commands err by streams of their own.
  Result<std::shared_ptr<AisleWorld>> twin() const;
  // Grasps of the product by which the episode's witness would have it taken; all of them for a
  // product that is no goal. Errors: those of studied_grasps().
  Result<std::vector<motion::GraspCandidate>> known_grasps(std::uint32_t product,
                                                           const robots::GraspTool& tool) const;

 protected:
  agent::Observation as_it_is() const override;

 private:
  Result<void> begin(const EpisodeSpec& spec);
  Result<void> begin_people(const EpisodeSpec& spec);
  Result<void> move(const agent::Action& action);
  Result<void> know_goods(std::uint32_t product);
  ItemState item_state(std::uint32_t product, const EpisodeWatch::Item& item) const;
  Result<std::vector<ItemState>> item_states();
  EpisodeOutcome judged(const std::vector<ItemState>& states) const;
  HoldsPoint region() const;
  void add_lengths(EpisodeResult& result) const;

  std::shared_ptr<const AisleStore> stocked_, store_;  // store_: of the episode
  std::vector<catalog::FrictionRow> frictions_;
  std::optional<Perturbation> perturbation_;
  std::vector<double> posture_;                        // as reset() was given it
  std::map<std::uint32_t, SharedEpisodeGoods> goods_;  // by SKU row

  EpisodeSpec spec_;
  std::unique_ptr<physics::World> world_;
  physics::RobotController controller_;
  physics::SuctionActor cups_;
  std::vector<int> commanded_;  // degrees of freedom
  EpisodeWatch watch_;
  PeopleInWorld people_;
  Vec3 axle_;  // where the middle between the wheels was
  double path_m_ = 0;
  int steps_ = 0;
  bool done_ = true;
};

}  // namespace marketgen::episodes
