// People beside a robot in physics: bodies that go where they go, whatever presses on them; how
// near the robot comes to them; what its laser scanner tells of them.
#pragma once
#include <set>
#include <string>
#include <vector>

#include "episodes/aisle/people_around.h"
#include "motion/base_follower.h"
#include "physics/world/world.h"
#include "robots/robot.h"

namespace marketgen::episodes {

// Beside a truck without a driver there must be 0.5 m of room, or it must not be faster than 0.3
// m/s (after ISO 3691-4).
inline constexpr double near_person_m = 0.5, near_person_m_s = 0.3;
// Somebody who was pressed with more, mean over 10 ms, was hurt: the least of the limits that
// ISO/TS 15066 (now ISO 10218-2:2025) sets for the regions of a body, that of the face.
inline constexpr double max_person_n = 65;

// A value, for one world. With nobody it does nothing.
class PeopleInWorld {
 public:
  static constexpr double scanner_range_m = 4;
  static constexpr double max_measured_m = 2;  // a robot that is farther is not measured

  PeopleInWorld() = default;
  explicit PeopleInWorld(PeopleAround around) : around_(std::move(around)) {}

  // Of WorldOptions::add_actors: a body each, named EpisodeWatch::person_prefix and its number.
  void add_to(mjSpec_& made) const;
  std::set<std::string> bodies() const;  // their names
  // Once the world is made; nobody has moved.
  void start(const physics::World& world, const robots::Robot& robot);

  // Before a control step: everybody decides by where the robot is now.
  void pass(const physics::World& world, double dt_s);
  // Before each step of physics: `share` of that control step is then over. Errors: those of
  // move_mocap.
  Result<void> move(physics::World& world, double share) const;
  // After the control step. Error physics.failed.
  Result<void> measure(const physics::World& world, double dt_s);

  // In the frame of the base: those within scanner_range_m of `axle` whom no fixture hides. Their
  // radius is that of a body, their speed as they walk.
  std::vector<motion::MovingDisc> scanned(const Pose& world_from_base, Vec3 axle) const;

  const PeopleAround& around() const { return around_; }
  double min_distance_m() const { return min_distance_m_; }  // so far
  double near_s() const { return near_s_; }                  // too fast nearer than near_person_m

  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.around_, self.min_distance_m_, self.near_s_);
  }

 private:
  std::vector<FloorDisc> robot_discs(const physics::World& world) const;

  PeopleAround around_;
  std::vector<int> robot_geoms_;
  std::vector<std::vector<int>> person_geoms_;
  std::vector<Pose> from_;  // where they were before the control step
  double min_distance_m_ = max_measured_m, near_s_ = 0;
};

}  // namespace marketgen::episodes
