// The oracle behind doors: it opens one, fetches what is asked for, and shuts it again.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "episodes/aisle/door_book.h"
#include "oracle/oracle_aisle.h"
#include "support/can_cooler.h"

namespace marketgen {
namespace {

constexpr double latched_rad = 0.01, half_open_rad = 0.8;

struct Run {
  episodes::EpisodeResult result;
  std::string failure;
  double widest_rad = 0, last_rad = 0;  // of the door
  int openings = 0;
};

Result<Run> run_oracle(const std::shared_ptr<const episodes::AisleStore>& store, int cans) {
  episodes::AisleWorld world(store, committed_catalog().frictions);
  MARKETGEN_CHECK(world.reset(can_cooler_episode(*store, cans)));
  MARKETGEN_TRY(auto oracle,
                oracle::make_aisle_oracle(
                    world, std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data", Seed(1)));
  agent::Task task;
  task.limit_s = world.spec().limit_s;
  agent::Observation now = world.observe();
  MARKETGEN_CHECK(oracle->begin(task, now));
  Run run;
  while (!world.done()) {
    MARKETGEN_TRY(const agent::Action action, oracle->act(now));
    MARKETGEN_TRY(now, world.step(action));
    const double before_rad =
        std::exchange(run.last_rad, world.world().joint_position(can_cooler_door));
    run.widest_rad = std::max(run.widest_rad, run.last_rad);
    run.openings += before_rad <= half_open_rad && run.last_rad > half_open_rad ? 1 : 0;
  }
  MARKETGEN_TRY(run.result, world.finish());
  run.failure = oracle->failure();
  return run;
}

TEST(SlowAisleDoors, TheOracleFetchesTwoCansAndShutsTheDoor) {
  const auto run = run_oracle(can_cooler(episodes::Doors::hinged), 2);
  ASSERT_TRUE(run.ok()) << to_string(run.error());
  EXPECT_TRUE(run->result.success_strict) << run->failure << " after " << run->result.simulated_s;
  EXPECT_GT(run->widest_rad, 1.4) << "it went through the glass";
  EXPECT_EQ(run->openings, 1);
  EXPECT_LT(run->last_rad, latched_rad);
  EXPECT_EQ(run->result.side_effects.doors_open, 0);
  EXPECT_EQ(run->result.side_effects.base_collisions, 0);
  EXPECT_EQ(run->result.side_effects.protective_stops, 0);
}

// The can by the hinge, before which one stands as a rule where now the open leaf is.
TEST(SlowAisleDoors, TheOracleTakesWhatStandsByTheHingeWithoutShuttingTheDoorFirst) {
  scene::Scene scene = can_cooler_scene();
  scene.products.resize(1);
  scene.facings.resize(1);
  const auto store = episodes::open_aisle_store(
      std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data", scene, {}, episodes::Doors::hinged);
  ASSERT_TRUE(store.ok()) << to_string(store.error());
  episodes::DoorBook doors(*store);
  const auto open = doors.before(0);
  const auto place = (*store)->standing_place(0);
  ASSERT_TRUE(open.ok() && open->row && place);
  ASSERT_FALSE(open->past->space().free(*place));
  const auto run = run_oracle(*store, 1);
  ASSERT_TRUE(run.ok()) << to_string(run.error());
  EXPECT_TRUE(run->result.success_strict) << run->failure << " after " << run->result.simulated_s;
  EXPECT_EQ(run->openings, 1);
}

}  // namespace
}  // namespace marketgen
