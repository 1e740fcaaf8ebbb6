// An environment of each track: its spaces, what it refuses, how it ends, what it rewards, and that
// it goes on bit for bit from a moment that was saved.
#include "environments/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "support/pool_ground.h"

namespace marketgen {
namespace {

constexpr double short_s = 0.5;

class EachEnvironment : public testing::TestWithParam<episodes::Track> {
 protected:
  static episodes::Track track() { return GetParam(); }

  static std::unique_ptr<environments::Environment> begun(
      const environments::EnvironmentOptions& options, double limit_s = short_s) {
    auto environment = pool_environment(track(), options);
    const auto reset = environment->reset(pool_episode(track(), limit_s));
    if (!reset.ok()) fatal(to_string(reset.error()).c_str());
    return environment;
  }

  // Joints where they are, fingers half open, wheels still, and the agent goes on.
  static std::vector<double> still(const environments::Environment& environment) {
    std::vector<double> action(environment.action_numbers().size(), 0.0);
    if (environment.options().stop) action.back() = -1;
    return action;
  }

  static environments::StepOutcome stepped(environments::Environment& environment,
                                           const std::vector<double>& action) {
    const auto outcome = environment.step(action);
    if (!outcome.ok()) fatal(to_string(outcome.error()).c_str());
    return *outcome;
  }
};

TEST_P(EachEnvironment, NumbersAreNamedAndObservationsStayWithinTheirBounds) {
  const auto plain = pool_environment(track());
  const auto environment = begun({.privileged = true});
  EXPECT_EQ(environment->action_numbers().back().name, "stop");
  EXPECT_GT(environment->observation_size(), plain->observation_size());
  EXPECT_FALSE(environment->cameras().empty());
  std::vector<float> seen(environment->observation_size());
  for (int i = 0; i < 3; ++i) {
    stepped(*environment, still(*environment));
    environment->observe(seen);
    std::size_t at = 0;
    for (const environments::ObservationPart& part : environment->observation_parts()) {
      ASSERT_EQ(part.low.size(), environments::count_of(part)) << part.name;
      const std::set<std::string> names(part.names.begin(), part.names.end());
      EXPECT_EQ(names.size(), part.group == "privileged" ? 0 : part.low.size()) << part.name;
      for (std::size_t n = 0; n < environments::count_of(part); ++n, ++at) {
        EXPECT_GE(seen[at], static_cast<float>(part.low[n])) << part.name;
        EXPECT_LE(seen[at], static_cast<float>(part.high[n])) << part.name;
      }
    }
    EXPECT_EQ(at, seen.size());
  }
}

TEST_P(EachEnvironment, WhatIsNoActionIsRefusedAndMovesNothing) {
  const auto fresh = pool_environment(track());
  EXPECT_EQ(fresh->step(still(*fresh)).error().code, "episode.bad_action") << "before a reset";
  const auto environment = begun({});
  const std::string before = environment->world().state_hash();
  std::vector<double> bad = still(*environment);
  bad.pop_back();
  EXPECT_EQ(environment->step(bad).error().code, "episode.bad_action") << "too few numbers";
  bad.resize(bad.size() + 2, 0.0);
  EXPECT_EQ(environment->step(bad).error().code, "episode.bad_action") << "too many numbers";
  for (const double number : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    bad = still(*environment);
    bad[1] = number;
    EXPECT_EQ(environment->step(bad).error().code, "episode.bad_action") << number;
  }
  EXPECT_EQ(environment->world().state_hash(), before);
  EXPECT_EQ(environment->world().steps(), 0);
}

TEST_P(EachEnvironment, EpisodesOfElsewhereAreRefused) {
  const auto environment = pool_environment(track());
  episodes::EpisodeSpec spec = pool_episode(track(), short_s);
  spec.plan_hash = "of another plan";
  EXPECT_EQ(environment->reset(spec).error().code, "episode.other_store");
  for (const episodes::Track other : episodes::all_tracks) {
    if (other == track()) continue;
    spec.track = other;
    EXPECT_EQ(environment->reset(spec).error().code, "episode.unknown_track");
  }
  EXPECT_FALSE(environment->running());
}

TEST_P(EachEnvironment, TimeThatIsOverTruncates) {
  const auto environment = begun({}, 2 * episodes::control_step_s);
  const environments::StepOutcome first = stepped(*environment, still(*environment));
  EXPECT_FALSE(first.terminated || first.truncated);
  const environments::StepOutcome last = stepped(*environment, still(*environment));
  EXPECT_TRUE(last.truncated && !last.terminated);
  ASSERT_TRUE(environment->result().has_value());
  EXPECT_EQ(environment->result()->failure, episodes::FailureCode::timeout);
  EXPECT_FALSE(environment->running());
  EXPECT_EQ(environment->step(still(*environment)).error().code, "episode.bad_action");
}

TEST_P(EachEnvironment, TheAgentsStopTerminates) {
  const auto environment = begun({});
  std::vector<double> stop = still(*environment);
  stop.back() = 1;
  const environments::StepOutcome last = stepped(*environment, stop);
  EXPECT_TRUE(last.terminated && !last.truncated);
  EXPECT_EQ(last.reward, 0) << "nothing was done";
  ASSERT_TRUE(environment->result().has_value());
  EXPECT_EQ(environment->result()->failure, episodes::FailureCode::unknown)
      << "who stops says nothing";
  episodes::EpisodeEnd end{"mine", "NotFound"};
  EXPECT_EQ(environment->judged(end).failure, episodes::FailureCode::not_found);
  EXPECT_EQ(environment->judged(end).policy, "mine");
}

TEST_P(EachEnvironment, WithoutStopOnlyGoalsOrTimeEndIt) {
  const auto environment = begun({.stop = false}, 2 * episodes::control_step_s);
  EXPECT_NE(environment->action_numbers().back().name, "stop");
  EXPECT_FALSE(stepped(*environment, still(*environment)).terminated);
  EXPECT_TRUE(stepped(*environment, still(*environment)).truncated);
}

TEST_P(EachEnvironment, RewardsAreWhatTheirModesSay) {
  const auto sparse = begun({.reward = environments::RewardMode::sparse});
  EXPECT_EQ(stepped(*sparse, still(*sparse)).reward, 0);
  const auto dense = begun({.reward = environments::RewardMode::dense});
  const double near = stepped(*dense, still(*dense)).reward;
  EXPECT_GT(near, 0);
  EXPECT_LT(near, 1);
  const auto shaped = begun({.reward = environments::RewardMode::shaped});
  double risen = 0;
  for (int i = 0; i < 5; ++i)
    risen += stepped(*shaped, still(*shaped)).reward;
  EXPECT_NEAR(risen, 0, 0.02) << "who stands still does not come on";
}

TEST_P(EachEnvironment, ASavedMomentGoesOnBitForBit) {
  const auto environment = begun({}), other = begun({});
  stepped(*environment, still(*environment));
  const std::string moment = environment->save();
  const auto ends = [](environments::Environment& from) {
    std::vector<double> action = still(from);
    action.front() = 1;
    for (int i = 0; i < 3; ++i)
      stepped(from, action);
    return from.world().state_hash();
  };
  const std::string end = ends(*environment);
  ASSERT_TRUE(other->restore(moment).ok());
  EXPECT_EQ(ends(*other), end);
  EXPECT_EQ(other->restore("no moment").error().code, "physics.bad_command");
  EXPECT_EQ(other->world().state_hash(), end) << "a bad moment changes nothing";
}

INSTANTIATE_TEST_SUITE_P(OfTracks,
                         EachEnvironment,
                         testing::ValuesIn(episodes::all_tracks),
                         [](const auto& track) { return std::string(name_of(track.param)); });

}  // namespace
}  // namespace marketgen
