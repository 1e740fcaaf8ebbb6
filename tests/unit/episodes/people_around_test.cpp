// People who walk about where a robot works: they never meet, stop before the robot and step back
// from it, go on when it has gone, and are there for its scanner, its cameras and its ledger.
#include "episodes/aisle/people_around.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "episodes/aisle/aisle_view.h"
#include "episodes/aisle/aisle_world.h"
#include "layout/layout.h"
#include "render/picture_objects.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

using episodes::FloorDisc;
using episodes::PeopleAround;

constexpr double dt = 0.05;

scene::Scene riverside_scene() {
  const std::string file = "tests/fixtures/plans/riverside.json";
  std::ifstream stream(std::filesystem::path(MARKETGEN_SOURCE_DIR) / file);
  std::stringstream text;
  text << stream.rdbuf();
  const plan::Plan plan = plan::read_plan(text.str(), file, committed_catalog()).value();
  const layout::Layout laid = layout::make_layout(plan, committed_catalog(), Seed(7)).value();
  return scene::build_scene(laid, plan, committed_catalog(), Seed(7)).value();
}

std::shared_ptr<const episodes::AisleStore> riverside() {
  static const std::shared_ptr<const episodes::AisleStore> store = [] {
    auto opened = episodes::open_aisle_store(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data",
                                             riverside_scene());
    if (!opened.ok()) fatal(to_string(opened.error()).c_str());
    return std::move(opened).value();
  }();
  return store;
}

PeopleAround people_of(int count, Vec2 robot = {-9, -9}) {
  auto made = PeopleAround::make(riverside()->scene, count, Seed(3), robot);
  if (!made.ok()) fatal(to_string(made.error()).c_str());
  return std::move(made).value();
}

Vec2 place_of(const PeopleAround& people, std::size_t i) {
  const Vec3 at = people.store_from_person(i).position;
  return {at.x, at.y};
}

double apart(Vec2 a, Vec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

double least_apart(const PeopleAround& people) {
  double least = 1e9;
  for (std::size_t i = 0; i < people.count(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      least = std::min(least, apart(place_of(people, i), place_of(people, j)));
  return least;
}

constexpr double bodies_m = 2 * episodes::person_radius_m;

TEST(PeopleAround, WithoutARobotEverybodyKeepsTime) {
  PeopleAround people = people_of(8);
  ASSERT_GE(people.count(), 6U);
  for (int step = 0; step < 2400; ++step)
    people.pass(dt, {});
  for (const double clock : people.clocks())
    EXPECT_NEAR(clock, 120, 1e-6);
}

// The robot stands where each of them is to come by, one after another.
TEST(PeopleAround, WhomTheRobotHoldsUpMeetsNobody) {
  PeopleAround people = people_of(8);
  const PeopleAround first = people;
  double least = 1e9;
  for (std::size_t i = 0; i < people.count(); ++i) {
    const Vec3 ahead = first.at(i, people.clocks()[i] + 20).world_from_person.position;
    const std::vector<FloorDisc> robot{{{ahead.x, ahead.y}, 0.4}};
    for (int step = 0; step < 1200; ++step) {
      people.pass(dt, robot);
      least = std::min(least, least_apart(people));
    }
  }
  EXPECT_GT(least, bodies_m);
  const std::vector<double> held_up = people.clocks();
  EXPECT_LT(*std::ranges::min_element(held_up), 60.0 * static_cast<double>(people.count()) - 5);
  for (int step = 0; step < 6000; ++step) {
    people.pass(dt, {});
    least = std::min(least, least_apart(people));
  }
  EXPECT_GT(least, bodies_m);
  for (std::size_t i = 0; i < people.count(); ++i)
    EXPECT_GT(people.clocks()[i], held_up[i] + 60) << i << " goes on when the robot has gone";
}

TEST(PeopleAround, StopBeforeTheRobotAndStepBack) {
  PeopleAround people = people_of(1);
  ASSERT_EQ(people.count(), 1U);
  const PeopleAround first = people;
  double walks_s = 0;  // in the middle of a way
  while (walks_s < collect::round_s) {
    people.pass(dt, {});
    walks_s = people.clocks()[0];
    if (people.speed_m_s(0) > 0.3) break;
  }
  const Vec3 ahead = first.at(0, walks_s + 2).world_from_person.position;
  const std::vector<FloorDisc> robot{{{ahead.x, ahead.y}, 0.3}};
  double nearest = 1e9, farthest_back = 1e9;
  for (int step = 0; step < 400; ++step) {
    people.pass(dt, robot);
    nearest = std::min(nearest,
                       apart(place_of(people, 0), robot[0].at) - 0.3 - episodes::person_radius_m);
    farthest_back = std::min(farthest_back, people.clocks()[0]);
  }
  EXPECT_GT(nearest, episodes::stop_before_robot_m - 0.08) << "a step of 0.07 m at most";
  EXPECT_LT(farthest_back, walks_s) << "back to where they stood";
  for (int step = 0; step < 400; ++step)
    people.pass(dt, {});
  EXPECT_GT(people.clocks()[0], walks_s + 2);
}

TEST(PeopleAround, NobodyBeginsAtTheRobot) {
  const PeopleAround all = people_of(8);
  const Vec2 robot = place_of(all, 0);
  const PeopleAround others = people_of(8, robot);
  EXPECT_LT(others.count(), all.count());
  for (std::size_t i = 0; i < others.count(); ++i)
    EXPECT_GT(apart(place_of(others, i), robot), 1.5);
}

TEST(PeopleAround, AMomentGoesOnAsItWas) {
  PeopleAround people = people_of(5);
  const std::vector<FloorDisc> robot{{place_of(people, 1), 0.5}};
  for (int step = 0; step < 150; ++step)
    people.pass(dt, robot);
  ByteWriter writer;
  writer(people);
  PeopleAround again = people_of(5);
  const std::string moment = writer.take();
  ByteReader reader(moment);
  reader(again);
  ASSERT_TRUE(reader.ok());
  for (int step = 0; step < 300; ++step)
    people.pass(dt, robot), again.pass(dt, robot);
  EXPECT_EQ(people.clocks(), again.clocks());
}

// ---- In a world. ----

episodes::EpisodeSpec riverside_task() {
  const episodes::AisleStore& store = *riverside();
  episodes::EpisodeSpec spec;
  spec.id = "aisle/people";
  spec.track = episodes::Track::aisle;
  spec.robot = store.station.robot;
  for (std::uint32_t row = 0; spec.goals.empty(); ++row)
    if (store.shelf_refusal(row) == episodes::ShelfRefusal::none)
      spec.goals = {{store.scene.catalog[store.scene.products[row].sku].sku, 1}};
  const PointMm at = *store.standing_places(spec.goals[0].sku).begin();
  spec.start.x_m = at[0] * 1e-3, spec.start.y_m = at[1] * 1e-3;
  spec.limit_s = 200;
  spec.seed = 11;
  return spec;
}

std::unique_ptr<episodes::AisleWorld> riverside_world(int people) {
  auto world = std::make_unique<episodes::AisleWorld>(riverside(), committed_catalog().frictions);
  episodes::Realism realism;
  if (people > 0) realism.people = episodes::PeopleDials{people};
  const auto reset = world->reset(riverside_task(), {}, realism);
  if (!reset.ok()) fatal(to_string(reset.error()).c_str());
  return world;
}

// Of the nearest person, in the frame of the base; true, not scanned.
Vec3 nearest_person(const episodes::AisleWorld& world) {
  Vec3 nearest{1e9, 0, 0};
  for (std::size_t i = 0; i < world.people().count(); ++i) {
    const Vec3 at = inverse(world.world_from_base()) * world.people().store_from_person(i).position;
    if (length(at) < length(nearest)) nearest = at;
  }
  return nearest;
}

void go(episodes::AisleWorld& world, double drive, double turn) {
  agent::Action action = episodes::still_action(world.observe());
  action.drive_m_s = drive, action.turn_rad_s = turn;
  const auto stepped = world.step(action);
  ASSERT_TRUE(stepped.ok()) << to_string(stepped.error());
}

TEST(PeopleInWorld, OneWhoStandsStillIsNotTouched) {
  const auto world = riverside_world(8);
  ASSERT_GE(world->people().count(), 4U);
  for (int step = 0; step < 300; ++step)
    go(*world, 0, 0);
  const episodes::SideEffects effects = world->side_effects();
  EXPECT_EQ(effects.person_contacts, 0);
  EXPECT_EQ(effects.person_near_s, 0.0);
  EXPECT_GT(effects.person_distance_m.value(), episodes::near_person_m);
  EXPECT_EQ(effects.hard_contacts, 0);
}

// Straight at whoever is nearest, whatever is in between.
TEST(PeopleInWorld, WhoDrivesAtPeopleIsFoundOut) {
  const auto world = riverside_world(8);
  for (int step = 0; step < 1200 && world->side_effects().person_contacts == 0; ++step) {
    const Vec3 there = nearest_person(*world);
    const double bearing = std::atan2(there.y, there.x);
    go(*world, std::abs(bearing) < 0.5 ? 0.8 : 0.0, std::clamp(3 * bearing, -1.0, 1.0));
  }
  const auto result = world->finish();
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_GE(result->side_effects.person_contacts, 1);
  EXPECT_GT(result->side_effects.person_near_s.value(), 0.1);
  EXPECT_LT(result->side_effects.person_distance_m.value(), 0.02);
  EXPECT_FALSE(is_clean(result->side_effects));
}

TEST(PeopleInWorld, TheScannerAndTheCameraSeeWhoIsThere) {
  const auto world = riverside_world(8);
  for (int step = 0; step < 1200 && world->observe().people.empty(); ++step)
    go(*world, 0, 0);
  ASSERT_FALSE(world->observe().people.empty());
  const auto view = episodes::AisleView::create(*world);
  ASSERT_TRUE(view.ok()) << to_string(view.error());
  const Vec2 at = world->observe().people[0].position;
  EXPECT_LT(std::hypot(at.x, at.y), 4.5);
  const Vec2 before = at * (1 - 1.5 / std::hypot(at.x, at.y));
  render::Camera camera;
  camera.name = "test";
  camera.width = 96, camera.height = 72;
  camera.from = world->world_from_base() * Vec3{before.x, before.y, 1.3};
  camera.at = world->world_from_base() * Vec3{at.x, at.y, 1.0};
  const auto frame = (*view)->renderer().render(camera, {});
  ASSERT_TRUE(frame.ok()) << to_string(frame.error());
  const auto first_person = render::first_actor_object(world->store().scene) + 1;
  EXPECT_GT(std::ranges::count_if(frame->instance,
                                  [&](std::uint32_t object) { return object >= first_person; }),
            96 * 72 / 20);
}

TEST(PeopleInWorld, MomentsRepeatAndWithoutPeopleNothingIsSaid) {
  const auto once = riverside_world(8), again = riverside_world(8), alone = riverside_world(0);
  for (int step = 0; step < 60; ++step)
    go(*once, 0.1, 0.1);
  ASSERT_TRUE(again->restore(once->save()).ok());
  for (int step = 0; step < 60; ++step)
    go(*once, 0.1, 0), go(*again, 0.1, 0);
  EXPECT_EQ(once->state_hash(), again->state_hash());
  EXPECT_EQ(once->people().clocks(), again->people().clocks());
  EXPECT_EQ(once->side_effects().person_distance_m, again->side_effects().person_distance_m);
  EXPECT_EQ(alone->people().count(), 0U);
  EXPECT_FALSE(alone->side_effects().person_contacts.has_value());
}

}  // namespace
}  // namespace marketgen
