// Robots as rows: data/robots/<id>.json, schema market-robot/1. A row is a whole robot, an arm, a
// base or a tool; a robot names the rows of which it is put together.
//
// Every link, joint, frame and drive names its sources by the keys of the row's `sources` list.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "robots/robot.h"

namespace marketgen::robots {

using Triple = std::array<double, 3>;

struct SourceRow {
  std::string key;   // "gaz-2019"
  std::string text;  // who published it, where

  static constexpr auto fields = field_list(
      field("key", &SourceRow::key, "short name used in this row", identifier()),
      field("text", &SourceRow::text, "who published the figures and where", required()));
};

struct CapsuleRow {
  Triple a{}, b{};
  double radius = 0;

  static constexpr auto fields =
      field_list(field("a", &CapsuleRow::a, "one end, m, link frame"),
                 field("b", &CapsuleRow::b, "other end, m"),
                 field("radius", &CapsuleRow::radius, "m", range(0.001, 2)));
};

// A tube goes from `a` to `b`; box and ball stand at `a`, the box turned by `rpy_deg`.
struct ShapeRow {
  ShapeKind kind = ShapeKind::tube;
  Triple a{}, b{}, size{}, rpy_deg{};
  double radius = 0;
  double radius_end = 0;  // 0: as `radius`
  double rounding = 0;
  std::string color = "#cccccc";
  double roughness = 0.45, metallic = 0;

  static constexpr auto fields = field_list(
      field("kind", &ShapeRow::kind, "box, tube or ball"),
      field("a", &ShapeRow::a, "start of a tube, middle of a box or ball; m, link frame"),
      field("b", &ShapeRow::b, "end of a tube, m"),
      field("size", &ShapeRow::size, "of a box, m", range(0, 3)),
      field("rpy_deg", &ShapeRow::rpy_deg, "of a box: roll, pitch, yaw, degrees"),
      field("radius", &ShapeRow::radius, "of a tube or ball, m", range(0, 2)),
      field("radius_end", &ShapeRow::radius_end, "of a tube at b, m; 0 = the same", range(0, 2)),
      field("rounding", &ShapeRow::rounding, "radius of the edges, m", range(0, 1)),
      field("color", &ShapeRow::color, "#rrggbb", at_most_bytes(7)),
      field("roughness", &ShapeRow::roughness, "0 mirror, 1 chalk", range(0, 1)),
      field("metallic", &ShapeRow::metallic, "0 dielectric, 1 metal", range(0, 1)));
};

struct LinkRow {
  std::string name;
  double mass = 0;
  Triple center_of_mass{};
  Inertia inertia;
  std::vector<CapsuleRow> capsules;
  std::vector<ShapeRow> look;
  std::string source;

  static constexpr auto fields =
      field_list(field("name", &LinkRow::name, "link name", identifier()),
                 field("mass", &LinkRow::mass, "kg", at_least(0)),
                 field("center_of_mass", &LinkRow::center_of_mass, "m, link frame"),
                 field("inertia", &LinkRow::inertia, "about the centre of mass"),
                 field("capsules", &LinkRow::capsules, "hold the body in collision checks"),
                 field("look", &LinkRow::look, "solids that show the link"),
                 field("source", &LinkRow::source, "keys of the sources, by blanks"));
};

// Modified Denavit-Hartenberg (Craig): turn alpha about X, move a along X, d along Z, turn
// q + offset about Z.
struct DhRow {
  double a_mm = 0, alpha_deg = 0, d_mm = 0, offset_deg = 0;

  static constexpr auto fields = field_list(field("a_mm", &DhRow::a_mm, "link length"),
                                            field("alpha_deg", &DhRow::alpha_deg, "link twist"),
                                            field("d_mm", &DhRow::d_mm, "link offset"),
                                            field("offset_deg", &DhRow::offset_deg, "at q = 0"));
};

enum class JointUnit { si, deg };
constexpr std::array<std::string_view, 2> names_of(JointUnit) {
  return {"si", "deg"};
}

struct JointRow {
  std::string name;
  JointType kind = JointType::revolute;
  std::string parent, child;
  std::optional<DhRow> dh;
  Triple xyz{}, rpy_deg{}, axis{0, 0, 1};
  JointUnit unit = JointUnit::si;
  std::optional<double> lower, upper, velocity, acceleration, jerk, effort;
  double armature = 0, damping = 0;
  std::string follows;
  std::string source;

  static constexpr auto fields =
      field_list(field("name", &JointRow::name, "joint name", identifier()),
                 field("kind", &JointRow::kind, "fixed, revolute, continuous or prismatic"),
                 field("parent", &JointRow::parent, "link", required()),
                 field("child", &JointRow::child, "link", required()),
                 field("dh", &JointRow::dh, "modified DH parameters, instead of xyz and rpy_deg"),
                 field("xyz", &JointRow::xyz, "joint frame in the parent link, m"),
                 field("rpy_deg", &JointRow::rpy_deg, "roll, pitch, yaw about fixed axes, degrees"),
                 field("axis", &JointRow::axis, "in the joint frame"),
                 field("unit", &JointRow::unit, "of the limits: si (rad, m) or deg"),
                 field("lower", &JointRow::lower, "least joint value"),
                 field("upper", &JointRow::upper, "largest joint value"),
                 field("velocity", &JointRow::velocity, "most, per s", at_least(0)),
                 field("acceleration", &JointRow::acceleration, "most, per s^2", at_least(0)),
                 field("jerk", &JointRow::jerk, "most, per s^3", at_least(0)),
                 field("effort", &JointRow::effort, "most, N m or N", at_least(0)),
                 field("armature", &JointRow::armature, "rotor inertia at the joint", at_least(0)),
                 field("damping", &JointRow::damping, "viscous, N m s/rad or N s/m", at_least(0)),
                 field("follows", &JointRow::follows, "joint whose value it copies"),
                 field("source", &JointRow::source, "keys of the sources, by blanks"));
};

struct FrameRow {
  std::string name, link;
  Triple xyz{}, rpy_deg{};
  std::string source;

  static constexpr auto fields =
      field_list(field("name", &FrameRow::name, "frame name", identifier()),
                 field("link", &FrameRow::link, "link it is fixed to", required()),
                 field("xyz", &FrameRow::xyz, "m, link frame"),
                 field("rpy_deg", &FrameRow::rpy_deg, "roll, pitch, yaw, degrees"),
                 field("source", &FrameRow::source, "keys of the sources, by blanks"));
};

struct GroupRow {
  std::string name;
  std::vector<std::string> joints;
  std::string base, tip, solver;

  static constexpr auto fields = field_list(
      field("name", &GroupRow::name, "group name", identifier()),
      field("joints", &GroupRow::joints, "in order from the base", required()),
      field("base", &GroupRow::base, "link in front of the first joint", required()),
      field("tip", &GroupRow::tip, "frame it moves; empty = none"),
      field("solver", &GroupRow::solver, "analytic inverse kinematics: rm65, rm75, panda"));
};

// Joint values by name; joints that it leaves out stay as they are.
struct PostureRow {
  std::string name;
  std::vector<std::string> joints;
  std::vector<double> values;
  JointUnit unit = JointUnit::si;
  std::string source;

  static constexpr auto fields =
      field_list(field("name", &PostureRow::name, "posture name", identifier()),
                 field("joints", &PostureRow::joints, "joint names", required()),
                 field("values", &PostureRow::values, "one per joint", required()),
                 field("unit", &PostureRow::unit, "of the values: si (rad, m) or deg"),
                 field("source", &PostureRow::source, "keys of the sources, by blanks"));
};

// Another row, fixed with its root link to a frame of this one. Its names get the prefix. A part
// that stands on a group's tip and has a frame "tcp" moves the group's tip there.
struct PartRow {
  std::string row, prefix, at, slot;

  static constexpr auto fields =
      field_list(field("row", &PartRow::row, "id of the other row", identifier()),
                 field("prefix", &PartRow::prefix, "in front of its names"),
                 field("at", &PartRow::at, "frame that carries it", required()),
                 field("slot", &PartRow::slot, "name under which users choose another row"));
};

struct ToolRow {
  ToolKind kind = ToolKind::gripper;
  double opening = 0, force = 0, cup_radius = 0, seal_depth = 0, payload = 0;
  std::string source;

  static constexpr auto fields =
      field_list(field("kind", &ToolRow::kind, "gripper or suction"),
                 field("opening", &ToolRow::opening, "most, between the pads, m", at_least(0)),
                 field("force", &ToolRow::force, "grip, or pull of a cup, N", at_least(0)),
                 field("cup_radius", &ToolRow::cup_radius, "of a suction cup, m", at_least(0)),
                 field("seal_depth",
                       &ToolRow::seal_depth,
                       "how uneven a surface may be for the cup to seal on it, m",
                       at_least(0)),
                 field("payload", &ToolRow::payload, "kg", at_least(0)),
                 field("source", &ToolRow::source, "keys of the sources, by blanks"));
};

// Where a robot gives way: it stands still for `pause` when something presses on this row's links,
// and on what they carry, harder than `contact_force`.
struct ProtectiveStopRow {
  double contact_force = 0, pause = 0;
  std::string source;

  static constexpr auto fields =
      field_list(field("contact_force",
                       &ProtectiveStopRow::contact_force,
                       "N, of all that presses from outside, added as vectors",
                       at_least(1)),
                 field("pause", &ProtectiveStopRow::pause, "s, until it goes on", at_least(0)),
                 field("source", &ProtectiveStopRow::source, "keys of the sources, by blanks"));
};

struct RobotRow {
  std::string schema = "market-robot/1";
  std::string id, name;
  std::vector<SourceRow> sources;
  std::vector<LinkRow> links;
  std::vector<JointRow> joints;
  std::vector<FrameRow> frames;
  std::vector<GroupRow> groups;
  std::vector<PostureRow> postures;
  std::vector<PartRow> parts;
  std::optional<Drive> drive;
  std::string drive_source;
  std::optional<ToolRow> tool;
  std::optional<ProtectiveStopRow> protective_stop;

  static constexpr auto fields = field_list(
      field("schema", &RobotRow::schema, "schema tag", constant("market-robot/1")),
      field("id", &RobotRow::id, "robot id, the name of its file", identifier()),
      field("name", &RobotRow::name, "what people call it", required()),
      field("sources", &RobotRow::sources, "where its figures come from"),
      field("links", &RobotRow::links, "rigid bodies", required()),
      field("joints", &RobotRow::joints, "between its links"),
      field("frames", &RobotRow::frames, "named places"),
      field("groups", &RobotRow::groups, "joints that move together"),
      field("postures", &RobotRow::postures, "named joint values"),
      field("parts", &RobotRow::parts, "other rows that it carries"),
      field("drive", &RobotRow::drive, "differential drive"),
      field("drive_source", &RobotRow::drive_source, "keys of the drive's sources, by blanks"),
      field("tool", &RobotRow::tool, "what it can do as a tool; it needs a frame \"tcp\""),
      field("protective_stop", &RobotRow::protective_stop, "when it stops at a contact"));
};

// slot -> row id: {"left_tool", "suction-cup"}.
using RobotTools = std::map<std::string, std::string>;

// Ids of the rows in `data`/robots, sorted; those of arms and tools too.
Result<std::vector<std::string>> robot_ids(const std::filesystem::path& data);

// One row as it stands, or a file of one's own (row_file.h). Errors: robot.unknown with all ids,
// those of read_file, read_json; robot.bad_file: an unknown source key, an id not the file's.
Result<RobotRow> read_robot_row(const std::filesystem::path& data, const std::string& id);

// The robot of a row, put together from its parts. `data` is usually data_folder(). Errors: those
// of read_robot_row and make_robot; robot.unknown for a slot, frame or joint that does not exist;
// robot.bad_file for a posture with another number of values than joints, robot.bad_state for one
// outside the limits.
Result<Robot> load_robot(const std::filesystem::path& data,
                         const std::string& id,
                         const RobotTools& tools = {});

}  // namespace marketgen::robots
