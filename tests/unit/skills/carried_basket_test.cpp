// How low something can be let down into a basket in which other things lie.
#include "skills/carried_basket.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace marketgen {
namespace {

constexpr double bottle_radius = 0.035, can_radius = 0.033, can_half_height = 0.06;

assets::ProductBody cylinder(double radius, double half_length) {
  const auto r = static_cast<float>(radius);
  return {
      {{assets::PieceShape::cylinder, {}, {r, r, static_cast<float>(half_length)}}}, {}, {}, {}};
}

// 0.40 x 0.30 m, turned a quarter and on a deck of the robot.
skills::CarriedBasket basket() {
  const Pose floor{{0.1, -0.05, 0.5}, rotation_about({0, 0, 1}, std::numbers::pi / 2)};
  return {floor, {0.40, 0.30, 0.22}, {}};
}

// Over the basket's floor, lying, its axis `turn` from X.
skills::CarriedItem lying_bottle(double turn) {
  const Quaternion lying =
      rotation_about({0, 0, 1}, turn) * rotation_about({0, 1, 0}, std::numbers::pi / 2);
  return {cylinder(bottle_radius, 0.12).pieces,
          basket().base_from_floor * Pose{{0, 0, bottle_radius}, lying}};
}

TEST(CarriedBasket, AnEmptyOneIsMetAtItsFloor) {
  const skills::Underside can(cylinder(can_radius, can_half_height), {});
  EXPECT_NEAR(can.box().half.z, can_half_height, 1e-6);
  EXPECT_EQ(skills::BasketFill(basket(), {}).rest_m(can, 0.1, 0.1), 0);
}

TEST(CarriedBasket, ABoxIsMetAtItsTop) {
  const skills::CarriedItem box =
      skills::carried_box({basket().base_from_floor * Vec3{0.1, 0, 0.03}, {0.1, 0.1, 0.03}});
  const skills::BasketFill fill(basket(), {box});
  const skills::Underside can(cylinder(can_radius, can_half_height), {});
  EXPECT_NEAR(fill.rest_m(can, 0.1, 0), 0.06, 1e-6);
  EXPECT_EQ(fill.rest_m(can, -0.1, 0), 0);
  EXPECT_NEAR(skills::box_of(box).half_size.z, 0.03, 1e-6);
}

// Sides that overlap by less than a column count, whichever side it is.
TEST(CarriedBasket, WhatOverlapsALittleIsMet) {
  skills::CarriedBasket narrow = basket();
  narrow.size.x = 0.28;
  const assets::ProductBody box{
      {{assets::PieceShape::box, {}, {0.0324F, 0.03F, 0.05F}}}, {}, {}, {}};
  const skills::Underside held(box, {});
  for (const double side : {-1.0, 1.0}) {
    const Vec3 middle{side * 0.0526, 0, 0.04};  // its near face at 2.6 mm
    const skills::CarriedItem lies{{{assets::PieceShape::box, {}, {0.05F, 0.05F, 0.04F}}},
                                   narrow.base_from_floor * Pose{middle, {}}};
    const skills::BasketFill fill(narrow, {lies});
    for (double apart = -0.0045; apart < 0; apart += 0.0005)
      EXPECT_NEAR(fill.rest_m(held, side * (0.0026 - 0.0324 - apart), 0.01), 0.08, 1e-6) << apart;
    EXPECT_EQ(fill.rest_m(held, side * (0.0026 - 0.0324 - 0.016), 0.01), 0);
  }
}

// In the corners of the box round a bottle that lies askew there is room down to the floor.
TEST(CarriedBasket, BesideABottleThatLiesAskewThereIsRoom) {
  const skills::BasketFill fill(basket(), {lying_bottle(std::numbers::pi / 4)});
  const skills::Underside can(cylinder(can_radius, can_half_height), {});
  EXPECT_NEAR(fill.rest_m(can, 0, 0), 2 * bottle_radius, 0.002);
  EXPECT_NEAR(fill.rest_m(can, 0.05, 0.05), 2 * bottle_radius, 0.002);
  EXPECT_EQ(fill.rest_m(can, 0.065, -0.065), 0);
}

// Its round underside finds its way down beside the top of what lies there.
TEST(CarriedBasket, WhatIsRoundComesLowerBesideATop) {
  const skills::BasketFill fill(basket(), {lying_bottle(0)});
  const Quaternion along = rotation_about({0, 1, 0}, std::numbers::pi / 2);
  const skills::Underside rod(cylinder(can_radius, can_half_height), along);
  const double apart = 0.05, reach = bottle_radius + can_radius;
  const double touching = bottle_radius + std::sqrt(reach * reach - apart * apart) - can_radius;
  EXPECT_NEAR(fill.rest_m(rod, 0, apart), touching, 0.012);
  EXPECT_GE(fill.rest_m(rod, 0, apart), touching - 0.003);
  EXPECT_NEAR(fill.rest_m(rod, 0, 0), 2 * bottle_radius, 0.002);
}

}  // namespace
}  // namespace marketgen
