// Difficulties of tasks in aisles, in the pool's store: on which boards goals stand, how far apart.
#include <gtest/gtest.h>

#include <algorithm>

#include "environments/environment_entry.h"
#include "episodes/aisle/aisle_store.h"
#include "support/drawn_checkout.h"
#include "support/pool_ground.h"
#include "support/realistic_worlds.h"

namespace marketgen {
namespace {

using episodes::Difficulty;
using episodes::EpisodeSpec;
using episodes::Track;

// Without planning: what is drawn and what is left out is the same.
EpisodeSpec drawn_in_aisles(const Difficulty& difficulty, int index) {
  environments::Arena& arena = pool_ground(Track::aisle)->arena();
  const episodes::EpisodeStore& store = pool_ground(Track::aisle)->stores().front();
  const auto sampler = or_die(environments::environment_entry_of(Track::aisle)
                                  .sampler(arena,
                                           "",
                                           {.split = episodes::Split::paper,
                                            .instructions = episodes::Instructions::ids,
                                            .difficulty = difficulty}));
  const auto from = or_die(sampler->of_store({store.name, store.scene_hash, store.plan_hash}));
  return or_die(from->sample(Seed(3), index));
}

const episodes::AisleStore& pool_aisles() {
  static const auto store = or_die(episodes::open_aisle_store(
      data_rows(),
      *or_die(pool_ground(Track::aisle)
                  ->arena()
                  .scene(pool_ground(Track::aisle)->stores().front().scene_hash))));
  return *store;
}

double tour_m(const EpisodeSpec& spec) {
  std::vector<std::string> skus;
  for (const episodes::EpisodeGoal& goal : spec.goals)
    skus.push_back(goal.sku);
  const auto tour = episodes::shortest_tour_m(
      pool_aisles(), floor_mm(Vec2{spec.start.x_m, spec.start.y_m}), skus);
  return tour.value_or(0);
}

TEST(DifficultAisles, GoalsStandOnTheLevelsThatAreSaid) {
  Difficulty low;
  low.name = "low";
  low.levels = {{0.45, 0.8}};
  for (int index = 0; index < 3; ++index) {
    const EpisodeSpec spec = drawn_in_aisles(low, index);
    EXPECT_TRUE(spec.id.starts_with("aisle/gripper/low/")) << spec.id;
    EXPECT_EQ(spec.difficulty, "low");
    for (const episodes::EpisodeGoal& goal : spec.goals)
      for (const std::uint32_t row : pool_aisles().front_items(goal.sku))
        EXPECT_LE(pool_aisles().scene.products[row].position_m[2], 0.8F) << goal.sku;
  }
}

TEST(DifficultAisles, GoalsAreAsFarApartAsIsSaid) {
  const RectMm floor = bounds_of(plan::floor_of(pool_aisles().scene.layout.shell));
  const double longer_m = std::max(floor.x1 - floor.x0, floor.y1 - floor.y0) * 1e-3;
  Difficulty far;
  far.name = "far";
  far.way = 1;
  for (int index = 0; index < 3; ++index)
    EXPECT_GE(tour_m(drawn_in_aisles(far, index)), longer_m);
}

TEST(DifficultAisles, ThatNoGoodsSuitAreImpossible) {
  Difficulty nowhere;
  nowhere.name = "nowhere";
  nowhere.levels = {{0.5, 0.5}};
  environments::Arena& arena = pool_ground(Track::aisle)->arena();
  const episodes::EpisodeStore& store = pool_ground(Track::aisle)->stores().front();
  const auto sampler = or_die(
      environments::environment_entry_of(Track::aisle).sampler(arena, "", {.difficulty = nowhere}));
  const auto from = sampler->of_store({store.name, store.scene_hash, store.plan_hash});
  ASSERT_FALSE(from.ok());
  EXPECT_EQ(from.error().code, "episode.impossible");
}

}  // namespace
}  // namespace marketgen
