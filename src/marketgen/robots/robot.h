// A robot as a tree of rigid links and joints: what it weighs, how far and how fast it moves, and
// the capsules and spheres that stand for it in collision checks.
//
// A Robot is immutable. It comes from a row of data/robots (robot_row.h) or from a URDF (urdf.h).
// Its state is apart: one number per degree of freedom, `q[dof]`, radians or metres, in the order
// of `Robot::dofs`. Frames: every pose is SI; the root link's frame is the robot's base frame (on
// the floor, X ahead, Y left, Z up); a joint's frame is its child link's frame at q = 0.
#pragma once
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "geometry/pose.h"

namespace marketgen::robots {

// Symmetric, about the centre of mass, in the link's axes; kg m^2.
struct Inertia {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

  static constexpr auto fields = field_list(field("xx", &Inertia::xx, "kg m^2"),
                                            field("yy", &Inertia::yy, "kg m^2"),
                                            field("zz", &Inertia::zz, "kg m^2"),
                                            field("xy", &Inertia::xy, "kg m^2"),
                                            field("xz", &Inertia::xz, "kg m^2"),
                                            field("yz", &Inertia::yz, "kg m^2"));
};

struct Sphere {
  Vec3 center;
  double radius = 0;
};
// Every point nearer than `radius` to the segment a..b; a sphere when a == b.
struct Capsule {
  Vec3 a, b;
  double radius = 0;
};

// What a link looks like: a solid in one colour. Box: centred, `size` along its axes. Tube: along Z
// from 0 to `length`, `radius` at the start, `radius_end` at the end. Ball: `radius`. Mesh: a file
// that a URDF names, scaled by `size`. `rounding` is the radius of the edges of boxes and tubes.
enum class ShapeKind { box, tube, ball, mesh };
constexpr std::array<std::string_view, 4> names_of(ShapeKind) {
  return {"box", "tube", "ball", "mesh"};
}
struct BodyShape {
  ShapeKind kind = ShapeKind::box;
  Pose link_from_shape;
  Vec3 size;                                                    // m
  double radius = 0, radius_end = 0, length = 0, rounding = 0;  // m
  std::string color = "#cccccc";                                // sRGB
  double roughness = 0.45, metallic = 0;  // 0..1; lacquered or moulded plastic
  std::string mesh_file;                  // absolute, or as written when it was not found
};

struct Link {
  std::string name;
  double mass = 0;  // kg; 0 for frames without a body
  Vec3 center_of_mass;
  Inertia inertia;
  std::vector<Capsule> capsules;  // link frame: together they hold the whole body
  std::vector<Sphere> spheres;    // link frame: they cover the capsules, see spheres_of()
  std::vector<BodyShape> look;    // link frame
};

enum class JointType { fixed, revolute, continuous, prismatic };
constexpr std::array<std::string_view, 4> names_of(JointType) {
  return {"fixed", "revolute", "continuous", "prismatic"};
}

// Joint k carries link k + 1. Limits are per degree of freedom; infinity = none is known.
struct Joint {
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  std::string name;
  JointType kind = JointType::fixed;
  int parent = 0;                                // link; always smaller than this joint's own link
  int dof = -1;                                  // index into q; -1 when fixed
  Pose parent_from_joint;                        // at q = 0
  Vec3 axis{0, 0, 1};                            // unit, joint frame
  double lower = -unlimited, upper = unlimited;  // rad or m
  double velocity = unlimited;                   // rad/s or m/s
  double acceleration = unlimited;               // rad/s^2 or m/s^2
  double jerk = unlimited;                       // rad/s^3 or m/s^3
  double effort = unlimited;                     // N m or N
  double armature = 0;                           // rotor inertia at the joint, kg m^2 or kg
  double damping = 0;                            // N m s/rad or N s/m
  int link = 0;                                  // the link it carries: the joint's index + 1
  int follows = -1;  // dof that this one copies (the second finger of a gripper); -1 = none
  double follow_ratio = 1, follow_offset = 0;  // its value is ratio * leader + offset
};

// A named place on a link: a tool's tip, a camera (X right, Y down, Z ahead), a mount.
struct RobotFrame {
  std::string name;
  int link = 0;
  Pose link_from_frame;
};

// Degrees of freedom that are planned and commanded together: "arm", "left_arm", "lift", "base".
struct JointGroup {
  std::string name;
  std::vector<int> dofs;
  int base = 0;        // link in front of the first joint
  int tip = -1;        // frame that the group moves; -1 = none
  std::string solver;  // analytic inverse kinematics: "rm65", "rm75", "panda"; empty = numeric
};

// Named joint values: "ready", "stow". Degrees of freedom that it leaves out stay as they are.
struct Posture {
  struct Value {
    int dof = 0;
    double value = 0;  // rad or m
  };
  std::string name;
  std::vector<Value> values;
};

// A differential drive under the base link.
struct Drive {
  double wheel_radius = 0, wheel_track = 0;  // m; track = between the wheels' middles
  double axle_x = 0;                         // of the wheels in the base frame, m
  double speed = 0, turn_rate = 0;           // most, m/s and rad/s
  double acceleration = 0;                   // most, m/s^2
  double wheel_torque = 0;                   // most, of each wheel's motor, N m
  double tyre_friction = 0;                  // on the floor
  double wheel_load = 0;                     // share of the robot's weight on its driven wheels
  double length = 0, width = 0;              // footprint, m

  static constexpr auto fields = field_list(
      field("wheel_radius", &Drive::wheel_radius, "m", at_least(0)),
      field("wheel_track", &Drive::wheel_track, "between the wheels, m", at_least(0)),
      field("axle_x", &Drive::axle_x, "of the wheels in the base frame, m"),
      field("speed", &Drive::speed, "most, m/s", at_least(0)),
      field("turn_rate", &Drive::turn_rate, "most, rad/s", at_least(0)),
      field("acceleration", &Drive::acceleration, "most, m/s^2", at_least(0)),
      field("wheel_torque", &Drive::wheel_torque, "most, of each wheel, N m", at_least(0)),
      field("tyre_friction", &Drive::tyre_friction, "on the floor", at_least(0)),
      field("wheel_load",
            &Drive::wheel_load,
            "share of the robot's weight on its driven wheels",
            range(0, 1)),
      field("length", &Drive::length, "footprint, m", at_least(0)),
      field("width", &Drive::width, "footprint, m", at_least(0)));
};

enum class ToolKind { gripper, suction };
constexpr std::array<std::string_view, 2> names_of(ToolKind) {
  return {"gripper", "suction"};
}
// What a tool can do. Its joints are the group `<prefix>fingers`, its tip the frame `<prefix>tcp`.
struct Tool {
  std::string prefix;  // of its names in the robot
  ToolKind kind = ToolKind::gripper;
  double opening = 0;     // most, between a gripper's pads, m
  double force = 0;       // grip, or pull of a cup, N
  double cup_radius = 0;  // of a suction cup, m
  double seal_depth = 0;  // how uneven a surface may be for the cup to seal on it, m
  double payload = 0;     // kg
  int frame = -1;         // "<prefix>tcp"
  std::string row = {};   // its id in data/robots
  int driven_dof = -1;    // of a gripper: the finger that the others follow
};

// A part, an arm mostly, that stops the whole robot when something outside it presses on it harder
// than this: `link` and all links that it carries.
struct ContactLimit {
  int link = 0;
  double force = 0;  // N, of all that presses, added as vectors
  double pause = 0;  // s, that the robot then stands still
};

struct Robot {
  std::string name;
  std::vector<Link> links;    // parents first; links[0] is the root
  std::vector<Joint> joints;  // joints[k] carries links[k + 1]
  std::vector<int> dofs;      // joint of each degree of freedom, parents first
  std::vector<RobotFrame> frames;
  std::vector<JointGroup> groups;
  std::vector<Posture> postures;
  std::vector<Tool> tools;
  std::optional<Drive> drive;
  std::vector<ContactLimit> contact_limits;

  std::size_t dof_count() const { return dofs.size(); }
  const Joint& joint_of_dof(std::size_t dof) const {
    return joints[static_cast<std::size_t>(dofs[dof])];
  }
  // Index, or -1.
  int find_link(std::string_view wanted) const;
  int find_dof(std::string_view joint_name) const;
  int find_frame(std::string_view wanted) const;
  const JointGroup* find_group(std::string_view wanted) const;
  const Posture* find_posture(std::string_view wanted) const;
};

// ---- Making a robot ----

// What a reader collects, in any order; parents, children and leaders are still names.
struct RobotParts {
  struct JointPart {
    Joint joint;
    std::string parent, child;
    std::string follows;  // joint name, or empty
  };
  std::string name;
  std::vector<Link> links;
  std::vector<JointPart> joints;
};

// Checks the parts and puts them in order. `source` names the file in errors. Without spheres a
// link gets those that cover its capsules. Errors: robot.bad_file with the link or joint at fault:
// names that are empty, double or unknown; no link, several roots or a cycle; a link with two
// parents; numbers that are not finite; negative mass, a mass without inertia, an inertia that no
// body has; a zero axis; limits in the wrong order; a joint that follows none or a follower.
Result<Robot> make_robot(RobotParts parts, const std::string& source);

// Spheres that together hold `capsule` and reach at most `spare_m` out of it.
std::vector<Sphere> spheres_of(const Capsule& capsule, double spare_m = 0.005);

double total_mass(const Robot& robot);  // kg
// A degree of freedom over the floor of a base that its wheels push; no servo moves it.
bool is_on_wheels(const Robot& robot, int dof);
// The gripper whose fingers a degree of freedom moves; null for any other.
const Tool* gripper_of(const Robot& robot, int dof);
// Of a gripper the finger that the others follow (Tool::driven_dof); null for a cup.
const Joint* driven_finger(const Robot& robot, const Tool& tool);
// A link and all that it carries, parents first.
std::vector<int> links_from(const Robot& robot, int link);

// ---- State ----

// All zero, moved into the limits.
std::vector<double> neutral_state(const Robot& robot);
// `q` with a posture's values in it.
std::vector<double> with_posture(const Posture& posture, std::vector<double> q);
// Those of a group's degrees of freedom in a state of the whole robot, in the group's order.
std::vector<double> values_of(const JointGroup& group, std::span<const double> state);
// Sets those that follow another by their leader's value.
std::vector<double> with_followers(const Robot& robot, std::vector<double> q);
bool within_limits(const Robot& robot, std::span<const double> q, double slack = 1e-9);
// Errors: robot.bad_state when `q` has the wrong length, a value that is not finite, or one outside
// its limits; it names the joint.
Result<void> check_state(const Robot& robot, std::span<const double> q);

// ---- Forward kinematics ----
// Preconditions: q.size() == dof_count(). They read no limits; a NaN goes through.

// Joint frame after its motion, in its parent link: parent_from_link.
Pose joint_motion(const Joint& joint, double q);
// Writes base_from_link of every link. `base_from_link` has links.size() places.
void forward_kinematics(const Robot& robot,
                        std::span<const double> q,
                        std::span<Pose> base_from_link);
std::vector<Pose> link_poses(const Robot& robot, std::span<const double> q);
Pose frame_pose(const Robot& robot, std::span<const double> q, int frame);

}  // namespace marketgen::robots
