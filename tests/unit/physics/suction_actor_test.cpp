// A Panda with a suction cup over goods that stand on a shelf: on what it seals, what it carries,
// what is too much, and the same again.
#include "physics/world/suction_actor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/committed_catalog.h"
#include "support/committed_robot.h"
#include "unit/physics/small_worlds.h"

namespace marketgen {
namespace {

constexpr float front_y = HandMadeScene::shelf_y_m - 0.15F;
constexpr std::array<float, 4> upright{1, 0, 0, 0};
constexpr std::array<float, 4> lying{0.70710678F, 0.70710678F, 0, 0};  // its axis along -Y
constexpr std::uint32_t wide_can = 3, heavy_box = 4;

// What stands there, where its highest point is, and how far the lip is over that.
struct Goods {
  std::uint32_t sku = cereal;
  std::array<float, 4> rotation = upright;
  double high_m = 0.28;
  double apart_m = 0.001, beside_m = 0;
};

struct CupStage {
  scene::Scene scene;
  robots::Robot robot;
  physics::RobotActorOptions options;
  std::unique_ptr<physics::World> world;
  physics::RobotActor actor;
  physics::SuctionActor cups;

  const robots::Tool& cup() const { return robot.tools.at(0); }
  auto sealed() const { return cups.sealed_product(*world, cup()); }
  Pose lip() const {
    return options.world_from_base * robots::frame_pose(robot, actor.position(*world), cup().frame);
  }
  void suck(bool on) { ASSERT_TRUE(cups.suck(*world, cup(), on).ok()); }
  void hold(int steps) {
    ASSERT_TRUE(actor.command(*world, options.state, std::vector<double>(7)).ok());
    run(*world, steps);
  }
  // By some centimetres, with the elbow.
  void lift() {
    const double low = options.state[3];
    for (int i = 1; i <= second; ++i) {
      options.state[3] = low + 0.1 * i / second;
      hold(1);
    }
  }
  // Turns its first joint there and back.
  void sway(double angle_rad, double seconds) {
    const int steps = static_cast<int>(seconds * second);
    for (int i = 1; i <= steps; ++i) {
      const double turn = 2 * std::numbers::pi * i / steps;
      std::vector<double> q = options.state, v(q.size());
      q[0] += angle_rad * (1 - std::cos(turn)) / 2;
      v[0] = angle_rad * std::numbers::pi / seconds * std::sin(turn);
      ASSERT_TRUE(actor.command(*world, q, v).ok());
      run(*world, 1);
    }
  }
};

std::unique_ptr<CupStage> cup_over(const Goods& goods) {
  auto stage = std::make_unique<CupStage>();
  HandMadeScene shop;
  shop.scene.catalog.push_back(hand_made_product("can-wide", "can", {140, 140, 120}, 0.4));
  shop.scene.catalog.push_back(hand_made_product("box-heavy", "box", {190, 60, 280}, 3));
  const auto half = static_cast<float>(goods.high_m / 2);
  shop.add(goods.sku, {3, front_y, upper + (goods.rotation == lying ? half : 0)}, goods.rotation);
  stage->scene = shop.scene;
  stage->robot = committed_robot("panda", {{"tool", "suction-cup"}});
  stage->options.state = robots::with_posture(*stage->robot.find_posture("ready"),
                                              robots::neutral_state(stage->robot));
  const Quaternion north = rotation_about({0, 0, 1}, std::numbers::pi / 2);
  const Vec3 tip =
      robots::frame_pose(stage->robot, stage->options.state, stage->cup().frame).position;
  const double middle_y = front_y - (goods.rotation == lying ? 0.05 : 0);
  const Vec3 over{3 + goods.beside_m, middle_y, upper + goods.high_m + goods.apart_m};
  stage->options.world_from_base = {over - rotate(north, tip), north};
  physics::WorldOptions options;
  options.frictions = committed_catalog().frictions;
  options.cups = physics::robot_cups(stage->robot, stage->options);
  options.add_actors = [s = stage.get()](mjSpec_& spec) {
    return physics::add_robot(spec, s->robot, s->options);
  };
  stage->world = std::make_unique<physics::World>(made(stage->scene, std::move(options)));
  stage->actor = physics::RobotActor::find(*stage->world, stage->robot).value();
  stage->cups = physics::SuctionActor::find(*stage->world, stage->robot).value();
  return stage;
}

bool seals_on(const Goods& goods) {
  const auto stage = cup_over(goods);
  stage->suck(true);
  stage->hold(5);
  return stage->sealed().has_value();
}

TEST(SuctionActor, TheLipLooksStraightDown) {
  const auto stage = cup_over({});
  EXPECT_NEAR(rotate(stage->lip().rotation, {0, 0, 1}).z, -1, 1e-9);
  EXPECT_NEAR(stage->lip().position.z, upper + 0.281, 1e-6);
}

TEST(SuctionActor, SealsOnWhatIsEvenAndNear) {
  EXPECT_TRUE(seals_on({}));
  EXPECT_TRUE(seals_on({.apart_m = 0.0035}));
  EXPECT_TRUE(seals_on({.apart_m = -0.0035})) << "its bellows give way";
  EXPECT_FALSE(seals_on({.apart_m = 0.006}));
  EXPECT_FALSE(seals_on({.beside_m = 0.085})) << "over the edge";
  // 17.5 mm from the middle a can of 140 mm is 2.2 mm lower, one of 66 mm 5 mm.
  EXPECT_TRUE(seals_on({.sku = wide_can, .rotation = lying, .high_m = 0.14}));
  EXPECT_FALSE(seals_on({.sku = can, .rotation = lying, .high_m = 0.066}));
}

TEST(SuctionActor, NothingIsSealedOrWokenWhileItIsOff) {
  const auto stage = cup_over({});
  stage->hold(second / 10);
  EXPECT_FALSE(stage->sealed().has_value());
  EXPECT_FALSE(stage->world->awake(0)) << "the lip itself touches nothing";
  EXPECT_FALSE(stage->cups.sucks(*stage->world, stage->cup()));
}

// Lifted off the shelf, swayed by 20 cm and held for ten seconds.
TEST(SuctionActor, CarriesWhatItHolds) {
  const auto stage = cup_over({});
  stage->suck(true);
  stage->hold(5);
  ASSERT_EQ(stage->sealed(), 0U);
  const Pose held = inverse(stage->lip()) * stage->world->product_pose(0);
  const double stood = stage->world->product_pose(0).position.z;
  stage->lift();
  EXPECT_GT(stage->world->product_pose(0).position.z, stood + 0.02);
  stage->sway(0.4, 4);
  stage->hold(10 * second);
  ASSERT_EQ(stage->sealed(), 0U);
  EXPECT_TRUE(stage->world->awake(0)) << "however long it hangs still";
  EXPECT_LT(distance(inverse(stage->lip()) * stage->world->product_pose(0), held), 0.002);
  stage->suck(false);
  stage->hold(second);
  EXPECT_FALSE(stage->sealed().has_value());
  EXPECT_LT(stage->world->product_pose(0).position.z, stood + 0.01);
}

// It pulls with 25 N, and with a third of that at each of three points. Lifted, the box hangs askew
// by 6 degrees, its middle 14 mm beside the lip's: with 3 N more the highest point bears 6.4 N.
TEST(SuctionActor, BreaksWhenItIsOverloaded) {
  const auto holds = [](const physics::Wrench& wrench) {
    const auto stage = cup_over({});
    stage->suck(true);
    stage->hold(5);
    stage->lift();
    EXPECT_EQ(stage->sealed(), 0U);
    for (int i = 0; i < second / 5; ++i) {
      EXPECT_TRUE(stage->world->push(0, wrench).ok());
      stage->hold(1);
    }
    return stage->sealed().has_value();
  };
  EXPECT_TRUE(holds({{0, 0, -3}, {}}));
  EXPECT_FALSE(holds({{0, 0, -40}, {}})) << "pulled off";
  EXPECT_FALSE(holds({{0, 40, 0}, {}})) << "slid off";
  EXPECT_FALSE(holds({{0, 0, -3}, {0, 1.5, 0}})) << "peeled off";
}

TEST(SuctionActor, ABrokenSealStaysBrokenUntilItIsToldAgain) {
  const auto stage = cup_over({.sku = heavy_box});
  stage->suck(true);
  stage->hold(5);
  ASSERT_EQ(stage->sealed(), 0U) << "on the shelf it has nothing to bear";
  for (int i = 0; i < 20 && stage->sealed(); ++i) {
    ASSERT_TRUE(stage->world->push(0, {{60, 0, 0}, {}}).ok());
    stage->hold(1);
  }
  EXPECT_FALSE(stage->sealed().has_value());
  stage->hold(second / 5);
  EXPECT_FALSE(stage->sealed().has_value());
  EXPECT_TRUE(stage->cups.sucks(*stage->world, stage->cup()));
  stage->suck(false);
  stage->suck(true);
  stage->hold(5);
  EXPECT_TRUE(stage->sealed().has_value());
}

TEST(SuctionActor, WhatIsTooHeavyStaysOnTheShelf) {
  const auto stage = cup_over({.sku = heavy_box});
  stage->suck(true);
  stage->hold(5);
  ASSERT_EQ(stage->sealed(), 0U);
  stage->lift();
  EXPECT_FALSE(stage->sealed().has_value());
  EXPECT_NEAR(stage->world->product_pose(0).position.z, upper, 0.005);
}

TEST(SuctionActor, RepeatsBitForBitAndGoesOnFromASnapshot) {
  const auto stage = cup_over({}), other = cup_over({});
  stage->suck(true);
  stage->hold(5);
  const std::string hash_sealed = stage->world->state_hash();
  stage->sway(0.2, 1);
  const physics::WorldSnapshot swaying = stage->world->snapshot();
  stage->sway(0.3, 1);
  ASSERT_EQ(stage->sealed(), 0U);
  const std::string end = stage->world->state_hash();

  const auto as_bytes = physics::WorldSnapshot::of_bytes(swaying.bytes());
  ASSERT_TRUE(as_bytes.ok());
  ASSERT_TRUE(other->world->restore(*as_bytes).ok());
  EXPECT_EQ(other->sealed(), 0U);
  other->sway(0.3, 1);
  EXPECT_EQ(other->world->state_hash(), end);

  const auto again = cup_over({});
  ASSERT_TRUE(physics::replay(*again->world, stage->world->commands()).ok());
  EXPECT_EQ(again->world->state_hash(), end);

  // Back to before it was sealed, and on without.
  const auto fresh = cup_over({});
  const physics::WorldSnapshot start = fresh->world->snapshot();
  fresh->hold(5);
  const std::string unsealed = fresh->world->state_hash();
  EXPECT_NE(unsealed, hash_sealed);
  ASSERT_TRUE(stage->world->restore(start).ok());
  EXPECT_FALSE(stage->sealed().has_value());
  stage->hold(5);
  EXPECT_EQ(stage->world->state_hash(), unsealed);
}

TEST(SuctionActor, APlacedProductIsLetGo) {
  const auto stage = cup_over({});
  stage->suck(true);
  stage->hold(5);
  ASSERT_EQ(stage->sealed(), 0U);
  ASSERT_TRUE(stage->world->place(0, {{1, 1, 0}, {}}).ok());
  EXPECT_FALSE(stage->sealed().has_value());
  stage->hold(second);
  EXPECT_LT(length(stage->world->product_pose(0).position - Vec3{1, 1, 0}), 0.005);
}

TEST(SuctionActor, BadCommandsAreErrors) {
  const auto stage = cup_over({});
  const robots::Robot hand = committed_robot("panda");
  const auto code = [](const auto& r) { return r.ok() ? std::string("ok") : r.error().code; };
  const std::string before = stage->world->state_hash();
  robots::Tool gripper = hand.tools.at(0);
  gripper.prefix = "other";
  EXPECT_EQ(code(stage->cups.suck(*stage->world, gripper, true)), "physics.bad_command");
  EXPECT_EQ(code(stage->world->suck(7, true)), "physics.bad_command");
  EXPECT_EQ(stage->world->state_hash(), before);
  EXPECT_EQ(code(physics::SuctionActor::find(*stage->world, stage->robot, "none/")),
            "physics.bad_command");
  const auto with_cups = [&](physics::WorldCup cup) {
    physics::WorldOptions options;
    options.cups = {std::move(cup)};
    return code(physics::World::create(stage->scene, std::move(options)));
  };
  EXPECT_EQ(with_cups({"nowhere", {}, 0.01, 0.001, 20}), "physics.bad_command");
  EXPECT_EQ(with_cups({"pool-0", {}, -1, 0.001, 20}), "physics.bad_command");
}

}  // namespace
}  // namespace marketgen
