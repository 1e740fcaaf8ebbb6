// Runs of many episodes: kept as they finish, gone on with after a break.
#include "evaluation/evaluate.h"

#include <gtest/gtest.h>

#include "io/file.h"
#include "io/json.h"
#include "support/drawn_checkout.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

// The same basket three times, a second each.
episodes::EpisodeFile three_episodes() {
  episodes::EpisodeFile file;
  file.header.products = checkout_goods_rows();
  episodes::EpisodeSpec spec = drawn(7, 0);
  spec.limit_s = 1;
  for (const char* id : {"a", "b", "c"}) {
    spec.id = id;
    ++spec.seed;
    file.episodes.push_back(spec);
  }
  return file;
}

Result<std::vector<episodes::EpisodeResult>> evaluated(const episodes::EpisodeFile& file,
                                                       const std::filesystem::path& folder,
                                                       bool resume,
                                                       int repetition = 1) {
  evaluation::EvaluationOptions options{"random", folder, resume};
  options.repetition = repetition;
  return evaluation::evaluate(data_rows(), file, committed_catalog(), options, silent_progress());
}

TEST(Evaluate, ABrokenRunGoesOnAndKeepsWhatWasFinished) {
  const episodes::EpisodeFile file = three_episodes();
  const ScratchFolder scratch;
  const auto whole = evaluated(file, scratch.path() / "whole", false);
  ASSERT_TRUE(whole.ok()) << to_string(whole.error());
  ASSERT_EQ(whole->size(), 3U);
  EXPECT_NE((*whole)[0].state_hash, (*whole)[1].state_hash) << "each draws its own steps";
  EXPECT_EQ((*whole)[0].failure, episodes::FailureCode::timeout);

  // As kill -9 leaves it: the second episode finished, with a mark; the first in the middle of its
  // line.
  episodes::EpisodeResult marked = (*whole)[1];
  marked.detail = "of the first run";
  const std::filesystem::path broken = scratch.path() / "broken";
  std::filesystem::create_directories(broken);
  const std::string half = io::write_json_line((*whole)[0]).substr(0, 40);
  ASSERT_TRUE(
      io::write_file(broken / "results.jsonl", io::write_json_line(marked) + "\n" + half).ok());
  const auto resumed = evaluated(file, broken, true);
  ASSERT_TRUE(resumed.ok()) << to_string(resumed.error());
  ASSERT_EQ(resumed->size(), 3U);
  EXPECT_EQ((*resumed)[1].detail, "of the first run") << "it was run again";
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ((*resumed)[i].state_hash, (*whole)[i].state_hash);
  EXPECT_TRUE(std::filesystem::exists(broken / "summary.json"));
}

TEST(Evaluate, RepetitionsDrawAnewAndAreKeptApart) {
  const episodes::EpisodeFile file = three_episodes();
  const ScratchFolder scratch;
  const auto first = evaluated(file, scratch.path() / "1", false);
  const auto second = evaluated(file, scratch.path() / "2", false, 2);
  const auto again = evaluated(file, scratch.path() / "again", false, 2);
  ASSERT_TRUE(first.ok() && second.ok() && again.ok());
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_FALSE((*first)[i].repetition);
    EXPECT_EQ((*second)[i].repetition, 2);
    EXPECT_EQ((*second)[i].episode_hash, (*first)[i].episode_hash);
    EXPECT_NE((*second)[i].state_hash, (*first)[i].state_hash);
    EXPECT_EQ((*second)[i].state_hash, (*again)[i].state_hash);
  }
  const auto refused = evaluated(file, scratch.path() / "1", true, 2);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().where, "--repetition");
}

TEST(Evaluate, ResultsAreNotOverwritten) {
  const ScratchFolder scratch;
  ASSERT_TRUE(io::write_file(scratch.path() / "results.jsonl", "{").ok());
  const auto refused = evaluated(three_episodes(), scratch.path(), false);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, "store.exists");
}

// A folder's results belong to its file: with another one they would be lost at the end.
TEST(Evaluate, ResultsOfOtherEpisodesAreKept) {
  const ScratchFolder scratch;
  episodes::EpisodeResult other;
  other.episode = "of-another-file";
  other.policy = "random";
  const std::string line = io::write_json_line(other) + "\n";
  ASSERT_TRUE(io::write_file(scratch.path() / "results.jsonl", line).ok());
  const auto refused = evaluated(three_episodes(), scratch.path(), true);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, "usage.bad_flag");
  EXPECT_EQ(io::read_file(scratch.path() / "results.jsonl").value(), line);
}

// ---- Runs without physics: a runner that answers at once. ----

episodes::EpisodeFile named(const std::vector<std::string>& ids) {
  episodes::EpisodeFile file;
  for (const std::string& id : ids) {
    episodes::EpisodeSpec spec;
    spec.id = id;
    spec.goals = {{"can-cola", 1}};
    file.episodes.push_back(spec);
  }
  return file;
}

// Notes in `ran` what it runs; `fails`, if any, is interrupted.
Result<std::vector<episodes::EpisodeResult>> quick_run(const episodes::EpisodeFile& file,
                                                       const std::filesystem::path& folder,
                                                       bool resume,
                                                       std::string& ran,
                                                       const std::string& fails = {}) {
  evaluation::EvaluationOptions options{"quick", folder, resume, 1};
  const evaluation::EpisodeRunner runner =
      [&](const episodes::EpisodeSpec& spec) -> Result<episodes::EpisodeResult> {
    if (spec.id == fails) return Error{"internal.interrupted", "", "interrupted"};
    ran += spec.id;
    return episodes::with_end(episodes::unjudged(spec), {"quick"});
  };
  return evaluation::evaluate_with(
      file, options, [&] { return runner; }, silent_progress());
}

TEST(Evaluate, AnEpisodeThatWasEditedIsRunAgain) {
  const ScratchFolder scratch;
  std::string first, second, third;
  episodes::EpisodeFile file = named({"a", "b", "c"});
  ASSERT_TRUE(quick_run(file, scratch.path(), false, first).ok());
  file.episodes[1].goals[0].count = 2;
  const auto resumed = quick_run(file, scratch.path(), true, second);
  ASSERT_TRUE(resumed.ok()) << to_string(resumed.error());
  EXPECT_EQ(first, "abc");
  EXPECT_EQ(second, "b");
  EXPECT_EQ((*resumed)[1].goals[0].count, 2);
  // So is one whose product has another mass: nothing in its own line has changed.
  catalog::Product cola;
  cola.sku = "can-cola";
  file.header.products = {cola};
  ASSERT_TRUE(quick_run(file, scratch.path(), true, third).ok());
  EXPECT_EQ(third, "abc");
}

TEST(Evaluate, WhatCouldNotBeRunIsTriedAgain) {
  const ScratchFolder scratch;
  const episodes::EpisodeFile file = named({"a", "b"});
  std::string ran;
  const auto all = quick_run(file, scratch.path(), false, ran);
  ASSERT_TRUE(all.ok());
  std::vector<episodes::EpisodeResult> results = *all;
  results[0].error = "robot.unknown";
  ASSERT_TRUE(io::write_file(
                  scratch.path() / "results.jsonl",
                  io::write_json_line(results[0]) + "\n" + io::write_json_line(results[1]) + "\n")
                  .ok());
  std::string again;
  const auto resumed = quick_run(file, scratch.path(), true, again);
  ASSERT_TRUE(resumed.ok());
  EXPECT_EQ(again, "a");
  EXPECT_TRUE((*resumed)[0].error.empty());
}

// Or it could end its process whenever things went badly, and have the run gone on with.
TEST(Evaluate, APolicyThatBreaksOffHasNoSecondTry) {
  const ScratchFolder scratch;
  const episodes::EpisodeFile file = named({"a", "b"});
  const auto breaks_off = [](const episodes::EpisodeSpec& spec) -> Result<episodes::EpisodeResult> {
    episodes::EpisodeEnd end{"quick"};
    end.broken = Error{"episode.policy_crashed", "policy", "ended"};
    end.by_policy = true;
    return episodes::with_end(episodes::unjudged(spec), end);
  };
  ASSERT_TRUE(evaluation::evaluate_with(
                  file,
                  {"quick", scratch.path(), false, 1},
                  [&] { return evaluation::EpisodeRunner(breaks_off); },
                  silent_progress())
                  .ok());
  std::string again;
  const auto resumed = quick_run(file, scratch.path(), true, again);
  ASSERT_TRUE(resumed.ok()) << to_string(resumed.error());
  EXPECT_EQ(again, "");
  for (const episodes::EpisodeResult& result : *resumed)
    EXPECT_EQ(result.failure, episodes::FailureCode::policy_error);
}

TEST(Evaluate, AnInterruptedRunSaysWhatIsKept) {
  const ScratchFolder scratch;
  std::string ran;
  const auto ended = quick_run(named({"a", "b", "c"}), scratch.path(), false, ran, "b");
  ASSERT_FALSE(ended.ok());
  EXPECT_EQ(ended.error().code, "internal.interrupted");
  EXPECT_EQ(ended.error().message,
            "interrupted; 1 finished episodes are kept in " + scratch.path().string() +
                ": go on with --resume");
  EXPECT_EQ(evaluation::finished_results(scratch.path() / "results.jsonl")->size(), 1U);
  const std::string summary = *io::read_file(scratch.path() / "summary.json");
  EXPECT_NE(summary.find("\"unfinished\": 2"), std::string::npos) << summary;
  ASSERT_TRUE(quick_run(named({"a", "b", "c"}), scratch.path(), true, ran).ok());
  EXPECT_EQ(ran, "abc");
}

TEST(Evaluate, AFolderIsOneRunsAtATime) {
  const ScratchFolder scratch;
  std::string ran;
  const auto other = io::FolderLock::take(scratch.path());
  ASSERT_TRUE(other.ok());
  const auto refused = quick_run(named({"a"}), scratch.path(), false, ran);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, "io.in_use");
  EXPECT_EQ(ran, "");
}

TEST(Evaluate, ADamagedLineOfResultsIsNamed) {
  const ScratchFolder scratch;
  episodes::EpisodeResult result;
  result.episode = "a";
  const std::string line = io::write_json_line(result);
  const std::filesystem::path file = scratch.path() / "results.jsonl";
  ASSERT_TRUE(io::write_file(file, line + "\n" + line.substr(0, 30) + "\n" + line + "\n").ok());
  const auto read = evaluation::finished_results(file);
  ASSERT_FALSE(read.ok());
  EXPECT_TRUE(read.error().where.starts_with(file.string() + ":2")) << read.error().where;
  EXPECT_EQ(evaluation::finished_results(scratch.path() / "none").error().code, "input.not_found");
}

}  // namespace
}  // namespace marketgen
