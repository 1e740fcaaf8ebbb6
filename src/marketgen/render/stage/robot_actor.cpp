#include "render/stage/robot_actor.h"

#include <algorithm>

#include "assets/print/color.h"
#include "robots/link_parts.h"

namespace marketgen::render {
namespace {

Result<ActorBody> body_of(const robots::Link& link, const Pose& world_from_link) {
  ActorBody body;
  body.name = link.name;
  body.world_from_body = world_from_link;
  MARKETGEN_TRY(std::vector<robots::LinkPart> parts, robots::link_parts(link));
  for (robots::LinkPart& part : parts) {
    std::fill(part.mesh.surfaces.begin(),
              part.mesh.surfaces.end(),
              static_cast<std::uint16_t>(body.surfaces.size()));
    body.mesh.append(part.mesh);
    MARKETGEN_TRY(const Vec3f color, assets::linear_from_hex(part.color));
    body.surfaces.push_back(
        {color, static_cast<float>(part.roughness), static_cast<float>(part.metallic)});
  }
  return body;
}

}  // namespace

std::vector<Pose> world_link_poses(const robots::Robot& robot,
                                   std::span<const double> q,
                                   const Pose& world_from_base) {
  std::vector<Pose> poses = robots::link_poses(robot, q);
  for (Pose& pose : poses)
    pose = world_from_base * pose;
  return poses;
}

Result<Actor> robot_actor(const robots::Robot& robot,
                          std::span<const double> q,
                          const Pose& world_from_base) {
  const std::vector<Pose> poses = world_link_poses(robot, q, world_from_base);
  Actor actor{robot.name, {}};
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    MARKETGEN_TRY(ActorBody body, body_of(robot.links[link], poses[link]));
    actor.bodies.push_back(std::move(body));
  }
  return actor;
}

Result<std::vector<Actor>> robot_actors(std::span<const robots::PlacedRobot> robots) {
  std::vector<Actor> actors;
  for (const robots::PlacedRobot& placed : robots) {
    MARKETGEN_TRY(Actor actor, robot_actor(placed.robot, placed.q, placed.world_from_base));
    actors.push_back(std::move(actor));
  }
  return actors;
}

}  // namespace marketgen::render
