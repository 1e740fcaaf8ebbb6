// Checkout Unloading in physics: reset to an episode, act, be judged. The same World as in the
// aisles, of a checkout lane with what is round it or of a room
// (episodes/checkout/checkout_scene.h), with the counter and the episode's items: the items lie
// loose, the basket and the arm are its actors.
//
// Station frame (episodes/checkout/checkout_station.h), SI units.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "episodes/checkout/checkout_scene.h"
#include "episodes/checkout/checkout_station.h"
#include "episodes/cup_commands.h"
#include "episodes/episode_goods.h"
#include "episodes/episode_watch.h"
#include "episodes/perturbation.h"
#include "episodes/track_world.h"
#include "scene/scene.h"

namespace marketgen::episodes {

class CheckoutWorld : public TrackWorld {
 public:
  // `tools`: a tool set of the station, the first when empty. Errors: those of
  // load_checkout_station, load_station_robot.
  static Result<CheckoutWorld> create(const std::filesystem::path& data,
                                      std::vector<catalog::FrictionRow> frictions,
                                      const std::string& station = checkout_station,
                                      const std::string& tools = {});

  // `lane`: the place of an episode that names one, made for this station; none for others. Errors:
  // catalog.unknown_sku for an item without a row in `products`; robot.unknown when the episode is
  // for another robot, station or tool set; episode.other_store when it is at another lane;
  // assets.*, physics.failed. With a perturbation basket and items come to lie a little elsewhere:
  // each item as far of what is drawn for it as it meets nothing, all then left to settle; spec()
  // tells where they lie. So does the basket with what lies in it where the realism displaces it.
  Result<void> reset(const EpisodeSpec& spec,
                     const std::vector<catalog::Product>& products,
                     std::shared_ptr<const CheckoutPlace> lane = nullptr,
                     const std::optional<Perturbation>& perturbation = {},
                     const Realism& realism = {});

  // Another world of the same episode, at its beginning: restore() brings it where this one is. Its
  // robot's sensors and commands err by streams of their own.
  Result<std::unique_ptr<CheckoutWorld>> twin() const;

  Result<agent::Observation> step(const agent::Action& action) override;
  bool done() const override { return done_; }
  double time_s() const override;
  int steps() const override { return steps_; }
  Result<EpisodeResult> finish() override;

  std::string save() const override;
  Result<void> restore(std::string_view moment) override;
  std::string state_hash() const override { return world_->state_hash(); }

  // ---- The truth: for the oracle, pictures and tests; no policy may look. ----

  const EpisodeSpec& spec() const override { return spec_; }
  const CheckoutStation& station() const { return station_; }
  const robots::Robot& robot() const override { return *robot_; }
  const EpisodeGoods& goods(std::size_t item) const { return *item_goods_[item]; }
  std::size_t item_count() const { return item_goods_.size(); }
  Pose item_pose(std::size_t item) const;      // station_from_product
  Vec3 item_velocity(std::size_t item) const;  // of its body's middle
  Pose basket_pose() const;                    // station_from_container
  Scenery scenery() const override;
  const physics::RobotController& controller() const override { return controller_; }
  const EpisodeWatch& watch() const override { return watch_; }
  const EpisodeWatch::Item& watched(std::size_t item) const {
    return watch_.items().at(product_of(item));
  }
  // Of the lane or the room, with the items; the frame of model() and data().
  const scene::Scene& scene() const { return *scene_; }
  std::uint32_t product_of(std::size_t item) const {  // its row in that scene
    return first_item_ + static_cast<std::uint32_t>(item);
  }
  std::vector<std::uint32_t> moved_neighbours() const;  // rows of its products that are no items
  Pose product_pose(std::uint32_t product) const { return world_->product_pose(product); }
  const Pose& store_from_station() const { return place_->store_from_station; }
  HoldsPoint region() const;              // where goals count, as the basket stands now
  bool in_place(std::size_t item) const;  // on the unloading area, let go, at rest
  // By the same rules in another region. Station frame.
  bool rests_in(const HoldsPoint& region, std::size_t item) const;
  Result<bool> goals_met() override;
  std::vector<double> robot_state() const override;
  SealedProducts sealed_products() const;  // rows of scene()
  // Between any two things but the arm's own, in the last step.
  double deepest_overlap_m() const;
  const mjModel_& model() const override { return world_->model(); }
  const mjData_& data() const override { return world_->data(); }
  AnyWorld any() const override { return this; }
  std::vector<MovedThing> things() const override;
  MovedThing thing_of(std::uint32_t product) const override;
  std::vector<double> joint_positions() const override;
  Pose store_from_robot() const override { return store_from_station(); }
  Result<std::unique_ptr<TrackView>> open_view() const override;  // checkout_view.cpp

 protected:
  agent::Observation as_it_is() const override;

 private:
  explicit CheckoutWorld(std::vector<catalog::FrictionRow> frictions)
      : frictions_(std::move(frictions)) {}
  Result<void> check_reset(const EpisodeSpec& spec, const CheckoutPlace* lane) const;
  Result<void> begin(const EpisodeSpec& spec);
  Result<void> place_items(const std::vector<EpisodeItem>& items);
  Result<physics::World> make_world(const scene::Scene& scene) const;
  // ---- perturbed_checkout.cpp ----
  EpisodeSpec displaced(EpisodeSpec spec);
  Result<void> begin_perturbed(const EpisodeSpec& spec);
  Result<std::vector<EpisodeItem>> apart(const EpisodeSpec& spec, double most);
  bool halve_pressed(std::vector<double>& shares) const;
  Result<std::optional<EpisodeSpec>> settled(EpisodeSpec spec);
  std::vector<std::uint32_t> item_rows() const;
  Result<void> move(const agent::Action& action);
  EpisodeWatch::Moment moment() const;
  ItemState item_state(std::size_t item) const;
  std::vector<ItemState> item_states() const;
  SideEffects side_effects(const EpisodeOutcome& outcome) const;

  CheckoutStation station_;
  std::unique_ptr<robots::Robot> robot_;
  std::vector<int> arm_;  // degrees of freedom that are commanded
  std::vector<catalog::FrictionRow> frictions_;

  EpisodeSpec spec_;
  std::optional<Perturbation> perturbation_;
  Pose basket_start_;  // station_from_container
  std::vector<SharedEpisodeGoods> item_goods_;
  std::shared_ptr<const CheckoutPlace> room_, place_;  // place_: of the episode
  Pose station_from_store_;
  std::unique_ptr<scene::Scene> scene_;
  std::uint32_t first_item_ = 0;           // row of its products
  std::unique_ptr<physics::World> world_;  // goes before the scene
  int basket_place_ = 0;                   // of its free joint in MuJoCo's qpos
  physics::RobotController controller_;
  physics::SuctionActor cups_;
  EpisodeWatch watch_;
  int steps_ = 0;
  bool done_ = true;
};

}  // namespace marketgen::episodes
