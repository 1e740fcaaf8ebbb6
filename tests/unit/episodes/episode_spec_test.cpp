// Episodes as files: read back as they were written; faults are named with their line.
#include "episodes/episode_spec.h"

#include <gtest/gtest.h>

#include "io/json.h"

namespace marketgen {
namespace {

EpisodeFile small_file() {
  EpisodeFile file;
  EpisodeStore store;
  store.name = "corner";
  store.scene_hash = "aa";
  store.plan_hash = "bb";
  file.header.stores.push_back(store);
  Product tea;
  tea.sku = "tea";
  tea.name = "Tea";
  tea.category = "beverages";
  tea.subcategory = "tea";
  tea.archetype = "box";
  file.header.products.push_back(tea);
  EpisodeSpec spec;
  spec.id = "checkout/corner/1/0";
  spec.store = "corner";
  spec.scene_hash = "aa";
  spec.plan_hash = "bb";
  spec.robot = "panda";
  spec.instruction = "Put the tea on the area.";
  spec.items = {{"tea", {0.01, 0.02, 0.03}, {1, 0, 0, 0}}};
  spec.goals = {{"tea", 1}};
  file.episodes = {spec, spec};
  file.episodes[1].id = "checkout/corner/1/1";
  file.header.episodes = 2;
  return file;
}

Error error_of(const std::string& text) {
  const auto read = read_episodes(text, "e.jsonl");
  if (read.ok()) return {"none", "", ""};
  return read.error();
}

TEST(EpisodeFile, ReadsWhatItWrote) {
  const std::string text = write_episodes(small_file());
  const auto read = read_episodes(text, "e.jsonl");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(write_episodes(*read), text);
  EXPECT_EQ(read->episodes[1].id, "checkout/corner/1/1");
}

TEST(EpisodeFile, ACutOffLineIsNamed) {
  std::string text = write_episodes(small_file());
  text.resize(text.size() - 20);
  const Error error = error_of(text);
  EXPECT_EQ(error.code, "episode.truncated");
  EXPECT_EQ(error.where, "e.jsonl:3");
}

TEST(EpisodeFile, MissingLinesAreNoticed) {
  std::string text = write_episodes(small_file());
  text.resize(text.rfind('\n', text.size() - 2) + 1);
  EXPECT_EQ(error_of(text).code, "episode.truncated");
  EXPECT_EQ(error_of("").code, "episode.truncated");
}

TEST(EpisodeFile, UnknownProductsAreErrors) {
  EpisodeFile file = small_file();
  file.episodes[1].items[0].sku = "tee";
  const Error error = error_of(write_episodes(file));
  EXPECT_EQ(error.code, "catalog.unknown_sku");
  EXPECT_EQ(error.where, "e.jsonl:3/items");
  EXPECT_NE(error.message.find("did you mean \"tea\""), std::string::npos) << error.message;
}

TEST(EpisodeFile, AGoalThatCannotBeMetIsAnError) {
  EpisodeFile file = small_file();
  file.episodes[0].goals[0].count = 2;
  EXPECT_EQ(error_of(write_episodes(file)).code, "episode.impossible");
}

TEST(EpisodeFile, AnotherStoreIsAnError) {
  EpisodeFile file = small_file();
  file.episodes[0].scene_hash = "cc";
  EXPECT_EQ(error_of(write_episodes(file)).code, "episode.other_store");
  EXPECT_EQ(check_store(small_file().episodes[0], "aa", "cc").error().code, "episode.other_store");
  EXPECT_TRUE(check_store(small_file().episodes[0], "aa", "bb").ok());
}

TEST(EpisodeFile, AnotherTrackIsAnError) {
  EXPECT_TRUE(track_named("checkout").ok());
  const auto track = track_named("chekout");
  ASSERT_FALSE(track.ok());
  EXPECT_EQ(track.error().code, "episode.unknown_track");
  std::string text = write_episodes(small_file());
  text.replace(text.rfind("\"checkout\""), 10, "\"ski-jump\"");
  EXPECT_EQ(error_of(text).code, "json.unknown_name");
}

}  // namespace
}  // namespace marketgen
