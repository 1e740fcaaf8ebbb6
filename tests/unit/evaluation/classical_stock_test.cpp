// What `classical` knows at the counter is what the store sells: an episode by itself and among
// others is the same to the last bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "environments/run_episode.h"
#include "scene/scene.h"
#include "support/drawn_checkout.h"

namespace marketgen {
namespace {

// A file of this episode alone: its store, and the rows of its own basket.
episodes::EpisodeFile alone(const episodes::EpisodeFile& file, const episodes::EpisodeSpec& spec) {
  episodes::EpisodeFile one;
  one.episodes = {spec};
  for (const episodes::EpisodeStore& store : file.header.stores)
    if (store.scene_hash == spec.scene_hash) one.header.stores = {store};
  for (const catalog::Product& product : file.header.products)
    if (std::ranges::count(spec.items, product.sku, &episodes::EpisodeItem::sku) > 0)
      one.header.products.push_back(product);
  return one;
}

TEST(ClassicalStock, IsAllThatTheStoreSells) {
  const episodes::EpisodeFile file = pool_file();
  for (const episodes::EpisodeStore& store : file.header.stores) {
    const auto scene = store::scene_of_plan(store.plan, committed_catalog(), store.seed);
    ASSERT_TRUE(scene.ok()) << to_string(scene.error());
    std::set<std::string> on_shelves;
    for (const scene::SceneProduct& product : scene->products)
      on_shelves.insert(scene->catalog[product.sku].sku);
    environments::Arena arena(data_rows(), file.header, committed_catalog());
    const auto stock = arena.stock(store.scene_hash);
    ASSERT_TRUE(stock.ok()) << to_string(stock.error());
    std::set<std::string> known;
    for (const catalog::Product& product : **stock)
      known.insert(product.sku);
    EXPECT_EQ(known, on_shelves);
    EXPECT_GT(known.size(), file.header.products.size());
  }
}

TEST(SlowClassicalStock, AnEpisodeAloneIsTheSameAsAmongOthers) {
  episodes::EpisodeFile file = pool_file();
  environments::Arena together(data_rows(), file.header, committed_catalog());
  // One of those (4 of 16) that were not, while its file's baskets were its catalogue.
  episodes::EpisodeSpec spec = file.episodes[3];
  spec.limit_s = 20;
  const episodes::EpisodeFile one = alone(file, spec);
  ASSERT_LT(one.header.products.size(), file.header.products.size());
  environments::Arena by_itself(data_rows(), one.header, committed_catalog());
  const auto among = environments::run_episode(together, spec, "classical");
  const auto single = environments::run_episode(by_itself, spec, "classical");
  ASSERT_TRUE(among.ok()) << to_string(among.error());
  ASSERT_TRUE(single.ok()) << to_string(single.error());
  EXPECT_TRUE(among->detail.empty()) << among->detail;
  EXPECT_GT(among->simulated_s, 10) << "it was at work";
  EXPECT_EQ(among->state_hash, single->state_hash) << spec.id;
  EXPECT_EQ(among->failure, single->failure) << spec.id;
}

}  // namespace
}  // namespace marketgen
