// Tables for papers, of made-up results with known answers.
#include <gtest/gtest.h>

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "evaluation/differences_table.h"
#include "evaluation/paired_tests.h"
#include "evaluation/shapes_table.h"
#include "evaluation/table_remarks.h"
#include "evaluation/tracks_table.h"
#include "io/csv.h"
#include "io/file.h"
#include "support/committed_catalog.h"

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

std::string notes_of(const evaluation::TextTable& table) {
  return fmt::format("{}", fmt::join(table.notes, "\n"));
}

std::vector<FinishedRun> at_realism(std::vector<FinishedRun> runs, const std::string& realism) {
  for (FinishedRun& run : runs)
    run.record.realism = realism;
  return runs;
}

TEST(TableRemarks, AreOfWhatIsNotThere) {
  const std::vector<std::string> both = evaluation::table_remarks(false, "ideal");
  ASSERT_EQ(both.size(), 2U);
  EXPECT_NE(both[0].find("No blind floor is among them"), std::string::npos);
  EXPECT_EQ(both[1], "Rankings use realism standard; these runs are of ideal.");
  EXPECT_EQ(evaluation::table_remarks(true, "hard").size(), 1U);
  EXPECT_TRUE(evaluation::table_remarks(true, "standard").empty());
}

TEST(TableRemarks, StandBelowTablesOfTracksAndShapes) {
  using enum episodes::Track;
  const std::vector<FinishedRun> alone{run_of(aisle, "ours", "10")};
  std::vector<FinishedRun> ranked{run_of(aisle, "ours", "10"), run_of(aisle, "random", "00")};
  ranked = at_realism(ranked, "standard");
  const auto tracks = [&](const std::vector<FinishedRun>& runs) {
    return notes_of(text_of(evaluation::tracks_table(runs, paper()).value()));
  };
  const auto shapes = [&](const std::vector<FinishedRun>& runs) {
    return notes_of(text_of(evaluation::shapes_table(runs, committed_catalog(), paper()).value()));
  };
  for (const std::string& notes : {tracks(alone), shapes(alone)}) {
    EXPECT_NE(notes.find("No blind floor is among them"), std::string::npos) << notes;
    EXPECT_NE(notes.find("Rankings use realism standard"), std::string::npos) << notes;
  }
  for (const std::string& notes : {tracks(ranked), shapes(ranked)}) {
    EXPECT_EQ(notes.find("No blind floor"), std::string::npos) << notes;
    EXPECT_EQ(notes.find("Rankings use"), std::string::npos) << notes;
  }
}

// The file has sources of generators, too.
TEST(TableRemarks, SourcesAreThoseOfTheRows) {
  const std::vector<robots::SourceRow> sources{{"a", "A."}, {"b", "B."}, {"c", "C."}};
  const auto cited = evaluation::cited_sources(sources, {"", "c a", "a"});
  ASSERT_EQ(cited.size(), 2U);
  EXPECT_EQ(cited[0].key, "a");
  EXPECT_EQ(cited[1].key, "c");
  const evaluation::Published published = paper();
  const auto table =
      evaluation::tracks_table({run_of(episodes::Track::aisle, "ours", "10")}, published);
  ASSERT_TRUE(table.ok());
  EXPECT_GE(table->sources.size(), 1U);
  EXPECT_LT(table->sources.size(), published.sources.size());
  const std::string notes = notes_of(text_of(*table));
  for (const robots::SourceRow& source : published.sources) {
    const bool shown = std::ranges::any_of(table->rows, [&](const evaluation::TracksRow& row) {
      return row.source.find(source.key) != std::string::npos;
    });
    EXPECT_EQ(notes.find("[" + source.key + "]") != std::string::npos, shown) << source.key;
  }
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

// ---- Shapes ----

TEST(PackShape, IsWhatPeopleCallTheContainer) {
  using enum evaluation::PackShape;
  EXPECT_EQ(evaluation::pack_shape("wine_bottle"), bottles);
  EXPECT_EQ(evaluation::pack_shape("food_tin"), cans);
  EXPECT_EQ(evaluation::pack_shape("gable_carton"), boxes);
  EXPECT_EQ(evaluation::pack_shape("pillow_bag"), bags);
  EXPECT_FALSE(evaluation::pack_shape("jar").has_value());
  EXPECT_FALSE(evaluation::pack_shape("aerosol").has_value());
}

TEST(Correlation, HasKnownValues) {
  const std::vector<double> sim{0.55, 0.45, 0.25, 0}, real{0.5, 0.45, 0.15, 0};
  // NumPy 2: numpy.corrcoef(sim, real)[0, 1]
  EXPECT_NEAR(evaluation::pearson(sim, real).value(), 0.9804, 1e-4);
  EXPECT_DOUBLE_EQ(evaluation::mean_max_rank_violation(real, sim), 0);
  const std::vector<double> swapped{0.45, 0.5, 0.15, 0};  // the first two, 0.05 apart
  EXPECT_NEAR(evaluation::mean_max_rank_violation(real, swapped), 0.025, 1e-12);
  const std::vector<double> flat(4, 0.3);
  EXPECT_FALSE(evaluation::pearson(real, flat).has_value());
  EXPECT_FALSE(evaluation::pearson(std::vector{1.0}, std::vector{1.0}).has_value());
}

// The first products of the catalogue that have a shape.
std::string sku_of(evaluation::PackShape shape) {
  for (const catalog::Product& product : committed_catalog().products)
    if (evaluation::pack_shape(product.archetype) == shape) return product.sku;
  return "";
}

TEST(ShapesTable, CountsTriesByShapeBesideWhatIsPublished) {
  using enum episodes::Track;
  FinishedRun far = run_of(aisle, "ours", "1101"), near = run_of(checkout, "ours", "0100");
  for (std::size_t i = 0; i < 4; ++i) {
    far.results[i].goals[0].sku = sku_of(static_cast<evaluation::PackShape>(i));
    near.results[i].goals[0].sku = sku_of(evaluation::PackShape::cans);
  }
  const auto table = evaluation::shapes_table({far, near}, committed_catalog(), paper());
  ASSERT_TRUE(table.ok()) << to_string(table.error());
  ASSERT_EQ(table->rows.size(), 3U);
  const evaluation::ShapesRow& ours = table->rows[0];
  EXPECT_EQ(ours.who, "ours");
  ASSERT_EQ(ours.shapes.size(), 4U);
  EXPECT_EQ(ours.shapes[1].tries, 5);
  EXPECT_DOUBLE_EQ(ours.shapes[1].share.value, 0.4);
  EXPECT_DOUBLE_EQ(ours.shapes[2].share.value, 0);
  EXPECT_EQ(ours.agreement.size(), 2U);
  ASSERT_EQ(table->rows[1].agreement.size(), 1U) << "not with itself";
  EXPECT_NEAR(table->rows[1].agreement[0].pearson.value(), 0.9804, 1e-4);
  const std::string text =
      evaluation::written(evaluation::text_of(*table), evaluation::TableFormat::text);
  EXPECT_NE(text.find("of 20"), std::string::npos) << text;
}

TEST(ShapesTable, ShapesThatWereNotTriedAreLeftOut) {
  const FinishedRun run = run_of(episodes::Track::aisle, "ours", "10");
  const auto table = evaluation::shapes_table({run}, committed_catalog(), paper());
  ASSERT_TRUE(table.ok()) << to_string(table.error());
  EXPECT_LE(table->rows[0].shapes.size(), 1U);
  EXPECT_EQ(evaluation::shapes_table({}, committed_catalog(), paper()).error().code,
            "usage.bad_flag");
}

}  // namespace
}  // namespace marketgen
