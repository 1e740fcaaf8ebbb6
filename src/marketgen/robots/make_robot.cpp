// Parts in any order become a checked tree with parents first.
#include <algorithm>
#include <cmath>
#include <map>
#include <ranges>
#include <set>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include "robots/robot.h"

namespace marketgen::robots {
namespace {

bool is_finite(const Pose& pose) {
  const Quaternion& q = pose.rotation;
  return marketgen::is_finite(pose.position) && std::isfinite(q.w + q.x + q.y + q.z);
}
bool is_finite(const Inertia& i) {
  return std::isfinite(i.xx + i.yy + i.zz + i.xy + i.xz + i.yz);
}

// Why no rigid body has this inertia; empty when one has. Principal moments are positive and obey
// the triangle inequality. `slack` allows for figures published with few digits.
std::string inertia_fault(const Inertia& i) {
  constexpr double slack = 1e-3;
  Eigen::Matrix3d matrix;
  matrix << i.xx, i.xy, i.xz, i.xy, i.yy, i.yz, i.xz, i.yz, i.zz;
  const Eigen::Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
  if (moments[0] <= 0)
    return fmt::format("the inertia is not positive: its least principal moment is {} kg m^2",
                       moments[0]);
  if (moments[2] > (moments[0] + moments[1]) * (1 + slack))
    return fmt::format(
        "no body has this inertia: its largest principal moment {} exceeds the sum "
        "of the others, {}",
        moments[2],
        moments[0] + moments[1]);
  return {};
}

std::string link_fault(const Link& link) {
  if (link.name.empty()) return "the link has no name";
  if (!std::isfinite(link.mass) || !marketgen::is_finite(link.center_of_mass) ||
      !is_finite(link.inertia))
    return "mass, centre of mass and inertia must be finite numbers";
  if (link.mass < 0) return fmt::format("the mass {} kg is negative", link.mass);
  for (const Capsule& c : link.capsules) {
    if (!marketgen::is_finite(c.a) || !marketgen::is_finite(c.b) ||
        !(c.radius > 0 && std::isfinite(c.radius)))
      return "a collision capsule needs finite ends and a radius above 0";
  }
  return link.mass > 0 ? inertia_fault(link.inertia) : std::string{};
}

std::string joint_fault(const Joint& joint) {
  if (joint.name.empty()) return "the joint has no name";
  if (!is_finite(joint.parent_from_joint) || !marketgen::is_finite(joint.axis))
    return "origin and axis must be finite numbers";
  if (joint.kind == JointType::fixed) return {};
  if (length(joint.axis) < 1e-9) return "the axis is zero; expected a direction such as 0 0 1";
  if (std::isnan(joint.lower) || std::isnan(joint.upper) || joint.lower > joint.upper)
    return fmt::format(
        "the limits {} .. {} are not in order; expected lower <= upper", joint.lower, joint.upper);
  for (const double most : {joint.velocity, joint.acceleration, joint.jerk, joint.effort}) {
    if (!(most >= 0)) return "velocity, acceleration, jerk and effort limits must not be negative";
  }
  if (!std::isfinite(joint.follow_ratio) || !std::isfinite(joint.follow_offset))
    return "ratio and offset to the joint that it follows must be finite";
  if (!(joint.armature >= 0) || !(joint.damping >= 0))
    return "armature and damping must not be negative";
  return {};
}

class Builder {
 public:
  Builder(RobotParts parts, const std::string& source)
      : parts_(std::move(parts)), source_(source) {}

  Result<Robot> build() {
    MARKETGEN_CHECK(check_links());
    MARKETGEN_CHECK(check_joints());
    MARKETGEN_TRY(const std::size_t root, find_root());
    Robot robot;
    robot.name = parts_.name;
    add_subtrees(robot, root);
    if (robot.links.size() != parts_.links.size()) return cycle(robot);
    MARKETGEN_CHECK(resolve_followers(robot));
    return robot;
  }

 private:
  Error fault(const std::string& what, const std::string& name, const std::string& message) const {
    return {"robot.bad_file", source_ + ":" + what + " \"" + name + "\"", message};
  }

  Result<void> check_links() {
    if (parts_.links.empty())
      return Error{"robot.bad_file", source_, "the robot has no link; expected at least one"};
    for (std::size_t i = 0; i < parts_.links.size(); ++i) {
      const Link& link = parts_.links[i];
      if (const std::string wrong = link_fault(link); !wrong.empty())
        return fault("link", link.name, wrong);
      if (!link_index_.emplace(link.name, i).second)
        return fault("link", link.name, "two links have this name");
    }
    return {};
  }

  Result<void> check_joints() {
    std::set<std::string> names;
    for (std::size_t i = 0; i < parts_.joints.size(); ++i) {
      const RobotParts::JointPart& part = parts_.joints[i];
      const std::string& name = part.joint.name;
      if (const std::string wrong = joint_fault(part.joint); !wrong.empty())
        return fault("joint", name, wrong);
      if (!names.insert(name).second) return fault("joint", name, "two joints have this name");
      for (const std::string& end : {part.parent, part.child}) {
        if (!link_index_.contains(end))
          return fault("joint", name, "there is no link \"" + end + "\"");
      }
      if (!joint_to_.emplace(part.child, i).second)
        return fault("joint", name, "the link \"" + part.child + "\" already has a parent");
    }
    return {};
  }

  Result<std::size_t> find_root() const {
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < parts_.links.size(); ++i) {
      if (!joint_to_.contains(parts_.links[i].name)) roots.push_back(i);
    }
    if (roots.empty())
      return Error{"robot.bad_file", source_, "the joints form a cycle: every link has a parent"};
    if (roots.size() > 1)
      return fault("link",
                   parts_.links[roots[1]].name,
                   "no joint leads to this link, nor to \"" + parts_.links[roots[0]].name +
                       "\"; expected one root");
    return roots[0];
  }

  // Depth first, children in the order of their joints.
  void add_subtrees(Robot& robot, std::size_t root) {
    std::map<std::string, std::vector<std::size_t>> children;
    for (std::size_t i = 0; i < parts_.joints.size(); ++i)
      children[parts_.joints[i].parent].push_back(i);
    add_link(robot, root);
    std::vector<std::pair<std::size_t, int>> open;  // joint part, parent link in `robot`
    const auto push = [&](int link) {
      const std::vector<std::size_t>& next =
          children[robot.links[static_cast<std::size_t>(link)].name];
      for (const std::size_t joint : std::views::reverse(next))
        open.emplace_back(joint, link);
    };
    for (push(0); !open.empty();) {
      const auto [part, parent] = open.back();
      open.pop_back();
      add_joint(robot, parts_.joints[part], parent);
      push(static_cast<int>(robot.links.size()) - 1);
    }
  }

  void add_link(Robot& robot, std::size_t index) {
    Link link = parts_.links[index];
    if (link.spheres.empty()) {
      for (const Capsule& capsule : link.capsules) {
        const std::vector<Sphere> cover = spheres_of(capsule);
        link.spheres.insert(link.spheres.end(), cover.begin(), cover.end());
      }
    }
    robot.links.push_back(std::move(link));
  }

  void add_joint(Robot& robot, const RobotParts::JointPart& part, int parent) {
    Joint joint = part.joint;
    joint.parent = parent;
    joint.axis = normalized(joint.axis);
    joint.link = static_cast<int>(robot.links.size());
    joint.dof = -1;
    if (joint.kind != JointType::fixed) {
      joint.dof = static_cast<int>(robot.dofs.size());
      robot.dofs.push_back(static_cast<int>(robot.joints.size()));
    }
    robot.joints.push_back(joint);
    add_link(robot, link_index_.at(part.child));
  }

  Error cycle(const Robot& robot) const {
    for (const Link& link : parts_.links) {
      if (robot.find_link(link.name) < 0)
        return fault("link", link.name, "the joints that lead to this link form a cycle");
    }
    return {"internal.bug", source_, "a link was lost"};
  }

  Result<void> resolve_followers(Robot& robot) const {
    for (const RobotParts::JointPart& part : parts_.joints) {
      if (part.follows.empty()) continue;
      const int leader = robot.find_dof(part.follows), own = robot.find_dof(part.joint.name);
      if (leader < 0 || own < 0 || leader == own)
        return fault("joint",
                     part.joint.name,
                     "it follows \"" + part.follows + "\", which is no other moving joint");
      if (follows_another(part.follows))
        return fault("joint",
                     part.joint.name,
                     "it follows \"" + part.follows + "\", which follows another itself");
      robot.joints[static_cast<std::size_t>(robot.dofs[static_cast<std::size_t>(own)])].follows =
          leader;
    }
    return {};
  }

  bool follows_another(const std::string& joint) const {
    return std::any_of(
        parts_.joints.begin(), parts_.joints.end(), [&](const RobotParts::JointPart& other) {
          return other.joint.name == joint && !other.follows.empty();
        });
  }

  RobotParts parts_;
  const std::string& source_;
  std::map<std::string, std::size_t> link_index_, joint_to_;
};

}  // namespace

Result<Robot> make_robot(RobotParts parts, const std::string& source) {
  return Builder(std::move(parts), source).build();
}

}  // namespace marketgen::robots
