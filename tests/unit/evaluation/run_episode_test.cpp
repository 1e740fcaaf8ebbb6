// Whole episodes with the oracle: run, judged, repeated bit for bit.
#include "evaluation/run_episode.h"

#include <gtest/gtest.h>

#include "io/json.h"
#include "support/drawn_checkout.h"

namespace marketgen {
namespace {

Result<EpisodeResult> run_by(const std::string& policy, const EpisodeSpec& spec) {
  EpisodeHeader header;
  header.products = checkout_goods_rows();
  Arena arena(data_rows(), header, committed_catalog());
  return run_episode(arena, spec, policy);
}

EpisodeResult run(const EpisodeSpec& spec) {
  auto result = run_by("oracle", spec);
  if (!result.ok()) fatal(to_string(result.error()).c_str());
  return std::move(result).value();
}

TEST(RunEpisode, TheOracleActsTwiceAlike) {
  EpisodeSpec spec = drawn(7, 0);
  spec.limit_s = 15;  // one item or two
  const EpisodeResult one = run(spec), again = run(spec);
  EXPECT_EQ(one.state_hash, again.state_hash);
  EXPECT_GT(one.side_effects.displaced + one.success_partial, 0) << write_json(one);
  EXPECT_TRUE(one.detail.empty()) << one.detail;
}

TEST(RunEpisode, UnknownPoliciesAreErrors) {
  const auto result = run_by("orakel", drawn(7, 0));
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, "usage.bad_flag");
}

TEST(Summarize, CountsEpisodesAndGoals) {
  EpisodeResult all, half;
  all.goals = {{"a", 1, 1}, {"b", 1, 1}};
  all.hits = all.asked = 2;
  all.success_partial = 1;
  all.success_strict = all.success_clean = true;
  half.goals = {{"a", 1, 1}, {"b", 1, 0}};
  half.hits = 1, half.asked = 2;
  half.success_partial = 0.5;
  half.failure = FailureCode::no_grasp;
  const EvaluationSummary summary = summarize({all, half});
  EXPECT_EQ(summary.goals.number, 3);
  EXPECT_EQ(summary.goals.of, 4);
  EXPECT_EQ(summary.strict.number, 1);
  EXPECT_DOUBLE_EQ(summary.success_partial, 0.75);
  ASSERT_EQ(summary.failures.size(), 1U);
  EXPECT_EQ(summary.failures[0].failure, FailureCode::no_grasp);
  EXPECT_EQ(summarize({}).episodes, 0);
}

// The share is for reading; what it was made of is what is summed up.
TEST(Summarize, TakesHitsFromTheirCountAndNotFromTheirShare) {
  EpisodeResult many;
  many.hits = 12345678, many.asked = 20000001;
  many.success_partial = 0.617;  // rounded, as a reader may have it
  const EvaluationSummary summary = summarize({many, many});
  EXPECT_EQ(summary.goals.number, 2 * 12345678);
  EXPECT_EQ(summary.goals.of, 2 * 20000001);
}

}  // namespace
}  // namespace marketgen
