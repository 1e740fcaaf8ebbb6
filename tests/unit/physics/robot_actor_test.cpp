// Robots in a World: the drives carry what independent dynamics say, trajectories are followed, a
// gripper presses with the force it is told and holds by it, an impedance yields like its spring.
#include "physics/world/robot_controller.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "robots/dynamics.h"
#include "robots/impedance.h"
#include "support/committed_catalog.h"
#include "support/committed_robot.h"
#include "unit/physics/small_worlds.h"

namespace marketgen {
namespace {

struct Stage {
  scene::Scene scene;
  robots::Robot robot;
  physics::RobotActorOptions options;
  std::unique_ptr<physics::World> world;
  physics::RobotActor actor;
  physics::RobotController controller;
  physics::RobotReference reference;  // at first: to stay

  void follow_reference() {
    ASSERT_TRUE(controller.command(*world, reference).ok());
    run(*world, 1);
    controller.feel(*world);
  }
  std::vector<double> q() const { return actor.position(*world); }
  void hold(const std::vector<double>& q, int steps) {
    ASSERT_TRUE(actor.command(*world, q, std::vector<double>(q.size())).ok());
    run(*world, steps);
  }
};

std::unique_ptr<Stage> stage_of(const std::string& id,
                                HandMadeScene shop,
                                physics::RobotActorOptions options) {
  auto stage = std::make_unique<Stage>();
  stage->scene = shop.scene;
  stage->robot = committed_robot(id);
  stage->options = std::move(options);
  physics::WorldOptions world;
  world.frictions = committed_catalog().frictions;
  world.actor_materials = physics::robot_materials(stage->robot, stage->options);
  world.add_actors = [s = stage.get()](mjSpec_& spec) {
    return physics::add_robot(spec, s->robot, s->options);
  };
  stage->world = std::make_unique<physics::World>(made(stage->scene, std::move(world)));
  stage->controller =
      physics::RobotController::start(*stage->world, stage->robot, stage->options.prefix).value();
  stage->actor = stage->controller.actor();
  stage->reference.joints = stage->controller.setpoints();
  stage->reference.grips.resize(stage->robot.tools.size());
  return stage;
}

physics::RobotActorOptions ready_on_the_floor(const robots::Robot& robot) {
  physics::RobotActorOptions options;
  options.world_from_base = {{1.5, 1.5, 0}, {}};
  options.state = robots::with_posture(*robot.find_posture("ready"), robots::neutral_state(robot));
  return options;
}

TEST(RobotActor, ThePandaStandsStillAndItsDrivesCarryItsWeight) {
  const robots::Robot panda = committed_robot("panda");
  const auto stage = stage_of("panda", row_of_cans(1), ready_on_the_floor(panda));
  const std::vector<double> start = stage->q();
  EXPECT_LT(std::abs(start[3] - stage->options.state[3]), 1e-12);
  stage->hold(stage->options.state, 2 * second);
  const Eigen::VectorXd gravity = robots::gravity_efforts(panda, stage->options.state);
  const std::vector<double> efforts = stage->actor.effort(*stage->world);
  for (std::size_t j = 0; j < 7; ++j) {
    EXPECT_LT(std::abs(stage->q()[j] - start[j]), 1e-5) << j;
    EXPECT_NEAR(efforts[j], gravity[static_cast<Eigen::Index>(j)], 0.02) << j;
    EXPECT_LT(std::abs(stage->actor.velocity(*stage->world)[j]), 1e-4) << j;
  }
}

TEST(RobotActor, ATrajectoryIsFollowedWithoutLag) {
  const robots::Robot panda = committed_robot("panda");
  const auto stage = stage_of("panda", row_of_cans(1), ready_on_the_floor(panda));
  const std::vector<double> middle = stage->options.state;
  double worst = 0;
  for (int i = 0; i < 2 * second; ++i) {
    const double t = i * 0.002, swing = 0.3 * (1 - std::cos(3 * t)), rate = 0.9 * std::sin(3 * t);
    std::vector<double> q = middle, v(q.size());
    for (const std::size_t j : {0U, 3U, 5U})
      q[j] += swing, v[j] = rate;
    ASSERT_TRUE(stage->actor.command(*stage->world, q, v).ok());
    for (std::size_t j = 0; j < 7; ++j)
      worst = std::max(worst, std::abs(stage->q()[j] - q[j]));
    run(*stage->world, 1);
  }
  EXPECT_LT(worst, 0.01);  // rad
}

TEST(RobotActor, TheDualArmDrivesLiftsAndMovesBothArms) {
  const robots::Robot realman = committed_robot("realman-rm75");
  physics::RobotActorOptions options;
  options.prefix = "left shop/";
  options.world_from_base = {{1.5, 1.0, 0}, {}};
  options.state =
      robots::with_posture(*realman.find_posture("stow"), robots::neutral_state(realman));
  const auto stage = stage_of("realman-rm75", row_of_cans(1), options);
  std::vector<double> goal = options.state;
  goal[static_cast<std::size_t>(realman.find_dof("base_x"))] += 0.1;
  goal[static_cast<std::size_t>(realman.find_dof("lift"))] += 0.1;
  for (const char* group : {"left_arm", "right_arm"})
    goal[static_cast<std::size_t>(realman.find_group(group)->dofs[0])] += 0.1;
  const std::vector<double> from = options.state;
  for (int i = 0; i <= 2 * second; ++i) {  // a half cosine
    const double turn = 3.14159265358979 * i / (2 * second), share = (1 - std::cos(turn)) / 2;
    const double rate = 3.14159265358979 / 4 * std::sin(turn);
    for (std::size_t j = 0; j < goal.size(); ++j)
      stage->reference.joints[j] = {from[j] + (goal[j] - from[j]) * share,
                                    (goal[j] - from[j]) * rate};
    stage->reference.drive_m_s = 0.1 * rate;
    stage->follow_reference();
  }
  for (int i = 0; i < second; ++i)
    stage->follow_reference();
  for (std::size_t j = 0; j < goal.size(); ++j) {
    if (realman.joint_of_dof(j).follows < 0) {
      EXPECT_NEAR(stage->q()[j], goal[j], 2e-3) << realman.joint_of_dof(j).name;
    }
  }
}

// The Panda's hand hangs upside down round a can that stands on a shelf.
std::unique_ptr<Stage> hand_round_a_can() {
  physics::RobotActorOptions options;
  const HandMadeScene shop = row_of_cans(1);
  const auto& can_at = shop.scene.products[0].position_m;
  options.world_from_base = {{can_at[0], can_at[1], can_at[2] + 0.095 + 0.1034},
                             rotation_about({1, 0, 0}, 3.14159265358979)};
  options.state = {0.04, 0.04};
  return stage_of("panda-hand", shop, options);
}

double slid_under(double grip_n, double pull_n) {
  const auto stage = hand_round_a_can();
  physics::World& world = *stage->world;
  stage->reference.grips[0] = {0, grip_n};
  for (int i = 0; i < second; ++i)
    stage->follow_reference();
  const Pose before = world.product_pose(0);
  for (int i = 0; i < second; ++i) {
    EXPECT_TRUE(world.push(0, {{0, 0, pull_n}, {}}).ok());
    stage->follow_reference();
  }
  return distance(before, world.product_pose(0));
}

TEST(RobotActor, AGripperPressesWithTheForceItIsToldToHaveAndHoldsByIt) {
  const auto stage = hand_round_a_can();
  for (const double force : {70.0, 20.0}) {
    stage->reference.grips[0] = {0, force};
    for (int i = 0; i < second; ++i)
      stage->follow_reference();
    double pressed = 0;
    for (const physics::WorldContact& c : stage->world->contacts()) {
      if (c.a.kind == physics::BodyKind::product && c.b.kind == physics::BodyKind::actor)
        pressed += c.normal_n;
    }
    EXPECT_NEAR(pressed, 2 * force, 0.05 * 2 * force);
  }
  EXPECT_LT(slid_under(70, 20), 1e-3);
  EXPECT_GT(slid_under(2, 20), 5e-3);  // until it meets the palm
}

// The tip is to go 2 cm under the floor: it presses as its spring does.
TEST(RobotActor, AnImpedanceYieldsLikeItsSpring) {
  const robots::Robot panda = committed_robot("panda");
  physics::RobotActorOptions options = ready_on_the_floor(panda);
  options.drive = physics::RobotDrive::torque;
  const auto stage = stage_of("panda", row_of_cans(1), options);
  const robots::JointGroup& arm = *panda.find_group("arm");
  robots::Impedance spring;
  spring.stiffness_n_m = 500;
  Pose goal = robots::frame_pose(panda, options.state, arm.tip);
  const auto go = [&](double z, int steps) {
    for (int i = 0; i < steps; ++i) {
      goal.position.z = std::max(goal.position.z - 0.0004, z);
      const std::vector<double> v = stage->actor.velocity(*stage->world);
      const Eigen::VectorXd efforts = robots::impedance_efforts(
          panda, arm.tip, arm.dofs, stage->q(), v, goal, options.state, spring);
      ASSERT_TRUE(stage->actor.apply(*stage->world, {efforts.data(), v.size()}).ok());
      run(*stage->world, 1);
    }
  };
  go(0.1, 3 * second);
  const Pose free = robots::frame_pose(panda, stage->q(), arm.tip);
  EXPECT_LT(length(free.position - goal.position), 2e-3);  // nothing in the way: it arrives
  go(-0.02, 4 * second);
  double pressed = 0;
  for (const physics::WorldContact& c : stage->world->contacts()) {
    if (c.a.kind == physics::BodyKind::room && c.b.kind == physics::BodyKind::actor)
      pressed += c.normal_n;
  }
  const double into = robots::frame_pose(panda, stage->q(), arm.tip).position.z + 0.02;
  EXPECT_GT(into, 0.015);
  EXPECT_NEAR(pressed, spring.stiffness_n_m * into, 0.2 * spring.stiffness_n_m * into);
}

TEST(RobotActor, BadCommandsAreErrorsThatSayWhy) {
  const robots::Robot panda = committed_robot("panda");
  const auto stage = stage_of("panda", row_of_cans(1), ready_on_the_floor(panda));
  physics::World& world = *stage->world;
  const std::string before = world.state_hash();
  std::vector<double> q = stage->options.state, v(q.size());
  const auto code = [](const Result<void>& r) { return r.ok() ? "ok" : r.error().code; };
  q[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code(stage->actor.command(world, q, v)), "physics.bad_command");
  q.pop_back();
  EXPECT_EQ(code(stage->actor.command(world, q, v)), "physics.bad_command");
  EXPECT_EQ(code(stage->actor.apply(world, v)), "physics.bad_command");
  const robots::Tool& hand = stage->robot.tools.at(0);
  EXPECT_EQ(code(stage->actor.grip(world, hand, {0.01, 0}, 1000)), "physics.bad_command");
  EXPECT_EQ(code(stage->actor.grip(world, hand, {0.01, 0}, -1)), "physics.bad_command");
  EXPECT_EQ(code(stage->actor.push_base(world, {})), "physics.bad_command");
  physics::RobotReference reference = stage->reference;
  reference.grips[0].opening_m = -1;
  EXPECT_EQ(code(stage->controller.command(world, reference)), "physics.bad_command");
  reference = stage->reference;
  reference.joints.pop_back();
  EXPECT_EQ(code(stage->controller.command(world, reference)), "physics.bad_command");
  EXPECT_EQ(world.state_hash(), before);
  EXPECT_EQ(physics::RobotActor::find(world, panda, "other/").error().code, "physics.bad_command");
  scene::Scene scene = row_of_cans(1).scene;
  physics::RobotActorOptions options;
  options.state = {1, 2};
  physics::WorldOptions bad;
  bad.add_actors = [&](mjSpec_& spec) { return physics::add_robot(spec, panda, options); };
  EXPECT_EQ(physics::World::create(scene, bad).error().code, "robot.bad_state");
  bad.add_actors = [&](mjSpec_& spec) {
    return physics::add_robot(spec, committed_robot("suction-cup"), {});
  };
  EXPECT_EQ(physics::World::create(scene, bad).error().code, "physics.bad_command");
}

}  // namespace
}  // namespace marketgen
