// All recursions run in the axes and about the origin of the base frame: no frame changes, and a
// link's inertia is a sum of plain vectors and matrices.
#include "robots/dynamics.h"

#include <ranges>
#include <vector>

#include <Eigen/Geometry>

namespace marketgen::robots {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d eigen(Vec3 v) {
  return {v.x, v.y, v.z};
}
Matrix3d eigen(const Quaternion& q) {
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
}
Matrix3d eigen(const Inertia& i) {
  Matrix3d m;
  m << i.xx, i.xy, i.xz, i.xy, i.yy, i.yz, i.xz, i.yz, i.zz;
  return m;
}

// A joint's unit motion as a twist about the base origin: `angular`, and the velocity of the point
// of the body at the base origin.
struct Twist {
  Vector3d linear = Vector3d::Zero(), angular = Vector3d::Zero();
};
struct Wrench {
  Vector3d force = Vector3d::Zero(), torque = Vector3d::Zero();  // torque about the base origin
};

double power(const Twist& t, const Wrench& w) {
  return t.linear.dot(w.force) + t.angular.dot(w.torque);
}

Twist motion_of(const Joint& joint, const Pose& base_from_link) {
  if (joint.kind == JointType::fixed) return {};
  const Vector3d axis = eigen(rotate(base_from_link.rotation, joint.axis));
  if (joint.kind == JointType::prismatic) return {axis, Vector3d::Zero()};
  return {eigen(base_from_link.position).cross(axis), axis};
}

struct Body {
  double mass = 0;
  Vector3d center = Vector3d::Zero();   // base frame
  Matrix3d inertia = Matrix3d::Zero();  // about the centre of mass, base axes
};

Body body_of(const Link& link, const Pose& base_from_link) {
  const Matrix3d turn = eigen(base_from_link.rotation);
  return {link.mass,
          eigen(base_from_link * link.center_of_mass),
          turn * eigen(link.inertia) * turn.transpose()};
}

// Mass, first moment and second moment about the base origin: they add up over bodies.
struct SpatialInertia {
  double mass = 0;
  Vector3d moment = Vector3d::Zero();
  Matrix3d inertia = Matrix3d::Zero();

  SpatialInertia() = default;
  explicit SpatialInertia(const Body& b)
      : mass(b.mass),
        moment(b.mass * b.center),
        inertia(b.inertia + b.mass * (b.center.squaredNorm() * Matrix3d::Identity() -
                                      b.center * b.center.transpose())) {}
  SpatialInertia& operator+=(const SpatialInertia& other) {
    mass += other.mass;
    moment += other.moment;
    inertia += other.inertia;
    return *this;
  }
  Wrench momentum(const Twist& t) const {
    return {mass * t.linear + t.angular.cross(moment),
            inertia * t.angular + moment.cross(t.linear)};
  }
};

double at(std::span<const double> values, int dof) {
  return values[static_cast<std::size_t>(dof)];
}

struct LinkMotion {
  Twist velocity, acceleration;  // of the body, about the base origin
};

// v_child = v + s qd;  a_child = a + s qdd + v x (s qd).
LinkMotion moved(const LinkMotion& parent, const Twist& s, double qd, double qdd) {
  const Twist rate{s.linear * qd, s.angular * qd};
  const Twist& v = parent.velocity;
  LinkMotion child;
  child.velocity = {v.linear + rate.linear, v.angular + rate.angular};
  child.acceleration = {
      parent.acceleration.linear + s.linear * qdd + v.angular.cross(rate.linear) +
          v.linear.cross(rate.angular),
      parent.acceleration.angular + s.angular * qdd + v.angular.cross(rate.angular)};
  return child;
}

// I a + v x* (I v).
Wrench wrench_of(const SpatialInertia& body, const LinkMotion& motion) {
  const Wrench inertial = body.momentum(motion.acceleration);
  const Wrench p = body.momentum(motion.velocity);
  const Twist& v = motion.velocity;
  return {inertial.force + v.angular.cross(p.force),
          inertial.torque + v.angular.cross(p.torque) + v.linear.cross(p.force)};
}

}  // namespace

Jacobian frame_jacobian(const Robot& robot, std::span<const double> q, int frame) {
  const std::vector<Pose> poses = link_poses(robot, q);
  const RobotFrame& wanted = robot.frames[static_cast<std::size_t>(frame)];
  const Vector3d tip =
      eigen(poses[static_cast<std::size_t>(wanted.link)] * wanted.link_from_frame.position);
  Jacobian jacobian = Jacobian::Zero(6, static_cast<Eigen::Index>(robot.dof_count()));
  for (int link = wanted.link; link > 0;) {
    const Joint& joint = robot.joints[static_cast<std::size_t>(link - 1)];
    if (joint.dof >= 0) {
      const Twist s = motion_of(joint, poses[static_cast<std::size_t>(link)]);
      jacobian.block<3, 1>(0, joint.dof) = s.linear + s.angular.cross(tip);
      jacobian.block<3, 1>(3, joint.dof) = s.angular;
    }
    link = joint.parent;
  }
  return jacobian;
}

Eigen::VectorXd inverse_dynamics(const Robot& robot,
                                 std::span<const double> q,
                                 std::span<const double> qd,
                                 std::span<const double> qdd,
                                 double gravity) {
  const std::vector<Pose> poses = link_poses(robot, q);
  std::vector<LinkMotion> motions(robot.links.size());
  std::vector<Wrench> wrenches(robot.links.size());
  motions[0].acceleration.linear = Vector3d(0, 0, gravity);  // a lift of the base acts as gravity
  for (const Joint& joint : robot.joints) {
    const auto link = static_cast<std::size_t>(joint.link);
    const double rate = joint.dof < 0 ? 0 : at(qd, joint.dof);
    const double change = joint.dof < 0 ? 0 : at(qdd, joint.dof);
    motions[link] = moved(motions[static_cast<std::size_t>(joint.parent)],
                          motion_of(joint, poses[link]),
                          rate,
                          change);
    wrenches[link] =
        wrench_of(SpatialInertia(body_of(robot.links[link], poses[link])), motions[link]);
  }
  Eigen::VectorXd efforts = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.dof_count()));
  for (const Joint& joint : std::views::reverse(robot.joints)) {
    const Wrench& w = wrenches[static_cast<std::size_t>(joint.link)];
    if (joint.dof >= 0)
      efforts[joint.dof] = power(motion_of(joint, poses[static_cast<std::size_t>(joint.link)]), w) +
                           joint.armature * at(qdd, joint.dof);
    Wrench& parent = wrenches[static_cast<std::size_t>(joint.parent)];
    parent.force += w.force;
    parent.torque += w.torque;
  }
  return efforts;
}

Eigen::VectorXd gravity_efforts(const Robot& robot, std::span<const double> q, double gravity) {
  const std::vector<double> still(robot.dof_count(), 0.0);
  return inverse_dynamics(robot, q, still, still, gravity);
}

Eigen::MatrixXd mass_matrix(const Robot& robot, std::span<const double> q) {
  const std::vector<Pose> poses = link_poses(robot, q);
  std::vector<SpatialInertia> composite(robot.links.size());
  for (std::size_t link = 0; link < robot.links.size(); ++link)
    composite[link] = SpatialInertia(body_of(robot.links[link], poses[link]));
  for (const Joint& joint : std::views::reverse(robot.joints))
    composite[static_cast<std::size_t>(joint.parent)] +=
        composite[static_cast<std::size_t>(joint.link)];

  const auto n = static_cast<Eigen::Index>(robot.dof_count());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (const Joint& joint : robot.joints) {
    if (joint.dof < 0) continue;
    const auto own = static_cast<std::size_t>(joint.link);
    const Wrench w = composite[own].momentum(motion_of(joint, poses[own]));
    for (int link = joint.link; link > 0;) {
      const Joint& above = robot.joints[static_cast<std::size_t>(link - 1)];
      if (above.dof >= 0) {
        const double value = power(motion_of(above, poses[static_cast<std::size_t>(link)]), w);
        matrix(joint.dof, above.dof) = matrix(above.dof, joint.dof) = value;
      }
      link = above.parent;
    }
    matrix(joint.dof, joint.dof) += joint.armature;
  }
  return matrix;
}

}  // namespace marketgen::robots
