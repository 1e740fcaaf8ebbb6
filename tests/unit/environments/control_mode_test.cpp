// Modes of tools: the tool goes where the numbers say whatever its fingers do, and where it cannot
// go it comes as near as it can and says by how much it was cut.
#include "environments/control_mode.h"

#include <gtest/gtest.h>

#include <cmath>

#include "environments/environment.h"
#include "support/committed_robot.h"

namespace marketgen {
namespace {

std::vector<double> posed(const robots::Robot& robot, const char* posture) {
  return robots::with_followers(
      robot, robots::with_posture(*robot.find_posture(posture), robots::neutral_state(robot)));
}

std::vector<double> commanded(const robots::Robot& robot, const std::vector<double>& state) {
  std::vector<double> position;
  for (const int dof : episodes::commanded_dofs(robot))
    position.push_back(state[static_cast<std::size_t>(dof)]);
  return position;
}

// The state with the joints where an action sends them.
std::vector<double> sent(const robots::Robot& robot,
                         std::vector<double> state,
                         const agent::Action& action) {
  const std::vector<int> dofs = episodes::commanded_dofs(robot);
  for (std::size_t j = 0; j < dofs.size(); ++j)
    state[static_cast<std::size_t>(dofs[j])] = action.position[j];
  return state;
}

struct Sent {
  Pose from, to;  // of the first tool
  environments::ToolCut cut;
};

Sent sent_by(const environments::ActionMap& map,
             const robots::Robot& robot,
             const std::vector<double>& state,
             std::vector<double> move) {
  move.resize(map.numbers().size(), 0.0);
  const auto mapped = map.action(move, state, commanded(robot, state));
  if (!mapped.ok()) {
    ADD_FAILURE() << to_string(mapped.error());
    return {};
  }
  return {map.tool_poses(state).front(),
          map.tool_poses(sent(robot, state, mapped->action)).front(),
          mapped->cuts.at(0)};
}

TEST(ControlMode, FingersThatPressOnOneAnotherDoNotHoldTheArm) {
  for (const char* name : {"panda", "realman-rm75"}) {
    const robots::Robot robot = committed_robot(name);
    const environments::ActionMap map(robot, environments::ControlMode::pd_ee_delta_pos);
    std::vector<double> state = posed(robot, robot.postures.front().name.c_str());
    const Sent open = sent_by(map, robot, state, {-0.5, 0, 0.5});
    for (const robots::JointGroup& group : robot.groups) {
      if (!group.name.ends_with("fingers")) continue;
      for (const int dof : group.dofs)
        state[static_cast<std::size_t>(dof)] =
            robot.joint_of_dof(static_cast<std::size_t>(dof)).lower - 1e-3;
    }
    const Sent shut = sent_by(map, robot, state, {-0.5, 0, 0.5});
    EXPECT_NEAR(length(open.to.position - open.from.position), 0.02 * std::sqrt(0.5), 1e-4) << name;
    EXPECT_NEAR(length(shut.to.position - open.to.position), 0, 1e-9) << name;
    EXPECT_EQ(shut.cut.off_m, 0) << name;
  }
}

// Pushed outward for 3 m, the arm ends stretched, not where it began; on its way there nothing is
// cut, at the end nearly the whole of each step is.
TEST(ControlMode, OutOfReachTheToolComesNearAndSaysSo) {
  const robots::Robot robot = committed_robot("panda");
  const environments::ActionMap map(robot, environments::ControlMode::pd_ee_delta_pos);
  std::vector<double> state = posed(robot, robot.postures.front().name.c_str());
  const double begun = map.tool_poses(state).front().position.x;
  EXPECT_EQ(sent_by(map, robot, state, {1, 0, 0}).cut.off_m, 0);
  Sent last;
  for (int step = 0; step < 150; ++step) {
    std::vector<double> move(map.numbers().size(), 0.0);
    move[0] = 1;
    last = sent_by(map, robot, state, move);
    const Vec3 wanted = last.from.position + Vec3{0.02, 0, 0};
    ASSERT_NEAR(last.cut.off_m, length(last.to.position - wanted), 2e-5) << step;
    const auto mapped = map.action(move, state, commanded(robot, state));
    ASSERT_TRUE(mapped.ok());
    state = sent(robot, state, mapped->action);
    ASSERT_TRUE(robots::within_limits(robot, state)) << step;
  }
  EXPECT_GT(last.to.position.x, begun + 0.15);
  EXPECT_GT(last.cut.off_m, 0.015);
  // Back it goes at once.
  EXPECT_LT(sent_by(map, robot, state, {-1, 0, 0}).to.position.x, last.to.position.x - 0.015);
}

TEST(ControlMode, AStateThatIsNoneIsAnErrorAndNoStandstill) {
  const robots::Robot robot = committed_robot("panda");
  const environments::ActionMap map(robot, environments::ControlMode::pd_ee_delta_pose);
  std::vector<double> state = posed(robot, robot.postures.front().name.c_str());
  const std::vector<double> target = commanded(robot, state);
  state[2] = std::nan("");
  const auto mapped = map.action(std::vector<double>(map.numbers().size(), 0.0), state, target);
  ASSERT_FALSE(mapped.ok());
  EXPECT_EQ(mapped.error().code, "robot.bad_state");
}

// In the worlds themselves: a second of shutting on nothing (or of staying open), then half a
// second up. Both tools of the aisles' robot.
class ShutOnNothing : public testing::TestWithParam<episodes::Track> {
 protected:
  struct Trip {
    double up_m = 0, min_finger_m = 1, cut_m = 0;
  };

  static Result<std::unique_ptr<environments::Environment>> environment() {
    environments::EnvironmentOptions options;
    options.control = environments::ControlMode::pd_ee_delta_pos;
    MARKETGEN_TRY(auto ground, environments::EpisodeGround::of_pool(GetParam()));
    MARKETGEN_TRY(auto made, environments::Environment::create(ground, GetParam(), options));
    MARKETGEN_TRY(const episodes::EpisodeSpec spec, ground->draw(GetParam(), 3));
    MARKETGEN_CHECK(made->reset(spec));
    return made;
  }

  static std::vector<double> action(const environments::Environment& of,
                                    double opening,
                                    double up) {
    std::vector<double> action;
    for (const environments::ActionNumber& number : of.action_numbers()) {
      if (number.name.ends_with("opening"))
        action.push_back(opening);
      else if (number.name.ends_with("tool_z"))
        action.push_back(up);
      else
        action.push_back(number.name == "stop" ? -1 : 0);
    }
    return action;
  }

  static Pose tool(const environments::Environment& of) {
    const robots::Robot& robot = of.world().robot();
    return robots::frame_pose(robot, of.world().robot_state(), robot.tools.front().frame);
  }

  // Error: of the environment.
  static Result<Trip> trip(double opening) {
    MARKETGEN_TRY(const auto made, environment());
    for (int step = 0; step < 20; ++step)
      MARKETGEN_CHECK(made->step(action(*made, opening, 0)));
    Trip trip;
    const robots::Robot& robot = made->world().robot();
    for (const robots::JointGroup& group : robot.groups)
      for (const int dof : group.name.ends_with("fingers") ? group.dofs : std::vector<int>{})
        trip.min_finger_m =
            std::min(trip.min_finger_m, made->world().robot_state()[static_cast<std::size_t>(dof)]);
    const double before = tool(*made).position.z;
    for (int step = 0; step < 10; ++step) {
      MARKETGEN_CHECK(made->step(action(*made, opening, 0.5)));
      for (const environments::ToolCut& cut : made->tool_cuts())
        trip.cut_m = std::max(trip.cut_m, cut.off_m);
    }
    trip.up_m = tool(*made).position.z - before;
    return trip;
  }
};

TEST_P(ShutOnNothing, TheToolMovesAsWithAnOpenHand) {
  const auto open = trip(1), shut = trip(-1);
  ASSERT_TRUE(open.ok()) << to_string(open.error());
  ASSERT_TRUE(shut.ok()) << to_string(shut.error());
  EXPECT_LT(shut->min_finger_m, 1e-4);
  EXPECT_GT(open->min_finger_m, 0.01);
  EXPECT_GT(open->up_m, 0.03);
  EXPECT_NEAR(shut->up_m, open->up_m, 1e-3);
  EXPECT_NEAR(shut->cut_m, open->cut_m, 1e-3);  // in the aisles the arm ends stretched, either way
}

INSTANTIATE_TEST_SUITE_P(OfEachTrack,
                         ShutOnNothing,
                         testing::Values(episodes::Track::checkout, episodes::Track::aisle),
                         [](const auto& track) { return std::string(name_of(track.param)); });

}  // namespace
}  // namespace marketgen
