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
#include "robots/urdf.h"

namespace marketgen {
namespace {

const std::filesystem::path source = MARKETGEN_SOURCE_DIR;
constexpr int states = 200;

struct State {
  std::vector<double> q, v, a;
};

// Across the limits; joints without limits within 3 of zero.
std::vector<State> random_states(const robots::Robot& robot) {
  Stream draw = Seed(3).child("dynamics", robot.name).stream();
  std::vector<State> list(states);
  for (State& s : list) {
    for (std::size_t i = 0; i < robot.dof_count(); ++i) {
      const robots::Joint& joint = robot.joint_of_dof(i);
      s.q.push_back(draw.uniform(std::max(joint.lower, -3.0), std::min(joint.upper, 3.0)));
      s.v.push_back(draw.uniform(-2, 2));
      s.a.push_back(draw.uniform(-5, 5));
    }
  }
  return list;
}

std::string question(const robots::Robot& robot, const std::vector<State>& list) {
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

// `folder`, `name` and `frame` are what pinocchio_answers.py takes.
void expect_agreement(const robots::Robot& robot,
                      int asked,
                      const std::filesystem::path& folder,
                      const std::string& name,
                      const std::string& frame) {
  ASSERT_GE(asked, 0);
  const std::vector<State> list = random_states(robot);
  const auto answers =
      io::run_program({io::worker_python(),
                       (source / "tests/unit/robots/pinocchio_answers.py").string(),
                       folder.string(),
                       name,
                       frame},
                      question(robot, list));
  ASSERT_TRUE(answers.ok()) << to_string(answers.error());
  Comparison pinocchio(*answers);
  double pose = 0, jacobian = 0, efforts = 0, mass = 0;
  for (const State& s : list) {
    pose = std::max(pose, pinocchio.difference(by_rows(robots::frame_pose(robot, s.q, asked))));
    jacobian = std::max(jacobian,
                        pinocchio.difference(by_rows(robots::frame_jacobian(robot, s.q, asked))));
    efforts = std::max(
        efforts, pinocchio.difference(by_rows(robots::inverse_dynamics(robot, s.q, s.v, s.a))));
    mass = std::max(mass, pinocchio.difference(by_rows(robots::mass_matrix(robot, s.q))));
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

void expect_pinocchio_agrees(const std::string& id, const std::string& frame) {
  const auto robot = robots::load_robot(source / "data", id);
  ASSERT_TRUE(robot.ok()) << to_string(robot.error());
  expect_agreement(*robot, robot->find_frame(frame), source / "data/robots", id, frame);
}

// Pinocchio's own reader of URDF files judges ours: poses, turned inertias, oblique axes, branches.
TEST(Dynamics, AUrdfAgreesWithPinocchiosReader) {
  const std::filesystem::path folder = source / "tests/fixtures/robots";
  const auto read = robots::read_urdf_file(folder / "desk_arm.urdf");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_TRUE(read->warnings.empty());
  robots::Robot robot = read->robot;
  ASSERT_EQ(robot.dof_count(), 4U);
  robot.frames.push_back({"asked", robot.find_link("tool"), {}});
  expect_agreement(robot, robot.find_frame("asked"), folder, "desk_arm.urdf", "tool");
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
  robots::RobotParts parts;
  parts.name = "pendulum";
  parts.links.resize(2);
  parts.links[0].name = "wall";
  parts.links[1].name = "ball";
  parts.links[1].mass = 2;
  parts.links[1].center_of_mass = {0.5, 0, 0};
  parts.links[1].inertia = {0.004, 0.004, 0.004, 0, 0, 0};
  robots::RobotParts::JointPart joint;
  joint.joint.name = "hinge";
  joint.joint.kind = robots::JointType::revolute;
  joint.joint.axis = {0, 1, 0};
  joint.parent = "wall", joint.child = "ball";
  parts.joints.push_back(joint);
  const auto robot = robots::make_robot(parts, "test");
  ASSERT_TRUE(robot.ok()) << to_string(robot.error());
  const std::vector<double> q{0};
  EXPECT_NEAR(
      robots::gravity_efforts(*robot, q)[0], -9.81, 1e-12);  // a turn about +Y lowers the ball
  EXPECT_NEAR(robots::mass_matrix(*robot, q)(0, 0), 0.504, 1e-12);
}

}  // namespace
}  // namespace marketgen
