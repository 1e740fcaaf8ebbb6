// In all three arms the first three joints turn as Rz(q1) Ry(+-q2) Rz(q3) about the shoulder, and
// two neighbouring parallel-frame joints conjugate to a turn about Y, so every step is a planar
// triangle or a ZYZ decomposition.
#include "robots/arm_ik.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <Eigen/Geometry>

namespace marketgen::robots {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
constexpr double pi = std::numbers::pi;

struct Target {
  Vector3d position;  // of the last joint's frame, in the arm's base
  Matrix3d rotation;
};

Matrix3d turn_x(double angle) {
  return Eigen::AngleAxisd(angle, Vector3d::UnitX()).toRotationMatrix();
}
Matrix3d turn_y(double angle) {
  return Eigen::AngleAxisd(angle, Vector3d::UnitY()).toRotationMatrix();
}
Matrix3d turn_z(double angle) {
  return Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
}

// The two triples with Rz(a) Ry(b) Rz(c) = m. Where b is 0 or pi, c = 0 is chosen.
std::array<Vector3d, 2> zyz(const Matrix3d& m) {
  const double s = std::hypot(m(0, 2), m(1, 2));
  if (s < 1e-12) {
    const double b = m(2, 2) > 0 ? 0 : pi;
    const double a = m(2, 2) > 0 ? std::atan2(m(1, 0), m(0, 0)) : std::atan2(-m(1, 0), -m(0, 0));
    return {Vector3d(a, b, 0), Vector3d(a, b, 0)};
  }
  const double b = std::atan2(s, m(2, 2));
  const double a = std::atan2(m(1, 2), m(0, 2)), c = std::atan2(m(2, 1), -m(2, 0));
  return {Vector3d(a, b, c), Vector3d(a + pi, -b, c + pi)};
}

// acos, with room for rounding at the ends; nothing outside.
bool in_reach(double cosine) {
  return std::abs(cosine) <= 1 + 1e-12;
}
double safe_acos(double cosine) {
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

std::vector<ArmJoints> solve_rm65(const ArmIk& arm, const Target& target) {
  const Vector3d v =
      target.position - target.rotation.col(2) * arm.hand - Vector3d(0, 0, arm.shoulder);
  const double flat = std::hypot(v.x(), v.y());
  const double bend =
      (v.squaredNorm() - arm.upper * arm.upper - arm.fore * arm.fore) / (2 * arm.upper * arm.fore);
  std::vector<ArmJoints> found;
  if (!in_reach(bend)) return found;
  for (const double side : {1.0, -1.0}) {  // positive q2 leans towards -X
    const double q1 = std::atan2(-side * v.y(), -side * v.x());
    for (const double q3 : {safe_acos(bend), -safe_acos(bend)}) {
      const double q2 = std::atan2(side * flat, v.z()) -
                        std::atan2(arm.fore * std::sin(q3), arm.upper + arm.fore * std::cos(q3));
      const Matrix3d third = turn_z(q1) * turn_x(pi / 2) * turn_z(q2 + q3 + pi);
      for (const Vector3d& w : zyz(turn_x(-pi / 2) * third.transpose() * target.rotation))
        found.push_back({q1, q2, q3, w[0], w[1], w[2], 0});
    }
  }
  return found;
}

// Level, square to the line from shoulder to wrist; from where the swivel of an RM75 counts.
Vector3d side_of(const Vector3d& ahead) {
  const Vector3d side = Vector3d::UnitZ().cross(ahead);
  return side.norm() < 1e-9 ? Vector3d::UnitY() : Vector3d(side.normalized());
}

std::vector<ArmJoints> solve_rm75(const ArmIk& arm, const Target& target, double swivel) {
  const Vector3d v =
      target.position - target.rotation.col(2) * arm.hand - Vector3d(0, 0, arm.shoulder);
  const double reach = v.norm();
  const double rise =
      (reach * reach + arm.upper * arm.upper - arm.fore * arm.fore) / (2 * reach * arm.upper);
  std::vector<ArmJoints> found;
  if (!(reach > 1e-9) || !in_reach(rise)) return found;
  const Vector3d ahead = v / reach;
  const Vector3d side = side_of(ahead);
  const Vector3d high = ahead.cross(side);
  const double angle = safe_acos(rise);
  const Vector3d u = std::cos(angle) * ahead +
                     std::sin(angle) * (std::cos(swivel) * high + std::sin(swivel) * side);
  const Vector3d w = (v - u * arm.upper).normalized();
  for (const double s2 : {1.0, -1.0}) {
    const double q2 = s2 * std::atan2(std::hypot(u.x(), u.y()), u.z());
    const double q1 = std::atan2(s2 * u.y(), s2 * u.x());
    const Matrix3d second = turn_z(q1) * turn_y(q2);
    const Vector3d fore = second.transpose() * w;
    for (const double s4 : {1.0, -1.0}) {
      const double q4 = s4 * std::atan2(std::hypot(fore.x(), fore.y()), fore.z());
      const double q3 = std::atan2(s4 * fore.y(), s4 * fore.x());
      const Matrix3d fourth = second * turn_z(q3) * turn_y(q4);
      for (const Vector3d& wrist : zyz(fourth.transpose() * target.rotation))
        found.push_back({q1, q2, q3, q4, wrist[0], wrist[1], wrist[2]});
    }
  }
  return found;
}

// The swivel of an RM75 in that posture; 0 where shoulder, elbow and wrist are in line.
double swivel_of(const ArmIk& arm, const ArmJoints& q) {
  const Matrix3d second = turn_z(q[0]) * turn_y(q[1]);
  const Vector3d u = second.col(2);
  const Vector3d v = arm.upper * u + arm.fore * (second * turn_z(q[2]) * turn_y(q[3])).col(2);
  if (v.norm() < 1e-9) return 0;
  const Vector3d ahead = v.normalized(), side = side_of(ahead);
  return std::atan2(u.dot(side), u.dot(ahead.cross(side)));
}

// The joints 1-3, 5 and 6 of a Panda whose arm plane contains `v` (shoulder to wrist) and `m`.
void add_panda(std::vector<ArmJoints>& found,
               const Vector3d& ahead,
               const Vector3d& m,
               const Vector3d& in_plane,
               double bend,
               const Vector3d& x6,
               const Vector3d& z6,
               double q7) {
  Matrix3d third;
  third.col(0) = in_plane.x() * ahead - in_plane.z() * m;
  third.col(1) = m.cross(ahead);
  third.col(2) = in_plane.z() * ahead + in_plane.x() * m;
  const Matrix3d fourth = third * turn_y(bend);
  const Vector3d y5 = -(fourth.transpose() * z6);
  const double q5 = std::atan2(-y5.x(), y5.y());
  const Vector3d c = (fourth * turn_z(q5)).transpose() * x6;
  const double q6 = std::atan2(c.z(), c.x());
  for (const Vector3d& s : zyz(third))
    found.push_back({s[0], s[1], s[2], -bend, q5, q6, q7});
}

std::vector<ArmJoints> solve_panda(const ArmIk& arm, const Target& target, double q7) {
  const Vector3d x6 = target.rotation * Vector3d(std::cos(q7), -std::sin(q7), 0);
  const Vector3d z6 = target.rotation * Vector3d(std::sin(q7), std::cos(q7), 0);
  const Vector3d v = target.position - arm.wrist * x6 - Vector3d(0, 0, arm.shoulder);
  const double a = arm.elbow, d3 = arm.upper, d5 = arm.fore;
  // |v|^2 = 2 a^2 + d3^2 + d5^2 + 2 (P cos bend + Q sin bend), bend = -q4.
  const double p = d3 * d5 - a * a, q = a * (d3 + d5);
  const double cosine = (v.squaredNorm() - 2 * a * a - d3 * d3 - d5 * d5) / (2 * std::hypot(p, q));
  std::vector<ArmJoints> found;
  if (!in_reach(cosine) || v.norm() < 1e-9) return found;
  const Vector3d ahead = v.normalized();
  const Vector3d n1 = ahead.unitOrthogonal(), n2 = ahead.cross(n1);
  for (const double sign : {1.0, -1.0}) {
    const double bend = std::atan2(q, p) + sign * safe_acos(cosine);
    const Vector3d in_plane =
        (Vector3d(a, 0, d3) + turn_y(bend) * Vector3d(-a, 0, d5)).normalized();
    const Vector3d fore(std::sin(bend), 0, std::cos(bend));  // z5 in the arm plane
    const double along = fore.dot(in_plane);
    const double across = fore.dot(Vector3d(-in_plane.z(), 0, in_plane.x()));
    const double spread = std::hypot(n1.dot(z6), n2.dot(z6));
    if (std::abs(across) * spread < 1e-12) continue;  // z5 is fixed: a singular line of poses
    const double needed = -along * ahead.dot(z6) / (across * spread);  // z5 is normal to z6
    if (!in_reach(needed)) continue;
    for (const double turn : {1.0, -1.0}) {
      const double phi = std::atan2(n2.dot(z6), n1.dot(z6)) + turn * safe_acos(needed);
      const Vector3d m = std::cos(phi) * n1 + std::sin(phi) * n2;
      add_panda(found, ahead, m, in_plane, bend, x6, z6, q7);
    }
  }
  return found;
}

// `q` and its turns by whole revolutions that lie within the limits.
void add_within_limits(std::vector<ArmJoints>& kept, const ArmIk& arm, ArmJoints q, int joint) {
  constexpr double slack = 1e-9;
  if (joint == arm.joints) {
    kept.push_back(q);
    return;
  }
  const auto i = static_cast<std::size_t>(joint);
  const double low = arm.lower[i] - slack, high = arm.upper_limit[i] + slack;
  const double first = q[i] - 2 * pi * std::floor((q[i] - low) / (2 * pi));
  for (double value = first; value <= high; value += 2 * pi) {
    q[i] = std::clamp(value, arm.lower[i], arm.upper_limit[i]);
    add_within_limits(kept, arm, q, joint + 1);
  }
}

double distance(const ArmIk& arm, const ArmJoints& a, const ArmJoints& b) {
  double largest = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(arm.joints); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

Error no_solver(const Robot& robot, const JointGroup& group, const std::string& message) {
  return {"robot.unknown", robot.name + ":" + group.name, message};
}

void take_lengths(ArmIk& arm, const Robot& robot, const JointGroup& group) {
  std::array<Vec3, 7> steps{};  // of each joint in its parent, at q = 0
  for (std::size_t i = 0; i < group.dofs.size(); ++i) {
    const Joint& joint = robot.joint_of_dof(static_cast<std::size_t>(group.dofs[i]));
    steps[i] = joint.parent_from_joint.position;
    arm.lower[i] = joint.lower, arm.upper_limit[i] = joint.upper;
  }
  arm.shoulder = steps[0].z, arm.upper = length(steps[2]);
  switch (arm.family) {
    case ArmFamily::rm65:
      arm.fore = length(steps[3]), arm.hand = length(steps[5]);
      break;
    case ArmFamily::rm75:
      arm.fore = length(steps[4]), arm.hand = length(steps[6]);
      break;
    case ArmFamily::panda:
      arm.elbow = steps[3].x, arm.fore = std::abs(steps[4].y), arm.wrist = steps[6].x;
      break;
  }
}

Result<Pose> last_from_tip_of(const Robot& robot, const JointGroup& group) {
  const Joint& last = robot.joint_of_dof(static_cast<std::size_t>(group.dofs.back()));
  const RobotFrame& tip = robot.frames[static_cast<std::size_t>(group.tip)];
  Pose last_from_tip = tip.link_from_frame;
  for (int link = tip.link; link != last.link;) {
    const bool fixed = link > 0 && robot.joints[static_cast<std::size_t>(link - 1)].dof < 0;
    if (!fixed) return no_solver(robot, group, "the tip is not fixed to the group's last link");
    const Joint& joint = robot.joints[static_cast<std::size_t>(link - 1)];
    last_from_tip = joint.parent_from_joint * last_from_tip;
    link = joint.parent;
  }
  return last_from_tip;
}

// Whether the solver finds a posture in the middle of the limits again: its joints are laid out as
// the family's are.
bool finds_again(const ArmIk& arm, const Robot& robot, const JointGroup& group) {
  ArmJoints q{};
  std::vector<double> state = neutral_state(robot);
  for (std::size_t i = 0; i < group.dofs.size(); ++i) {
    q[i] = arm.lower[i] + 0.6 * (arm.upper_limit[i] - arm.lower[i]);
    state[static_cast<std::size_t>(group.dofs[i])] = q[i];
  }
  const Pose base = link_poses(robot, state)[static_cast<std::size_t>(group.base)];
  const Pose tip = inverse(base) * frame_pose(robot, state, group.tip);
  const double redundancy = arm.family == ArmFamily::rm75 ? swivel_of(arm, q) : q[6];
  const std::vector<ArmJoints> found = solve_arm(arm, tip, redundancy);
  return std::any_of(found.begin(), found.end(), [&](const ArmJoints& other) {
    return distance(arm, q, other) < 1e-6;
  });
}

}  // namespace

Result<ArmIk> make_arm_ik(const Robot& robot, const JointGroup& group) {
  const auto family = value_named<ArmFamily>(group.solver);
  if (!family || group.tip < 0)
    return no_solver(
        robot, group, "the group has no analytic inverse kinematics; use solve_numeric");
  ArmIk arm;
  arm.family = *family;
  arm.joints = *family == ArmFamily::rm65 ? 6 : 7;
  if (static_cast<int>(group.dofs.size()) != arm.joints)
    return no_solver(
        robot, group, fmt::format("the solver \"{}\" needs {} joints", group.solver, arm.joints));
  take_lengths(arm, robot, group);
  MARKETGEN_TRY(arm.last_from_tip, last_from_tip_of(robot, group));
  if (!finds_again(arm, robot, group))
    return no_solver(robot,
                     group,
                     "the joints are not laid out as the solver \"" + group.solver +
                         "\" expects; leave the solver empty to use solve_numeric");
  return arm;
}

std::vector<ArmJoints> solve_arm(const ArmIk& arm, const Pose& base_from_tip, double redundancy) {
  const Pose last = base_from_tip * inverse(arm.last_from_tip);
  const Quaternion& r = last.rotation;
  const Target target{{last.position.x, last.position.y, last.position.z},
                      Eigen::Quaterniond(r.w, r.x, r.y, r.z).normalized().toRotationMatrix()};
  std::vector<ArmJoints> found;
  switch (arm.family) {
    case ArmFamily::rm65:
      found = solve_rm65(arm, target);
      break;
    case ArmFamily::rm75:
      found = solve_rm75(arm, target, redundancy);
      break;
    case ArmFamily::panda:
      found = solve_panda(arm, target, redundancy);
      break;
  }
  std::vector<ArmJoints> kept;
  for (const ArmJoints& q : found)
    add_within_limits(kept, arm, q, 0);
  return kept;
}

std::vector<double> redundancies(const ArmIk& arm, const SweepOptions& options) {
  if (arm.family == ArmFamily::rm65) return {0.0};
  const bool panda = arm.family == ArmFamily::panda;
  const double low = panda ? arm.lower[6] : -pi, high = panda ? arm.upper_limit[6] : pi;
  std::vector<double> values(static_cast<std::size_t>(std::max(1, options.steps)));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] =
        low + (high - low) * (static_cast<double>(i) + 0.5) / static_cast<double>(values.size());
  return values;
}

Result<ArmJoints> nearest_arm_solution(const ArmIk& arm,
                                       const Pose& base_from_tip,
                                       const ArmJoints& seed,
                                       const SweepOptions& options) {
  bool any = false;
  ArmJoints best{};
  const auto look = [&](double redundancy) {
    for (const ArmJoints& q : solve_arm(arm, base_from_tip, redundancy)) {
      if (any && distance(arm, q, seed) >= distance(arm, best, seed)) continue;
      any = true, best = q;
    }
  };
  if (arm.family == ArmFamily::panda) look(seed[6]);
  if (arm.family == ArmFamily::rm75) look(swivel_of(arm, seed));
  for (const double redundancy : redundancies(arm, options))
    look(redundancy);
  if (!any)
    return Error{"robot.unreachable",
                 std::string(name_of(arm.family)),
                 fmt::format("no joint values within the limits bring the tip to ({:.3f}, {:.3f}, "
                             "{:.3f}); move the base or lift, or turn the tool",
                             base_from_tip.position.x,
                             base_from_tip.position.y,
                             base_from_tip.position.z)};
  return best;
}

}  // namespace marketgen::robots
