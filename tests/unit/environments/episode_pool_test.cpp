// The pool of episodes that comes with the program is that of the stores and products as they are.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "environments/episode_ground.h"
#include "io/file.h"
#include "scene/scene.h"
#include "store/store.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

const std::filesystem::path pool =
    std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data/benchmark/pool";
constexpr char remedy[] = "run tools/refresh_pool: the pool is no longer what would be drawn";

class Pool : public testing::TestWithParam<episodes::Track> {
 protected:
  episodes::EpisodeFile file() const {
    auto read = episodes::read_episode_file(pool / (std::string(name_of(GetParam())) + ".jsonl"));
    if (!read.ok()) fatal(to_string(read.error()).c_str());
    return std::move(read).value();
  }
};

TEST_P(Pool, ItsStoresAreStillMadeFromItsPlans) {
  for (const episodes::EpisodeStore& store : file().header.stores) {
    const auto scene = store::scene_of_plan(store.plan, committed_catalog(), store.seed);
    ASSERT_TRUE(scene.ok()) << to_string(scene.error());
    EXPECT_EQ(scene::scene_hash(*scene), store.scene_hash) << store.name << ": " << remedy;
    EXPECT_EQ(episodes::plan_hash(store.plan), store.plan_hash) << store.name << ": " << remedy;
  }
}

TEST_P(Pool, OpensAndHasTensOfEpisodes) {
  const auto ground = environments::EpisodeGround::of_pool(GetParam());
  ASSERT_TRUE(ground.ok()) << to_string(ground.error()) << "\n" << remedy;
  EXPECT_GE((*ground)->episodes().size(), 20U);
  const auto first = (*ground)->draw(GetParam(), 3), again = (*ground)->draw(GetParam(), 3);
  ASSERT_TRUE(first.ok() && again.ok());
  EXPECT_EQ(first->id, again->id);
}

TEST_P(Pool, HasThePlansThatLieBesideIt) {
  std::size_t plans = 0;
  for (const auto& entry : std::filesystem::directory_iterator(pool))
    plans += entry.path().string().ends_with(".plan.json") ? 1U : 0U;
  EXPECT_EQ(file().header.stores.size(), plans) << remedy;
}

INSTANTIATE_TEST_SUITE_P(OfEachTrack,
                         Pool,
                         testing::Values(episodes::Track::checkout, episodes::Track::aisle),
                         [](const auto& track) { return std::string(name_of(track.param)); });

// With products as they no longer are, it says what to do.
TEST(StalePool, IsAnErrorThatNamesTheRemedy) {
  namespace fs = std::filesystem;
  const fs::path data = fs::path(testing::TempDir()) / "stale_pool_data";
  fs::remove_all(data);
  fs::copy(pool.parent_path().parent_path(), data, fs::copy_options::recursive);
  const fs::path file = data / "benchmark/pool/checkout.jsonl";
  std::string text = io::read_file(file).value();
  const std::string key = "\"mass_kg\": 0.";
  const std::size_t at = text.find(key);
  ASSERT_NE(at, std::string::npos);
  text[at + key.size()] = text[at + key.size()] == '1' ? '2' : '1';
  std::ofstream(file, std::ios::binary) << text;
  const char* before = std::getenv("MARKETGEN_DATA");
  setenv("MARKETGEN_DATA", data.c_str(), 1);
  const auto ground = environments::EpisodeGround::of_pool(episodes::Track::checkout);
  if (before == nullptr)
    unsetenv("MARKETGEN_DATA");
  else
    setenv("MARKETGEN_DATA", before, 1);
  ASSERT_FALSE(ground.ok());
  EXPECT_EQ(ground.error().code, "episode.other_store");
  EXPECT_NE(ground.error().message.find("tools/refresh_pool"), std::string::npos);
}

}  // namespace
}  // namespace marketgen
