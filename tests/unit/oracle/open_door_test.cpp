// A robot opens the door of a cooler in physics; it stays open by itself; the robot shuts it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "episodes/aisle/aisle_world.h"
#include "motion/plan_drive.h"
#include "scene/fixture_stage.h"
#include "skills/door_moves.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

constexpr double shut_rad = 0.01;
constexpr std::uint32_t the_door = 1;  // the second of two, as most coolers of stores have them

// The robot of the aisles before a cooler that stands alone in a room.
class BeforeACooler {
 public:
  explicit BeforeACooler(const char* kind) {
    auto store = episodes::open_aisle_store(
        std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data",
        scene::stage_fixture(*committed_catalog().fixture_kind(kind), committed_catalog()).value());
    if (!store.ok()) fatal(to_string(store.error()).c_str());
    store_ = *store;
  }

  Result<skills::DoorQuestion> question() const {
    collect::GoodsNow now(store_->scene);
    if (world_) now.set_joints(world_->joint_positions());
    return store_->door_question(now, the_door);
  }

  const robots::Robot& robot() const { return store_->robot; }
  episodes::AisleWorld& world() { return *world_; }
  double door_rad() const { return world_->world().joint_position(the_door); }

  // The episode begins where the plan has the robot stand.
  Result<void> begin(const skills::DoorPlan& plan) {
    episodes::EpisodeSpec spec;
    spec.id = "aisle/door";
    spec.track = episodes::Track::aisle;
    spec.store = "cooler";
    spec.robot = store_->station.robot;
    spec.limit_s = 300;
    const Vec3 at = plan.world_from_base.position;
    spec.start = {at.x, at.y, heading(plan) * 180 / std::numbers::pi};
    world_ = std::make_unique<episodes::AisleWorld>(store_, committed_catalog().frictions);
    MARKETGEN_CHECK(world_->reset(spec));
    body_.emplace(store_->robot, episodes::commanded_dofs(store_->robot));
    body_->start(world_->observe());
    return {};
  }

  Result<void> drive_to(const skills::DoorPlan& plan) {
    const Vec3 from = episodes::axle_of(robot(), world_->world_from_base()),
               to = episodes::axle_of(robot(), plan.world_from_base);
    MARKETGEN_TRY(auto way,
                  motion::plan_drive(store_->ways,
                                     robot(),
                                     store_->driving,
                                     {{from.x, from.y}, world_->observe().base.heading},
                                     {{to.x, to.y}, heading(plan)}));
    body_->follow(std::move(way.follower));
    return {};
  }

  Result<void> move(const skills::DoorPlan& plan, double then_wait_s) {
    MARKETGEN_CHECK(skills::queue_door(*body_, robot(), plan));
    body_->wait(then_wait_s);
    agent::Observation now = world_->observe();
    while (!body_->idle() && !world_->done()) {
      MARKETGEN_TRY(now, world_->step(body_->next(now)));
    }
    return {};
  }

 private:
  static double heading(const skills::DoorPlan& plan) {
    return yaw_of(plan.world_from_base.rotation);
  }

  std::shared_ptr<const episodes::AisleStore> store_;
  std::unique_ptr<episodes::AisleWorld> world_;
  std::optional<skills::BodyExecutor> body_;
};

TEST(OpenDoor, OpensACoolerThatStaysOpenAndShutsIt) {
  BeforeACooler place("glass_door_cooler");
  const auto opening = place.question();
  ASSERT_TRUE(opening.ok()) << to_string(opening.error());
  const auto open = skills::plan_open_door(place.robot(), *opening, Seed(1));
  ASSERT_TRUE(open.ok()) << to_string(open.error());
  ASSERT_TRUE(place.begin(*open).ok());
  ASSERT_TRUE(place.move(*open, 3).ok());
  EXPECT_GT(place.door_rad(), opening->door.hold_rad - 0.07)
      << "and its friction, which is 3.6 degrees";
  EXPECT_EQ(place.world().controller().stops(), 0);

  const auto shutting = place.question();
  ASSERT_TRUE(shutting.ok());
  EXPECT_EQ(shutting->position_rad, place.door_rad());
  const auto shut = skills::plan_shut_door(place.robot(), *shutting, Seed(1));
  ASSERT_TRUE(shut.ok()) << to_string(shut.error());
  ASSERT_TRUE(place.drive_to(*shut).ok());
  ASSERT_TRUE(place.move(*shut, 6).ok());
  EXPECT_LT(std::abs(place.door_rad()), shut_rad);
  EXPECT_EQ(place.world().controller().stops(), 0);
  EXPECT_EQ(place.world().watch().effects().base_collisions, 0);
}

TEST(OpenDoor, ADoorThatDoesNotStayOpenIsNotOpened) {
  const BeforeACooler place("glass_door_cooler");
  auto question = place.question();
  ASSERT_TRUE(question.ok());
  question->door.hold_rad = 0;
  const auto plan = skills::plan_open_door(place.robot(), *question, Seed(1));
  ASSERT_FALSE(plan.ok());
  EXPECT_EQ(plan.error().code, "collect.no_door");
}

}  // namespace
}  // namespace marketgen
