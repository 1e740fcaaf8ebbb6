#include "episodes/checkout/checkout_view.h"

#include "episodes/field_of_view.h"
#include "geometry/rotation_axes.h"
#include "render/picture_objects.h"
#include "render/stage/robot_actor.h"

namespace marketgen::episodes {
namespace {

constexpr render::ActorSurface basket_plastic{{0.42F, 0.03F, 0.025F}, 0.45F, 0};

}  // namespace

render::Actor basket_actor(const CheckoutStation& station) {
  render::ActorBody body;
  body.name = "basket";
  body.surfaces = {basket_plastic};
  for (const physics::ContainerBox& box : station.basket_boxes()) {
    Mesh part;
    add_box(part, to_float(-box.half_size), to_float(box.half_size), 0, 0);
    for (std::size_t v = 0; v < part.positions.size(); ++v) {
      part.positions[v] = to_float(box.container_from_box * to_double(part.positions[v]));
      part.normals[v] =
          to_float(rotate(box.container_from_box.rotation, to_double(part.normals[v])));
    }
    body.mesh.append(part);
  }
  return {"basket", {std::move(body)}};
}

Result<std::unique_ptr<CheckoutView>> CheckoutView::create(const CheckoutStation& station,
                                                           const robots::Robot& robot,
                                                           std::unique_ptr<scene::Scene> scene,
                                                           const Pose& store_from_station,
                                                           const render::RendererOptions& options) {
  std::unique_ptr<CheckoutView> view(new CheckoutView);
  view->station_ = station;
  view->world_from_station_ = store_from_station;
  view->scene_ = std::move(scene);
  MARKETGEN_TRY(view->renderer_,
                render::Renderer::create(*view->scene_, silent_progress(), options));
  MARKETGEN_TRY(
      render::Actor actor,
      render::robot_actor(robot, robots::neutral_state(robot), view->world_from_station_));
  MARKETGEN_CHECK(view->renderer_->set_actors({basket_actor(station), std::move(actor)}));
  return view;
}

Result<std::unique_ptr<CheckoutView>> CheckoutView::create(const CheckoutWorld& world) {
  MARKETGEN_TRY(std::unique_ptr<CheckoutView> view,
                create(world.station(),
                       world.robot(),
                       std::make_unique<scene::Scene>(world.scene()),
                       world.store_from_station()));
  MARKETGEN_CHECK(view->follow(world));
  return view;
}

Result<std::unique_ptr<TrackView>> CheckoutWorld::open_view() const {
  return open_view_of<CheckoutView>(*this);
}

std::uint32_t CheckoutView::object_of_item(const CheckoutWorld& world, std::size_t item) {
  return render::first_product_object(world.scene()) + world.product_of(item);
}

Result<void> CheckoutView::follow(const robots::Robot& robot,
                                  const Scenery& then,
                                  std::span<const render::MovedJoint> joints) {
  std::vector<render::MovedProduct> items;
  for (const auto& [row, pose] : then.products)
    items.push_back({row, pose});
  MARKETGEN_CHECK(renderer_->move_things(items, joints));
  MARKETGEN_CHECK(renderer_->move_actor(0, {&*then.basket, 1}));
  const std::vector<Pose> links = render::world_link_poses(robot, then.robot, world_from_station_);
  MARKETGEN_CHECK(renderer_->move_actor(1, links));
  world_from_hand_ = links[static_cast<std::size_t>(robot.find_link("hand"))];
  return {};
}

Result<render::Camera> CheckoutView::camera(std::string_view name, int width, int height) const {
  const auto which =
      name == film_camera_name ? StationCamera::scene : value_named<StationCamera>(name);
  if (!which)
    return Error{"camera.unknown", std::string(name), "there are scene_camera and wrist_camera"};
  return camera(*which, width, height);
}

render::Camera CheckoutView::camera(StationCamera which, int width, int height) const {
  render::Camera camera;
  camera.name = name_of(which);
  const auto size = [&](const auto& row) {
    camera.width = width > 0 ? width : row.width;
    camera.height = height > 0 ? height : row.height;
    camera.fov_deg = fov_down_deg(row.fov_deg, camera.width, camera.height);
  };
  if (which == StationCamera::scene) {
    const StationCameraRow& row = station_.scene_camera;
    size(row);
    camera.from = world_from_station_ * Vec3{row.from_m[0], row.from_m[1], row.from_m[2]};
    camera.at = world_from_station_ * Vec3{row.at_m[0], row.at_m[1], row.at_m[2]};
    return camera;
  }
  const WristCameraRow& row = station_.wrist_camera;
  size(row);
  // Ahead is the hand's Z; the fingers are at the picture's lower edge: right is the hand's Y.
  const Quaternion hand_from_camera = rotation_with_axes({-1, 0, 0}, {0, 0, 1});
  camera.world_from_camera =
      world_from_hand_ * Pose{{row.hand_m[0], row.hand_m[1], row.hand_m[2]}, hand_from_camera};
  return camera;
}

}  // namespace marketgen::episodes
