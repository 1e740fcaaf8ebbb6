// Whole episodes with the oracle: run, judged, repeated bit for bit.
#include "environments/run_episode.h"

#include <gtest/gtest.h>

#include "episodes/checkout/checkout_lanes.h"
#include "io/json.h"
#include "support/drawn_checkout.h"

namespace marketgen {
namespace {

Result<episodes::EpisodeResult> run_by(const std::string& policy,
                                       const episodes::EpisodeSpec& spec) {
  episodes::EpisodeHeader header;
  header.products = checkout_goods_rows();
  environments::Arena arena(data_rows(), header, committed_catalog());
  return environments::run_episode(arena, spec, policy);
}

episodes::EpisodeResult run(const episodes::EpisodeSpec& spec) {
  auto result = run_by("oracle", spec);
  if (!result.ok()) fatal(to_string(result.error()).c_str());
  return std::move(result).value();
}

TEST(RunEpisode, TheOracleActsTwiceAlike) {
  episodes::EpisodeSpec spec = drawn(7, 0);
  spec.limit_s = 15;  // one item or two
  const episodes::EpisodeResult one = run(spec), again = run(spec);
  EXPECT_EQ(one.state_hash, again.state_hash);
  EXPECT_GT(one.side_effects.displaced + one.success_partial, 0) << io::write_json(one);
  EXPECT_TRUE(one.detail.empty()) << one.detail;
}

// In a store that is made from its plan: what stands round the lane is in the oracle's world and in
// its twin, and none of it is knocked.
TEST(RunEpisode, TheOracleActsAtALaneOfAStore) {
  const episodes::EpisodeFile pool = pool_file();
  environments::Arena arena(data_rows(), pool.header, committed_catalog());
  const auto station = episodes::load_checkout_station(data_rows());
  ASSERT_TRUE(station.ok()) << to_string(station.error());
  for (episodes::EpisodeSpec spec : pool.episodes) {
    const auto store = arena.scene(spec.scene_hash);
    ASSERT_TRUE(store.ok()) << to_string(store.error());
    const episodes::CheckoutLanes lanes =
        episodes::checkout_lanes(**store, committed_catalog(), *station);
    if (lanes.suited.empty()) continue;
    spec.lane = lanes.suited.front();
    const auto result = environments::run_episode(arena, spec, "oracle");
    ASSERT_TRUE(result.ok()) << to_string(result.error());
    EXPECT_TRUE(result->success_strict) << io::write_json(*result);
    EXPECT_TRUE(episodes::is_clean(result->side_effects)) << io::write_json(*result);
    return;
  }
  FAIL() << "no store of the pool has a lane with room for the arm";
}

// Both know nothing of what is asked for: the one ends at once, the other lifts something.
TEST(RunEpisode, TheFloorPoliciesEndAlikeTwice) {
  episodes::EpisodeSpec spec = drawn(7, 0);
  spec.limit_s = 20;
  for (const char* policy : {"stop", "highest"}) {
    const auto one = run_by(policy, spec), again = run_by(policy, spec);
    ASSERT_TRUE(one.ok()) << policy << ": " << to_string(one.error());
    EXPECT_EQ(one->state_hash, again->state_hash) << policy;
    EXPECT_FALSE(one->success_strict) << policy;
    EXPECT_EQ(one->simulated_s > 5, std::string(policy) == "highest") << one->simulated_s;
  }
}

TEST(RunEpisode, WhoGraspsWithFingersAloneRefusesACup) {
  episodes::EpisodeSpec spec = drawn(7, 0);
  spec.tools = "suction";
  spec.limit_s = 2;
  for (const char* policy : {"classical", "highest"}) {
    const auto refused = run_by(policy, spec);
    ASSERT_FALSE(refused.ok()) << policy;
    EXPECT_EQ(refused.error().code, "usage.bad_flag") << policy;
  }
  EXPECT_TRUE(run_by("stop", spec).ok());
}

TEST(RunEpisode, UnknownPoliciesAreErrors) {
  const auto result = run_by("orakel", drawn(7, 0));
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, "usage.bad_flag");
}

}  // namespace
}  // namespace marketgen
