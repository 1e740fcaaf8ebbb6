// One code for why an episode failed, whoever ran it.
#include "episodes/episode_end.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

EpisodeResult missed_one() {
  EpisodeResult result;
  add_outcome({{{"tea", 2, 1}}, 2, 1, 0, false}, result);
  return result;
}

EpisodeEnd told(const std::string& word) {
  EpisodeEnd end;
  end.told = word;
  return end;
}

TEST(EpisodeEnd, AFailureThatNobodyExplainedIsUnknown) {
  for (const char* word : {"None", "", "no idea", "Unknown"})
    EXPECT_EQ(failure_of(missed_one(), told(word)), FailureCode::unknown) << word;
}

TEST(EpisodeEnd, APolicyTellsWhatItKnowsAndNoMore) {
  EXPECT_EQ(failure_of(missed_one(), told("NoGrasp")), FailureCode::no_grasp);
  EXPECT_EQ(failure_of(missed_one(), told("Dropped")), FailureCode::dropped);
  for (const char* word : {"PolicyError", "NotRun"})  // not the policy's to say
    EXPECT_EQ(failure_of(missed_one(), told(word)), FailureCode::unknown) << word;
}

TEST(EpisodeEnd, WhatWasSeenCountsBeforeWhatIsTold) {
  EpisodeEnd late = told("NoGrasp");
  late.in_time = false;
  EXPECT_EQ(failure_of(missed_one(), late), FailureCode::timeout);
  EpisodeResult tilted = missed_one(), wrong = missed_one(), all = missed_one();
  tilted.is_void = true;
  EXPECT_EQ(failure_of(tilted, told("NoGrasp")), FailureCode::collision);
  wrong.side_effects.wrong_items = 1;
  EXPECT_EQ(failure_of(wrong, told("NoGrasp")), FailureCode::wrong_item);
  all.success_strict = true;
  EXPECT_EQ(failure_of(all, told("NoGrasp")), FailureCode::none);
}

TEST(EpisodeEnd, SaysWhatKeptThePolicyFromTheTruth) {
  EXPECT_EQ(with_end(missed_one(), told("None")).isolation, PolicyIsolation::own);
  EpisodeEnd apart = told("None");
  apart.isolation = PolicyIsolation::landlock;
  EXPECT_EQ(with_end(missed_one(), apart).isolation, PolicyIsolation::landlock);
}

// In this process the world is judged after the policy threw, in a worker it has gone with it; the
// code is the same.
TEST(EpisodeEnd, AnErrorThatBrokeItOffCountsBeforeAll) {
  EpisodeEnd threw = told("NoGrasp");
  threw.broken = Error{"episode.policy_failed", "policy", "threw"};
  threw.by_policy = true;
  EpisodeResult wrong = missed_one();
  wrong.side_effects.wrong_items = 1;
  EXPECT_EQ(failure_of(wrong, threw), FailureCode::policy_error);
  EpisodeEnd physics = told("NoGrasp");
  physics.broken = Error{"physics.failed", "world", "diverged"};
  EXPECT_EQ(failure_of(missed_one(), physics), FailureCode::unknown);
  EXPECT_EQ(with_end(missed_one(), physics).detail, to_string(*physics.broken));
}

TEST(EpisodeEnd, WhatNobodyJudgedAsksForItsGoals) {
  EpisodeSpec spec;
  spec.goals = {{"tea", 2}, {"rice", 1}};
  const EpisodeResult result = unjudged(spec);
  EXPECT_EQ(result.asked, 3);
  EXPECT_EQ(result.hits, 0);
}

}  // namespace
}  // namespace marketgen
