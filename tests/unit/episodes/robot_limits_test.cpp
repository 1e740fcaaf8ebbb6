// Whatever a policy commands, robots keep to their rows in both tracks: read from MuJoCo's own
// state after every step of physics.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "base/seed.h"
#include "episodes/aisle/aisle_world.h"
#include "episodes/checkout/checkout_world.h"
#include "support/can_aisle.h"
#include "support/drawn_checkout.h"
#include "support/number_of_cases.h"

namespace marketgen {
namespace {

constexpr int window = 10;  // steps of physics over which an acceleration is measured
constexpr double step_s = 0.002;
// After the last contact of the robot with anything, and after a drive last gave all it has: it
// cannot keep an acceleration then.
constexpr double undisturbed_s = 0.25;
// What moves at its limit and is rammed goes faster than its drive; a base of 157 kg rams hard.
constexpr double max_pushed = 2.5, max_finger_pushed = 5;
// Of the row's acceleration. Joints: what a drive adds that had lagged and catches up. The base:
// its tyres give, and both arms that swing turn it beneath them.
constexpr double max_accelerated = 1.3, max_base_accelerated = 1.6, max_yaw_accelerated = 2.2;

std::size_t actions() {
  return number_of_cases("MARKETGEN_WILD_ACTIONS", 1000);
}

// The greatest of what a joint did, as a share of what its row allows.
struct Shares {
  double velocity = 0, pushed_velocity = 0, acceleration = 0, effort = 0;
};

class LimitWatch {
 public:
  explicit LimitWatch(const robots::Robot& robot) : robot_(robot), shares_(robot.dof_count()) {}

  void look(const mjModel& m, const mjData& d) {
    if (touched(m, d)) calm_from_s_ = d.time + undisturbed_s;
    std::vector<double> speeds, efforts;
    for (std::size_t dof = 0; dof < robot_.dof_count(); ++dof) {
      const robots::Joint& joint = robot_.joint_of_dof(dof);
      const int row = m.jnt_dofadr[mj_name2id(&m, mjOBJ_JOINT, joint.name.c_str())];
      speeds.push_back(d.qvel[row]);
      const bool finger = !std::isfinite(joint.acceleration);  // what they press with counts
      efforts.push_back(finger ? 0 : std::abs(d.qfrc_actuator[row] / joint.effort));
      const bool at_stop = !finger && d.qfrc_constraint[row] != 0;
      if (efforts.back() > 0.999 || at_stop) calm_from_s_ = d.time + undisturbed_s;
    }
    along_heading(m, d, speeds);
    calm_ = d.time >= calm_from_s_;
    for (std::size_t dof = 0; dof < robot_.dof_count(); ++dof) {
      Shares& share = shares_[dof];
      raise(calm_ ? share.velocity : share.pushed_velocity,
            speeds[dof] / robot_.joint_of_dof(dof).velocity);
      raise(share.effort, efforts[dof]);
    }
    speeds_.push_back(speeds);
    if (speeds_.size() > window) speeds_.pop_front();
    if (speeds_.size() < window || !calm_) return;
    ++calm_steps_;
    for (std::size_t dof = 0; dof < robot_.dof_count(); ++dof)
      raise(shares_[dof].acceleration,
            (speeds_.back()[dof] - speeds_.front()[dof]) / ((window - 1) * step_s) /
                robot_.joint_of_dof(dof).acceleration);
  }

  const std::vector<Shares>& shares() const { return shares_; }
  int calm_steps() const { return calm_steps_; }
  bool calm() const { return calm_; }  // now

 private:
  static void raise(double& greatest, double share) {
    greatest = std::max(greatest, std::abs(share));
  }
  // Anything presses on a body of the robot: all bodies under its first link.
  bool touched(const mjModel& m, const mjData& d) const {
    const int root = m.body_rootid[mj_name2id(&m, mjOBJ_BODY, robot_.links.front().name.c_str())];
    for (int c = 0; c < d.ncon; ++c) {
      if (d.contact[c].efc_address < 0) continue;
      for (const int geom : d.contact[c].geom)
        if (m.body_rootid[m.geom_bodyid[geom]] == root) return true;
    }
    return false;
  }

  // The base's speed ahead, and none across: turning changes the direction of both in the store.
  void along_heading(const mjModel& m, const mjData& d, std::vector<double>& speeds) const {
    if (!robot_.drive) return;
    const double heading = d.qpos[m.jnt_qposadr[mj_name2id(&m, mjOBJ_JOINT, "base_yaw")]];
    double& x = speeds[static_cast<std::size_t>(robot_.find_dof("base_x"))];
    double& y = speeds[static_cast<std::size_t>(robot_.find_dof("base_y"))];
    x = x * std::cos(heading) + y * std::sin(heading);
    y = 0;
  }

  const robots::Robot& robot_;
  std::vector<Shares> shares_;
  std::deque<std::vector<double>> speeds_;
  double calm_from_s_ = 0;
  int calm_steps_ = 0;
  bool calm_ = false;
};

double wild(Stream& draw, double low, double high) {
  const int kind = draw.integer(0, 3);
  if (kind == 0) return draw.uniform(-1e6, 1e6);
  if (kind == 1) return draw.chance(0.5) ? low : high;
  return draw.uniform(low, high);
}

// Held for some steps, or another every step: what jumps, and what runs into things.
class WildActions {
 public:
  WildActions(const robots::Robot& robot, Seed seed) : robot_(robot), draw_(seed.stream()) {}

  agent::Action next(const agent::Observation& now) {
    if (left_-- > 0) return action_;
    left_ = draw_.chance(0.3) ? draw_.integer(0, 29) : 0;
    action_ = episodes::still_action(now);
    std::size_t j = 0;
    for (const int dof : episodes::commanded_dofs(robot_)) {
      const robots::Joint& joint = robot_.joint_of_dof(static_cast<std::size_t>(dof));
      double& target = action_.position[j++];
      if (draw_.chance(0.7)) target = wild(draw_, joint.lower, joint.upper);
    }
    for (agent::ToolCommand& tool : action_.tools)
      tool = {draw_.chance(0.5) ? 0 : draw_.uniform(0, 1), draw_.uniform(0, 1000)};
    if (robot_.drive) {
      action_.drive_m_s = wild(draw_, -robot_.drive->speed, robot_.drive->speed);
      action_.turn_rad_s = wild(draw_, -robot_.drive->turn_rate, robot_.drive->turn_rate);
    }
    return action_;
  }

 private:
  const robots::Robot& robot_;
  Stream draw_;
  agent::Action action_;
  int left_ = 0;
};

void expect_within(const LimitWatch& watch, const robots::Robot& robot) {
  for (std::size_t dof = 0; dof < robot.dof_count(); ++dof) {
    const robots::Joint& joint = robot.joint_of_dof(dof);
    const Shares& share = watch.shares()[dof];
    const bool finger = !std::isfinite(joint.acceleration);
    EXPECT_LT(share.velocity, 1.05) << joint.name;
    EXPECT_LT(share.pushed_velocity, finger ? max_finger_pushed : max_pushed) << joint.name;
    EXPECT_LT(share.acceleration,
              joint.name == "base_yaw" ? max_yaw_accelerated
              : joint.name == "base_x" ? max_base_accelerated
                                       : max_accelerated)
        << joint.name;
    EXPECT_LT(share.effort, 1.0001) << joint.name;
  }
  EXPECT_GT(watch.calm_steps(), 1000) << "accelerations were hardly ever measured";
}

// What the drives are told never speeds up by more than the row's acceleration; undisturbed it
// neither brakes harder nor changes its acceleration by more than the row's jerk. To rounding.
class SetpointWatch {
 public:
  explicit SetpointWatch(const episodes::TrackWorld& world) : world_(world) {}

  void look(bool calm) {
    const std::vector<robots::Setpoint> now = world_.controller().setpoints();
    std::vector<double> accelerations;
    for (std::size_t dof = 0; dof < before_.size(); ++dof) {
      const robots::Joint& joint = world_.robot().joint_of_dof(dof);
      const double faster = std::abs(now[dof].velocity) - std::abs(before_[dof].velocity);
      speeding_up_ = std::max(speeding_up_, faster / (joint.acceleration * step_s));
      accelerations.push_back((now[dof].velocity - before_[dof].velocity) / step_s);
    }
    if (calm) compare(accelerations);
    before_ = now, accelerations_ = accelerations;
  }
  // As shares of what the rows allow.
  double speeding_up() const { return speeding_up_; }
  double acceleration() const { return acceleration_; }
  double jerk() const { return jerk_; }

 private:
  void compare(const std::vector<double>& accelerations) {
    for (std::size_t dof = 0; dof < accelerations_.size(); ++dof) {
      const robots::Joint& joint = world_.robot().joint_of_dof(dof);
      const double change = accelerations[dof] - accelerations_[dof];
      acceleration_ = std::max(acceleration_, std::abs(accelerations[dof]) / joint.acceleration);
      jerk_ = std::max(jerk_, std::abs(change) / (joint.jerk * step_s));
    }
  }

  const episodes::TrackWorld& world_;
  std::vector<robots::Setpoint> before_;
  std::vector<double> accelerations_;
  double speeding_up_ = 0, acceleration_ = 0, jerk_ = 0;
};

void act_wildly(episodes::TrackWorld& world, std::uint64_t seed) {
  LimitWatch watch(world.robot());
  SetpointWatch told(world);
  world.watch_physics([&](const mjModel& m, const mjData& d) {
    watch.look(m, d);
    told.look(watch.calm());
  });
  WildActions wild_actions(world.robot(), Seed(seed));
  for (std::size_t i = 0; i < actions(); ++i)
    ASSERT_TRUE(world.step(wild_actions.next(world.observe())).ok()) << i;
  world.watch_physics({});
  expect_within(watch, world.robot());
  EXPECT_LT(told.speeding_up(), 1.0001);
  EXPECT_LT(told.acceleration(), 1.0001);
  EXPECT_LT(told.jerk(), 1.0001);
  EXPECT_GT(world.controller().stops(), 0) << "nothing was ever met";
}

TEST(RobotLimits, HoldAtTheCounterWhateverIsCommanded) {
  auto made = episodes::CheckoutWorld::create(data_rows(), committed_catalog().frictions);
  ASSERT_TRUE(made.ok());
  episodes::CheckoutWorld& world = *made;
  episodes::EpisodeSpec spec = drawn(7, 0);
  spec.limit_s = 1e6;
  ASSERT_TRUE(world.reset(spec, checkout_goods_rows()).ok());
  act_wildly(world, 1);
}

TEST(RobotLimits, HoldInTheAisleWhateverIsCommanded) {
  episodes::EpisodeSpec spec = can_episode(*can_aisle());
  spec.limit_s = 1e6;
  const auto world = can_world(spec);
  act_wildly(*world, 2);
}

}  // namespace
}  // namespace marketgen
