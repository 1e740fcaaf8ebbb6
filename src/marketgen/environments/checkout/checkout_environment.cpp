#include "environments/checkout/checkout_environment.h"

#include <algorithm>

#include "environments/checkout/shared_lane.h"
#include "environments/goal_nearness.h"
#include "episodes/camera_senses.h"
#include "episodes/checkout/checkout_goals.h"
#include "episodes/checkout/checkout_view.h"
#include "episodes/checkout/sample_one_item.h"

namespace marketgen::environments {
namespace {

constexpr double reward_scale_m = 1.0 / 3;  // half a metre away counts 0.1
constexpr ProgressScale counter_scale{0.15, 0.25};
// Beyond that a thing lies on the floor, and far off.
constexpr ObservationBounds counter_bounds{3, 3};

class CheckoutEnvironment : public Environment {
 public:
  CheckoutEnvironment(std::shared_ptr<EpisodeGround> shared,
                      const EnvironmentOptions& options,
                      episodes::CheckoutWorld world)
      : Environment(std::move(shared), episodes::Track::checkout, options),
        counter_(std::move(world)) {
    set_robot(counter_.robot(), counter_bounds);
  }

  std::vector<std::string> cameras() const override {
    const auto names = episodes::names_of(episodes::StationCamera{});
    return {names.begin(), names.end()};
  }

  Result<render::Frame> picture(const std::string& camera,
                                int width,
                                int height,
                                const render::RenderOptions& options) override {
    MARKETGEN_TRY(const render::Camera from, camera_in_room(camera, width, height));
    if (camera == episodes::film_camera_name) return view_->renderer().render(from, options);
    return episodes::sensed_picture(counter_, camera, view_->renderer(), from, options);
  }

  Result<render::Camera> camera(const std::string& camera, int width, int height) override {
    MARKETGEN_TRY(const render::Camera there, camera_in_room(camera, width, height));
    return render::posed_camera(
        there.name,
        inverse(view_->world_from_station()) * render::opencv_pose_of(there),
        render::intrinsics_of(there),
        there.width,
        there.height);
  }

  Result<std::vector<std::pair<std::uint32_t, std::string>>> products() override {
    std::vector<std::pair<std::uint32_t, std::string>> rows;
    for (std::size_t i = 0; i < counter_.item_count(); ++i)
      rows.emplace_back(episodes::CheckoutView::object_of_item(counter_, i),
                        counter_.spec().items[i].sku);
    return rows;
  }

  Result<std::vector<EnvironmentItem>> items() override {
    std::vector<EnvironmentItem> rows;
    for (std::size_t i = 0; i < counter_.item_count(); ++i)
      rows.push_back(item(i));
    return rows;
  }

  EnvironmentPlace place() const override {
    if (into_basket()) {
      const episodes::BasketRow& basket = counter_.station().basket;
      const Pose floor = counter_.basket_pose();
      return {floor * Vec3{0, 0, basket.height_m / 2},
              {basket.top_m[0], basket.top_m[1], basket.height_m},
              floor};
    }
    const episodes::UnloadingRow& area = counter_.station().unloading;
    return {{area.center_m[0], area.center_m[1], 0},
            {area.size_m[0], area.size_m[1], 0},
            counter_.basket_pose()};
  }

 protected:
  Result<episodes::TrackWorld*> begin(const episodes::EpisodeSpec& spec) override {
    view_.reset();
    MARKETGEN_TRY(auto lane, shared_lane(ground().arena(), counter_.station(), spec));
    MARKETGEN_CHECK(
        counter_.reset(spec, ground().products(), std::move(lane), {}, this->options().realism));
    return &counter_;
  }

  // To the middle of the unloading area.
  double nearness() const override {
    const episodes::UnloadingRow& area = counter_.station().unloading;
    const auto distances = [&](const episodes::EpisodeGoal& goal) {
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

  ProgressScale progress_scale() const override { return counter_scale; }

 private:
  EnvironmentItem item(std::size_t i) const {
    const episodes::EpisodeWatch::Item& seen = counter_.watched(i);
    const episodes::EpisodeGoods& goods = counter_.goods(i);
    EnvironmentItem made;
    made.sku = goods.product.sku;
    made.pose = counter_.item_pose(i);
    made.middle = made.pose * Vec3{0, 0, goods.product.height_m() / 2};
    made.size_m = {goods.product.width_m(), goods.product.depth_m(), goods.product.height_m()};
    made.velocity_m_s = counter_.item_velocity(i);
    made.wanted =
        std::ranges::count(counter_.spec().goals, made.sku, &episodes::EpisodeGoal::sku) > 0;
    made.held = seen.held_by >= 0;
    made.touched = seen.touched_by >= 0;
    const Vec3 center = made.pose * to_double(goods.body.center_of_mass);
    made.in_place = counter_.rests_in(region(), i);
    made.in_region = region()(center);
    made.rested_s = seen.rested_s;
    made.object = episodes::CheckoutView::object_of_item(counter_, i);
    return made;
  }

  bool into_basket() const { return options().stage == episodes::Stage::place; }

  // Where goods are to go.
  episodes::HoldsPoint region() const {
    if (!into_basket()) return counter_.region();
    return episodes::in_basket({counter_.station().container(), counter_.basket_pose()});
  }

  Result<render::Camera> camera_in_room(const std::string& camera, int width, int height) {
    MARKETGEN_CHECK(show(camera));
    return view_->camera(camera, width, height);
  }

  // As that camera gives it.
  Result<void> show(const std::string& camera) {
    if (!view_) {
      MARKETGEN_TRY(view_, episodes::CheckoutView::create(counter_));
    }
    return view_->follow(
        counter_, camera == episodes::film_camera_name ? counter_.scenery() : counter_.pictured());
  }

  episodes::CheckoutWorld counter_;
  std::unique_ptr<episodes::CheckoutView> view_;  // of this episode, once a picture was asked for
};

}  // namespace

Result<std::unique_ptr<Environment>> make_checkout_environment(
    std::shared_ptr<EpisodeGround> ground, const EnvironmentOptions& options) {
  const std::string station = episodes::station_or_own(options.station);
  MARKETGEN_TRY(episodes::CheckoutWorld world,
                episodes::CheckoutWorld::create(
                    ground->data(), ground->catalog().frictions, station, options.tools));
  return std::unique_ptr<Environment>(
      std::make_unique<CheckoutEnvironment>(std::move(ground), options, std::move(world)));
}

Result<episodes::EpisodeSpec> draw_one_item(const EpisodeGround& ground, std::uint64_t seed) {
  const episodes::EpisodeStore& row = ground.stores().front();
  return episodes::sample_one_item(
      ground.data(), ground.products(), {row.name, row.scene_hash, row.plan_hash}, Seed(seed), 0);
}

}  // namespace marketgen::environments
