// Stores that travel with episodes: the scenes themselves with frozen sets.
#include "environments/travelling_stores.h"

#include <gtest/gtest.h>

#include "episodes/episode_header.h"
#include "support/committed_catalog.h"
#include "support/drawn_checkout.h"

namespace marketgen {
namespace {

using SharedStore = std::shared_ptr<const store::Store>;

episodes::EpisodeHeader header_of(const std::string& set) {
  auto header = episodes::read_episode_header(set, data_rows());
  if (!header.ok()) fatal(to_string(header.error()).c_str());
  return *std::move(header);
}

// In no folder, and of nothing else.
SharedStore store_called(const std::string& name) {
  auto made = std::make_shared<store::Store>();
  made->manifest.name = made->manifest.scene_hash = name;
  return made;
}

catalog::Catalog rows() {
  return catalog::Catalog(committed_catalog());
}

// A store that was named comes first.
TEST(TravellingStores, AreOpenedAsTheyWereFrozen) {
  const episodes::EpisodeHeader header = header_of("v1/checkout");
  ASSERT_GT(header.stores.size(), 2U);
  const SharedStore named = store_called("named");
  const std::string first = header.stores[0].scene_hash, third = header.stores[2].scene_hash;
  const auto opened = environments::with_travelling_stores(
      store::opened_stores({named}, rows()), {third, first, "0123"}, "v1/checkout");
  ASSERT_TRUE(opened.ok()) << to_string(opened.error());
  ASSERT_EQ(opened->stores.size(), 3U) << "nobody has 0123";
  EXPECT_EQ(opened->stores[0], named);
  EXPECT_EQ(scene::scene_hash(opened->stores[1]->scene), first);
  EXPECT_EQ(scene::scene_hash(opened->stores[2]->scene), third);
}

TEST(TravellingStores, AllOfASetAreNamedByIt) {
  const auto named = environments::open_named_stores({"v1/aisle"}, rows());
  ASSERT_TRUE(named.ok()) << to_string(named.error());
  EXPECT_EQ(named->frozen, "v1/aisle");
  const episodes::EpisodeHeader header = header_of("v1/aisle");
  ASSERT_EQ(named->opened.stores.size(), header.stores.size());
  for (std::size_t i = 0; i < header.stores.size(); ++i) {
    EXPECT_EQ(scene::scene_hash(named->opened.stores[i]->scene), header.stores[i].scene_hash);
    EXPECT_EQ(episodes::plan_hash(named->opened.stores[i]->plan), header.stores[i].plan_hash);
    const std::string& hash = header.stores[i].scene_hash;
    EXPECT_EQ(named->scenes.at(hash).sha256, header.stores[i].scene->sha256);
  }
}

// The pool's stores come of their plans.
TEST(TravellingStores, OfASetThatIsNotFrozenAreMadeAnew) {
  const auto named = environments::open_named_stores({"pool/checkout"}, rows());
  ASSERT_TRUE(named.ok()) << to_string(named.error());
  EXPECT_EQ(named->frozen, "");
  EXPECT_EQ(named->opened.stores.size(), header_of("pool/checkout").stores.size());
}

TEST(TravellingStores, AreNamedOnce) {
  const auto twice = environments::open_named_stores({"v1/aisle", "v1/checkout"}, rows());
  ASSERT_FALSE(twice.ok());
  EXPECT_EQ(twice.error().code, "usage.bad_flag");
  EXPECT_EQ(twice.error().where, "v1/checkout");
  const auto nowhere = environments::open_named_stores({"v1/isle"}, rows());
  ASSERT_FALSE(nowhere.ok());
  EXPECT_EQ(nowhere.error().code, "input.not_found") << to_string(nowhere.error());
}

}  // namespace
}  // namespace marketgen
