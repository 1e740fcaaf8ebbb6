// One code for why an episode failed, whoever ran it.
#include "episodes/episode_end.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

episodes::EpisodeResult missed_one() {
  episodes::EpisodeResult result;
  episodes::add_outcome({{{"tea", 2, 1}}, 2, 1, 0, false}, result);
  return result;
}

episodes::EpisodeEnd told(const std::string& word) {
  episodes::EpisodeEnd end;
  end.told = word;
  return end;
}

TEST(EpisodeEnd, AFailureThatNobodyExplainedIsUnknown) {
  for (const char* word : {"None", "", "no idea", "Unknown"})
    EXPECT_EQ(episodes::failure_of(missed_one(), told(word)), episodes::FailureCode::unknown)
        << word;
}

TEST(EpisodeEnd, APolicyTellsWhatItKnowsAndNoMore) {
  EXPECT_EQ(episodes::failure_of(missed_one(), told("NoGrasp")), episodes::FailureCode::no_grasp);
  EXPECT_EQ(episodes::failure_of(missed_one(), told("Dropped")), episodes::FailureCode::dropped);
  for (const char* word : {"PolicyError", "NotRun"})  // not the policy's to say
    EXPECT_EQ(episodes::failure_of(missed_one(), told(word)), episodes::FailureCode::unknown)
        << word;
}

TEST(EpisodeEnd, WhatWasSeenCountsBeforeWhatIsTold) {
  episodes::EpisodeEnd late = told("NoGrasp");
  late.in_time = false;
  EXPECT_EQ(episodes::failure_of(missed_one(), late), episodes::FailureCode::timeout);
  episodes::EpisodeResult tilted = missed_one(), wrong = missed_one(), all = missed_one();
  tilted.is_void = true;
  EXPECT_EQ(episodes::failure_of(tilted, told("NoGrasp")), episodes::FailureCode::collision);
  wrong.side_effects.wrong_items = 1;
  EXPECT_EQ(episodes::failure_of(wrong, told("NoGrasp")), episodes::FailureCode::wrong_item);
  all.success_strict = true;
  EXPECT_EQ(episodes::failure_of(all, told("NoGrasp")), episodes::FailureCode::none);
}

TEST(EpisodeEnd, SaysWhatKeptThePolicyFromTheTruth) {
  EXPECT_EQ(episodes::with_end(missed_one(), told("None")).isolation,
            episodes::PolicyIsolation::own);
  episodes::EpisodeEnd apart = told("None");
  apart.isolation = episodes::PolicyIsolation::landlock;
  EXPECT_EQ(episodes::with_end(missed_one(), apart).isolation, episodes::PolicyIsolation::landlock);
}

// In this process the world is judged after the policy threw, in a worker it has gone with it; the
// code is the same.
TEST(EpisodeEnd, AnErrorThatBrokeItOffCountsBeforeAll) {
  episodes::EpisodeEnd threw = told("NoGrasp");
  threw.broken = Error{"episode.policy_failed", "policy", "threw"};
  threw.by_policy = true;
  episodes::EpisodeResult wrong = missed_one();
  wrong.side_effects.wrong_items = 1;
  EXPECT_EQ(episodes::failure_of(wrong, threw), episodes::FailureCode::policy_error);
  episodes::EpisodeEnd physics = told("NoGrasp");
  physics.broken = Error{"physics.failed", "world", "diverged"};
  EXPECT_EQ(episodes::failure_of(missed_one(), physics), episodes::FailureCode::unknown);
  EXPECT_EQ(episodes::with_end(missed_one(), physics).detail, to_string(*physics.broken));
}

TEST(EpisodeEnd, WhatNobodyJudgedAsksForItsGoals) {
  episodes::EpisodeSpec spec;
  spec.goals = {{"tea", 2}, {"rice", 1}};
  const episodes::EpisodeResult result = episodes::unjudged(spec);
  EXPECT_EQ(result.asked, 3);
  EXPECT_EQ(result.hits, 0);
}

}  // namespace
}  // namespace marketgen
