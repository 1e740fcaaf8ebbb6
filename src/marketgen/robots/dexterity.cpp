#include "robots/dexterity.h"

#include <algorithm>
#include <limits>

#include <Eigen/SVD>

#include "robots/dynamics.h"

namespace marketgen::robots {

double min_gain(const Robot& robot,
                std::span<const double> q,
                int frame,
                const std::vector<int>& dofs) {
  const Jacobian all = frame_jacobian(robot, q, frame);
  Jacobian some(6, static_cast<Eigen::Index>(dofs.size()));
  for (std::size_t i = 0; i < dofs.size(); ++i)
    some.col(static_cast<Eigen::Index>(i)) = all.col(dofs[i]);
  if (dofs.size() < 6) return 0;
  return Eigen::JacobiSVD<Eigen::MatrixXd>(some).singularValues().minCoeff();
}

double min_room(const Robot& robot, std::span<const double> q, const std::vector<int>& dofs) {
  double room = std::numeric_limits<double>::infinity();
  for (const int dof : dofs) {
    const auto place = static_cast<std::size_t>(dof);
    const Joint& joint = robot.joint_of_dof(place);
    room = std::min({room, q[place] - joint.lower, joint.upper - q[place]});
  }
  return room;
}

}  // namespace marketgen::robots
