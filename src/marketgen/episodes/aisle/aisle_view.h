// Pictures of a running In-Aisle Item Collection: from the robot's head and wrists, and from beside
// it.
#pragma once
#include <array>
#include <memory>
#include <span>
#include <string_view>

#include "episodes/aisle/aisle_world.h"
#include "episodes/track_view.h"
#include "render/render.h"

namespace marketgen::episodes {

class AisleView {
 public:
  // Of the episode to which `world` was reset; the world's store must outlive the view. Errors:
  // those of Renderer::create, link_parts.
  static Result<std::unique_ptr<AisleView>> create(const AisleWorld& world);
  // The same without a world, to be followed before pictures are taken; the scene must outlive the
  // view.
  static Result<std::unique_ptr<AisleView>> create(const AisleStation& station,
                                                   const robots::Robot& robot,
                                                   const scene::Scene& scene,
                                                   const render::RendererOptions& options = {});

  // From now on everything is seen where it stands in `world`. Errors: render.bad_move.
  Result<void> follow(const AisleWorld& world) { return follow(world, world.scenery()); }
  // The same, where it stood in `then` of that world; doors are seen as they stand now. People near
  // the robot are posed anew, a twentieth of a second each; farther ones glide as they stood.
  Result<void> follow(const AisleWorld& world, const Scenery& then);
  Result<void> follow(const robots::Robot& robot,
                      const Scenery& then,
                      std::span<const render::MovedJoint> joints);

  // As it stood when follow() was called: one of aisle_cameras, or "film_camera". 0: as many pixels
  // as the station's row says. The film's camera stands where its row says, or on another side of
  // the robot or nearer to it where that sees more of it: in an aisle there are shelves all round.
  // Error camera.unknown.
  Result<render::Camera> camera(std::string_view name, int width = 0, int height = 0) const;
  render::Renderer& renderer() { return *renderer_; }
  const Pose& world_from_base() const { return world_from_base_; }  // likewise

 private:
  AisleView() = default;
  // Somebody as pictures have them now.
  struct SeenPerson {
    PersonMoment moment;  // of which their mesh is
    render::Actor actor;
  };
  Result<void> follow_people(const PeopleAround& people,
                             const std::vector<PersonMoment>& moments,
                             const Pose& world_from_base);
  Result<void> place_film_camera(render::Camera& camera) const;
  AisleStation station_;
  std::unique_ptr<render::Renderer> renderer_;
  render::Actor robot_;
  std::vector<SeenPerson> people_;
  std::uint32_t robot_object_ = 0;  // its number in pictures
  Pose world_from_base_;
  std::array<Pose, aisle_cameras.size()> world_from_camera_{};
};

}  // namespace marketgen::episodes
