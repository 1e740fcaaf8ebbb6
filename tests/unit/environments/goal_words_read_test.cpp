// Words as episodes have them, read by the catalogue's words alone: writer and reader have no table
// in common.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "environments/episode_ground.h"
#include "episodes/episode_origin.h"
#include "episodes/referring_expression.h"
#include "perception/goal_reader.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

struct ReadShares {
  int told = 0, right = 0, among_ties = 0, not_understood = 0, untold = 0;
};

// Of every n-th product of the stock two texts, read among all of it.
ReadShares read_shares(const std::vector<catalog::Product>& stock, std::size_t every = 1) {
  const episodes::Offer offer(stock);
  const perception::CatalogueReader reader(stock, committed_catalog().search_lexicon);
  ReadShares shares;
  for (std::size_t number = 0; number < offer.size(); number += every) {
    for (const int count : {1, 2}) {
      const auto told = episodes::refer_to(
          offer, number, count, Seed(static_cast<std::uint64_t>(count)).child(stock[number].sku));
      if (!told) {
        ++shares.untold;
        continue;
      }
      ++shares.told;
      const auto skus = reader.read(told->text);
      if (!skus.ok()) {
        ++shares.not_understood;
        continue;
      }
      const bool is_first = skus->front() == stock[number].sku;
      shares.right += is_first ? 1 : 0;
      shares.among_ties += !is_first && std::ranges::count(*skus, stock[number].sku) > 0 ? 1 : 0;
    }
  }
  return shares;
}

// Measured on 26 November 2026: see docs/episodes.md, "Instructions in words".
TEST(GoalWords, AreReadRightAmongTheWholeCatalogue) {
  const ReadShares shares = read_shares(committed_catalog().products, 20);
  std::printf("told %d, untold %d, right %d, among ties %d, not understood %d\n",
              shares.told,
              shares.untold,
              shares.right,
              shares.among_ties,
              shares.not_understood);
  EXPECT_GT(shares.told, 250);
  EXPECT_GE(shares.right, shares.told * 95 / 100);
  EXPECT_EQ(shares.not_understood, 0);
}

// What a store sells is less, and less alike.
TEST(GoalWords, AreReadRightOverAStoresStock) {
  const auto ground = environments::EpisodeGround::of_pool(episodes::Track::checkout);
  ASSERT_TRUE(ground.ok()) << to_string(ground.error());
  for (const episodes::EpisodeStore& store : (*ground)->stores()) {
    const auto stock = (*ground)->arena().stock(store.scene_hash);
    ASSERT_TRUE(stock.ok()) << to_string(stock.error());
    const ReadShares shares = read_shares(**stock);
    std::printf("%s: told %d, untold %d, right %d, among ties %d, not understood %d\n",
                store.name.c_str(),
                shares.told,
                shares.untold,
                shares.right,
                shares.among_ties,
                shares.not_understood);
    EXPECT_GE(shares.right, shares.told * 97 / 100) << store.name;
    EXPECT_EQ(shares.not_understood, 0);
  }
}

}  // namespace
}  // namespace marketgen
