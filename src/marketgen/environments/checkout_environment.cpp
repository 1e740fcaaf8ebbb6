#include "environments/checkout_environment.h"

#include <fmt/format.h>

#include "environments/goal_nearness.h"
#include "episodes/checkout_view.h"

namespace marketgen {
namespace {

constexpr double reward_scale_m = 1.0 / 3;  // half a metre away counts 0.1
constexpr char filming[] = "film_camera";   // seen as by the scene camera

class CheckoutEnvironment : public Environment {
 public:
  CheckoutEnvironment(std::shared_ptr<EpisodeGround> shared,
                      const EnvironmentOptions& options,
                      CheckoutWorld world)
      : Environment(std::move(shared), Track::checkout, options), counter_(std::move(world)) {
    set_robot(counter_.robot());
  }

  std::vector<std::string> cameras() const override {
    const auto names = names_of(StationCamera{});
    return {names.begin(), names.end()};
  }

  Result<Frame> picture(const std::string& camera,
                        int width,
                        int height,
                        const RenderOptions& options) override {
    MARKETGEN_TRY(const Camera from, this->camera(camera, width, height));
    return view_->renderer().render(from, options);
  }

  Result<Camera> camera(const std::string& camera, int width, int height) override {
    const auto which =
        camera == filming ? StationCamera::scene : value_named<StationCamera>(camera);
    if (!which) return Error{"camera.unknown", camera, "there are scene_camera and wrist_camera"};
    MARKETGEN_CHECK(show());
    return view_->camera(*which, width, height);
  }

 protected:
  Result<TrackWorld*> begin(const EpisodeSpec& spec) override {
    view_.reset();
    MARKETGEN_CHECK(counter_.reset(spec, ground().products()));
    return &counter_;
  }

  // To the middle of the unloading area.
  double nearness() const override {
    const UnloadingRow& area = counter_.station().unloading;
    const auto distances = [&](const EpisodeGoal& goal) {
      std::vector<double> found;
      for (std::size_t i = 0; i < counter_.item_count(); ++i) {
        if (counter_.spec().items[i].sku != goal.sku) continue;
        const Vec3 at = counter_.item_pose(i).position;
        found.push_back(std::hypot(at.x - area.center_m[0], at.y - area.center_m[1]));
      }
      return found;
    };
    return goal_nearness(counter_.spec().goals, reward_scale_m, distances);
  }

 private:
  Result<void> show() {
    if (view_) return view_->follow(counter_);
    MARKETGEN_TRY(view_, CheckoutView::create(counter_));
    return {};
  }

  CheckoutWorld counter_;
  std::unique_ptr<CheckoutView> view_;  // of this episode, once a picture was asked for
};

}  // namespace

Result<std::unique_ptr<Environment>> make_checkout_environment(
    std::shared_ptr<EpisodeGround> ground, const EnvironmentOptions& options) {
  MARKETGEN_TRY(CheckoutWorld world,
                CheckoutWorld::create(ground->data(), ground->catalog().frictions));
  return std::unique_ptr<Environment>(
      std::make_unique<CheckoutEnvironment>(std::move(ground), options, std::move(world)));
}

}  // namespace marketgen
