// A robot as an actor of a picture: one body for each link, in the order of Robot::links.
//
// So what forward kinematics or a physics engine says about the links goes straight to
// Renderer::move_actor(): one world_from_link for each, in that order.
#pragma once
#include <span>
#include <vector>

#include "base/result.h"
#include "render/stage/actor.h"
#include "robots/placed_robot.h"
#include "robots/robot.h"

namespace marketgen::render {

// Where every link stands in the store frame. Precondition: q.size() == robot.dof_count().
std::vector<Pose> world_link_poses(const robots::Robot& robot,
                                   std::span<const double> q,
                                   const Pose& world_from_base);

// With the meshes of link_parts(); links without a body have none. Errors: those of link_parts();
// assets.bad_row for a colour that is not "#rrggbb".
Result<Actor> robot_actor(const robots::Robot& robot,
                          std::span<const double> q,
                          const Pose& world_from_base);
Result<std::vector<Actor>> robot_actors(std::span<const robots::PlacedRobot> robots);

}  // namespace marketgen::render
