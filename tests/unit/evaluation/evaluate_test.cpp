// Runs of many episodes: kept as they finish, gone on with after a break.
#include "evaluation/evaluate.h"

#include <gtest/gtest.h>

#include "drawn_checkout.h"
#include "io/file.h"
#include "io/json.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

// The same basket three times, a second each.
EpisodeFile three_episodes() {
  EpisodeFile file;
  file.header.products = checkout_goods_rows();
  EpisodeSpec spec = drawn(7, 0);
  spec.limit_s = 1;
  for (const char* id : {"a", "b", "c"}) {
    spec.id = id;
    ++spec.seed;
    file.episodes.push_back(spec);
  }
  return file;
}

Result<std::vector<EpisodeResult>> evaluated(const EpisodeFile& file,
                                             const std::filesystem::path& folder,
                                             bool resume) {
  return evaluate(
      data_rows(), file, committed_catalog(), {"random", folder, resume}, silent_progress());
}

TEST(Evaluate, ABrokenRunGoesOnAndKeepsWhatWasFinished) {
  const EpisodeFile file = three_episodes();
  const ScratchFolder scratch;
  const auto whole = evaluated(file, scratch.path() / "whole", false);
  ASSERT_TRUE(whole.ok()) << to_string(whole.error());
  ASSERT_EQ(whole->size(), 3U);
  EXPECT_NE((*whole)[0].state_hash, (*whole)[1].state_hash) << "each draws its own steps";
  EXPECT_EQ((*whole)[0].failure, FailureCode::timeout);

  // As kill -9 leaves it: the second episode finished, with a mark; the first in the middle of its
  // line.
  EpisodeResult marked = (*whole)[1];
  marked.detail = "of the first run";
  const std::filesystem::path broken = scratch.path() / "broken";
  std::filesystem::create_directories(broken);
  const std::string half = write_json_line((*whole)[0]).substr(0, 40);
  ASSERT_TRUE(write_file(broken / "results.jsonl", write_json_line(marked) + "\n" + half).ok());
  const auto resumed = evaluated(file, broken, true);
  ASSERT_TRUE(resumed.ok()) << to_string(resumed.error());
  ASSERT_EQ(resumed->size(), 3U);
  EXPECT_EQ((*resumed)[1].detail, "of the first run") << "it was run again";
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ((*resumed)[i].state_hash, (*whole)[i].state_hash);
  EXPECT_TRUE(std::filesystem::exists(broken / "summary.json"));
}

TEST(Evaluate, ResultsAreNotOverwritten) {
  const ScratchFolder scratch;
  ASSERT_TRUE(write_file(scratch.path() / "results.jsonl", "").ok());
  const auto refused = evaluated(three_episodes(), scratch.path(), false);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, "store.exists");
}

// A folder's results belong to its file: with another one they would be lost at the end.
TEST(Evaluate, ResultsOfOtherEpisodesAreKept) {
  const ScratchFolder scratch;
  EpisodeResult other;
  other.episode = "of-another-file";
  other.policy = "random";
  const std::string line = write_json_line(other) + "\n";
  ASSERT_TRUE(write_file(scratch.path() / "results.jsonl", line).ok());
  const auto refused = evaluated(three_episodes(), scratch.path(), true);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, "usage.bad_flag");
  EXPECT_EQ(read_file(scratch.path() / "results.jsonl").value(), line);
}

}  // namespace
}  // namespace marketgen
