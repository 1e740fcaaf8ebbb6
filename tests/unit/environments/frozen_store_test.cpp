// Frozen episodes run in the store that they were frozen in, whatever the generator makes of its
// plan today; what does not belong to them is refused.
#include "episodes/frozen_store.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "environments/episode_ground.h"
#include "episodes/episode_sets.h"
#include "io/file.h"
#include "io/gzip.h"
#include "store/store.h"
#include "support/committed_catalog.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

const fs::path data = fs::path(MARKETGEN_SOURCE_DIR) / "data";

episodes::EpisodeFile pool_file() {
  auto read = episodes::read_episode_file(data / "benchmark/pool/aisle.jsonl");
  if (!read.ok()) fatal(to_string(read.error()).c_str());
  return std::move(read).value();
}

const scene::Scene& scene_of_first_store() {
  static const scene::Scene scene = [] {
    const episodes::EpisodeStore store = pool_file().header.stores.front();
    auto made = store::scene_of_plan(store.plan, committed_catalog(), store.seed);
    if (!made.ok()) fatal(to_string(made.error()).c_str());
    return std::move(made).value();
  }();
  return scene;
}

// The pool's episodes of its first store, frozen in a folder of their own; a later generator makes
// something else of the plan that they have.
class Frozen : public testing::Test {
 protected:
  void SetUp() override {
    episodes::EpisodeStore& store = file_.header.stores.front();
    file_.header.stores.resize(1);
    std::erase_if(file_.episodes, [&](const episodes::EpisodeSpec& spec) {
      return spec.scene_hash != store.scene_hash;
    });
    file_.header.episodes = static_cast<int>(file_.episodes.size());
    packed_ = episodes::pack_scene(scene_of_first_store());
    store.scene = {episodes::frozen_scene_file(store), io::sha256_hex(packed_)};
    store.plan.shell.width_mm += 1000;
    file_.header.rows_hash = episodes::rows_hash(data, file_).value();
    write();
  }

  void write() const {
    ASSERT_TRUE(io::write_file(path(), io::gzip(episodes::write_episodes(file_))).ok());
    ASSERT_TRUE(io::write_file(folder_ / file_.header.stores.front().scene->file, packed_).ok());
  }
  fs::path path() const { return folder_ / "aisle.jsonl.gz"; }

  Error error_of_opening() const {
    const auto ground = environments::EpisodeGround::of_file(path());
    if (!ground.ok()) return ground.error();
    const auto scene = (*ground)->arena().scene(file_.header.stores.front().scene_hash);
    return scene.ok() ? Error{"none", "", ""} : scene.error();
  }

  const ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path() / "frozen";
  episodes::EpisodeFile file_ = pool_file();
  std::string packed_;
};

TEST_F(Frozen, EpisodesRunInTheStoreThatTravelsWithThem) {
  const auto ground = environments::EpisodeGround::of_file(path());
  ASSERT_TRUE(ground.ok()) << to_string(ground.error());
  const auto scene = (*ground)->arena().scene(file_.header.stores.front().scene_hash);
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  EXPECT_EQ((*scene)->products.size(), scene_of_first_store().products.size());
  EXPECT_EQ((*scene)->catalog.size(), scene_of_first_store().catalog.size());
  const auto world = (*ground)->arena().open(file_.episodes.front());
  EXPECT_TRUE(world.ok()) << to_string(world.error());
}

TEST_F(Frozen, WithoutTheSceneALaterGeneratorsStoreIsRefused) {
  episodes::EpisodeStore& store = file_.header.stores.front();
  store.scene.reset();
  store.plan_hash = episodes::plan_hash(store.plan);
  for (episodes::EpisodeSpec& spec : file_.episodes)
    spec.plan_hash = store.plan_hash;
  ASSERT_TRUE(io::write_file(path(), episodes::write_episodes(file_)).ok());
  EXPECT_EQ(error_of_opening().code, "episode.other_store");
}

TEST_F(Frozen, ASceneThatWasChangedIsRefused) {
  packed_[packed_.size() / 2] ^= 1;
  write();
  const Error error = error_of_opening();
  EXPECT_EQ(error.code, "episode.other_store");
  EXPECT_NE(error.message.find("SHA-256"), std::string::npos) << error.message;
}

TEST_F(Frozen, AnotherStoresSceneIsRefused) {
  scene::Scene other = scene_of_first_store();
  other.products.front().position_m[0] += 0.1F;
  packed_ = episodes::pack_scene(other);
  file_.header.stores.front().scene->sha256 = io::sha256_hex(packed_);
  write();
  EXPECT_EQ(error_of_opening().code, "episode.other_store");
}

TEST_F(Frozen, OtherRowsOfRobotsStationsOrFrictionAreRefused) {
  file_.header.rows_hash->front() = file_.header.rows_hash->front() == '0' ? '1' : '0';
  write();
  EXPECT_EQ(error_of_opening().code, "episode.other_rows");
}

TEST_F(Frozen, AFileOutsideTheirFolderIsNotOpened) {
  file_.header.stores.front().scene->file = "../secret";
  ASSERT_TRUE(io::write_file(path(), episodes::write_episodes(file_)).ok());
  EXPECT_EQ(error_of_opening().code, "input.outside_folder");
}

// Rows that a track's robot does not reach do not count.
TEST_F(Frozen, RowsHashIsOfWhatTheEpisodesUse) {
  const fs::path copy = scratch_.path() / "rows";
  for (const char* part : {"robots", "benchmark", "friction.json"}) {
    fs::create_directories(copy);
    fs::copy(data / part, copy / part, fs::copy_options::recursive);
  }
  const auto hash = [&] { return episodes::rows_hash(copy, file_).value(); };
  const std::string before = hash();
  EXPECT_EQ(before, *file_.header.rows_hash);
  ASSERT_TRUE(io::write_file(copy / "robots/panda.json", "{}").ok());
  EXPECT_EQ(hash(), before);
  ASSERT_TRUE(io::write_file(copy / "robots/realman-rm75.json", "{}").ok());
  EXPECT_NE(hash(), before);
}

TEST(EpisodeSets, AreNamedWithoutTheirFolder) {
  const auto named = episodes::read_episode_file("pool/aisle");
  ASSERT_TRUE(named.ok()) << to_string(named.error());
  EXPECT_EQ(named->episodes.size(), pool_file().episodes.size());
  const auto wrong = episodes::read_episode_file("pool/aisles");
  ASSERT_FALSE(wrong.ok());
  EXPECT_EQ(wrong.error().code, "input.not_found");
  EXPECT_NE(wrong.error().message.find("did you mean \"pool/aisle\""), std::string::npos)
      << wrong.error().message;
}

TEST(EpisodeSets, AreFilesOfEpisodesPackedOrNot) {
  const ScratchFolder scratch;
  const fs::path set = scratch.path() / "benchmark/v9";
  for (const char* file :
       {"aisle.jsonl", "cup.jsonl.gz", "doors.jsonl.gz.unfinished", "SHA256SUMS"})
    ASSERT_TRUE(io::write_file(set / file, "").ok());
  const auto sets = episodes::episode_sets(scratch.path());
  ASSERT_EQ(sets.size(), 2U);
  EXPECT_EQ(sets.at("v9/aisle"), set / "aisle.jsonl");
  EXPECT_EQ(sets.at("v9/cup"), set / "cup.jsonl.gz");
}

}  // namespace
}  // namespace marketgen
