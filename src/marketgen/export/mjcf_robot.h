// A robot of an MJCF export: a model of its own beside the store's, which attaches it.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "export/exporter.h"
#include "robots/placed_robot.h"

namespace marketgen::exporters {

// A custom text of the model with this name lists the prefixes of the robots in it.
constexpr const char* mjcf_robots_text = "robots";

// What the store's file needs to know of it.
struct MjcfRobot {
  std::string name;    // of the model and its file, without ending
  std::string prefix;  // of all its names in the store's model: "<name>/"
  std::string base;    // its first body
  Pose world_from_base;
  std::vector<double> start;  // of its drives, in the model's order: where it stands
  std::vector<BesideFile> files;
};

// The same bodies, joints and drives as in our own physics (physics/world/robot_actor.h), with the
// links' meshes over them. `name` is its row's, numbered from the second robot of a row on. Errors:
// physics.*, robot.bad_file, assets.bad_row.
Result<std::vector<MjcfRobot>> mjcf_robots(const std::vector<robots::PlacedRobot>& robots);

}  // namespace marketgen::exporters
