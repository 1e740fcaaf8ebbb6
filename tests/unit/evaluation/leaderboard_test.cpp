// Runs of made-up results: read, merged and ranked, or refused with a reason.
#include "evaluation/leaderboard.h"

#include <gtest/gtest.h>

#include "evaluation/evaluate.h"
#include "evaluation/leaderboard_page.h"
#include "evaluation/merge_runs.h"
#include "evaluation/run_page.h"
#include "io/file.h"
#include "io/json.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

// `count` episodes of two stores in turn, each with one goal.
episodes::EpisodeFile episodes_of_two_stores(int count) {
  episodes::EpisodeFile file;
  for (int i = 0; i < count; ++i) {
    episodes::EpisodeSpec spec;
    spec.id = "episode-" + std::to_string(i);
    spec.store = "Market";  // as both are called
    spec.scene_hash = i % 2 == 0 ? "first" : "second";
    spec.goals = {{"can-cola", 1}};
    file.episodes.push_back(spec);
  }
  return file;
}

// `solves` says which episodes end well, by their last digit.
Result<void> run_quickly(const episodes::EpisodeFile& file,
                         const fs::path& folder,
                         const std::string& policy,
                         const std::string& solves,
                         const evaluation::Shard& shard = {},
                         int repetition = 1) {
  evaluation::EvaluationOptions options{policy, folder, false, 1};
  options.shard = shard;
  options.repetition = repetition;
  const evaluation::EpisodeRunner runner =
      [&](const episodes::EpisodeSpec& spec) -> Result<episodes::EpisodeResult> {
    if (solves == "none can be run") return Error{"robot.unknown", spec.id, "no such robot"};
    episodes::EpisodeResult result = episodes::with_end(episodes::unjudged(spec), {policy});
    if (solves.find(spec.id.back()) != std::string::npos)
      episodes::add_outcome({{{"can-cola", 1, 1}}, 1, 1}, result);
    return result;
  };
  const auto ran = evaluation::evaluate_with(
      file, options, [&] { return runner; }, silent_progress());
  if (!ran.ok()) return ran.error();
  return {};
}

std::vector<evaluation::FinishedRun> read_all(const std::vector<fs::path>& folders) {
  std::vector<evaluation::FinishedRun> runs;
  for (const fs::path& folder : folders) {
    auto run = evaluation::read_run(folder);
    EXPECT_TRUE(run.ok()) << to_string(run.error());
    if (run.ok()) runs.push_back(*std::move(run));
  }
  return runs;
}

class Runs : public testing::Test {
 protected:
  fs::path folder(const std::string& name) const { return scratch_.path() / name; }
  // Changes the text of a file of a run.
  void change(const fs::path& file, const std::string& what, const std::string& into) const {
    std::string text = io::read_file(file).value();
    const std::size_t at = text.find(what);
    ASSERT_NE(at, std::string::npos);
    ASSERT_TRUE(io::write_file(file, text.replace(at, what.size(), into)).ok());
  }
  ScratchFolder scratch_;
};

TEST_F(Runs, AreRankedWithTheirFloors) {
  const episodes::EpisodeFile file = episodes_of_two_stores(10);
  ASSERT_TRUE(run_quickly(file, folder("good"), "oracle", "012345678").ok());
  ASSERT_TRUE(run_quickly(file, folder("poor"), "classical", "0123").ok());
  ASSERT_TRUE(run_quickly(file, folder("floor"), "stop", "").ok());
  const auto board =
      evaluation::leaderboard_of(read_all({folder("poor"), folder("floor"), folder("good")}));
  ASSERT_TRUE(board.ok()) << to_string(board.error());
  ASSERT_EQ(board->tracks.size(), 1U);
  const auto& entries = board->tracks[0].entries;
  ASSERT_EQ(entries.size(), 3U);
  EXPECT_EQ(entries[0].policy, "oracle");
  EXPECT_EQ(entries[1].policy, "classical");
  EXPECT_TRUE(entries[2].floor && !entries[1].floor);
  EXPECT_EQ(entries[0].strict.number, 9);
  EXPECT_EQ(entries[0].stores, 2);
  EXPECT_FALSE(entries[0].to_best || entries[0].spl);
  ASSERT_TRUE(entries[1].to_best.has_value());
  EXPECT_EQ(entries[1].to_best->only_other, 5);
  EXPECT_NEAR(entries[1].to_best->p_strict, 0.0625, 1e-12);
  EXPECT_DOUBLE_EQ(entries[1].to_best->p_partial, 0.5) << "two stores: four ways, two as far";
  EXPECT_FALSE(entries[0].commit.empty());
}

TEST_F(Runs, RepetitionsAreSummedUp) {
  const episodes::EpisodeFile file = episodes_of_two_stores(10);
  ASSERT_TRUE(run_quickly(file, folder("1"), "oracle", "01234567").ok());
  ASSERT_TRUE(run_quickly(file, folder("2"), "oracle", "0123", {}, 2).ok());
  ASSERT_TRUE(run_quickly(file, folder("3"), "oracle", "012345", {}, 3).ok());
  ASSERT_TRUE(run_quickly(file, folder("floor"), "stop", "").ok());
  auto board = evaluation::leaderboard_of(
      read_all({folder("1"), folder("2"), folder("3"), folder("floor")}));
  ASSERT_TRUE(board.ok()) << to_string(board.error());
  const evaluation::LeaderboardTrack& track = board->tracks[0];
  ASSERT_EQ(track.repeated.size(), 1U) << "the floor was run once";
  EXPECT_EQ(track.repeated[0].repetitions, 3);
  EXPECT_NEAR(track.repeated[0].strict.mean, 0.6, 1e-12);
  EXPECT_NEAR(track.repeated[0].strict.deviation, 0.2, 1e-12);
  EXPECT_EQ(evaluation::spoken_entry(track.entries[1]), "oracle (repetition 3)");
  EXPECT_NE(evaluation::leaderboard_html(*board).find("3 repetitions: strict 60.0 ± 20.0"),
            std::string::npos);
  // The same one by two builds is not two of them.
  ASSERT_TRUE(run_quickly(file, folder("other build"), "oracle", "0").ok());
  board = evaluation::leaderboard_of(read_all({folder("1"), folder("2"), folder("other build")}));
  EXPECT_TRUE(board->tracks[0].repeated.empty());
}

TEST_F(Runs, ShardsOfTwoRepetitionsAreNotJoined) {
  const episodes::EpisodeFile file = episodes_of_two_stores(4);
  ASSERT_TRUE(run_quickly(file, folder("first"), "oracle", "0", {1, 2}).ok());
  ASSERT_TRUE(run_quickly(file, folder("second"), "oracle", "1", {2, 2}, 2).ok());
  const auto joined =
      evaluation::merge_folders({folder("first"), folder("second")}, folder("whole"));
  ASSERT_FALSE(joined.ok());
  EXPECT_EQ(joined.error().code, "results.not_comparable");
}

TEST_F(Runs, OfASetOfTheProgramSayWhich) {
  episodes::EpisodeFile file = episodes_of_two_stores(4);
  ASSERT_TRUE(run_quickly(file, folder("copy"), "stop", "").ok());
  file.set = "v1/checkout";
  ASSERT_TRUE(run_quickly(file, folder("first"), "oracle", "0", {1, 2}).ok());
  ASSERT_TRUE(run_quickly(file, folder("second"), "oracle", "1", {2, 2}).ok());
  const auto whole =
      evaluation::merge_folders({folder("first"), folder("second")}, folder("whole"));
  ASSERT_TRUE(whole.ok()) << to_string(whole.error());
  const auto board = evaluation::leaderboard_of(read_all({folder("whole")}));
  ASSERT_TRUE(board.ok()) << to_string(board.error());
  EXPECT_EQ(board->set, "v1/checkout");
  const std::string said = "episodes v1/checkout (" + board->episodes_hash + ")";
  EXPECT_NE(evaluation::leaderboard_html(*board).find(said), std::string::npos);
  const auto page = evaluation::runs_html(read_all({folder("whole")}), {});
  ASSERT_TRUE(page.ok()) << to_string(page.error());
  EXPECT_NE(page->find("file of " + said), std::string::npos);
  EXPECT_EQ(io::read_file(folder("copy") / "run.json").value().find("\"set\""), std::string::npos);
  const auto mixed = evaluation::leaderboard_of(read_all({folder("whole"), folder("copy")}));
  ASSERT_TRUE(mixed.ok()) << "the episodes are the same: " << to_string(mixed.error());
  EXPECT_FALSE(mixed->set.has_value());
}

TEST_F(Runs, SayWhatTheRankingLacks) {
  const episodes::EpisodeFile file = episodes_of_two_stores(4);
  ASSERT_TRUE(run_quickly(file, folder("good"), "oracle", "01").ok());
  ASSERT_TRUE(run_quickly(file, folder("floor"), "random", "").ok());
  const auto page = [&](const std::vector<fs::path>& folders) {
    return evaluation::leaderboard_html(evaluation::leaderboard_of(read_all(folders)).value());
  };
  const std::string alone = page({folder("good")}),
                    beside = page({folder("good"), folder("floor")});
  EXPECT_NE(alone.find("No blind floor is among them"), std::string::npos);
  EXPECT_NE(alone.find("Rankings use realism standard; these runs are of ideal."),
            std::string::npos);
  EXPECT_EQ(beside.find("No blind floor"), std::string::npos);
}

TEST_F(Runs, ThatAreNotWholeAreNotRanked) {
  const episodes::EpisodeFile file = episodes_of_two_stores(10);
  ASSERT_TRUE(run_quickly(file, folder("part"), "oracle", "0", {1, 4}).ok());
  const auto refused = evaluation::leaderboard_of(read_all({folder("part")}));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, "results.incomplete");
  EXPECT_NE(refused.error().message.find("of 10 episodes 7 have no result"), std::string::npos)
      << refused.error().message;
  EXPECT_NE(refused.error().message.find("merge"), std::string::npos);
  ASSERT_TRUE(run_quickly(file, folder("failed"), "oracle", "none can be run").ok());
  const auto failed = evaluation::leaderboard_of(read_all({folder("failed")}));
  ASSERT_FALSE(failed.ok());
  EXPECT_NE(failed.error().message.find("10 could not be run"), std::string::npos);
}

TEST_F(Runs, OfOtherEpisodesOrVersionsAreNotMixed) {
  ASSERT_TRUE(run_quickly(episodes_of_two_stores(10), folder("a"), "oracle", "0").ok());
  ASSERT_TRUE(run_quickly(episodes_of_two_stores(8), folder("b"), "stop", "").ok());
  const auto others = evaluation::leaderboard_of(read_all({folder("a"), folder("b")}));
  ASSERT_FALSE(others.ok());
  EXPECT_EQ(others.error().code, "results.not_comparable");
  ASSERT_TRUE(run_quickly(episodes_of_two_stores(10), folder("c"), "stop", "").ok());
  change(folder("c") / "run.json", "\"version\": \"0.", "\"version\": \"9.");
  const auto later = evaluation::leaderboard_of(read_all({folder("a"), folder("c")}));
  ASSERT_FALSE(later.ok());
  EXPECT_NE(later.error().message.find("version 9."), std::string::npos) << later.error().message;
  const auto twice = evaluation::leaderboard_of(read_all({folder("a"), folder("a")}));
  ASSERT_FALSE(twice.ok());
  EXPECT_EQ(twice.error().code, "usage.bad_flag");
}

TEST_F(Runs, OfAllShardsAreTheRunThatWasNotCut) {
  const episodes::EpisodeFile file = episodes_of_two_stores(10);
  ASSERT_TRUE(run_quickly(file, folder("whole"), "oracle", "1357").ok());
  std::vector<fs::path> parts;
  for (const int part : {3, 1, 2}) {
    parts.push_back(folder("part-" + std::to_string(part)));
    ASSERT_TRUE(run_quickly(file, parts.back(), "oracle", "1357", {part, 3}).ok());
  }
  const auto merged = evaluation::merge_runs(read_all(parts), folder("merged"));
  ASSERT_TRUE(merged.ok()) << to_string(merged.error());
  ASSERT_TRUE(evaluation::write_run(*merged).ok());
  for (const char* name : {"results.jsonl", "run.json"})
    EXPECT_EQ(io::read_file(folder("merged") / name).value(),
              io::read_file(folder("whole") / name).value());
  EXPECT_TRUE(evaluation::leaderboard_of(read_all({folder("merged")})).ok());
  EXPECT_EQ(evaluation::write_run(*merged).error().code, "store.exists");
}

TEST_F(Runs, ShardsThatDoNotFitAreNamed) {
  const episodes::EpisodeFile file = episodes_of_two_stores(10);
  ASSERT_TRUE(run_quickly(file, folder("1"), "oracle", "1", {1, 3}).ok());
  ASSERT_TRUE(run_quickly(file, folder("2"), "oracle", "1", {2, 3}).ok());
  ASSERT_TRUE(run_quickly(file, folder("half"), "oracle", "0", {1, 2}).ok());
  ASSERT_TRUE(run_quickly(file, folder("other"), "stop", "", {3, 3}).ok());
  const auto fault = [&](const std::vector<fs::path>& folders) {
    const auto merged = evaluation::merge_runs(read_all(folders), folder("out"));
    return merged.ok() ? Error{} : merged.error();
  };
  const Error missing = fault({folder("1"), folder("2")});
  EXPECT_EQ(missing.code, "results.incomplete");
  EXPECT_NE(missing.message.find("shards that lack some: 3/3"), std::string::npos)
      << missing.message;
  const Error overlap = fault({folder("1"), folder("half")});
  EXPECT_EQ(overlap.code, "results.overlap");
  EXPECT_NE(overlap.message.find(folder("1").string()), std::string::npos) << overlap.message;
  EXPECT_EQ(fault({folder("1"), folder("other")}).code, "results.not_comparable");
  change(folder("2") / "run.json", "\"commits\": [\"", "\"commits\": [\"x");
  EXPECT_NE(fault({folder("1"), folder("2")}).message.find("is of commit x"), std::string::npos);
}

// ---- Files that are not as they were written. ----

std::string fault_of(const fs::path& folder) {
  const auto run = evaluation::read_run(folder);
  return run.ok() ? "none" : run.error().code;
}

TEST_F(Runs, ThatWereChangedAreRefused) {
  const episodes::EpisodeFile file = episodes_of_two_stores(3);
  const auto again = [&](const std::string& name) {
    EXPECT_TRUE(run_quickly(file, folder(name), "oracle", "0").ok());
    return folder(name) / "results.jsonl";
  };
  fs::path results = again("twice");
  const std::string text = io::read_file(results).value(),
                    line = text.substr(0, text.find('\n') + 1);
  ASSERT_TRUE(io::write_file(results, text + line).ok());
  EXPECT_EQ(fault_of(folder("twice")), "results.duplicate_id");
  EXPECT_EQ(evaluation::read_run(results).error().where, results.string() + ":4");
  ASSERT_TRUE(io::write_file(again("cut"), text.substr(0, text.size() - 9)).ok());
  EXPECT_EQ(fault_of(folder("cut")), "results.truncated");
  change(again("schema"), "market-result/1", "market-result/2");
  EXPECT_EQ(fault_of(folder("schema")), "json.wrong_schema");
  change(again("hash"), "\"episode_hash\": \"", "\"episode_hash\": \"0");
  EXPECT_EQ(fault_of(folder("hash")), "results.changed");
  change(again("id"), "episode-1", "episode-7");
  EXPECT_EQ(fault_of(folder("id")), "results.changed");
  fs::remove(again("record").parent_path() / "run.json");
  EXPECT_EQ(fault_of(folder("record")), "results.no_record");
  EXPECT_EQ(fault_of(folder("nowhere")), "input.not_found");
}

// Results that were kept say which program made them; of an earlier version that is unknown.
TEST_F(Runs, ThatAreGoneOnWithNameEveryCommit) {
  const episodes::EpisodeFile file = episodes_of_two_stores(3);
  ASSERT_TRUE(run_quickly(file, folder("a"), "oracle", "0").ok());
  const std::string now = evaluation::read_record(folder("a"))->commit();
  evaluation::EvaluationOptions options{"oracle", folder("a"), true, 1};
  const auto go_on = [&] {
    const auto all = evaluation::evaluate_with(
        file, options, [] { return evaluation::EpisodeRunner(); }, silent_progress());
    EXPECT_TRUE(all.ok());
    return evaluation::read_record(folder("a"))->commit();
  };
  EXPECT_EQ(go_on(), now);
  fs::remove(folder("a") / "run.json");
  EXPECT_EQ(go_on(), now == "unknown" ? now : "unknown, " + now);
  options.shard = {2, 2};
  const auto refused = evaluation::evaluate_with(
      file, options, [] { return evaluation::EpisodeRunner(); }, silent_progress());
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().where, "--shard");
}

TEST(Shards, AreReadAsPartOfAWhole) {
  EXPECT_EQ(evaluation::read_shard("2/4").value(), (evaluation::Shard{2, 4}));
  for (const char* text : {"", "2", "0/4", "5/4", "2/", "/4", "a/b", "2/4x", "-1/4"})
    EXPECT_FALSE(evaluation::read_shard(text).ok()) << text;
}

}  // namespace
}  // namespace marketgen
