// Kinematics and dynamics against Pinocchio, which reads the same rows by itself
// (pinocchio_answers.py), and against a pendulum worked out by hand.
#include "robots/dynamics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "base/seed.h"
#include "io/program.h"
#include "robots/robot_row.h"

namespace marketgen {
namespace {

const std::filesystem::path source = MARKETGEN_SOURCE_DIR;
constexpr int states = 200;

struct State {
  std::vector<double> q, v, a;
};

// Across the limits; joints without limits within 3 of zero.
std::vector<State> random_states(const Robot& robot) {
  Stream draw = Seed(3).child("dynamics", robot.name).stream();
  std::vector<State> list(states);
  for (State& s : list) {
    for (std::size_t i = 0; i < robot.dof_count(); ++i) {
      const Joint& joint = robot.joint_of_dof(i);
      s.q.push_back(draw.uniform(std::max(joint.lower, -3.0), std::min(joint.upper, 3.0)));
      s.v.push_back(draw.uniform(-2, 2));
      s.a.push_back(draw.uniform(-5, 5));
    }
  }
  return list;
}

std::string question(const Robot& robot, const std::vector<State>& list) {
  std::string text = fmt::format("{}\n", robot.dof_count());
  for (std::size_t i = 0; i < robot.dof_count(); ++i)
    text += robot.joint_of_dof(i).name + "\n";
  text += fmt::format("{}\n", list.size());
  for (const State& s : list) {
    for (const auto* values : {&s.q, &s.v, &s.a}) {
      for (const double value : *values)
        text += fmt::format("{} ", value);
    }
  }
  return text;
}

// The next `count` numbers and our own: the largest difference over the largest number.
class Comparison {
 public:
  explicit Comparison(const std::string& answers) : in_(answers) {}

  double difference(const std::vector<double>& own) {
    double worst = 0, largest = 1e-3;
    for (const double value : own) {
      double other = std::nan("");
      in_ >> other;
      worst = std::max(worst, std::isfinite(other) ? std::abs(other - value) : HUGE_VAL);
      largest = std::max(largest, std::abs(other));
    }
    return worst / largest;
  }

 private:
  std::istringstream in_;
};

template <class Matrix>
std::vector<double> by_rows(const Matrix& m) {
  std::vector<double> values;
  for (Eigen::Index r = 0; r < m.rows(); ++r) {
    for (Eigen::Index c = 0; c < m.cols(); ++c)
      values.push_back(m(r, c));
  }
  return values;
}

std::vector<double> by_rows(const Pose& pose) {
  const Matrix34 m = matrix_of(pose);
  return {&m.m[0][0], &m.m[0][0] + 12};
}

void expect_pinocchio_agrees(const std::string& id, const std::string& frame) {
  const auto robot = load_robot(source / "data", id);
  ASSERT_TRUE(robot.ok()) << to_string(robot.error());
  const int asked = robot->find_frame(frame);
  ASSERT_GE(asked, 0);
  const std::vector<State> list = random_states(*robot);
  const auto answers = run_program({worker_python(),
                                    (source / "tests/unit/robots/pinocchio_answers.py").string(),
                                    (source / "data/robots").string(),
                                    id,
                                    frame},
                                   question(*robot, list));
  ASSERT_TRUE(answers.ok()) << to_string(answers.error());
  Comparison pinocchio(*answers);
  double pose = 0, jacobian = 0, efforts = 0, mass = 0;
  for (const State& s : list) {
    pose = std::max(pose, pinocchio.difference(by_rows(frame_pose(*robot, s.q, asked))));
    jacobian =
        std::max(jacobian, pinocchio.difference(by_rows(frame_jacobian(*robot, s.q, asked))));
    efforts =
        std::max(efforts, pinocchio.difference(by_rows(inverse_dynamics(*robot, s.q, s.v, s.a))));
    mass = std::max(mass, pinocchio.difference(by_rows(mass_matrix(*robot, s.q))));
  }
  EXPECT_LT(pose, 1e-9);
  EXPECT_LT(jacobian, 1e-9);
  EXPECT_LT(efforts, 1e-9);
  EXPECT_LT(mass, 1e-9);
  ::testing::Test::RecordProperty("pose", fmt::format("{:.1e}", pose));
  ::testing::Test::RecordProperty("jacobian", fmt::format("{:.1e}", jacobian));
  ::testing::Test::RecordProperty("efforts", fmt::format("{:.1e}", efforts));
  ::testing::Test::RecordProperty("mass", fmt::format("{:.1e}", mass));
}

TEST(Dynamics, PandaAgreesWithPinocchio) {
  expect_pinocchio_agrees("panda", "tcp");
}
TEST(Dynamics, Rm65AgreesWithPinocchio) {
  expect_pinocchio_agrees("rm65-b-v", "flange");
}
TEST(Dynamics, Rm75AgreesWithPinocchio) {
  expect_pinocchio_agrees("rm75-b", "flange");
}
TEST(Dynamics, DualArmRobotsAgreeWithPinocchio) {
  expect_pinocchio_agrees("realman-rm65", "left_tool_tcp");
  expect_pinocchio_agrees("realman-rm75", "right_tool_tcp");
}

// A 2 kg ball, 0.5 m along X from a joint about Y: it takes m g l = 9.81 N m to hold, and its
// inertia about the joint is m l^2 + I = 0.504 kg m^2.
TEST(Dynamics, APendulumByHand) {
  RobotParts parts;
  parts.name = "pendulum";
  parts.links.resize(2);
  parts.links[0].name = "wall";
  parts.links[1].name = "ball";
  parts.links[1].mass = 2;
  parts.links[1].center_of_mass = {0.5, 0, 0};
  parts.links[1].inertia = {0.004, 0.004, 0.004, 0, 0, 0};
  RobotParts::JointPart joint;
  joint.joint.name = "hinge";
  joint.joint.kind = JointKind::revolute;
  joint.joint.axis = {0, 1, 0};
  joint.parent = "wall", joint.child = "ball";
  parts.joints.push_back(joint);
  const auto robot = make_robot(parts, "test");
  ASSERT_TRUE(robot.ok()) << to_string(robot.error());
  const std::vector<double> q{0};
  EXPECT_NEAR(gravity_efforts(*robot, q)[0], -9.81, 1e-12);  // a turn about +Y lowers the ball
  EXPECT_NEAR(mass_matrix(*robot, q)(0, 0), 0.504, 1e-12);
}

}  // namespace
}  // namespace marketgen
