#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "motion/arm_checker.h"
#include "robots/rotation.h"

namespace marketgen::motion {
namespace {

constexpr std::size_t max_joints = 16;

// Column of the group that moves this joint, -1 when none does.
int column_of(const robots::JointGroup& group, const robots::Joint& joint) {
  const int leader = joint.follows >= 0 ? joint.follows : joint.dof;
  const auto found = std::find(group.dofs.begin(), group.dofs.end(), leader);
  return leader < 0 || found == group.dofs.end() ? -1
                                                 : static_cast<int>(found - group.dofs.begin());
}

bool finite_spheres(const std::vector<robots::Sphere>& spheres) {
  return std::all_of(spheres.begin(), spheres.end(), [](const robots::Sphere& s) {
    return is_finite(s.center) && std::isfinite(s.radius) && s.radius > 0;
  });
}

}  // namespace

Result<ArmModel> make_arm_model(const robots::Robot& robot, std::string_view group) {
  const robots::JointGroup* found = robot.find_group(group);
  if (found == nullptr) {
    return Error{"robot.unknown", robot.name, fmt::format("the robot has no group \"{}\"", group)};
  }
  if (found->dofs.empty() || found->dofs.size() > max_joints) {
    return Error{
        "motion.bad_configuration",
        found->name,
        fmt::format(
            "a group of {} joints; 1 to {} can be planned", found->dofs.size(), max_joints)};
  }
  ArmModel model{&robot, *found, robots::pairs_that_may_touch(robot), {}, {}};
  for (const int dof : found->dofs) {
    const robots::Joint& joint = robot.joint_of_dof(static_cast<std::size_t>(dof));
    if (!std::isfinite(joint.lower) || !std::isfinite(joint.upper))
      return Error{"motion.bad_configuration", joint.name, "the joint has no limits"};
    model.lower.push_back(joint.lower);
    model.upper.push_back(joint.upper);
  }
  return model;
}

void ArmChecker::add_bodies() {
  const robots::Robot& robot = *model_->robot;
  body_of_link_.assign(robot.links.size(), -1);
  body_from_link_.assign(robot.links.size(), {});
  for (const robots::Joint& joint : robot.joints) {
    const auto link = static_cast<std::size_t>(joint.link);
    const auto parent = static_cast<std::size_t>(joint.parent);
    const int parent_body = body_of_link_[parent];
    const Pose before = parent_body < 0 ? world_from_link_[parent] : body_from_link_[parent];
    const int column = column_of(model_->group, joint);
    if (column < 0) {
      const double value = joint.dof < 0 ? 0 : state_[static_cast<std::size_t>(joint.dof)];
      body_of_link_[link] = parent_body;
      body_from_link_[link] = before * robots::joint_motion(joint, value);
      continue;
    }
    const Quaternion turned = robots::rotation_from_z_to(joint.axis);
    const Pose at_zero = before * joint.parent_from_joint * Pose{{}, turned};
    const Matrix34 m = matrix_of(at_zero);
    Body body;
    body.parent = parent_body;
    body.turns = joint.kind != robots::JointType::prismatic;
    body.column = static_cast<std::size_t>(column);
    const bool follows = joint.follows >= 0;
    body.ratio = follows ? static_cast<float>(joint.follow_ratio) : 1;
    body.offset = follows ? static_cast<float>(joint.follow_offset) : 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k)
        body.rotation[3 * i + k] = static_cast<float>(m.m[i][k]);
      body.position[i] = static_cast<float>(m.m[i][3]);
    }
    const double slides = body.turns ? 0 : std::max(std::abs(joint.lower), std::abs(joint.upper));
    body.offset_m = length(at_zero.position) + slides;
    body_of_link_[link] = static_cast<int>(bodies_.size());
    body_from_link_[link] = {{}, inverse(turned)};
    bodies_.push_back(body);
  }
}

void ArmChecker::add_part(int link, const std::vector<robots::Sphere>& spheres, std::string name) {
  const auto at = static_cast<std::size_t>(link);
  const int body = body_of_link_[at];
  const Pose& pose = body < 0 ? world_from_link_[at] : body_from_link_[at];
  Part part{std::move(name), world_, link, body, {}, balls_.size(), balls_.size() + spheres.size()};
  Vec3 low{1e30, 1e30, 1e30}, high = -low;
  for (const robots::Sphere& sphere : spheres) {
    const Vec3 c = pose * sphere.center;
    const Vec3f at_f = to_float(c);
    balls_.push_back({at_f.x, at_f.y, at_f.z, static_cast<float>(sphere.radius + margin_m_)});
    low = {std::min(low.x, c.x), std::min(low.y, c.y), std::min(low.z, c.z)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y), std::max(high.z, c.z)};
  }
  const Vec3 middle = (low + high) * 0.5;
  double radius = 0;
  for (const robots::Sphere& sphere : spheres)
    radius = std::max(radius, length(pose * sphere.center - middle) + sphere.radius + margin_m_);
  const Vec3f m = to_float(middle);
  part.bound = {m.x, m.y, m.z, static_cast<float>(radius + 1e-6)};
  parts_.push_back(std::move(part));
}

Result<void> ArmChecker::add_attached(const AttachedObject& object, std::size_t index) {
  const std::string where = fmt::format("attached/{}", index);
  const int count = static_cast<int>(body_of_link_.size());
  if (object.link < 0 || object.link >= count ||
      body_of_link_[static_cast<std::size_t>(object.link)] < 0) {
    return Error{"motion.bad_configuration",
                 where,
                 fmt::format("link {} is not one that the group moves", object.link)};
  }
  if (object.spheres.empty() || !finite_spheres(object.spheres)) {
    return Error{
        "motion.bad_configuration", where, "needs spheres that are finite, with radii over 0"};
  }
  add_part(object.link, object.spheres, where);
  return {};
}

void ArmChecker::add_pairs(const std::vector<AttachedObject>& attached) {
  for (const robots::LinkPair& pair : model_->pairs) {
    const auto part_of = [&](int link) {
      std::size_t part = 0;
      while (part < links_ && parts_[part].link != link)
        ++part;
      return part;
    };
    const std::size_t a = part_of(pair.a), b = part_of(pair.b);
    if (a < links_ && b < links_ && parts_[a].body != parts_[b].body)
      pairs_.push_back({a, b, true});
  }
  for (std::size_t held = links_; held < parts_.size(); ++held) {
    const std::vector<int>& allowed = attached[held - links_].may_touch;
    for (std::size_t other = 0; other < held; ++other) {
      const bool may =
          other < links_ &&
          std::find(allowed.begin(), allowed.end(), parts_[other].link) != allowed.end();
      if (!may && parts_[other].body != parts_[held].body) pairs_.push_back({other, held, false});
    }
  }
}

// The sum of offsets between a joint and a point bounds their distance in every posture.
void ArmChecker::find_reach() {
  reach_.assign(model_->lower.size(), 0);
  for (const Part& part : parts_) {
    if (part.body < 0) continue;
    double away = 0;
    for (std::size_t i = part.first_ball; i < part.end_ball; ++i) {
      const Ball& b = balls_[i];
      away = std::max(away, std::hypot(b.x, b.y, b.z) + static_cast<double>(b.radius));
    }
    std::vector<double> reach(reach_.size(), 0);
    for (int at = part.body; at >= 0;) {
      const Body& body = bodies_[static_cast<std::size_t>(at)];
      reach[body.column] += (body.turns ? away : 1) * std::abs(static_cast<double>(body.ratio));
      away += body.offset_m;
      at = body.parent;
    }
    for (std::size_t j = 0; j < reach.size(); ++j)
      reach_[j] = std::max(reach_[j], reach[j]);
  }
}

Result<ArmChecker> ArmChecker::make(const ArmModel& model,
                                    std::span<const double> state,
                                    const Pose& world_from_base,
                                    const CollisionWorld& world,
                                    const ArmCheckOptions& options) {
  const robots::Robot& robot = *model.robot;
  MARKETGEN_CHECK(robots::check_state(robot, state));
  ArmChecker checker;
  checker.model_ = &model;
  checker.world_ = &world;
  checker.state_.assign(state.begin(), state.end());
  checker.margin_m_ = options.margin_m;
  for (const Pose& pose : robots::link_poses(robot, state))
    checker.world_from_link_.push_back(world_from_base * pose);
  checker.add_bodies();
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const robots::Link& link = robot.links[i];
    if (!link.spheres.empty()) checker.add_part(static_cast<int>(i), link.spheres, link.name);
  }
  checker.links_ = checker.parts_.size();
  for (Part& part : checker.parts_) {
    const bool works = std::ranges::find(options.at_work, part.link) != options.at_work.end();
    if (works && options.their_world != nullptr) part.world = options.their_world;
  }
  for (std::size_t i = 0; i < options.attached.size(); ++i) {
    MARKETGEN_CHECK(checker.add_attached(options.attached[i], i));
  }
  checker.add_pairs(options.attached);
  checker.find_reach();
  return checker;
}

}  // namespace marketgen::motion
