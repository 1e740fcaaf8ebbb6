// What the numbers of an environment's observation are, and between which bounds they lie.
//
// Poses are x, y, z, qw, qx, qy, qz in the frame of the robot's base, which at a counter is the
// station's own. Numbers that physics takes beyond a bound are told as the bound.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "agent/policy.h"
#include "geometry/pose.h"
#include "robots/robot.h"

namespace marketgen::environments {

// Numbers that belong together, row-major. `low` and `high` have one for each, and so have `names`
// of the robot's own parts.
struct ObservationPart {
  std::string group, name;  // "agent", "qpos"
  std::vector<int> shape;
  std::vector<double> low, high;
  std::vector<std::string> names = {};  // "joint1"; none of privileged parts
};

// How names of a tool's numbers begin, in actions and observations: "left_tool_", and of a robot
// with one tool "tool_".
std::string tool_prefix(const robots::Tool& tool);

// A thing that an episode is about, as it stands: the truth, for those who may know.
struct EnvironmentItem {
  std::string sku;
  Pose pose;            // of its footprint's middle
  Vec3 middle, size_m;  // of its box when it stands; `middle` is turned with it
  Vec3 velocity_m_s;    // of its middle
  bool wanted = false;  // its product is a goal
  bool held = false, touched = false, in_place = false;
  bool in_region = false;  // its middle is where the goals are to go
  double rested_s = 0;
  std::uint32_t object = 0;  // its number in pictures; 0: pictures do not show it
};

// Where goals are to go, and what holds the goods: in the frame of the robot's base.
struct EnvironmentPlace {
  Vec3 middle, size_m;
  Pose basket;  // middle of its inner floor
};

// What bounds depend on.
struct ObservationBounds {
  double ground_m = 0;  // no place lies farther from the frame's origin along any axis
  double things_m = 0;  // as far as items are told
};

// agent.qpos (joints, then openings), agent.qvel, extra.tcp_pose (a row a tool), extra.base_pose
// (x, y, heading within half a turn, as the robot believes: in the store's frame, at a counter in
// its own, where it is 0), of a robot with a cup agent.sealed (1 for each tool that has sealed),
// agent.external_force (N, for each arm that feels contacts, what presses on it), agent.stopped (1
// while a protective stop lets it take no command).
std::vector<ObservationPart> robot_parts(const robots::Robot& robot,
                                         const ObservationBounds& bounds);

// privileged: rows of `items` things, those that are missing 0: item_pose, item_size,
// item_velocity, item_present, item_goal, item_held, item_in_place (0 or 1), tcp_to_item (for
// each tool); goal_position, goal_size, basket_pose; instruction_id (equal for equal instructions,
// below 2^24).
std::vector<ObservationPart> privileged_parts(const robots::Robot& robot,
                                              int items,
                                              const ObservationBounds& bounds);

std::size_t count_of(const ObservationPart& part);

struct RobotSeen {
  agent::Observation now;
  std::vector<Pose> tools;  // base_from_tool
};
// In the order of robot_parts(); appended.
void add_robot_numbers(const robots::Robot& robot,
                       const RobotSeen& seen,
                       std::vector<double>& into);
// In the order of privileged_parts(). Items behind the row `rows` are left out.
void add_privileged_numbers(const std::vector<EnvironmentItem>& items,
                            int rows,
                            const EnvironmentPlace& place,
                            const std::vector<Pose>& tools,
                            const std::string& instruction,
                            std::vector<double>& into);

}  // namespace marketgen::environments
