#include <cmath>

#include "robots/robot.h"

namespace marketgen::robots {

Pose joint_motion(const Joint& joint, double q) {
  switch (joint.kind) {
    case JointType::revolute:
    case JointType::continuous:
      return {joint.parent_from_joint.position,
              joint.parent_from_joint.rotation * rotation_about(joint.axis, q)};
    case JointType::prismatic:
      return {joint.parent_from_joint * (joint.axis * q), joint.parent_from_joint.rotation};
    case JointType::fixed:
      break;
  }
  return joint.parent_from_joint;
}

void forward_kinematics(const Robot& robot,
                        std::span<const double> q,
                        std::span<Pose> base_from_link) {
  base_from_link[0] = Pose{};
  for (std::size_t k = 0; k < robot.joints.size(); ++k) {
    const Joint& joint = robot.joints[k];
    const double value = joint.dof < 0 ? 0 : q[static_cast<std::size_t>(joint.dof)];
    base_from_link[k + 1] =
        base_from_link[static_cast<std::size_t>(joint.parent)] * joint_motion(joint, value);
  }
}

std::vector<Pose> link_poses(const Robot& robot, std::span<const double> q) {
  std::vector<Pose> poses(robot.links.size());
  forward_kinematics(robot, q, poses);
  return poses;
}

Pose frame_pose(const Robot& robot, std::span<const double> q, int frame) {
  const RobotFrame& wanted = robot.frames[static_cast<std::size_t>(frame)];
  Pose link_from_frame = wanted.link_from_frame;
  for (int link = wanted.link; link > 0;) {
    const Joint& joint = robot.joints[static_cast<std::size_t>(link - 1)];
    const double value = joint.dof < 0 ? 0 : q[static_cast<std::size_t>(joint.dof)];
    link_from_frame = joint_motion(joint, value) * link_from_frame;
    link = joint.parent;
  }
  return link_from_frame;
}

}  // namespace marketgen::robots
