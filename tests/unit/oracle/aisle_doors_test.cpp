// The oracle behind doors: it opens one, fetches what is asked for, and shuts it again.
#include <gtest/gtest.h>

#include "oracle/oracle_aisle.h"
#include "support/can_cooler.h"

namespace marketgen {
namespace {

constexpr double latched_rad = 0.01;

TEST(AisleDoors, TheOracleFetchesTwoCansAndShutsTheDoor) {
  const auto store = can_cooler(episodes::Doors::hinged);
  episodes::AisleWorld world(store, committed_catalog().frictions);
  const auto reset = world.reset(can_cooler_episode(*store, 2));
  ASSERT_TRUE(reset.ok()) << to_string(reset.error());
  auto oracle = oracle::make_aisle_oracle(
      world, std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data", Seed(1));
  ASSERT_TRUE(oracle.ok());
  agent::Task task;
  task.limit_s = world.spec().limit_s;
  agent::Observation now = world.observe();
  ASSERT_TRUE((*oracle)->begin(task, now).ok());
  double widest = 0;
  while (!world.done()) {
    const auto action = (*oracle)->act(now);
    ASSERT_TRUE(action.ok()) << to_string(action.error());
    now = world.step(*action).value();
    widest = std::max(widest, world.world().joint_position(can_cooler_door));
  }
  const auto result = world.finish();
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_TRUE(result->success_strict) << (*oracle)->failure() << " after " << result->simulated_s;
  EXPECT_GT(widest, 1.4) << "it went through the glass";
  EXPECT_LT(world.world().joint_position(can_cooler_door), latched_rad);
  EXPECT_EQ(result->side_effects.doors_open, 0);
  EXPECT_EQ(result->side_effects.base_collisions, 0);
  EXPECT_EQ(result->side_effects.protective_stops, 0);
}

}  // namespace
}  // namespace marketgen
