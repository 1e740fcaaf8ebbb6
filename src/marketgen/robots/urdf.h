// Users' own robots from URDF (wiki.ros.org/urdf/XML).
//
// Read: links with inertial, visual and collision; joints of kinds fixed, revolute, continuous and
// prismatic with origin, axis, limit, dynamics and mimic. Boxes, cylinders and spheres of a
// collision become capsules that hold them; a mesh is kept by name for drawing only. An effort or
// velocity limit of 0 counts as none. Transmissions, sensors and plugins are passed over.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "robots/robot.h"

namespace marketgen::robots {

struct UrdfRobot {
  Robot robot;
  std::vector<std::string> warnings;  // what was left out: a mesh that is not there, ...
};

// `source` names the text in errors, which have the line: "arm.urdf:12". Meshes are sought from
// `folder`; "package://name/rest" at `folder`/rest and in every folder above it.
// Errors: robot.bad_file for text that is not XML or not a URDF, a number that cannot be read or is
// not finite, a mass without inertia, a joint kind that is not supported, a moving joint without
// its limits, and all of make_robot.
Result<UrdfRobot> read_urdf(std::string_view text,
                            const std::string& source,
                            const std::filesystem::path& folder);
// Errors: also those of read_file.
Result<UrdfRobot> read_urdf_file(const std::filesystem::path& file);

}  // namespace marketgen::robots
