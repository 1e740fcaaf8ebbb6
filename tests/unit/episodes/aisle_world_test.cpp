// The robot in a small shop: it drives as told, refuses what is no action, repeats bit for bit, and
// what it did is judged.
#include "episodes/aisle/aisle_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "episodes/aisle/aisle_view.h"
#include "render/picture_objects.h"
#include "support/can_aisle.h"

namespace marketgen {
namespace {

episodes::EpisodeSpec cans() {
  return can_episode(*can_aisle());
}

void drive(episodes::AisleWorld& world, double speed, double turn, int steps) {
  for (int i = 0; i < steps; ++i) {
    agent::Action action = episodes::still_action(world.observe());
    action.drive_m_s = speed, action.turn_rad_s = turn;
    const auto stepped = world.step(action);
    ASSERT_TRUE(stepped.ok()) << to_string(stepped.error());
  }
}

TEST(AisleWorld, TheBaseGoesWhereItIsDriven) {
  const auto world = can_world(cans());
  const agent::Observation first = world->observe();
  EXPECT_NEAR(first.base.x_m, 2.0, 1e-6);
  EXPECT_NEAR(first.base.y_m, 1.6, 1e-6);
  ASSERT_EQ(first.position.size(), 17U);  // lift, head, two arms of seven
  ASSERT_EQ(first.openings_m.size(), 2U);
  drive(*world, 0.4, 0, 20);
  drive(*world, 0, 0, 10);
  const agent::Observation ahead = world->observe();
  EXPECT_NEAR(ahead.base.x_m, 2.4, 0.01);
  EXPECT_NEAR(ahead.base.y_m, 1.6, 0.005);
  EXPECT_NEAR(world->path_m(), 0.4, 0.01);
  drive(*world, 0, 0.8, 20);
  drive(*world, 0, 0, 10);
  EXPECT_NEAR(world->observe().base.heading, 0.8, 0.02);
  EXPECT_NEAR(world->path_m(), 0.4, 0.02) << "it turns about the middle between its wheels";
}

TEST(AisleWorld, RepeatsBitForBit) {
  const auto once = can_world(cans()), again = can_world(cans());
  for (const auto* world : {&once, &again})
    drive(**world, 0.3, 0.2, 12);
  EXPECT_EQ(once->state_hash(), again->state_hash());
  drive(*again, 0.3, 0.2, 1);
  EXPECT_NE(once->state_hash(), again->state_hash());
}

TEST(AisleWorld, WhatIsNoActionIsRefused) {
  const auto world = can_world(cans());
  const std::string before = world->state_hash();
  const agent::Action still = episodes::still_action(world->observe());
  agent::Action nan = still, few = still, no_tool = still;
  nan.drive_m_s = std::numeric_limits<double>::quiet_NaN();
  few.position.pop_back();
  no_tool.tools.clear();
  for (const agent::Action& action : {nan, few, no_tool}) {
    const auto refused = world->step(action);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, "episode.bad_action");
  }
  EXPECT_EQ(world->state_hash(), before);
  agent::Action stop = still;
  stop.stop = true;
  ASSERT_TRUE(world->step(stop).ok());
  EXPECT_TRUE(world->done());
  EXPECT_EQ(world->step(still).error().code, "episode.bad_action");
}

TEST(AisleWorld, NothingFetchedIsNothingReached) {
  const auto world = can_world(cans());
  drive(*world, 0.2, 0, 10);
  const auto result = world->finish();
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_EQ(result->success_partial, 0);
  EXPECT_FALSE(result->success_strict);
  EXPECT_EQ(result->spl, 0);
  EXPECT_GT(result->shortest_m, 0.3);
  EXPECT_GT(result->path_m, 0.05);
  EXPECT_EQ(result->side_effects.dropped + result->side_effects.toppled, 0);
}

TEST(AisleWorld, DrivingIntoAShelfIsACollision) {
  episodes::EpisodeSpec spec = cans();
  spec.start = {3.0, 2.2, 90};
  const auto world = can_world(spec);
  drive(*world, 0.5, 0, 60);
  const auto result = world->finish();
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_GE(result->side_effects.base_collisions, 1);
  EXPECT_GE(result->side_effects.hard_contacts, 1);
}

// Its wheels go on when it stands in front of a shelf that it rams with a corner, and then it is
// not where it thinks.
TEST(AisleWorld, RammingAShelfTurnsTheReckoning) {
  episodes::EpisodeSpec spec = cans();
  spec.start = {3.0, 2.2, 75};
  const auto world = can_world(spec);
  const double from_m = length(world->world_from_base().position -
                               Vec3{world->observe().base.x_m, world->observe().base.y_m, 0});
  EXPECT_LT(from_m, 1e-9);
  drive(*world, 0.5, 0, 80);
  const robots::BasePlace reckoned = world->observe().base;
  const Vec3 off = world->world_from_base().position - Vec3{reckoned.x_m, reckoned.y_m, 0};
  EXPECT_GT(length(off), 0.2);
}

// Where the row would have it the camera stands in a shelf, or behind a wall.
TEST(AisleWorld, TheFilmsCameraSeesTheRobot) {
  for (const double heading_deg : {-90, 0, 90, 180}) {
    episodes::EpisodeSpec spec = cans();
    spec.start = {3.0, 2.2, heading_deg};
    const auto world = can_world(spec);
    const auto view = episodes::AisleView::create(*world);
    ASSERT_TRUE(view.ok()) << to_string(view.error());
    const auto camera = (*view)->camera(episodes::film_camera_name, 64, 48);
    ASSERT_TRUE(camera.ok()) << to_string(camera.error());
    const auto frame = (*view)->renderer().render(*camera, {});
    ASSERT_TRUE(frame.ok()) << to_string(frame.error());
    const auto robot = render::first_actor_object(world->store().scene);
    EXPECT_GT(std::ranges::count(frame->instance, robot), 64 * 48 / 20) << heading_deg;
  }
}

TEST(AisleWorld, UnknownGoalsAndRobotsAreErrors) {
  const auto store = can_aisle();
  episodes::AisleWorld world(store, committed_catalog().frictions);
  episodes::EpisodeSpec other = can_episode(*store);
  other.goals = {{"can-coal", 1}};
  EXPECT_EQ(world.reset(other).error().code, "catalog.unknown_sku");
  other = can_episode(*store);
  other.robot = "panda";
  EXPECT_EQ(world.reset(other).error().code, "robot.unknown");
}

TEST(ShortestTour, GoesPastOnePlaceOfEachGoal) {
  const auto store = can_aisle();
  const auto one = episodes::shortest_tour_m(*store, {2000, 1600}, {"can-cola"});
  ASSERT_TRUE(one.has_value());
  const auto places = store->standing_places("can-cola");
  ASSERT_FALSE(places.empty());
  double nearest = 1e9;
  for (const PointMm& place : places)
    nearest = std::min(nearest, std::hypot(place[0] - 2000, place[1] - 1600) * 1e-3);
  EXPECT_GE(*one, nearest - 1e-6);
  EXPECT_LT(*one, nearest + 0.5);
  EXPECT_EQ(episodes::shortest_tour_m(*store, {2000, 1600}, {}).value(), 0);
  EXPECT_FALSE(episodes::shortest_tour_m(*store, {2000, 1600}, {"fruit-apple"}).has_value());
}

}  // namespace
}  // namespace marketgen
