// Tables for papers, of made-up results with known answers.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "evaluation/differences_table.h"
#include "evaluation/paired_tests.h"
#include "evaluation/tracks_table.h"
#include "io/csv.h"
#include "io/file.h"

namespace marketgen {
namespace {

using evaluation::FinishedRun;

// One goal an episode, two stores in turn; `scores`: a digit each, 1 for reached.
FinishedRun run_of(episodes::Track track, const std::string& policy, const std::string& scores) {
  FinishedRun run;
  run.folder = fmt::format("{}-{}", policy, name_of(track));
  run.record.policy = policy;
  run.record.version = "1.0";
  run.record.commits = {"abc"};
  run.record.episodes_hash = fmt::format("{} {}", name_of(track), scores.size());
  for (std::size_t i = 0; i < scores.size(); ++i) {
    episodes::EpisodeResult result;
    result.episode = "episode-" + std::to_string(i);
    result.scene_hash = i % 2 == 0 ? "first" : "second";
    result.policy = policy;
    if (track == episodes::Track::aisle) result.shortest_m = 5, result.path_m = 10;
    const int reached = scores[i] - '0';
    episodes::add_outcome({{{"can-cola", 1, reached}}, 1, reached}, result);
    result.spl = result.success_partial / 2;
    run.record.episodes.push_back({result.episode, "hash", track});
    run.results.push_back(result);
  }
  return run;
}

evaluation::Published paper() {
  return evaluation::load_published(io::data_folder().value()).value();
}

TEST(TracksTable, PutsBothTracksBesideWhatIsPublished) {
  using enum episodes::Track;
  const auto table = evaluation::tracks_table({run_of(checkout, "stop", "0000"),
                                               run_of(aisle, "stop", "0000"),
                                               run_of(aisle, "ours", "1000"),
                                               run_of(checkout, "ours", "1110")},
                                              paper());
  ASSERT_TRUE(table.ok()) << to_string(table.error());
  ASSERT_EQ(table->rows.size(), 6U);
  const evaluation::TracksRow& ours = table->rows[0];
  EXPECT_EQ(ours.policy, "ours");
  EXPECT_DOUBLE_EQ(ours.overall.value().value, 0.5);
  EXPECT_LT(ours.overall->low.value(), 0.5);
  EXPECT_GT(ours.overall->high.value(), 0.5);
  EXPECT_EQ(ours.tracks[0].track, aisle) << "as they were named";
  EXPECT_DOUBLE_EQ(ours.tracks[0].spl.value().value, 0.125);
  EXPECT_DOUBLE_EQ(ours.tracks[0].path_m.value().value, 10);
  EXPECT_FALSE(ours.tracks[1].path_m.has_value());
  EXPECT_TRUE(table->rows[1].floor);
  EXPECT_EQ(table->rows[2].policy, "GPT-4o");
  EXPECT_FALSE(table->rows[2].overall.value().low.has_value());
}

// What is published is what the paper prints: its overall is the mean of its tracks.
TEST(TracksTable, OverallOfThePaperIsTheMeanOfItsTracks) {
  for (const evaluation::PublishedPolicy& policy : paper().policies) {
    double sum = 0;
    for (const evaluation::PublishedTrack& track : policy.tracks)
      sum += track.sr;
    EXPECT_NEAR(sum / 2, policy.overall_sr, 1e-4) << policy.policy;
  }
}

TEST(TracksTable, RunsThatDoNotBelongTogetherAreRefused) {
  using enum episodes::Track;
  const auto code = [](const std::vector<FinishedRun>& runs) {
    const auto table = evaluation::tracks_table(runs, paper());
    return table.ok() ? "" : table.error().code;
  };
  EXPECT_EQ(code({}), "usage.bad_flag");
  EXPECT_EQ(code({run_of(aisle, "a", "1"), run_of(aisle, "a", "1")}), "usage.bad_flag");
  EXPECT_EQ(code({run_of(aisle, "a", "1"), run_of(aisle, "b", "11")}), "results.not_comparable");
  FinishedRun noisy = run_of(checkout, "a", "1");
  noisy.record.realism = "hard";
  EXPECT_EQ(code({run_of(aisle, "a", "1"), noisy}), "results.not_comparable");
  FinishedRun part = run_of(aisle, "a", "11");
  part.results.pop_back();
  EXPECT_EQ(code({part}), "results.incomplete");
}

TEST(DifferencesTable, SaysWhatTrueModulesAreWorth) {
  using enum episodes::Track;
  const auto table = evaluation::differences_table({run_of(checkout, "classical+target", "111000"),
                                                    run_of(checkout, "classical", "100000"),
                                                    run_of(checkout, "classical+grasp", "100000")},
                                                   evaluation::Varied::truth);
  ASSERT_TRUE(table.ok()) << to_string(table.error());
  ASSERT_EQ(table->tracks.size(), 1U);
  const auto& rows = table->tracks[0].rows;
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].run, "");
  EXPECT_FALSE(rows[0].gain.has_value());
  EXPECT_EQ(rows[1].run, "+grasp");
  EXPECT_DOUBLE_EQ(rows[1].gain.value().value, 0);
  EXPECT_DOUBLE_EQ(rows[1].p_strict.value(), 1);
  EXPECT_NEAR(rows[2].gain.value().value, 2 / 6.0, 1e-12);
  EXPECT_DOUBLE_EQ(rows[2].p_strict.value(), 1) << "two episodes: 0.5, of two rows";
}

TEST(DifferencesTable, NeedsSomethingToCompareWith) {
  using enum episodes::Track;
  const auto code = [](const std::vector<FinishedRun>& runs, evaluation::Varied varied) {
    const auto table = evaluation::differences_table(runs, varied);
    return table.ok() ? "" : table.error().code;
  };
  using evaluation::Varied;
  const FinishedRun plain = run_of(aisle, "classical", "10"),
                    target = run_of(aisle, "classical+target", "11");
  EXPECT_EQ(code({}, Varied::truth), "usage.bad_flag");
  EXPECT_EQ(code({plain}, Varied::truth), "usage.bad_flag");
  EXPECT_EQ(code({target}, Varied::truth), "usage.bad_flag");
  EXPECT_EQ(code({plain, plain, target}, Varied::truth), "usage.bad_flag");
  EXPECT_EQ(code({plain, run_of(aisle, "oracle", "11")}, Varied::truth), "results.not_comparable");
  FinishedRun noisy = plain;
  noisy.record.realism = "standard";
  EXPECT_EQ(code({plain, noisy}, Varied::truth), "results.not_comparable");
  EXPECT_EQ(code({plain, noisy}, Varied::realism), "");
  EXPECT_EQ(code({target, noisy}, Varied::realism), "results.not_comparable");
}

TEST(Holm, CorrectsForHowManyTestsThereAre) {
  // By hand: 0.01 * 4, then 0.02 * 3, 0.03 * 2 (not below the one before), 0.5.
  const std::vector<double> corrected = evaluation::holm({0.03, 0.01, 0.5, 0.02});
  const std::vector<double> expected{0.06, 0.04, 0.5, 0.06};
  ASSERT_EQ(corrected.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(corrected[i], expected[i], 1e-12);
  EXPECT_DOUBLE_EQ(evaluation::holm({0.6, 0.7})[0], 1);
  EXPECT_TRUE(evaluation::holm({}).empty());
}

TEST(TextTable, IsWrittenForPeopleAndPapers) {
  using enum evaluation::TableFormat;
  const evaluation::TextTable table{
      {"policy", "SR %"}, {{"a|b_c", "1.0 (0.5, 2)"}, {"long name ü", "2"}}, {"a note"}};
  EXPECT_EQ(evaluation::written(table, text),
            "policy       SR %\na|b_c        1.0 (0.5, 2)\nlong name ü  2\na note\n");
  EXPECT_EQ(evaluation::written(table, markdown),
            "| policy | SR % |\n| --- | --- |\n| a\\|b\\_c | 1.0 (0.5, 2) |\n| long name ü | 2 "
            "|\n\na note\n");
  const std::string tabular = evaluation::written(table, latex);
  EXPECT_NE(tabular.find("policy & SR \\% \\\\\n"), std::string::npos) << tabular;
  EXPECT_NE(tabular.find("a|b\\_c & 1.0 (0.5, 2) \\\\\n"), std::string::npos) << tabular;
  const auto rows = io::parse_csv(evaluation::written(table, csv), "table.csv");
  ASSERT_TRUE(rows.ok());
  ASSERT_EQ(rows->size(), 3U);
  EXPECT_EQ((*rows)[1].fields[1], "1.0 (0.5, 2)");
}

}  // namespace
}  // namespace marketgen
