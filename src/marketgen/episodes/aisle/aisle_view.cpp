#include "episodes/aisle/aisle_view.h"

#include <fmt/format.h>

#include "episodes/field_of_view.h"
#include "render/stage/robot_actor.h"

namespace marketgen::episodes {
namespace {

constexpr std::string_view head_name = "head_camera";

Vec3 vec3_of_row(const robots::Triple& row) {
  return {row[0], row[1], row[2]};
}

}  // namespace

Result<std::unique_ptr<AisleView>> AisleView::create(const AisleWorld& world) {
  std::unique_ptr<AisleView> view(new AisleView);
  view->station_ = world.store().station;
  MARKETGEN_TRY(view->renderer_, render::Renderer::create(world.store().scene));
  MARKETGEN_TRY(render::Actor robot, render::robot_actor(world.robot(), world.robot_state(), {}));
  MARKETGEN_CHECK(view->renderer_->set_actors({std::move(robot)}));
  MARKETGEN_CHECK(view->follow(world));
  return view;
}

Result<std::unique_ptr<TrackView>> AisleWorld::open_view() const {
  return open_view_of<AisleView>(*this);
}

Result<void> AisleView::follow(const AisleWorld& world, const Scenery& then) {
  std::vector<render::MovedProduct> moved;
  for (const auto& [row, pose] : then.products)
    moved.push_back({row, pose});
  MARKETGEN_CHECK(renderer_->move_things(moved, {}));
  MARKETGEN_CHECK(
      renderer_->move_actor(0, render::world_link_poses(world.robot(), then.robot, {})));
  world_from_base_ = base_of(world.robot(), then.robot);
  world_from_head_ = robots::frame_pose(
      world.robot(), then.robot, world.robot().find_frame(station_.head_camera.frame));
  return {};
}

Result<render::Camera> AisleView::camera(std::string_view name, int width, int height) const {
  render::Camera camera;
  camera.name = name;
  const auto size = [&](const auto& row) {
    camera.width = width > 0 ? width : row.width;
    camera.height = height > 0 ? height : row.height;
    camera.fov_deg = fov_down_deg(row.fov_deg, camera.width, camera.height);
  };
  if (name == head_name) {
    size(station_.head_camera);
    camera.world_from_camera = world_from_head_;
    return camera;
  }
  if (name == film_camera_name) {
    size(station_.film_camera);
    camera.from = world_from_base_ * vec3_of_row(station_.film_camera.from_m);
    camera.at = world_from_base_ * vec3_of_row(station_.film_camera.at_m);
    return camera;
  }
  return Error{"camera.unknown",
               std::string(name),
               fmt::format("there are {} and {}", head_name, film_camera_name)};
}

}  // namespace marketgen::episodes
