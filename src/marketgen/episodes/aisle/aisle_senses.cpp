#include "episodes/aisle/aisle_senses.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "collect/scene_obstacles.h"
#include "episodes/camera_senses.h"
#include "episodes/told_goals.h"

namespace marketgen::episodes {
Result<agent::View> AisleEyes::look(std::string_view camera) {
  if (!is_aisle_camera(camera))
    return Error{
        "usage.bad_flag",
        std::string(camera),
        fmt::format("the agent has no such camera; it has {}", fmt::join(aisle_cameras, ", "))};
  if (!view_) {
    MARKETGEN_TRY(view_, AisleView::create(world_));
  }
  const Scenery then = world_.pictured();
  MARKETGEN_CHECK(view_->follow(world_, then));
  MARKETGEN_TRY(const render::Camera taken, view_->camera(camera));
  MARKETGEN_TRY(render::Frame frame, sensed_picture(world_, camera, view_->renderer(), taken, {}));
  agent::View view;
  view.camera = camera;
  const render::Intrinsics lens = render::intrinsics_of(taken);
  view.lens = {lens.fx, lens.fy, lens.cx, lens.cy};
  view.time_s = then.time_s;
  view.base_from_camera = inverse(view_->world_from_base()) * render::opencv_pose_of(taken);
  view.color = std::move(frame.color);
  view.depth_m = std::move(frame.depth_m);
  return view;
}

StoreMap::StoreMap(const AisleStore& store) : store_(store) {
  for (std::uint32_t row = 0; row < store.scene.shelves.size(); ++row) {
    const scene::SceneShelf& shelf = store.scene.shelves[row];
    boards_.push_back({scene::world_from_shelf(store.scene, row),
                       shelf.width_m,
                       shelf.depth_m,
                       shelf.clearance_m,
                       shelf.use,
                       has_doors(store.scene, shelf.fixture)});
  }
}

PointMm StoreMap::axle_mm(const robots::BasePlace& place) const {
  return floor_mm(axle_of(store_.robot, agent::store_from_base(place)));
}

bool StoreMap::has_room(const robots::BasePlace& place) const {
  return store_.ways.space().free(axle_mm(place));
}

motion::FloorPlace StoreMap::floor_place(const robots::BasePlace& place) const {
  const Vec3 axle = axle_of(store_.robot, agent::store_from_base(place));
  return {{axle.x, axle.y}, place.heading};
}

Result<motion::WayRound> StoreMap::way_round(const robots::BasePlace& from,
                                             const robots::BasePlace& to,
                                             std::span<const motion::MovingDisc> people,
                                             bool waited) const {
  return motion::plan_way_round(store_.ways,
                                store_.robot,
                                store_.driving,
                                floor_place(from),
                                floor_place(to),
                                people,
                                waited);
}

Result<motion::BaseFollower> StoreMap::way(const robots::BasePlace& from,
                                           const robots::BasePlace& to) const {
  MARKETGEN_TRY(motion::DrivePlan plan,
                motion::plan_drive(
                    store_.ways, store_.robot, store_.driving, floor_place(from), floor_place(to)));
  return std::move(plan.follower);
}

std::optional<double> StoreMap::way_m(const robots::BasePlace& from,
                                      const robots::BasePlace& to) const {
  const auto path = store_.ways.shortest_path(axle_mm(from), axle_mm(to));
  return path.ok() ? std::optional(path->length_m) : std::nullopt;
}

motion::Obstacles StoreMap::fixtures(Vec3 middle, double within_m) const {
  return collect::fixture_obstacles(store_.scene, middle, within_m);
}

std::vector<agent::CategoryHint> category_hints(const EpisodeSpec& spec) {
  std::vector<agent::CategoryHint> hints;
  for (const ToldCategory& told : told_categories(spec))
    hints.push_back({static_cast<std::size_t>(told.goal), {told.x_m, told.y_m}});
  return hints;
}

}  // namespace marketgen::episodes
