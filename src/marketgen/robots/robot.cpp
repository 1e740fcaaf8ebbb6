#include "robots/robot.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace marketgen::robots {
namespace {

template <class Named>
int index_of(const std::vector<Named>& list, std::string_view wanted) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const Named& n) { return n.name == wanted; });
  return found == list.end() ? -1 : static_cast<int>(found - list.begin());
}

}  // namespace

int Robot::find_link(std::string_view wanted) const {
  return index_of(links, wanted);
}
int Robot::find_dof(std::string_view joint_name) const {
  const int joint = index_of(joints, joint_name);
  return joint < 0 ? -1 : joints[static_cast<std::size_t>(joint)].dof;
}
int Robot::find_frame(std::string_view wanted) const {
  return index_of(frames, wanted);
}
const JointGroup* Robot::find_group(std::string_view wanted) const {
  const int group = index_of(groups, wanted);
  return group < 0 ? nullptr : &groups[static_cast<std::size_t>(group)];
}

const Posture* Robot::find_posture(std::string_view wanted) const {
  const int posture = index_of(postures, wanted);
  return posture < 0 ? nullptr : &postures[static_cast<std::size_t>(posture)];
}

std::vector<Sphere> spheres_of(const Capsule& capsule, double spare_m) {
  const double reach = length(capsule.b - capsule.a);
  const double radius = capsule.radius + spare_m;
  // Spheres `step` apart meet at `capsule.radius` from the segment.
  const double step = 2 * std::sqrt(radius * radius - capsule.radius * capsule.radius);
  const int count = reach <= 0 ? 1 : static_cast<int>(std::ceil(reach / step));
  std::vector<Sphere> spheres;
  if (reach <= 0) return {{capsule.a, capsule.radius}};
  for (int i = 0; i < count; ++i) {
    const double along = (i + 0.5) / count;
    spheres.push_back({capsule.a + (capsule.b - capsule.a) * along, radius});
  }
  // The rounded ends reach out of the outermost spheres.
  spheres.push_back({capsule.a, capsule.radius});
  spheres.push_back({capsule.b, capsule.radius});
  return spheres;
}

bool is_on_wheels(const Robot& robot, int dof) {
  const JointGroup* base = robot.drive ? robot.find_group("base") : nullptr;
  return base != nullptr && std::ranges::count(base->dofs, dof) > 0;
}

const Tool* gripper_of(const Robot& robot, int dof) {
  for (const Tool& tool : robot.tools) {
    const JointGroup* fingers = robot.find_group(tool.prefix + "fingers");
    if (tool.kind == ToolKind::gripper && fingers != nullptr &&
        std::ranges::count(fingers->dofs, dof) > 0)
      return &tool;
  }
  return nullptr;
}

const Joint* driven_finger(const Robot& robot, const Tool& tool) {
  return tool.driven_dof < 0 ? nullptr
                             : &robot.joint_of_dof(static_cast<std::size_t>(tool.driven_dof));
}

std::vector<int> links_from(const Robot& robot, int link) {
  std::vector<int> links{link};
  for (const Joint& joint : robot.joints)  // parents come first
    if (std::ranges::find(links, joint.parent) != links.end()) links.push_back(joint.link);
  return links;
}

double total_mass(const Robot& robot) {
  double mass = 0;
  for (const Link& link : robot.links)
    mass += link.mass;
  return mass;
}

std::vector<double> values_of(const JointGroup& group, std::span<const double> state) {
  std::vector<double> values;
  for (const int dof : group.dofs)
    values.push_back(state[static_cast<std::size_t>(dof)]);
  return values;
}

std::vector<double> neutral_state(const Robot& robot) {
  std::vector<double> q(robot.dof_count());
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Joint& joint = robot.joint_of_dof(i);
    q[i] = std::clamp(0.0, joint.lower, joint.upper);
  }
  return q;
}

std::vector<double> with_posture(const Posture& posture, std::vector<double> q) {
  for (const Posture::Value& v : posture.values)
    q[static_cast<std::size_t>(v.dof)] = v.value;
  return q;
}

std::vector<double> with_followers(const Robot& robot, std::vector<double> q) {
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Joint& joint = robot.joint_of_dof(i);
    if (joint.follows >= 0)
      q[i] = joint.follow_ratio * q[static_cast<std::size_t>(joint.follows)] + joint.follow_offset;
  }
  return q;
}

bool within_limits(const Robot& robot, std::span<const double> q, double slack) {
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Joint& joint = robot.joint_of_dof(i);
    if (!(q[i] >= joint.lower - slack && q[i] <= joint.upper + slack)) return false;
  }
  return true;
}

Result<void> check_state(const Robot& robot, std::span<const double> q) {
  if (q.size() != robot.dof_count())
    return Error{"robot.bad_state",
                 robot.name,
                 fmt::format("{} joint values were given; the robot has {} degrees of freedom",
                             q.size(),
                             robot.dof_count())};
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Joint& joint = robot.joint_of_dof(i);
    const std::string where = robot.name + ":" + joint.name;
    if (!std::isfinite(q[i]))
      return Error{"robot.bad_state", where, "the joint value is not a finite number"};
    if (q[i] < joint.lower - 1e-9 || q[i] > joint.upper + 1e-9)
      return Error{
          "robot.bad_state",
          where,
          fmt::format("{} is outside the limits {} .. {}", q[i], joint.lower, joint.upper)};
  }
  return {};
}

}  // namespace marketgen::robots
