// A tool as a grasp sees it: what it can do, where its pads are, and the solids that may hit
// things. All of it is read off the tool's row in data/robots.
//
// Tool frame: the row's frame "tcp"; Z points ahead, out of the tool; a gripper's fingers open
// along Y, left towards +Y. SI units.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "robots/robot.h"

namespace marketgen::robots {

// A box, or a cylinder along Z that holds a tube of the row's look.
struct ToolSolid {
  Pose tool_from_solid;
  Vec3 half_size;      // cylinder: radius, radius, half length
  bool round = false;  // a cylinder
};

struct GraspTool {
  std::string id;  // of the row
  ToolKind kind = ToolKind::gripper;
  double opening_m = 0;     // most, between the pads
  double force_n = 0;       // on each pad; of a cup, its greatest pull
  double payload_kg = 0;    // most
  double cup_radius_m = 0;  // of a suction cup
  double seal_depth_m = 0;  // how uneven a surface may be for the cup to seal on it
  double mass_kg = 0;

  // Grippers only.
  double finger_kg = 0, finger_speed_m_s = 0;
  Vec3 pad_center = {};  // between the pads, tool frame
  double pad_x_m = 0;    // half the pads' width, along X
  double pad_z_m = 0;    // half the pads' length, along Z
  double pad_thick_m = 0;

  std::vector<ToolSolid> body = {};              // what does not move
  std::vector<ToolSolid> left = {}, right = {};  // the fingers when shut: they move along +Y and
                                                 // -Y; the first of each is its pad
};

// Where a tool takes hold of a product, and how.
struct Grasp {
  Pose product_from_tool;
  double opening_m = 0;  // between a gripper's pads on the way there
  double force_n = 0;    // then, on each pad; of a cup, its greatest pull
};

// The finger's solids with `opening_m` between the pads.
std::vector<ToolSolid> opened(const GraspTool& tool, double opening_m);  // left, then right

// A tool by its row, "panda-hand". Errors: robot.unknown with the nearest tool and all that there
// are; robot.bad_file when the row's fingers do not slide along Y, or have no flat pads.
Result<GraspTool> load_grasp_tool(const std::filesystem::path& data, const std::string& id);

// What a link looks like, as solids in the tool's frame. Meshes are left out.
std::vector<ToolSolid> solids_of(const Link& link, const Pose& tool_from_link);

// Ids of the rows that are tools, sorted.
Result<std::vector<std::string>> grasp_tool_ids(const std::filesystem::path& data);

}  // namespace marketgen::robots
