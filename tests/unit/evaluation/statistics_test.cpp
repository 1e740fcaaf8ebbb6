// Intervals, tests and power against values worked out by hand or published.
#include <gtest/gtest.h>

#include <algorithm>

#include "evaluation/paired_tests.h"
#include "evaluation/power_table.h"
#include "evaluation/store_bootstrap.h"

namespace marketgen {
namespace {

using evaluation::ScoredEpisode;

std::vector<ScoredEpisode> episodes_of(const std::string& store, int solved, int all) {
  std::vector<ScoredEpisode> episodes;
  for (int i = 0; i < all; ++i)
    episodes.push_back({store, i < solved ? 1.0 : 0.0});
  return episodes;
}

std::vector<ScoredEpisode> joined(std::vector<ScoredEpisode> a, std::vector<ScoredEpisode> b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// A quarter of the draws has the good store twice, a quarter the bad one: 0 to 1, however many
// episodes there are. Wilson would say 0.40 to 0.60 of 100.
TEST(StoreBootstrap, IsAsWideAsStoresDiffer) {
  const auto estimate =
      evaluation::estimate_of(joined(episodes_of("a", 50, 50), episodes_of("b", 0, 50)));
  EXPECT_DOUBLE_EQ(estimate.value, 0.5);
  EXPECT_DOUBLE_EQ(estimate.low, 0);
  EXPECT_DOUBLE_EQ(estimate.high, 1);
}

// Half of 100 independent draws: the binomial distribution's 2.5 % and 97.5 % are 40 and 60.
TEST(StoreBootstrap, OfOneStoreDrawsItsEpisodes) {
  const auto estimate = evaluation::estimate_of(episodes_of("a", 50, 100));
  EXPECT_DOUBLE_EQ(estimate.value, 0.5);
  EXPECT_NEAR(estimate.low, 0.40, 0.0101);
  EXPECT_NEAR(estimate.high, 0.60, 0.0101);
}

// Three stores, one of them solved: of 27 equally likely draws 8 have it never, 12 once, 6 twice
// and 1 thrice, which is 3.7 % and so within 97.5 %.
TEST(StoreBootstrap, OfThreeStoresIsWorkedOutByHand) {
  auto episodes = joined(episodes_of("a", 4, 4), episodes_of("b", 0, 4));
  episodes = joined(episodes, episodes_of("c", 0, 4));
  const auto estimate = evaluation::estimate_of(episodes);
  EXPECT_DOUBLE_EQ(estimate.value, 1.0 / 3);
  EXPECT_DOUBLE_EQ(estimate.low, 0);
  EXPECT_DOUBLE_EQ(estimate.high, 1);
}

TEST(StoreBootstrap, DoesNotDependOnTheOrder) {
  auto episodes = joined(episodes_of("a", 7, 20), episodes_of("b", 3, 30));
  episodes = joined(episodes, episodes_of("c", 11, 12));
  const auto estimate = evaluation::estimate_of(episodes);
  std::ranges::reverse(episodes);
  const auto again = evaluation::estimate_of(episodes);
  EXPECT_EQ(estimate.low, again.low);
  EXPECT_EQ(estimate.high, again.high);
  EXPECT_LT(estimate.low, estimate.value);
  EXPECT_GT(estimate.high, estimate.value);
}

// Goals, not episodes, are what weighs: 1 of 1 and 0 of 3 is a quarter.
TEST(StoreBootstrap, WeighsByGoals) {
  EXPECT_DOUBLE_EQ(evaluation::estimate_of({{"a", 1, 1}, {"a", 0, 3}}).value, 0.25);
  EXPECT_DOUBLE_EQ(evaluation::estimate_of({}).high, 0);
}

// 2 (1 + 9) / 512; 2 / 32; nothing that differs.
TEST(PairedTests, McNemarIsExact) {
  EXPECT_NEAR(evaluation::mcnemar_exact(1, 8), 0.0390625, 1e-12);
  EXPECT_NEAR(evaluation::mcnemar_exact(5, 0), 0.0625, 1e-12);
  EXPECT_DOUBLE_EQ(evaluation::mcnemar_exact(4, 4), 1);
  EXPECT_DOUBLE_EQ(evaluation::mcnemar_exact(0, 0), 1);
  EXPECT_LT(evaluation::mcnemar_exact(0, 2000), 1e-100);
}

// Of three stores' signs 8 ways, of which all plus and all minus are as far; 3 - 1 is no farther
// than any other.
TEST(PairedTests, SignFlipsGoThroughAllWays) {
  EXPECT_DOUBLE_EQ(evaluation::sign_flip_test({1, 1, 1}), 0.25);
  EXPECT_DOUBLE_EQ(evaluation::sign_flip_test({0.1, 0.2, 0.3}), 0.25);
  EXPECT_DOUBLE_EQ(evaluation::sign_flip_test({3, -1}), 1);
  EXPECT_DOUBLE_EQ(evaluation::sign_flip_test({0, 0, 0, 0}), 1);
  EXPECT_DOUBLE_EQ(evaluation::sign_flip_test({}), 1);
}

// Beyond 13 stores ways are drawn. Of 16 ones with 12 plus and 4 minus, |sum| >= 8 in
// 2 (1 + 16 + 120 + 560 + 1820) / 65536 = 7.68 % of the ways.
TEST(PairedTests, SignFlipsOfManyStoresAreDrawn) {
  std::vector<double> sums(12, 1);
  sums.resize(16, -1);
  EXPECT_NEAR(evaluation::sign_flip_test(sums), 0.0768, 0.01);
  EXPECT_NEAR(evaluation::sign_flip_test(std::vector<double>(100, 1)), 1.0 / 10'001, 1e-12);
}

TEST(PowerTable, LikenessIsThatOfAnalysisOfVariance) {
  const auto all_alike = joined(episodes_of("a", 2, 2), episodes_of("b", 0, 2));
  EXPECT_DOUBLE_EQ(evaluation::likeness_in_stores(all_alike), 1);
  const auto not_alike = joined(episodes_of("a", 1, 2), episodes_of("b", 1, 2));
  EXPECT_DOUBLE_EQ(evaluation::likeness_in_stores(not_alike), 0);
  // 3 of 4 and 1 of 4: between 0.5, within 1.5 / 6, four a store: 0.25 / (0.5 + 3 * 0.25) = 0.2.
  const auto partly = joined(episodes_of("a", 3, 4), episodes_of("b", 1, 4));
  EXPECT_NEAR(evaluation::likeness_in_stores(partly), 0.2, 1e-12);
  EXPECT_DOUBLE_EQ(evaluation::likeness_in_stores(episodes_of("a", 1, 9)), 0);
}

// 0.5 against 0.6 takes 388 a group, against 0.7 93 (Fleiss 1981, without the correction).
TEST(PowerTable, OfTwoRunsIsTheTextbooks) {
  const auto rows = evaluation::power_of_two_runs(0.5, {1, 0});
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[2].episodes, 388);
  EXPECT_EQ(rows[3].episodes, 93);
  EXPECT_GT(rows[0].episodes, rows[1].episodes);
}

// 20 episodes a store that are 0.1 alike weigh as 1 / 2.9 each.
TEST(PowerTable, AlikeEpisodesAskForMoreOfThem) {
  const auto rows = evaluation::power_of_two_runs(0.5, {20, 0.1});
  EXPECT_EQ(rows[2].episodes, 1124);  // 387.3 * 2.9 = 1123.3
  EXPECT_EQ(rows[2].stores, 57);
}

// (1.96 sqrt(0.3) + 0.8416 sqrt(0.29))^2 / 0.01 = 233.1
TEST(PowerTable, OfPairsCountsOnlyWhatDiffers) {
  EXPECT_EQ(evaluation::power_of_pairs(0.3, {1, 0})[2].episodes, 234);
  EXPECT_LT(evaluation::power_of_pairs(0.1, {1, 0})[2].episodes, 100);
  EXPECT_GT(evaluation::power_of_pairs(0, {1, 0})[3].episodes, 0);
}

}  // namespace
}  // namespace marketgen
