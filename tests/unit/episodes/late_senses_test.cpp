// Pictures and readings that come late: by how much, of what moment, and that a moment of the
// episode goes on with what was on its way.
#include "episodes/late_senses.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>

#include "episodes/aisle/aisle_senses.h"
#include "episodes/checkout/checkout_senses.h"
#include "physics/goods/contact_shape.h"
#include "support/realistic_worlds.h"

namespace marketgen {
namespace {

episodes::Realism late_pictures(double seconds) {
  episodes::Realism realism;
  realism.latency.images = {seconds, seconds};
  return realism;
}

episodes::Realism late_readings(double seconds) {
  episodes::Realism realism;
  realism.latency.readings = {seconds, seconds};
  return realism;
}

int in_steps(double seconds) {
  return static_cast<int>(std::lround(seconds / physics::time_step_s));
}

agent::Action turning(const episodes::TrackWorld& world) {
  agent::Action action = episodes::still_action(world.observe());
  action.position = world.told();
  action.position[1] += 0.04;
  return action;
}

// Of less than a control step, one, and more of them: the arm as it stood exactly so long before,
// and at its beginning before that.
TEST(SlowLateSenses, PicturesAndReadingsAreOfTheirMoment) {
  for (const double seconds : {0.02, 0.05, 0.08, 0.15}) {
    const auto pictures = counter_at(late_pictures(seconds));
    const auto readings = counter_at(late_readings(seconds));
    std::vector<std::vector<double>> states{pictures->robot_state()};
    std::vector<double> first_joint{readings->observe().position[1]};
    pictures->watch_physics([&](const mjModel_&, const mjData_&) {
      states.push_back(pictures->robot_state());
      first_joint.push_back(
          states.back()[static_cast<std::size_t>(episodes::commanded_dofs(pictures->robot())[1])]);
    });
    for (int step = 1; step <= 8; ++step) {
      const agent::Action action = turning(*pictures);
      or_die(pictures->step(action));
      const agent::Observation told = or_die(readings->step(action));
      const int of = std::max(0, step * episodes::ControlStep::count() - in_steps(seconds));
      const episodes::Scenery shown = pictures->pictured();
      ASSERT_EQ(shown.robot, states[static_cast<std::size_t>(of)]) << seconds << " s, " << step;
      EXPECT_NEAR(shown.time_s, of * physics::time_step_s, 1e-9);
      ASSERT_EQ(told.position[1], first_joint[static_cast<std::size_t>(of)]) << seconds;
      EXPECT_EQ(told.time_s, readings->time_s()) << "the robot's clock is of now";
    }
    EXPECT_NE(states.front(), states.back()) << "it does turn";
    EXPECT_EQ(pictures->observe().position[1], first_joint.back())
        << "readings have their own dial";
    EXPECT_EQ(readings->state_hash(), pictures->state_hash()) << "the world is as it is";
  }
}

TEST(LateSenses, WithNoDialOnAllIsOfNow) {
  const auto world = counter_at({});
  or_die(world->step(turning(*world)));
  EXPECT_EQ(world->pictured().time_s, world->time_s());
  EXPECT_EQ(world->pictured().robot, world->robot_state());
}

// The picture itself is the one that would have been taken a control step earlier, from where the
// camera was; the agent is told when that was.
TEST(LateSenses, TheEyesAreShownWhatTheyWouldHaveSeen) {
  const auto late = counter_at(late_pictures(0.05)), prompt = counter_at({});
  episodes::CheckoutEyes late_eyes(*late), prompt_eyes(*prompt);
  for (int step = 0; step < 4; ++step)
    or_die(late->step(turning(*late)));
  for (int step = 0; step < 3; ++step)
    or_die(prompt->step(turning(*prompt)));
  for (const char* camera : {"scene_camera", "wrist_camera"}) {
    const agent::View seen = or_die(late_eyes.look(camera));
    const agent::View was = or_die(prompt_eyes.look(camera));
    EXPECT_EQ(seen.color.pixels, was.color.pixels);
    EXPECT_EQ(seen.depth_m, was.depth_m);
    EXPECT_EQ(seen.base_from_camera.position, was.base_from_camera.position);
    EXPECT_NEAR(seen.time_s, 0.15, 1e-9);
    EXPECT_EQ(seen.time_s, was.time_s);
  }
}

// In the aisles the base has driven on meanwhile: the camera is told where the head was in its
// base's frame of then.
TEST(LateSenses, AHeadThatDrivesSeesWhereItWas) {
  const auto late = can_world_at(late_pictures(0.1)), prompt = can_world_at({});
  const auto ahead = [](const episodes::AisleWorld& world) {
    agent::Action action = episodes::still_action(world.observe());
    action.drive_m_s = 0.3;
    return action;
  };
  for (int step = 0; step < 10; ++step)
    or_die(late->step(ahead(*late)));
  for (int step = 0; step < 8; ++step)
    or_die(prompt->step(ahead(*prompt)));
  EXPECT_GT(late->world_from_base().position.x, prompt->world_from_base().position.x + 0.01);
  episodes::AisleEyes late_eyes(*late), prompt_eyes(*prompt);
  const agent::View seen = or_die(late_eyes.look("head_camera"));
  const agent::View was = or_die(prompt_eyes.look("head_camera"));
  EXPECT_EQ(seen.color.pixels, was.color.pixels);
  EXPECT_EQ(seen.base_from_camera.position, was.base_from_camera.position);
  EXPECT_NEAR(seen.time_s, 0.4, 1e-9);
}

// A vacuum sensor tells of a change later than the rest; once an episode the rest is drawn.
TEST(LateSenses, AVacuumSensorIsSlow) {
  episodes::Realism realism;
  realism.tools.vacuum_s = 0.1;
  agent::Observation now;
  now.position = {0};
  now.sealed = {0};
  episodes::LateSenses senses(realism, Seed(1), now, {});
  const auto control_step = [&] {
    for (int i = 1; i <= episodes::ControlStep::count(); ++i)
      senses.pass(
          i, [&] { return now; }, [] { return episodes::Scenery(); });
    return senses.told(now);
  };
  control_step();
  now.sealed = {1};
  now.position = {2};
  EXPECT_EQ(control_step().sealed[0], 0);
  EXPECT_EQ(senses.told(now).position[0], 2) << "joints are not slow";
  EXPECT_EQ(control_step().sealed[0], 0);
  EXPECT_EQ(control_step().sealed[0], 1);
}

TEST(LateSenses, IsDrawnOnceAnEpisodeEvenly) {
  double low = 1, high = 0, sum = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const double late =
        episodes::drawn_lateness({0.03, 0.08}, Seed(seed).stream()) * physics::time_step_s;
    low = std::min(low, late), high = std::max(high, late), sum += late;
  }
  EXPECT_GE(low, 0.03 - 1e-9);
  EXPECT_LE(high, 0.08 + 1e-9);
  EXPECT_LT(low, 0.032);
  EXPECT_GT(high, 0.078);
  EXPECT_NEAR(sum / 400, 0.055, 0.003);
}

// In another world, from a moment in which pictures and readings were on their way.
TEST(LateSenses, AMomentGoesOnWithWhatWasOnItsWay) {
  const episodes::Realism hard = realism_row("hard");
  const auto one = counter_at(hard), two = counter_at(hard);
  const agent::Action action = turning(*one);
  for (int step = 0; step < 3; ++step)
    or_die(one->step(action));
  ASSERT_TRUE(two->restore(one->save()).ok());
  ASSERT_LT(one->pictured().time_s, one->time_s());
  for (int step = 0; step < 6; ++step) {
    EXPECT_EQ(two->pictured().robot, one->pictured().robot) << step;
    EXPECT_EQ(two->pictured().time_s, one->pictured().time_s);
    const agent::Observation a = or_die(one->step(action)), b = or_die(two->step(action));
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.velocity, b.velocity);
    EXPECT_EQ(a.openings_m, b.openings_m);
  }
  EXPECT_EQ(one->state_hash(), two->state_hash());
}

// One whose readings are prompt takes up a moment of one whose readings are late, and the other way
// round: as rehearsals do.
TEST(LateSenses, ATwinHasALatenessOfItsOwn) {
  const auto late = counter_at(late_readings(0.1)), prompt = counter_at({});
  for (int step = 0; step < 4; ++step) {
    or_die(late->step(turning(*late)));
    or_die(prompt->step(turning(*prompt)));
  }
  const std::string of_late = late->save(), of_prompt = prompt->save();
  ASSERT_TRUE(prompt->restore(of_late).ok());
  EXPECT_EQ(prompt->observe().time_s, prompt->time_s());
  const auto twin = or_die(late->twin());
  ASSERT_TRUE(twin->restore(of_prompt).ok());
  const double now = twin->observe().position[1];
  for (int step = 0; step < 4; ++step)
    or_die(twin->step(turning(*twin)));
  EXPECT_GT(twin->observe().position[1], now);
  EXPECT_LT(
      twin->observe().position[1],
      twin->robot_state()[static_cast<std::size_t>(episodes::commanded_dofs(twin->robot())[1])])
      << "late again";
}

}  // namespace
}  // namespace marketgen
