#include "robots/grasp_tool.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "robots/robot_row.h"

namespace marketgen::robots {
namespace {

constexpr double square = 1e-6;  // cosines and metres nearer than this are taken for equal

// The solid that reaches furthest towards the other finger comes first.
void pad_first(std::vector<ToolSolid>& finger, double side) {
  const auto inner_face = [&](const ToolSolid& s) {
    return side * s.tool_from_solid.position.y - s.half_size.y;
  };
  std::ranges::stable_sort(finger, [&](const ToolSolid& a, const ToolSolid& b) {
    return inner_face(a) < inner_face(b);
  });
}

Error bad_fingers(const std::string& id) {
  return {"robot.bad_file",
          id + ".json",
          "expected two fingers that slide apart along the tool's Y, each with a box for its pad"};
}

Result<void> read_fingers(const Robot& robot,
                          const std::vector<Pose>& tool_from_link,
                          GraspTool& tool) {
  const JointGroup* fingers = robot.find_group("fingers");
  if (fingers == nullptr || fingers->dofs.size() != 2) return bad_fingers(tool.id);
  for (const int dof : fingers->dofs) {
    const Joint& joint = robot.joint_of_dof(static_cast<std::size_t>(dof));
    const auto link = static_cast<std::size_t>(joint.link);
    const Vec3 axis = rotate(tool_from_link[link].rotation, joint.axis);
    if (joint.kind != JointType::prismatic || std::abs(std::abs(axis.y) - 1) > square)
      return bad_fingers(tool.id);
    std::vector<ToolSolid>& finger = axis.y > 0 ? tool.left : tool.right;
    finger = solids_of(robot.links[link], tool_from_link[link]);
    pad_first(finger, axis.y);
    tool.finger_kg = robot.links[link].mass;
    tool.finger_speed_m_s = joint.velocity;
  }
  if (tool.left.empty() || tool.right.empty() || tool.left[0].round) return bad_fingers(tool.id);
  const ToolSolid& pad = tool.left[0];
  tool.pad_center = pad.tool_from_solid.position;
  tool.pad_center.y = 0;
  tool.pad_x_m = pad.half_size.x;
  tool.pad_z_m = pad.half_size.z;
  tool.pad_thick_m = 2 * pad.half_size.y;
  return {};
}

}  // namespace

std::vector<ToolSolid> solids_of(const Link& link, const Pose& tool_from_link) {
  std::vector<ToolSolid> solids;
  for (const BodyShape& shape : link.look) {
    const Pose pose = tool_from_link * shape.link_from_shape;
    const double radius = std::max(shape.radius, shape.radius_end);
    if (shape.kind == ShapeKind::box) solids.push_back({pose, shape.size * 0.5, false});
    if (shape.kind == ShapeKind::ball) solids.push_back({pose, {radius, radius, radius}, false});
    if (shape.kind == ShapeKind::tube) {
      const Pose middle = pose * Pose{{0, 0, shape.length / 2}, {}};
      solids.push_back({middle, {radius, radius, shape.length / 2}, true});
    }
  }
  return solids;
}

std::vector<ToolSolid> opened(const GraspTool& tool, double opening_m) {
  std::vector<ToolSolid> solids;
  const auto add = [&](const std::vector<ToolSolid>& finger, double by) {
    for (ToolSolid solid : finger) {
      solid.tool_from_solid.position.y += by;
      solids.push_back(solid);
    }
  };
  add(tool.left, opening_m / 2);
  add(tool.right, -opening_m / 2);
  return solids;
}

Result<std::vector<std::string>> grasp_tool_ids(const std::filesystem::path& data) {
  MARKETGEN_TRY(const std::vector<std::string> ids, robot_ids(data));
  std::vector<std::string> tools;
  for (const std::string& id : ids) {
    MARKETGEN_TRY(const RobotRow row, read_robot_row(data, id));
    if (row.tool) tools.push_back(id);
  }
  return tools;
}

Result<GraspTool> load_grasp_tool(const std::filesystem::path& data, const std::string& id) {
  MARKETGEN_TRY(const std::vector<std::string> ids, grasp_tool_ids(data));
  if (!std::ranges::binary_search(ids, id)) {
    const std::vector<std::string_view> names(ids.begin(), ids.end());
    return Error{"robot.unknown",
                 id,
                 fmt::format("there is no such tool{}; there are: {}",
                             did_you_mean(id, names),
                             fmt::join(ids, ", "))};
  }
  MARKETGEN_TRY(const Robot robot, load_robot(data, id));
  const std::vector<double> shut(robot.dof_count(), 0);
  const Tool& row = robot.tools.at(0);
  const Pose tool_from_base = inverse(frame_pose(robot, shut, row.frame));
  std::vector<Pose> tool_from_link = link_poses(robot, shut);
  for (Pose& pose : tool_from_link)
    pose = tool_from_base * pose;

  GraspTool tool{.id = id,
                 .kind = row.kind,
                 .opening_m = row.opening,
                 .force_n = row.force,
                 .payload_kg = row.payload,
                 .cup_radius_m = row.cup_radius,
                 .seal_depth_m = row.seal_depth};
  for (const Link& link : robot.links)
    tool.mass_kg += link.mass;
  tool.body = solids_of(robot.links[0], tool_from_link[0]);
  if (tool.kind == ToolKind::gripper) MARKETGEN_CHECK(read_fingers(robot, tool_from_link, tool));
  return tool;
}

}  // namespace marketgen::robots
