// A robot as a page moves it: links that nothing moves against one another are one rigid body.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "episodes/recorded_place.h"
#include "geometry/pose.h"
#include "server/view_files.h"
#include "server/view_mesh.h"

namespace marketgen::server {

class ReplayBodies {
 public:
  // The robot's bodies that have a shape, then the place's basket if there is one. Errors: those of
  // robot_actor.
  static Result<ReplayBodies> of(const episodes::RecordedPlace& place);

  std::size_t robot_bodies() const { return links_.size(); }
  const std::vector<std::string>& names() const { return names_; }

  ViewFile file() const;  // robot.bin

  // store_from_body of the robot's, one each. Precondition: a value a degree of freedom.
  std::vector<Pose> poses(const robots::Robot& robot,
                          std::span<const double> state,
                          const Pose& store_from_robot) const;

 private:
  void add(const render::ActorBody& body, const Pose& body_from_mesh);
  std::vector<std::size_t> links_;  // whose frame is the body's
  std::vector<std::string> names_;
  ViewMesh mesh_;
  std::vector<std::uint32_t> ranges_;  // first index and their count, a body
};

}  // namespace marketgen::server
