// What a person wants of a robot, as numbers of an action: the right ones, bounded, exact in
// float32; and a robot that is told nothing stays where it is.
#include "environments/teleop_hands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "environments/environment_batch.h"
#include "support/committed_catalog.h"
#include "support/pool_ground.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

using episodes::Track;
using robots::TeleopCommand;
using robots::TeleopGrip;

struct Driven {
  std::unique_ptr<environments::Environment> environment;
  std::optional<environments::TeleopHands> hands;

  explicit Driven(Track track) {
    environments::EnvironmentOptions options;
    options.control = environments::ControlMode::pd_ee_delta_pose;
    environment = pool_environment(track, options);
    const auto done = environment->reset(pool_episode(track, 60));
    if (!done.ok()) fatal(to_string(done.error()).c_str());
    hands.emplace(*environment);
  }
  double number(const std::vector<double>& numbers, const std::string& name) const {
    const auto& all = environment->action_numbers();
    const auto at = std::ranges::find(all, name, &environments::ActionNumber::name);
    return numbers.at(static_cast<std::size_t>(at - all.begin()));
  }
  void step(const TeleopCommand& command) {
    const auto made = environment->step(hands->numbers(command, false));
    if (!made.ok()) fatal(to_string(made.error()).c_str());
  }
};

class Teleop : public testing::TestWithParam<Track> {};

TEST_P(Teleop, NumbersAreAnAction) {
  Driven driven(GetParam());
  TeleopCommand command;
  command.drive = command.turn = 0.333;
  command.move = {0.1, -0.777, 1};
  command.twist = {1, 1, 1};
  command.joints = {0.5, 0.5, 0.5, 0.5};
  command.axes = robots::TeleopAxes::tool;
  const std::vector<double> numbers = driven.hands->numbers(command, false);
  ASSERT_TRUE(driven.environment->check(numbers).ok());
  for (const double number : numbers) {
    EXPECT_LE(std::abs(number), 1);
    EXPECT_EQ(number, static_cast<double>(static_cast<float>(number)));
  }
}

TEST_P(Teleop, OneArmMovesAndOneToolGrips) {
  Driven driven(GetParam());
  TeleopCommand command;
  command.arm = 7;  // more than there are: the last
  command.move = {0, 0, 0.25};
  command.grip = TeleopGrip::close;
  const std::vector<double> numbers = driven.hands->numbers(command, true);
  const auto& tools = driven.environment->world().robot().tools;
  EXPECT_EQ(numbers.back(), 1) << "the driver is done";
  EXPECT_EQ(driven.hands->openings().back(), -1);
  EXPECT_EQ(std::ranges::count(driven.hands->openings(), -1), 1);
  EXPECT_EQ(numbers[(tools.size() - 1) * 6 + 2], 0.25);
  const std::vector<double> later = driven.hands->numbers({}, false);
  EXPECT_EQ(driven.hands->openings().back(), -1) << "it holds what it holds";
  EXPECT_EQ(later.back(), -1);
}

TEST_P(Teleop, AlongTheToolsOwnAxesIsTurnedByIt) {
  Driven driven(GetParam());
  const Pose tool = driven.environment->tool_poses().front();
  TeleopCommand command;
  command.axes = robots::TeleopAxes::tool;
  command.move = {0, 0, 0.5};
  const std::vector<double> numbers = driven.hands->numbers(command, false);
  const Vec3 ahead = rotate(tool.rotation, Vec3{0, 0, 0.5});
  EXPECT_NEAR(numbers[0], ahead.x, environments::teleop_grid);
  EXPECT_NEAR(numbers[1], ahead.y, environments::teleop_grid);
  EXPECT_NEAR(numbers[2], ahead.z, environments::teleop_grid);
}

TEST_P(Teleop, WhoIsToldNothingStaysWhereItIs) {
  Driven driven(GetParam());
  for (int step = 0; step < 20; ++step)
    driven.step({});
  const Pose before = driven.environment->tool_poses().front();
  for (int step = 0; step < 60; ++step)
    driven.step({});
  EXPECT_LT(length(driven.environment->tool_poses().front().position - before.position), 0.002)
      << "in three seconds";
}

TEST_P(Teleop, AToolIsBroughtWhereItIsTold) {
  Driven driven(GetParam());
  const Pose before = driven.environment->tool_poses().front();
  TeleopCommand command;
  command.move = {0, 0, -0.5};  // down, where both arms have room
  for (int step = 0; step < 20; ++step)
    driven.step(command);
  const Vec3 way = driven.environment->tool_poses().front().position - before.position;
  EXPECT_LT(way.z, -0.15) << "20 steps of 10 mm";
  EXPECT_LT(std::hypot(way.x, way.y), 0.03);
}

INSTANTIATE_TEST_SUITE_P(Tracks,
                         Teleop,
                         testing::Values(Track::checkout, Track::aisle),
                         [](const auto& track) { return std::string(name_of(track.param)); });

TEST(TeleopBase, DrivesAhead) {
  Driven driven(Track::aisle);
  const auto joints = environments::teleop_joints(*driven.environment);
  ASSERT_FALSE(joints.empty());
  EXPECT_EQ(joints.front().dimension, "m") << "the lift";
  TeleopCommand command;
  command.drive = 0.3;
  const robots::BasePlace before = driven.environment->world().observe().base;
  for (int step = 0; step < 20; ++step)
    driven.step(command);
  const robots::BasePlace after = driven.environment->world().observe().base;
  const double along = (after.x_m - before.x_m) * std::cos(before.heading) +
                       (after.y_m - before.y_m) * std::sin(before.heading);
  EXPECT_GT(along, 0.1);
}

}  // namespace
}  // namespace marketgen
