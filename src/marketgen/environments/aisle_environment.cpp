#include "environments/aisle_environment.h"

#include <algorithm>

#include "environments/goal_nearness.h"
#include "io/json.h"

namespace marketgen {
namespace {

constexpr double aisle_reward_scale_m = 3;  // 4.4 m away counts 0.1
constexpr char head[] = "head_camera";

class AisleEnvironment : public Environment {
 public:
  AisleEnvironment(std::shared_ptr<EpisodeGround> shared,
                   const EnvironmentOptions& options,
                   Robot robot)
      : Environment(std::move(shared), Track::aisle, options), robot_(std::move(robot)) {
    set_robot(robot_);
  }

  std::vector<std::string> cameras() const override { return {head}; }

  Result<Frame> picture(const std::string& camera,
                        int width,
                        int height,
                        const RenderOptions& options) override {
    const std::scoped_lock lock(view_->mutex);
    MARKETGEN_CHECK(show());
    MARKETGEN_TRY(const Camera from, view_->view->camera(camera, width, height));
    return view_->view->renderer().render(from, options);
  }

  Result<Camera> camera(const std::string& camera, int width, int height) override {
    const std::scoped_lock lock(view_->mutex);
    MARKETGEN_CHECK(show());
    return view_->view->camera(camera, width, height);
  }

  std::string map() const override { return write_json(aisles_->store().scene.layout); }

 protected:
  Result<TrackWorld*> begin(const EpisodeSpec& spec) override {
    if (spec.scene_hash != scene_hash_) {
      MARKETGEN_TRY(auto store, ground().aisle_store(spec.scene_hash, options().tools));
      aisles_ = std::make_unique<AisleWorld>(std::move(store), ground().catalog().frictions);
      view_ = ground().aisle_view(spec.scene_hash, options().tools);
      scene_hash_ = spec.scene_hash;
    }
    MARKETGEN_CHECK(aisles_->reset(spec));
    wanted_.clear();
    for (const EpisodeGoal& goal : spec.goals)
      wanted_.emplace(goal.sku, aisles_->store().front_items(goal.sku));
    return aisles_.get();
  }

  // To the robot's basket.
  double nearness() const override {
    const Vec3 basket = aisles_->world_from_basket().position;
    return goal_nearness(aisles_->spec().goals, aisle_reward_scale_m, [&](const EpisodeGoal& goal) {
      std::vector<double> found;
      for (const std::uint32_t row : wanted_.at(goal.sku))
        found.push_back(length(aisles_->world().product_pose(row).position - basket));
      return found;
    });
  }

 private:
  // The caller has the view's lock.
  Result<void> show() {
    if (view_->view) return view_->view->follow(*aisles_);
    MARKETGEN_TRY(view_->view, AisleView::create(*aisles_));
    return {};
  }

  Robot robot_;
  std::string scene_hash_;
  std::unique_ptr<AisleWorld> aisles_;
  std::shared_ptr<SharedAisleView> view_;
  std::map<std::string, std::vector<std::uint32_t>> wanted_;  // rows of products by SKU
};

}  // namespace

Result<std::unique_ptr<Environment>> make_aisle_environment(std::shared_ptr<EpisodeGround> ground,
                                                            const EnvironmentOptions& options) {
  MARKETGEN_TRY(const AisleStation station, load_aisle_station(ground->data(), options.tools));
  MARKETGEN_TRY(Robot robot, load_station_robot(ground->data(), station));
  return std::unique_ptr<Environment>(
      std::make_unique<AisleEnvironment>(std::move(ground), options, std::move(robot)));
}

}  // namespace marketgen
