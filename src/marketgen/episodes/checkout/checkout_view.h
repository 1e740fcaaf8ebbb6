// Pictures of a running Checkout Unloading, as its cameras take them.
//
// What does not move is a scene that is built at reset: the lane with what is round it, or the
// room. Items, basket, arm and what else was pushed are moved before each picture. Object numbers
// are those of render/picture_objects.h: the scene's last products are the episode's items, actor 0
// the basket, actor 1 the robot.
#pragma once
#include <memory>
#include <span>

#include "episodes/checkout/checkout_world.h"
#include "episodes/track_view.h"
#include "render/render.h"

namespace marketgen::episodes {

enum class StationCamera { scene, wrist };
constexpr std::array<std::string_view, 2> names_of(StationCamera) {
  return {"scene_camera", "wrist_camera"};
}

// The station's basket: one body, in its container's frame.
render::Actor basket_actor(const CheckoutStation& station);

class CheckoutView {
 public:
  // Of the episode to which `world` was reset. Errors: those of Renderer::create, link_parts.
  static Result<std::unique_ptr<CheckoutView>> create(const CheckoutWorld& world);
  // The same without a world, to be followed before pictures are taken. `scene`: the place with the
  // episode's items.
  static Result<std::unique_ptr<CheckoutView>> create(const CheckoutStation& station,
                                                      const robots::Robot& robot,
                                                      std::unique_ptr<scene::Scene> scene,
                                                      const Pose& store_from_station,
                                                      const render::RendererOptions& options = {});

  // From now on everything is seen where it stands in `world`. Errors: render.bad_move, and nothing
  // has moved: the physics has lost something.
  Result<void> follow(const CheckoutWorld& world) { return follow(world, world.scenery()); }
  // The same, where it stood in `then` of that world.
  Result<void> follow(const CheckoutWorld& world, const Scenery& then) {
    return follow(world.robot(), then, {});
  }
  Result<void> follow(const robots::Robot& robot,
                      const Scenery& then,
                      std::span<const render::MovedJoint> joints);

  // As it stood when follow() was called. 0: as many pixels as the station's row says; other sizes
  // see the same width.
  render::Camera camera(StationCamera which, int width = 0, int height = 0) const;
  // By its name; films are taken by the scene camera. Error camera.unknown.
  Result<render::Camera> camera(std::string_view name, int width = 0, int height = 0) const;
  render::Renderer& renderer() { return *renderer_; }
  const scene::Scene& scene() const { return *scene_; }
  // In pictures of that world, without making one.
  static std::uint32_t object_of_item(const CheckoutWorld& world, std::size_t item);
  const Pose& world_from_station() const { return world_from_station_; }  // of its pictures' frame

 private:
  CheckoutView() = default;

  CheckoutStation station_;
  std::unique_ptr<scene::Scene> scene_;  // the renderer reads it
  std::unique_ptr<render::Renderer> renderer_;
  Pose world_from_station_, world_from_hand_;
};

}  // namespace marketgen::episodes
