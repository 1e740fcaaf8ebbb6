#include "physics/settle/let_go.h"

#include <gtest/gtest.h>

#include "unit/physics/shelf_places.h"

namespace marketgen {
namespace {

physics::LetGoOptions let_go_in_room() {
  physics::LetGoOptions options;
  options.region_m = {0, 0, 6, 4};
  return options;
}

std::vector<physics::LetGoProduct> let_go_ends(const scene::Scene& scene,
                                               const physics::LetGoOptions& options) {
  const auto ends = physics::let_go(scene, options);
  EXPECT_TRUE(ends.ok()) << (ends.ok() ? "" : to_string(ends.error()));
  return ends.ok() ? *ends : std::vector<physics::LetGoProduct>{};
}

TEST(LetGo, ALiftedCanFallsBackToWhereItStood) {
  HandMadeScene made;
  made.add(can, {3, on_shelf_y, lower});
  physics::LetGoOptions options = let_go_in_room();
  options.lift_m = 0.005;
  const auto ends = let_go_ends(made.scene, options);
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_TRUE(ends[0].rests);
  EXPECT_NEAR(ends[0].world_from_product.position.z, lower, 0.001);
  EXPECT_NEAR(ends[0].world_from_product.position.x, 3, 0.001);
  options.seconds = 0.02;  // it is still in the air: 9.81 / 2 * 0.02^2 = 2 mm
  const auto falling = let_go_ends(made.scene, options);
  ASSERT_EQ(falling.size(), 1U);
  EXPECT_FALSE(falling[0].rests);
  EXPECT_NEAR(falling[0].world_from_product.position.z, lower + 0.003, 0.0003);
}

TEST(LetGo, WhatStandsOutsideOfTheRegionIsNotAmongThem) {
  HandMadeScene made;
  made.add(can, {3, on_shelf_y, lower});
  made.add(can, {3.5, on_shelf_y, lower});
  physics::LetGoOptions options = let_go_in_room();
  options.region_m = {3.4, 0, 6, 4};
  const auto ends = let_go_ends(made.scene, options);
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_EQ(ends[0].product, 1U);
}

TEST(LetGo, WhatHangsIsNotLifted) {  // nothing is below it
  HandMadeScene made;
  made.scene.shelves[1].use = assets::ShelfUse::hang;
  made.add(cereal, {3, on_shelf_y - 0.6F, 1.2F});
  physics::LetGoOptions options = let_go_in_room();
  options.lift_m = 0.05;
  const auto ends = let_go_ends(made.scene, options);
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_NEAR(ends[0].world_from_product.position.z, 1.2, 0.001);
}

TEST(LetGo, MoreThanAWorldCanMoveAreRefused) {
  HandMadeScene made;
  for (int i = 0; i < 1025; ++i)
    made.add(can, {0.5F + 0.005F * static_cast<float>(i), on_shelf_y, lower});
  const auto ends = physics::let_go(made.scene, let_go_in_room());
  ASSERT_FALSE(ends.ok());
  EXPECT_EQ(ends.error().code, "physics.bad_command");
}

}  // namespace
}  // namespace marketgen
