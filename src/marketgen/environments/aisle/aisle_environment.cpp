#include "environments/aisle/aisle_environment.h"

#include <algorithm>

#include "agent/aisle_map.h"
#include "environments/aisle/shared_aisle.h"
#include "environments/draw_stage.h"
#include "environments/goal_nearness.h"
#include "episodes/aisle/aisle_stage.h"
#include "episodes/aisle/aisle_world.h"
#include "episodes/camera_senses.h"
#include "io/json.h"
#include "render/picture_objects.h"

namespace marketgen::environments {
namespace {

constexpr double aisle_reward_scale_m = 3;  // 4.4 m away counts 0.1
constexpr ProgressScale aisle_scale{aisle_reward_scale_m, aisle_reward_scale_m};

class AisleEnvironment : public Environment {
 public:
  AisleEnvironment(std::shared_ptr<EpisodeGround> shared,
                   const EnvironmentOptions& options,
                   robots::Robot robot)
      : Environment(std::move(shared), episodes::Track::aisle, options), robot_(std::move(robot)) {
    const double far = ground().largest_side_m();
    set_robot(robot_, {far, 2 * far});  // from one corner of a store to another
  }

  std::vector<std::string> cameras() const override {
    return {episodes::aisle_cameras.begin(), episodes::aisle_cameras.end()};
  }
  // What is in a hand's picture the head mostly sees, too, and each picture takes its time.
  std::vector<std::string> usual_cameras() const override {
    return {std::string(episodes::aisle_cameras.front())};
  }

  Result<render::Frame> picture(const std::string& camera,
                                int width,
                                int height,
                                const render::RenderOptions& options) override {
    const std::scoped_lock lock(view_->mutex);
    MARKETGEN_CHECK(show(camera));
    MARKETGEN_TRY(const render::Camera from, view_->view->camera(camera, width, height));
    if (!episodes::is_aisle_camera(camera)) return view_->view->renderer().render(from, options);
    return episodes::sensed_picture(*aisles_, camera, view_->view->renderer(), from, options);
  }

  // The robot knows where its cameras are from its joints and from where it believes that it
  // stands: the true place would tell it how far off that is.
  Result<render::Camera> camera(const std::string& camera, int width, int height) override {
    const std::scoped_lock lock(view_->mutex);
    MARKETGEN_CHECK(show(camera));
    MARKETGEN_TRY(render::Camera seen, view_->view->camera(camera, width, height));
    if (episodes::is_aisle_camera(camera))
      seen.world_from_camera = agent::store_from_base(aisles_->observe().base) *
                               inverse(view_->view->world_from_base()) * *seen.world_from_camera;
    return seen;
  }

  Result<std::vector<std::pair<std::uint32_t, std::string>>> products() override {
    const scene::Scene& scene = aisles_->store().scene;
    std::vector<std::pair<std::uint32_t, std::string>> rows;
    for (std::uint32_t row = 0; row < scene.products.size(); ++row)
      rows.emplace_back(render::first_product_object(scene) + row,
                        scene.catalog[scene.products[row].sku].sku);
    return rows;
  }

  Result<std::vector<EnvironmentItem>> items() override {
    const std::vector<std::uint32_t> carried = aisles_->in_basket();
    const Pose base_from_world = inverse(aisles_->world_from_base());
    std::vector<EnvironmentItem> rows;
    for (const episodes::EpisodeGoal& goal : aisles_->spec().goals) {
      for (const std::uint32_t row : next_of(goal, carried)) {
        MARKETGEN_TRY(EnvironmentItem made, item(row, base_from_world));
        made.in_region = std::ranges::find(carried, row) != carried.end();
        rows.push_back(std::move(made));
      }
    }
    return rows;
  }

  EnvironmentPlace place() const override {
    const episodes::AisleStore& store = aisles_->store();
    const episodes::CarriedBasketRow& b = store.station.basket;
    const Pose floor = store.basket.base_from_floor;
    return {floor * Vec3{0, 0, b.height_m / 2}, {b.top_m[0], b.top_m[1], b.height_m}, floor};
  }

  Result<episodes::WayToStand> way_to_stand() const override {
    return episodes::way_to_stand(*aisles_);
  }

  Result<episodes::DoorSeen> door() const override { return episodes::door_seen(*aisles_); }

  Result<std::string> map() const override {
    MARKETGEN_TRY(const auto mapped, aisles_->mapped());
    return io::write_json(mapped->scene.layout);
  }

 protected:
  Result<episodes::TrackWorld*> begin(const episodes::EpisodeSpec& spec) override {
    if (spec.scene_hash != scene_hash_ || doors_of(spec) != doors_) {
      Arena& arena = ground().arena();
      MARKETGEN_TRY(auto store,
                    shared_aisle_store(arena, spec.scene_hash, options().tools, doors_of(spec)));
      MARKETGEN_TRY(shared_view_, shared_aisle_view(arena, spec.scene_hash, options().tools));
      aisles_ =
          std::make_unique<episodes::AisleWorld>(std::move(store), ground().catalog().frictions);
      scene_hash_ = spec.scene_hash;
      doors_ = doors_of(spec);
    }
    std::vector<double> posture;
    wanted_.clear();
    for (const episodes::EpisodeGoal& goal : spec.goals)
      wanted_.emplace(goal.sku, aisles_->stocked().front_items(goal.sku));
    if (options().stage == episodes::Stage::pick) {
      MARKETGEN_TRY(posture, start_of_pick(ground(), spec));
      MARKETGEN_TRY(const std::uint32_t row, witnessed_product(aisles_->stocked(), spec));
      wanted_ = {{spec.certificate.witness.front().sku, {row}}};
    }
    if (options().stage == episodes::Stage::open) {
      MARKETGEN_TRY(posture, start_of_open(ground(), spec));
    }
    MARKETGEN_CHECK(aisles_->reset(spec, {}, options().realism, std::move(posture)));
    // A renderer has its store's goods where they stood when it was made.
    const bool as_stocked = &aisles_->store() == &aisles_->stocked();
    view_ = as_stocked ? shared_view_ : std::make_shared<SharedAisleView>();
    return aisles_.get();
  }

  // To the robot's basket.
  double nearness() const override {
    const Vec3 basket = aisles_->world_from_basket().position;
    return goal_nearness(
        aisles_->spec().goals, aisle_reward_scale_m, [&](const episodes::EpisodeGoal& goal) {
          std::vector<double> found;
          for (const std::uint32_t row : wanted_.at(goal.sku))
            found.push_back(length(aisles_->world().product_pose(row).position - basket));
          return found;
        });
  }

  ProgressScale progress_scale() const override { return aisle_scale; }

 private:
  // As many as are asked for: those in the basket, then those next to the robot.
  std::vector<std::uint32_t> next_of(const episodes::EpisodeGoal& goal,
                                     const std::vector<std::uint32_t>& carried) const {
    const scene::Scene& scene = aisles_->store().scene;
    std::vector<std::uint32_t> rows;
    for (const std::uint32_t row : carried)
      if (scene.catalog[scene.products[row].sku].sku == goal.sku) rows.push_back(row);
    const Vec3 robot = aisles_->world_from_base().position;
    std::vector<std::pair<double, std::uint32_t>> others;
    for (const std::uint32_t row : wanted_.at(goal.sku))
      if (std::ranges::find(carried, row) == carried.end())
        others.emplace_back(length(aisles_->world().product_pose(row).position - robot), row);
    std::ranges::sort(others);
    for (const auto& [distance, row] : others)
      rows.push_back(row);
    rows.resize(std::min(rows.size(), static_cast<std::size_t>(goal.count)));
    return rows;
  }

  Result<EnvironmentItem> item(std::uint32_t row, const Pose& base_from_world) {
    const scene::Scene& scene = aisles_->store().scene;
    const catalog::Product& product = scene.catalog[scene.products[row].sku];
    const physics::ProductMotion motion = aisles_->world().product_motion(row);
    EnvironmentItem made;
    made.sku = product.sku;
    made.pose = base_from_world * motion.pose;
    made.middle = made.pose * Vec3{0, 0, product.height_m() / 2};
    made.size_m = {product.width_m(), product.depth_m(), product.height_m()};
    made.velocity_m_s = rotate(base_from_world.rotation, motion.velocity_m_s);
    made.wanted = true;
    made.held = aisles_->watch().is_held(row);
    if (const auto seen = aisles_->watch().items().find(row);
        seen != aisles_->watch().items().end()) {
      made.touched = seen->second.touched_by >= 0;
      made.rested_s = seen->second.rested_s;
    }
    MARKETGEN_TRY(made.in_place, aisles_->in_place(row));
    made.object = render::first_product_object(scene) + row;
    return made;
  }

  // As that camera gives it. The caller has the view's lock.
  Result<void> show(const std::string& camera) {
    if (!view_->view) {
      MARKETGEN_TRY(view_->view, episodes::AisleView::create(*aisles_));
    }
    return view_->view->follow(
        *aisles_, episodes::is_aisle_camera(camera) ? aisles_->pictured() : aisles_->scenery());
  }

  robots::Robot robot_;
  std::string scene_hash_;
  episodes::Doors doors_ = episodes::Doors::none;
  std::unique_ptr<episodes::AisleWorld> aisles_;
  std::shared_ptr<SharedAisleView> shared_view_;
  std::shared_ptr<SharedAisleView> view_;                     // shared_view_, or this episode's own
  std::map<std::string, std::vector<std::uint32_t>> wanted_;  // rows of products by SKU
};

}  // namespace

Result<std::unique_ptr<Environment>> make_aisle_environment(std::shared_ptr<EpisodeGround> ground,
                                                            const EnvironmentOptions& options) {
  MARKETGEN_TRY(const episodes::AisleStation station,
                episodes::load_aisle_station(ground->data(), options.tools));
  MARKETGEN_TRY(robots::Robot robot, episodes::load_station_robot(ground->data(), station));
  return std::unique_ptr<Environment>(
      std::make_unique<AisleEnvironment>(std::move(ground), options, std::move(robot)));
}

}  // namespace marketgen::environments
