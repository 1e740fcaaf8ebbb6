// The sums of many results.
#include "evaluation/evaluation_summary.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

TEST(Summarize, CountsEpisodesAndGoals) {
  episodes::EpisodeResult all, half;
  all.goals = {{"a", 1, 1}, {"b", 1, 1}};
  all.hits = all.asked = 2;
  all.success_partial = 1;
  all.success_strict = all.success_clean = true;
  half.goals = {{"a", 1, 1}, {"b", 1, 0}};
  half.hits = 1, half.asked = 2;
  half.success_partial = 0.5;
  half.failure = episodes::FailureCode::no_grasp;
  const evaluation::EvaluationSummary summary = evaluation::summarize({all, half});
  EXPECT_EQ(summary.goals.number, 3);
  EXPECT_EQ(summary.goals.of, 4);
  EXPECT_EQ(summary.strict.number, 1);
  EXPECT_DOUBLE_EQ(summary.success_partial, 0.75);
  ASSERT_EQ(summary.failures.size(), 1U);
  EXPECT_EQ(summary.failures[0].failure, episodes::FailureCode::no_grasp);
  EXPECT_EQ(evaluation::summarize({}).episodes, 0);
}

// The share is for reading; what it was made of is what is summed up.
TEST(Summarize, TakesHitsFromTheirCountAndNotFromTheirShare) {
  episodes::EpisodeResult many;
  many.hits = 12345678, many.asked = 20000001;
  many.success_partial = 0.617;  // rounded, as a reader may have it
  const evaluation::EvaluationSummary summary = evaluation::summarize({many, many});
  EXPECT_EQ(summary.goals.number, 2 * 12345678);
  EXPECT_EQ(summary.goals.of, 2 * 20000001);
}

}  // namespace
}  // namespace marketgen
