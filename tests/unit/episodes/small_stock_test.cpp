// Stores with few kinds of goods have baskets, too, and the first task for a learner.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

#include "episodes/checkout/sample_checkout.h"
#include "episodes/checkout/sample_one_item.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

const std::filesystem::path small_stock_data = std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data";
const episodes::EpisodeOrigin kiosk_origin{"kiosk", "scene", "plan"};

// So many of the goods that a gripper takes out of a basket, of different shapes.
std::vector<catalog::Product> stock_of(std::size_t kinds) {
  std::vector<catalog::Product> goods;
  std::set<std::string> shapes;
  for (const catalog::Product& product : committed_catalog().products) {
    if (goods.size() == kinds) break;
    if (episodes::is_checkout_item(product) &&
        (goods.size() >= 3 || shapes.insert(product.archetype).second))
      goods.push_back(product);
  }
  return goods;
}

TEST(SlowSmallStock, BasketsAreAsSmallAsItIs) {
  for (const std::size_t kinds : {2U, 6U, 11U}) {
    const auto stock = stock_of(kinds);
    ASSERT_EQ(stock.size(), kinds);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const auto spec = episodes::sample_checkout(
          small_stock_data, stock, committed_catalog().frictions, kiosk_origin, Seed(seed), 0);
      ASSERT_TRUE(spec.ok()) << to_string(spec.error());
      EXPECT_LE(spec->items.size(), kinds + 1);  // of one target there may be two
      EXPECT_GE(spec->items.size(), 2U);
      EXPECT_GE(spec->goals.size(), 1U);
      EXPECT_LT(spec->goals.size(), spec->items.size());
      std::map<std::string, int> counts, asked;
      for (const episodes::EpisodeItem& item : spec->items)
        ++counts[item.sku];
      for (const episodes::EpisodeGoal& goal : spec->goals)
        asked[goal.sku] = goal.count;
      for (const auto& [sku, count] : counts)
        EXPECT_EQ(count, asked.contains(sku) ? asked[sku] : 1) << sku;
    }
  }
}

TEST(SmallStock, OneKindIsTooFewAndSaid) {
  const auto spec = episodes::sample_checkout(
      small_stock_data, stock_of(1), committed_catalog().frictions, kiosk_origin, Seed(1), 0);
  ASSERT_FALSE(spec.ok());
  EXPECT_EQ(spec.error().code, "episode.impossible");
  EXPECT_NE(spec.error().message.find("1 products"), std::string::npos);
}

TEST(OneItem, StandsWithinItsPlaceAtRest) {
  const episodes::CheckoutStation station =
      episodes::load_checkout_station(small_stock_data, episodes::one_item_station).value();
  std::vector<catalog::Product> stock;
  for (const catalog::Product& product : committed_catalog().products)
    if (episodes::is_one_item(product)) stock.push_back(product);
  ASSERT_GT(stock.size(), 3U);
  episodes::CheckoutWorld world =
      episodes::CheckoutWorld::create(
          small_stock_data, committed_catalog().frictions, episodes::one_item_station)
          .value();
  std::set<std::string> drawn;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const auto spec =
        episodes::sample_one_item(small_stock_data, stock, kiosk_origin, Seed(seed), 0);
    ASSERT_TRUE(spec.ok()) << to_string(spec.error());
    drawn.insert(spec->goals[0].sku);
    ASSERT_TRUE(world.reset(*spec, stock).ok());
    const Vec3 before = world.item_pose(0).position;
    EXPECT_TRUE(station.set_aside.holds(before.x, before.y));
    EXPECT_FALSE(station.unloading.area().holds(before.x, before.y));
    const agent::Action wait = episodes::still_action(world.observe());
    for (int i = 0; i < 10; ++i)
      ASSERT_TRUE(world.step(wait).ok());
    EXPECT_LT(length(world.item_pose(0).position - before), 0.003) << spec->goals[0].sku;
    EXPECT_FALSE(world.goals_met().value());
  }
  EXPECT_GT(drawn.size(), 3U);
}

TEST(OneItem, WithoutABoxIsSaid) {
  const auto spec = episodes::sample_one_item(small_stock_data, {}, kiosk_origin, Seed(1), 0);
  ASSERT_FALSE(spec.ok());
  EXPECT_EQ(spec.error().code, "episode.impossible");
}

TEST(OneItem, IsNotForTheOtherStation) {
  std::vector<catalog::Product> stock;
  for (const catalog::Product& product : committed_catalog().products)
    if (episodes::is_one_item(product)) stock.push_back(product);
  const episodes::EpisodeSpec spec =
      episodes::sample_one_item(small_stock_data, stock, kiosk_origin, Seed(1), 0).value();
  episodes::CheckoutWorld world =
      episodes::CheckoutWorld::create(small_stock_data, committed_catalog().frictions).value();
  const auto reset = world.reset(spec, stock);
  ASSERT_FALSE(reset.ok());
  EXPECT_EQ(reset.error().code, "robot.unknown");
  EXPECT_NE(reset.error().message.find("one-item"), std::string::npos);
}

}  // namespace
}  // namespace marketgen
