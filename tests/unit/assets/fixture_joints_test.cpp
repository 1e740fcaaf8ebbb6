// How parts of fixtures move: the frames of joints, how pieces are hung on one another, and what
// every generator's joints promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "assets/fixtures/joints.h"
#include "fixture_table.h"

namespace marketgen {
namespace {

assets::FixtureModel cube_at(double x_mm) {
  assets::FixtureModel model;
  assets::add(model,
              assets::box(assets::UnitKind::door, {}, {{x_mm, x_mm + 10}, {0, 10}, {0, 10}}));
  return model;
}

TEST(Joints, AFramesAxisIsItsZ) {
  for (const Vec3& axis : {assets::x_axis,
                           assets::y_axis,
                           assets::z_axis,
                           -assets::x_axis,
                           -assets::y_axis,
                           -assets::z_axis,
                           Vec3{0.6, 0, -0.8}}) {
    const Pose frame = assets::joint_frame({100, 200, 300}, axis);
    EXPECT_EQ(frame.position, (Vec3{0.1, 0.2, 0.3}));
    const Vec3 z = rotate(frame.rotation, {0, 0, 1});
    EXPECT_NEAR(z.x, axis.x, 1e-12);
    EXPECT_NEAR(z.y, axis.y, 1e-12);
    EXPECT_NEAR(z.z, axis.z, 1e-12);
  }
}

TEST(Joints, APieceOnAPieceIsCarriedByIt) {
  assets::FixtureModel fork = cube_at(0);
  assets::hang(fork, assets::wheel_at("wheel", {0, 0, 0}, assets::y_axis, 0.2), cube_at(20));
  assets::FixtureModel cart = cube_at(100);
  assets::hang(cart, assets::caster_at("caster", {0, 0, 0}, 0.5), std::move(fork));

  assets::FixtureModel model;
  assets::hang(model, assets::slide_along("drawer", {0, 0, 0}, -assets::y_axis, 300), cube_at(200));
  assets::append(model, std::move(cart));
  ASSERT_EQ(model.joints.size(), 3U);
  EXPECT_EQ(model.joints[0].name, "drawer");
  EXPECT_EQ(model.joints[1].name, "caster");
  EXPECT_EQ(model.joints[2].name, "wheel");
  EXPECT_EQ(model.joints[0].parent, -1);
  EXPECT_EQ(model.joints[1].parent, -1);
  EXPECT_EQ(model.joints[2].parent, 1);
  ASSERT_EQ(model.parts.size(), 4U);
  const int joints[] = {0, -1, 1, 2};  // drawer, cart, fork, wheel
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(model.parts[i].joint, joints[i]) << i;
}

TEST(Joints, TheBackSideTurnsWithItsParts) {
  assets::FixtureModel model;
  assets::hang(model, assets::hinge_at("lid", {100, -200, 0}, assets::x_axis, 1), cube_at(0));
  model = assets::as_back_side(std::move(model));
  const assets::FixtureJoint& joint = model.joints.front();
  EXPECT_EQ(joint.name, "back-lid");
  EXPECT_NEAR(joint.fixture_from_joint.position.x, -0.1, 1e-12);
  EXPECT_NEAR(joint.fixture_from_joint.position.y, 0.2, 1e-12);
  EXPECT_NEAR(rotate(joint.fixture_from_joint.rotation, {0, 0, 1}).x, -1, 1e-12);
}

TEST(Joints, SpringsOfDoorsArePreloaded) {
  const assets::FixtureJoint door =
      assets::self_closing(assets::hinge_at("door", {0, 0, 0}, assets::z_axis, 1.6), 2, 1.4);
  EXPECT_GT(door.stiffness * (0 - door.spring_rest), door.friction);  // it pulls the closed door
  EXPECT_EQ(door.hold_open, 1.4);
  assets::FixtureJoint both_ways = assets::hinge_at("leaf", {0, 0, 0}, assets::z_axis, 1.5);
  both_ways.lower = -1.5;
  EXPECT_EQ(assets::self_closing(both_ways, 2, 0).spring_rest, 0);
}

void expect_sound(const assets::FixtureModel& model, std::size_t row) {
  const assets::FixtureJoint& joint = model.joints[row];
  SCOPED_TRACE(joint.name);
  EXPECT_LT(joint.parent, static_cast<int>(row));
  EXPECT_GT(joint.mass_kg, 0);
  EXPECT_GE(joint.friction, 0);
  EXPECT_GE(joint.damping, 0);
  EXPECT_GE(joint.stiffness, 0);
  EXPECT_LT(joint.lower, joint.upper);
  EXPECT_LE(joint.lower, 0);
  EXPECT_LE(joint.hold_open, joint.upper);
  ASSERT_FALSE(joint.states.empty());
  EXPECT_EQ(joint.states.front().position, 0);
  for (const assets::JointState& state : joint.states) {
    EXPECT_GE(state.position, joint.lower) << state.name;
    EXPECT_LE(state.position, joint.upper) << state.name;
  }
  EXPECT_TRUE(std::ranges::any_of(model.parts, [&](const assets::FixturePart& part) {
    return part.joint == static_cast<int>(row);
  })) << "moves nothing";
}

void expect_sound(const assets::FixtureModel& model) {
  std::set<std::string> names;
  for (std::size_t row = 0; row < model.joints.size(); ++row) {
    EXPECT_TRUE(names.insert(model.joints[row].name).second) << model.joints[row].name;
    expect_sound(model, row);
  }
  for (const assets::FixturePart& part : model.parts)
    EXPECT_LT(part.joint, static_cast<int>(model.joints.size()));
}

TEST(Joints, OfEveryTableRowAreSound) {
  const catalog::Catalog catalog = small_catalog();
  for (const assets::FixtureShape& shape : table()) {
    SCOPED_TRACE(text_of(shape));
    expect_sound(made(shape, catalog));
  }
}

TEST(Joints, GeneratorsWhoseRealThingMovesHaveThem) {
  const std::set<std::string> moving{"glass_door_cooler",
                                     "chest_freezer",
                                     "island_freezer",
                                     "checkout_lane",
                                     "self_checkout",
                                     "kiosk",
                                     "basket_stack",
                                     "trolley_bay",
                                     "coffee_machine",
                                     "gate"};
  const catalog::Catalog catalog = small_catalog();
  for (const assets::FixtureShape& shape : table()) {
    if (moving.contains(shape.generator)) {
      EXPECT_FALSE(made(shape, catalog).joints.empty()) << text_of(shape);
    }
  }
}

TEST(Joints, ACoolersDoorsOpenToTheFront) {
  const assets::FixtureModel model =
      made(shape_of("glass_door_cooler", 1250, 710, 2200, 5, 250, 350, 1), small_catalog());
  ASSERT_EQ(model.joints.size(), 2U);
  const assets::FixtureJoint& first = model.joints[0];
  EXPECT_EQ(first.name, "door-1");
  EXPECT_NEAR(first.fixture_from_joint.position.x, -0.625 + 0.002, 1e-9);  // its left edge
  EXPECT_NEAR(rotate(first.fixture_from_joint.rotation, {0, 0, 1}).z, -1, 1e-12);
  EXPECT_NEAR(first.upper, assets::radians(95), 1e-12);
  EXPECT_GT(first.hold_open, assets::radians(80));
  EXPECT_GT(first.stiffness, 0);
  EXPECT_NEAR(
      first.gasket * first.gasket_reach, assets::gasket_n * assets::gasket_gap_mm * 1e-3, 1e-12);
  EXPECT_NEAR(first.gasket, assets::gasket_n * (0.625 - 0.004 - 0.0225), 1e-9);
  int on_first = 0;
  for (const assets::FixturePart& part : model.parts)
    on_first += part.joint == 0 ? 1 : 0;
  EXPECT_EQ(on_first, 8);  // four stiles, a pane, a bar on two brackets
}

}  // namespace
}  // namespace marketgen
