// What a policy has seen, and episodes that ask for what it has not.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "catalog/look_alike.h"
#include "episodes/checkout/sample_checkout.h"
#include "support/committed_catalog.h"
#include "support/drawn_checkout.h"

namespace marketgen {
namespace {

using episodes::Unseen;

const std::vector<Unseen> all_kinds = {Unseen::products, Unseen::layouts, Unseen::looks};

episodes::EpisodeFile training_file() {
  episodes::EpisodeFile file;
  episodes::EpisodeStore store;
  store.name = "School";
  store.plan.shell.width_mm = 12000;
  store.plan.look.floor = "oak";
  file.header.stores = {store};
  episodes::EpisodeSpec spec;
  const std::vector<catalog::Product>& goods = checkout_goods_rows();
  spec.items = {episodes::EpisodeItem::at(goods[0].sku, {}),
                episodes::EpisodeItem::at(goods[1].sku, {})};
  spec.goals = {{goods[0].sku}};
  file.episodes = {spec};
  file.header.products = {goods[0], goods[1], goods[2]};
  return file;
}

TEST(TrainingSet, HasWhatIsAskedForOrLiesAboutAndWhatLooksLikeIt) {
  const auto set = episodes::TrainingSet::of({training_file()}, all_kinds);
  const std::vector<catalog::Product>& goods = checkout_goods_rows();
  EXPECT_TRUE(set.has(goods[0]));
  EXPECT_TRUE(set.has(goods[1]));
  int alike = 0;
  for (const catalog::Product& product : committed_catalog().products) {
    const bool close = product.sku == goods[0].sku || product.sku == goods[1].sku ||
                       catalog::are_look_alikes(product, goods[0]) ||
                       catalog::are_look_alikes(product, goods[1]);
    EXPECT_EQ(set.has(product), close) << product.sku;
    alike += close;
  }
  EXPECT_GE(alike, 3);
  EXPECT_LT(alike, 100);
}

TEST(TrainingSet, RefusesStoresOfItsLayoutsAndLooks) {
  const auto set = episodes::TrainingSet::of({training_file()}, all_kinds);
  episodes::EpisodeStore store = training_file().header.stores.front();
  store.name = store.plan.name = "Other name";
  auto checked = set.check_store(store);
  ASSERT_FALSE(checked.ok());
  EXPECT_EQ(checked.error().code, "episode.seen");
  EXPECT_NE(checked.error().message.find("layout is that of the training store \"School\""),
            std::string::npos);
  store.plan.shell.width_mm = 13000;
  checked = set.check_store(store);
  ASSERT_FALSE(checked.ok());
  EXPECT_NE(checked.error().message.find("look"), std::string::npos);
  store.plan.look.light_kelvin = 3000;
  EXPECT_TRUE(set.check_store(store).ok());
}

TEST(TrainingSet, OnlyWhatIsToBeNewCounts) {
  const auto goods = episodes::TrainingSet::of({training_file()}, {Unseen::products});
  EXPECT_TRUE(goods.has(checkout_goods_rows()[0]));
  EXPECT_TRUE(goods.check_store(training_file().header.stores.front()).ok());
  const auto looks = episodes::TrainingSet::of({training_file()}, {Unseen::looks});
  EXPECT_FALSE(looks.has(checkout_goods_rows()[0]));
  EXPECT_FALSE(looks.check_store(training_file().header.stores.front()).ok());
}

TEST(TrainingSet, IsToldInTheHeaderByWhatIsInIt) {
  EXPECT_FALSE(episodes::TrainingSet().row().has_value());
  const auto first = episodes::TrainingSet::of({training_file()}, all_kinds).row();
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->what, all_kinds);
  episodes::EpisodeFile other = training_file();
  other.episodes.front().items.pop_back();
  EXPECT_NE(episodes::TrainingSet::of({other}, all_kinds).row()->training, first->training);
}

TEST(SlowTrainingSet, BasketsAskForNothingOfItButMayHoldIt) {
  std::vector<catalog::Product> stock(checkout_goods_rows().begin(),
                                      checkout_goods_rows().begin() + 16);
  episodes::EpisodeFile training;
  training.episodes.resize(1);
  for (std::size_t i = 0; i < 10; ++i) {
    training.header.products.push_back(stock[i]);
    training.episodes[0].goals.push_back({stock[i].sku});
  }
  episodes::DrawRules rules;
  rules.trained_on = episodes::TrainingSet::of({training}, all_kinds);
  const auto seen = [&](const std::string& sku) {
    return rules.trained_on.has(*std::ranges::find(stock, sku, &catalog::Product::sku));
  };
  ASSERT_GE(std::ranges::count_if(
                stock, [&](const auto& product) { return !rules.trained_on.has(product); }),
            2);
  int seen_others = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const auto spec = episodes::sample_checkout(data_rows(),
                                                stock,
                                                committed_catalog().frictions,
                                                {"s", "s", "p"},
                                                Seed(seed),
                                                0,
                                                {},
                                                {},
                                                rules);
    ASSERT_TRUE(spec.ok()) << to_string(spec.error());
    for (const episodes::EpisodeGoal& goal : spec->goals)
      EXPECT_FALSE(seen(goal.sku)) << goal.sku;
    for (const episodes::EpisodeItem& item : spec->items)
      seen_others += seen(item.sku);
  }
  EXPECT_GT(seen_others, 0);
}

}  // namespace
}  // namespace marketgen
