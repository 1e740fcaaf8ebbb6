// People who walk about where a robot works: they never meet, stop before the robot, make room for
// it, wait where they cannot, and are there for its scanner, its cameras and its ledger.
#include "episodes/aisle/people_around.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "collect/drive_graph.h"
#include "collect/store_people.h"
#include "episodes/aisle/aisle_view.h"
#include "episodes/aisle/aisle_world.h"
#include "episodes/episode_end.h"
#include "render/picture_objects.h"
#include "support/committed_catalog.h"
#include "unit/episodes/riverside_people.h"

namespace marketgen {
namespace {

using episodes::FloorDisc;
using episodes::PeopleAround;
using people_test::apart;
using people_test::bodies_m;
using people_test::dt;
using people_test::gap_to;
using people_test::min_apart;
using people_test::people_of;
using people_test::riverside;

TEST(PeopleAround, AreAsManyAsTheFloorHas) {
  const scene::Scene& scene = riverside()->scene;
  const double free_m2 = collect::free_floor_m2(scene, 2.0);
  const double whole_m2 = area_m2(plan::floor_of(scene.layout.shell));
  EXPECT_GT(free_m2, 0.3 * whole_m2);
  EXPECT_LT(free_m2, whole_m2);
  for (const double per_m2 : {0.0, 0.02, 0.05}) {
    const auto people = PeopleAround::make(scene, per_m2, Seed(1), {-9, -9});
    ASSERT_TRUE(people.ok());
    EXPECT_EQ(people->count(), static_cast<std::size_t>(per_m2 * free_m2));
  }
  EXPECT_EQ(PeopleAround::make(scene, 0.9 / free_m2, Seed(1), {-9, -9})->count(), 0U)
      << "a small shop has nobody";
}

TEST(PeopleAround, WalkFromShelfToShelfAndMeetNobody) {
  for (const std::uint64_t seed : {3U, 4U, 5U}) {
    PeopleAround people = people_of(8, {-9, -9}, seed);
    ASSERT_GE(people.count(), 6U);
    double least = 1e9, fastest = 0;
    for (int step = 0; step < 6000; ++step) {
      people.pass(dt, {});
      least = std::min(least, min_apart(people));
      for (std::size_t i = 0; i < people.count(); ++i)
        fastest = std::max(fastest, people.speed_m_s(i));
    }
    EXPECT_GT(least, bodies_m);
    EXPECT_LT(fastest, collect::max_walk_m_s * 1.1);
    EXPECT_GT(fastest, collect::min_walk_m_s);
    for (std::size_t i = 0; i < people.count(); ++i)
      EXPECT_GE(people.walks(i), 3) << i << " of seed " << seed << " in five minutes";
  }
}

TEST(PeopleAround, NeverJumpNorWalkThroughFixtures) {
  PeopleAround people = people_of(8);
  const auto floor =
      collect::drive_graph(riverside()->scene, {0.45, 2.0}, {}, 0).value();  // corners are cut
  std::vector<Pose> before;
  for (std::size_t i = 0; i < people.count(); ++i)
    before.push_back(people.store_from_person(i));
  for (int step = 0; step < 4000; ++step) {
    people.pass(dt, {});
    for (std::size_t i = 0; i < people.count(); ++i) {
      const Pose now = people.store_from_person(i);
      ASSERT_LT(length(now.position - before[i].position), dt * 1.4 * 1.1) << i;
      ASSERT_TRUE(floor.space().free(floor_mm(now.position))) << i;
      before[i] = now;
    }
  }
}

// Feet, too: where one stands it stays, also of who is stopped on the way.
TEST(PeopleAround, BodiesAreStillWhereTheyStop) {
  PeopleAround people = people_of(4);
  std::vector<FloorDisc> robot;
  std::vector<assets::PlacedPerson> before(people.count());
  for (int step = 0; step < 3000; ++step) {
    if (step % 600 == 200) robot = {{people.place(0) + Vec2{1.5, 0.3}, 0.3}};
    if (step % 600 == 500) robot.clear();
    people.pass(dt, robot);
    const auto moments = people.moments();
    for (std::size_t i = 0; i < people.count(); ++i) {
      const assets::PlacedPerson now = people.at(i, moments[i]);
      for (std::size_t foot = 0; foot < 2 && step > 0; ++foot) {
        const Vec3 was = before[i].world_from_person * before[i].pose.feet[foot].ball;
        const Vec3 is = now.world_from_person * now.pose.feet[foot].ball;
        ASSERT_LT(length(is - was), 0.30) << i << " at " << step * dt << " s";
      }
      before[i] = now;
    }
  }
}

// The robot stands where each of them is, a little off, one after another.
TEST(PeopleAround, MakeRoomForARobotThatStandsBeforeThem) {
  PeopleAround people = people_of(6);
  for (std::size_t i = 0; i < people.count(); ++i) {
    const Pose pose = people.store_from_person(i);
    const Vec3 behind = pose * Vec3{-1.0, 0, 0};  // in the aisle
    const std::vector<FloorDisc> robot{{{behind.x, behind.y}, 0.3}};
    double least = 1e9, nearest = 1e9;
    bool has_left = false;
    for (int step = 0; step < 600; ++step) {
      people.pass(dt, robot);
      least = std::min(least, min_apart(people));
      has_left = has_left || gap_to(robot[0], people.place(i)) > 1.0;
      for (std::size_t j = 0; j < people.count(); ++j)
        nearest = std::min(nearest, gap_to(robot[0], people.place(j)));
    }
    EXPECT_TRUE(has_left) << i;
    EXPECT_GT(least, bodies_m);
    EXPECT_GT(nearest, 0.3);
  }
}

// In a walk of somebody alone, so long before they come to where the robot is put.
std::optional<PeopleAround> who_walks(std::uint64_t seed, FloorDisc& robot) {
  PeopleAround people = people_of(1, {-9, -9}, seed);
  while (people.speed_m_s(0) < 0.5)
    people.pass(dt, {});
  PeopleAround later = people;
  for (int step = 0; step < 70; ++step)
    later.pass(dt, {});
  robot = {later.place(0), 0.3};
  if (gap_to(robot, people.place(0)) < 2) return {};
  return people;
}

TEST(PeopleAround, ComeToStandBeforeARobotInTheirWayAndGoElsewhere) {
  int found = 0;
  for (std::uint64_t seed = 1; seed < 12; ++seed) {
    FloorDisc robot;
    auto people = who_walks(seed, robot);
    if (!people) continue;
    ++found;
    double nearest = 1e9;
    for (int step = 0; step < 1200; ++step) {
      people->pass(dt, std::span(&robot, 1));
      nearest = std::min(nearest, gap_to(robot, people->place(0)));
    }
    EXPECT_GT(nearest, episodes::stop_before_robot_m - 0.07) << seed;
    EXPECT_GE(people->walks(0), 2) << seed;
  }
  EXPECT_GE(found, 2);
}

// A corner shut by the robot: whoever is in it waits, and gets out when the robot has gone.
TEST(PeopleAround, WhoIsShutInWaitsAndThenGetsOut) {
  PeopleAround people = people_of(1);
  const Vec2 at = people.place(0);
  std::vector<FloorDisc> ring;  // all about them, a metre and a half away
  for (int i = 0; i < 16; ++i)
    ring.push_back({at + Vec2{std::cos(i * 0.3927), std::sin(i * 0.3927)} * 1.6, 0.4});
  for (int step = 0; step < 1200; ++step)
    people.pass(dt, ring);
  EXPECT_LT(apart(people.place(0), at), 1.0);
  const int walks = people.walks(0);
  for (int step = 0; step < 1200; ++step)
    people.pass(dt, {});
  EXPECT_GT(people.walks(0), walks);
  EXPECT_GT(apart(people.place(0), at), 0.5);
}

TEST(PeopleAround, NobodyBeginsAtTheRobot) {
  const Vec2 robot = people_of(8).place(0);
  const PeopleAround others = people_of(8, robot);
  ASSERT_GT(others.count(), 0U);
  for (std::size_t i = 0; i < others.count(); ++i)
    EXPECT_GT(apart(others.place(i), robot), 1.5);
}

TEST(PeopleAround, AMomentGoesOnAsItWas) {
  PeopleAround people = people_of(5);
  const std::vector<FloorDisc> robot{{people.place(1) + Vec2{1, 0}, 0.4}};
  for (int step = 0; step < 450; ++step)
    people.pass(dt, robot);
  ByteWriter writer;
  writer(people);
  PeopleAround again = people_of(5);
  const std::string moment = writer.take();
  ByteReader reader(moment);
  reader(again);
  ASSERT_TRUE(reader.ok());
  for (int step = 0; step < 900; ++step)
    people.pass(dt, robot), again.pass(dt, robot);
  EXPECT_EQ(people.moments(), again.moments());
  EXPECT_NE(people.moments(), people_of(5).moments());
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
  if (people > 0)
    realism.people =
        episodes::PeopleDials{(people + 0.5) / collect::free_floor_m2(riverside()->scene, 2.0)};
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
  EXPECT_EQ(effects.person_hardest_n, 0.0);
  EXPECT_GT(effects.person_distance_m.value(), 0.3);
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
  EXPECT_GT(result->side_effects.person_hardest_n.value(), episodes::max_person_n);
  EXPECT_TRUE(result->is_void) << "somebody was hurt";
  EXPECT_EQ(episodes::failure_of(*result, {}), episodes::FailureCode::collision);
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
  EXPECT_EQ(once->people().moments(), again->people().moments());
  EXPECT_EQ(once->side_effects().person_distance_m, again->side_effects().person_distance_m);
  EXPECT_EQ(alone->people().count(), 0U);
  EXPECT_FALSE(alone->side_effects().person_contacts.has_value());
}

}  // namespace
}  // namespace marketgen
