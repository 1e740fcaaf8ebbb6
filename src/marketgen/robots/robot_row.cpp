#include "robots/robot_row.h"

#include <algorithm>
#include <numbers>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/file.h"
#include "io/json.h"
#include "robots/rotation.h"
#include "robots/row_file.h"

namespace marketgen::robots {
namespace fs = std::filesystem;
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr std::uint64_t max_row_bytes = 4U << 20;
constexpr int deepest_part = 4;

double unit_of(JointUnit unit) {
  return unit == JointUnit::deg ? degree : 1;
}
Vec3 vector_of(const Triple& t) {
  return {t[0], t[1], t[2]};
}
Pose pose_of(const Triple& xyz, const Triple& rpy_deg) {
  return {vector_of(xyz), rotation_from_rpy(vector_of(rpy_deg) * degree)};
}
Pose pose_of(const DhRow& dh) {
  const Pose turn{{}, rotation_about({1, 0, 0}, dh.alpha_deg * degree)};
  const Pose rest{{dh.a_mm / 1000, 0, dh.d_mm / 1000},
                  rotation_about({0, 0, 1}, dh.offset_deg * degree)};
  return turn * rest;
}

BodyShape shape_of(const ShapeRow& row) {
  BodyShape shape;
  shape.kind = row.kind;
  shape.size = vector_of(row.size);
  shape.radius = row.radius;
  shape.radius_end = row.radius_end > 0 ? row.radius_end : row.radius;
  shape.rounding = row.rounding;
  shape.color = row.color;
  shape.roughness = row.roughness;
  shape.metallic = row.metallic;
  shape.link_from_shape = pose_of(row.a, row.rpy_deg);
  if (row.kind == ShapeKind::tube) {
    const Vec3 along = vector_of(row.b) - vector_of(row.a);
    shape.length = length(along);
    shape.link_from_shape.rotation = rotation_from_z_to(normalized(along));
  }
  return shape;
}

Link link_of(const LinkRow& row, const std::string& prefix) {
  Link link;
  link.name = prefix + row.name;
  link.mass = row.mass;
  link.center_of_mass = vector_of(row.center_of_mass);
  link.inertia = row.inertia;
  for (const CapsuleRow& c : row.capsules)
    link.capsules.push_back({vector_of(c.a), vector_of(c.b), c.radius});
  for (const ShapeRow& shape : row.look)
    link.look.push_back(shape_of(shape));
  return link;
}

RobotParts::JointPart joint_of(const JointRow& row, const std::string& prefix) {
  const double unit = unit_of(row.unit);
  const auto limit = [&](const std::optional<double>& value, double none) {
    return value ? *value * unit : none;
  };
  RobotParts::JointPart part;
  Joint& joint = part.joint;
  joint.name = prefix + row.name;
  joint.kind = row.kind;
  joint.parent_from_joint = row.dh ? pose_of(*row.dh) : pose_of(row.xyz, row.rpy_deg);
  joint.axis = vector_of(row.axis);
  joint.lower = limit(row.lower, -Joint::unlimited);
  joint.upper = limit(row.upper, Joint::unlimited);
  joint.velocity = limit(row.velocity, Joint::unlimited);
  joint.acceleration = limit(row.acceleration, Joint::unlimited);
  joint.jerk = limit(row.jerk, Joint::unlimited);
  joint.effort = row.effort.value_or(Joint::unlimited);
  joint.armature = row.armature;
  joint.damping = row.damping;
  part.parent = prefix + row.parent;
  part.child = prefix + row.child;
  if (!row.follows.empty()) part.follows = prefix + row.follows;
  return part;
}

struct NamedFrame {
  std::string name, link;
  Pose link_from_frame;
};

// Everything of a row and its parts, with full names.
class Assembly {
 public:
  Assembly(const fs::path& data, const RobotTools& tools) : data_(data), tools_(tools) {}

  Result<void> add(const RobotRow& row, const std::string& prefix, int depth) {
    if (depth > deepest_part)
      return Error{"robot.bad_file", row.id, "parts nest deeper than 4; is a row part of itself?"};
    for (const LinkRow& link : row.links)
      parts_.links.push_back(link_of(link, prefix));
    for (const JointRow& joint : row.joints)
      parts_.joints.push_back(joint_of(joint, prefix));
    for (const FrameRow& f : row.frames)
      frames_.push_back({prefix + f.name, prefix + f.link, pose_of(f.xyz, f.rpy_deg)});
    for (const GroupRow& group : row.groups)
      groups_.push_back(with_prefix(group, prefix));
    for (const PostureRow& posture : row.postures)
      postures_.push_back(with_prefix(posture, prefix));
    if (row.drive) drive_ = row.drive;
    if (row.protective_stop && !row.links.empty())
      stops_.emplace_back(prefix + row.links.front().name, *row.protective_stop);
    if (row.tool)
      tools_made_.push_back({prefix,
                             row.tool->kind,
                             row.tool->opening,
                             row.tool->force,
                             row.tool->cup_radius,
                             row.tool->seal_depth,
                             row.tool->payload,
                             -1,
                             row.id,
                             -1});
    for (const PartRow& part : row.parts)
      MARKETGEN_CHECK(add_part(row, part, prefix, depth));
    return {};
  }

  Result<void> all_tools_used(const std::string& id) const {
    for (const auto& [slot, tool] : tools_) {
      if (std::find(slots_.begin(), slots_.end(), slot) == slots_.end())
        return Error{
            "robot.unknown",
            id,
            fmt::format("the robot has no slot \"{}\"; it has: {}",
                        slot,
                        slots_.empty() ? "none" : fmt::format("{}", fmt::join(slots_, ", ")))};
    }
    return {};
  }

  Result<Robot> finish(const RobotRow& row) {
    parts_.name = row.id;
    MARKETGEN_TRY(Robot robot, make_robot(std::move(parts_), row.id + ".json"));
    for (const NamedFrame& f : frames_) {
      const int link = robot.find_link(f.link);
      if (link < 0) return unknown(row, "link", f.link);
      robot.frames.push_back({f.name, link, f.link_from_frame});
    }
    for (const GroupRow& group : groups_) {
      MARKETGEN_TRY(JointGroup made, group_of(row, robot, group));
      robot.groups.push_back(std::move(made));
    }
    for (Tool tool : tools_made_) {
      tool.frame = robot.find_frame(tool.prefix + "tcp");
      if (tool.frame < 0) return unknown(row, "frame", tool.prefix + "tcp");
      tool.driven_dof = driven_dof(robot, tool);
      robot.tools.push_back(std::move(tool));
    }
    for (const PostureRow& posture : postures_) {
      MARKETGEN_TRY(Posture made, posture_of(row, robot, posture));
      robot.postures.push_back(std::move(made));
    }
    robot.drive = drive_;
    for (const auto& [link, stop] : stops_)
      robot.contact_limits.push_back({robot.find_link(link), stop.contact_force, stop.pause});
    return robot;
  }

 private:
  static GroupRow with_prefix(GroupRow group, const std::string& prefix) {
    group.name = prefix + group.name;
    group.base = prefix + group.base;
    if (!group.tip.empty()) group.tip = prefix + group.tip;
    for (std::string& joint : group.joints)
      joint.insert(0, prefix);
    return group;
  }

  static PostureRow with_prefix(PostureRow posture, const std::string& prefix) {
    posture.name = prefix + posture.name;
    for (std::string& joint : posture.joints)
      joint.insert(0, prefix);
    return posture;
  }

  // -1 for a cup, and for a gripper without fingers.
  static int driven_dof(const Robot& robot, const Tool& tool) {
    const JointGroup* fingers = robot.find_group(tool.prefix + "fingers");
    if (tool.kind != ToolKind::gripper || fingers == nullptr) return -1;
    for (const int dof : fingers->dofs)
      if (robot.joint_of_dof(static_cast<std::size_t>(dof)).follows < 0) return dof;
    return -1;
  }

  static Error unknown(const RobotRow& row, const char* what, const std::string& name) {
    return {"robot.unknown", row.id + ".json", fmt::format("there is no {} \"{}\"", what, name)};
  }

  Result<void> add_part(const RobotRow& row,
                        const PartRow& part,
                        const std::string& prefix,
                        int depth) {
    std::string id = part.row;
    if (!part.slot.empty()) {
      const std::string slot = prefix + part.slot;
      slots_.push_back(slot);
      if (const auto chosen = tools_.find(slot); chosen != tools_.end()) id = chosen->second;
    }
    MARKETGEN_TRY(const RobotRow other, read_robot_row(data_, id));
    const std::string at = prefix + part.at, inner = prefix + part.prefix;
    const auto carrier = std::find_if(
        frames_.begin(), frames_.end(), [&](const NamedFrame& f) { return f.name == at; });
    if (carrier == frames_.end()) return unknown(row, "frame", at);
    RobotParts::JointPart mount;
    mount.joint.name = inner + other.id + "_mount";
    mount.joint.parent_from_joint = carrier->link_from_frame;
    mount.parent = carrier->link;
    mount.child = inner + other.links.front().name;
    parts_.joints.push_back(mount);
    MARKETGEN_CHECK(add(other, inner, depth + 1));
    move_tips(at, inner + "tcp");
    return {};
  }

  void move_tips(const std::string& from, const std::string& to) {
    const bool exists = std::any_of(
        frames_.begin(), frames_.end(), [&](const NamedFrame& f) { return f.name == to; });
    for (GroupRow& group : groups_) {
      if (exists && group.tip == from) group.tip = to;
    }
  }

  static Result<JointGroup> group_of(const RobotRow& row,
                                     const Robot& robot,
                                     const GroupRow& from) {
    JointGroup group;
    group.name = from.name;
    group.solver = from.solver;
    group.base = robot.find_link(from.base);
    if (group.base < 0) return unknown(row, "link", from.base);
    group.tip = robot.find_frame(from.tip);
    if (group.tip < 0 && !from.tip.empty()) return unknown(row, "frame", from.tip);
    for (const std::string& joint : from.joints) {
      group.dofs.push_back(robot.find_dof(joint));
      if (group.dofs.back() < 0) return unknown(row, "moving joint", joint);
    }
    return group;
  }

  static Result<Posture> posture_of(const RobotRow& row,
                                    const Robot& robot,
                                    const PostureRow& from) {
    if (from.values.size() != from.joints.size())
      return Error{
          "robot.bad_file",
          row.id + ".json:" + from.name,
          fmt::format(
              "the posture has {} joints and {} values", from.joints.size(), from.values.size())};
    Posture posture;
    posture.name = from.name;
    for (std::size_t i = 0; i < from.joints.size(); ++i) {
      const int dof = robot.find_dof(from.joints[i]);
      if (dof < 0) return unknown(row, "moving joint", from.joints[i]);
      posture.values.push_back({dof, from.values[i] * unit_of(from.unit)});
    }
    MARKETGEN_CHECK(check_state(robot, with_posture(posture, neutral_state(robot))));
    return posture;
  }

  const fs::path& data_;
  const RobotTools& tools_;
  RobotParts parts_;
  std::vector<NamedFrame> frames_;
  std::vector<GroupRow> groups_;
  std::vector<PostureRow> postures_;
  std::vector<std::string> slots_;
  std::vector<Tool> tools_made_;
  std::optional<Drive> drive_;
  std::vector<std::pair<std::string, ProtectiveStopRow>> stops_;  // of a row's first link
};

Result<void> check_sources(const RobotRow& row, const std::string& part, const std::string& keys) {
  std::istringstream words(keys);
  for (std::string key; words >> key;) {
    const bool known = std::any_of(
        row.sources.begin(), row.sources.end(), [&](const SourceRow& s) { return s.key == key; });
    if (!known)
      return Error{"robot.bad_file",
                   row.id + ".json:" + part,
                   "there is no source \"" + key + "\" in the row's sources"};
  }
  return {};
}

Result<void> check_known(const fs::path& data, const std::string& id) {
  MARKETGEN_TRY(const std::vector<std::string> ids, robot_ids(data));
  if (std::find(ids.begin(), ids.end(), id) != ids.end()) return {};
  return Error{"robot.unknown",
               id,
               fmt::format("there is no such robot or tool; there are: {}, and rows of your own by "
                           "their files: mine.json",
                           fmt::join(ids, ", "))};
}

}  // namespace

Result<std::vector<std::string>> robot_ids(const fs::path& data) {
  std::error_code failed;
  std::vector<std::string> ids;
  for (const fs::directory_entry& entry : fs::directory_iterator(data / "robots", failed)) {
    if (entry.path().extension() == ".json") ids.push_back(entry.path().stem().string());
  }
  if (failed)
    return Error{"catalog.missing_data",
                 (data / "robots").string(),
                 "the robots' rows cannot be listed: " + failed.message()};
  std::sort(ids.begin(), ids.end());
  return ids;
}

Result<RobotRow> read_robot_row(const fs::path& data, const std::string& id) {
  if (!is_row_file(id)) {
    MARKETGEN_CHECK(check_known(data, id));
  }
  const fs::path path = is_row_file(id) ? fs::path(id) : data / "robots" / (id + ".json");
  const std::string file = is_row_file(id) ? id : path.filename().string();
  MARKETGEN_TRY(const std::string text, io::read_file(path, max_row_bytes));
  MARKETGEN_TRY(RobotRow row, io::read_json<RobotRow>(text, file));
  if (row.id != path.stem())
    return Error{"robot.bad_file",
                 file + ":/id",
                 "expected \"" + path.stem().string() + "\", as the file is called"};
  if (row.links.empty())
    return Error{"robot.bad_file", file + ":/links", "expected at least one link"};
  for (const LinkRow& link : row.links)
    MARKETGEN_CHECK(check_sources(row, link.name, link.source));
  for (const JointRow& joint : row.joints)
    MARKETGEN_CHECK(check_sources(row, joint.name, joint.source));
  for (const FrameRow& frame : row.frames)
    MARKETGEN_CHECK(check_sources(row, frame.name, frame.source));
  for (const PostureRow& posture : row.postures)
    MARKETGEN_CHECK(check_sources(row, posture.name, posture.source));
  MARKETGEN_CHECK(check_sources(row, "drive", row.drive_source));
  if (row.protective_stop)
    MARKETGEN_CHECK(check_sources(row, "protective_stop", row.protective_stop->source));
  if (row.tool) MARKETGEN_CHECK(check_sources(row, "tool", row.tool->source));
  return row;
}

Result<Robot> load_robot(const fs::path& data, const std::string& id, const RobotTools& tools) {
  MARKETGEN_TRY(const RobotRow row, read_robot_row(data, id));
  Assembly assembly(data, tools);
  MARKETGEN_CHECK(assembly.add(row, "", 0));
  MARKETGEN_CHECK(assembly.all_tools_used(id));
  return assembly.finish(row);
}

}  // namespace marketgen::robots
