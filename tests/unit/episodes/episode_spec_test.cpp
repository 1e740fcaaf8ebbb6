// Episodes as files: read back as they were written; faults are named with their line.
#include "episodes/episode_spec.h"

#include <gtest/gtest.h>

#include "episodes/check_episodes.h"
#include "io/json.h"

namespace marketgen {
namespace {

episodes::EpisodeFile small_file() {
  episodes::EpisodeFile file;
  episodes::EpisodeStore store;
  store.name = "corner";
  store.scene_hash = "aa";
  store.plan_hash = episodes::plan_hash(store.plan);
  file.header.stores.push_back(store);
  catalog::Product tea;
  tea.sku = "tea";
  tea.name = "Tea";
  tea.category = "beverages";
  tea.subcategory = "tea";
  tea.archetype = "box";
  file.header.products.push_back(tea);
  episodes::EpisodeSpec spec;
  spec.id = "checkout/corner/1/0";
  spec.store = "corner";
  spec.scene_hash = "aa";
  spec.plan_hash = store.plan_hash;
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
  const auto read = episodes::read_episodes(text, "e.jsonl");
  if (read.ok()) return {"none", "", ""};
  return read.error();
}

TEST(EpisodeFile, ReadsWhatItWrote) {
  const std::string text = episodes::write_episodes(small_file());
  const auto read = episodes::read_episodes(text, "e.jsonl");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(episodes::write_episodes(*read), text);
  EXPECT_EQ(read->episodes[1].id, "checkout/corner/1/1");
}

TEST(EpisodeFile, ACutOffLineIsNamed) {
  std::string text = episodes::write_episodes(small_file());
  text.resize(text.size() - 20);
  const Error error = error_of(text);
  EXPECT_EQ(error.code, "episode.truncated");
  EXPECT_EQ(error.where, "e.jsonl:3");
}

TEST(EpisodeFile, MissingLinesAreNoticed) {
  std::string text = episodes::write_episodes(small_file());
  text.resize(text.rfind('\n', text.size() - 2) + 1);
  EXPECT_EQ(error_of(text).code, "episode.truncated");
  EXPECT_EQ(error_of("").code, "episode.truncated");
}

TEST(EpisodeFile, UnknownProductsAreErrors) {
  episodes::EpisodeFile file = small_file();
  file.episodes[1].items[0].sku = "tee";
  const Error error = error_of(episodes::write_episodes(file));
  EXPECT_EQ(error.code, "catalog.unknown_sku");
  EXPECT_EQ(error.where, "e.jsonl:3/items");
  EXPECT_NE(error.message.find("did you mean \"tea\""), std::string::npos) << error.message;
}

TEST(EpisodeFile, AGoalThatCannotBeMetIsAnError) {
  episodes::EpisodeFile file = small_file();
  file.episodes[0].goals[0].count = 2;
  EXPECT_EQ(error_of(episodes::write_episodes(file)).code, "episode.impossible");
}

TEST(EpisodeFile, WithoutAWordOnInstructionsGoalsAreToldBySku) {
  std::string text = episodes::write_episodes(small_file());
  const std::string said = "\"instructions\": \"ids\", ";
  for (std::size_t at = text.find(said); at != std::string::npos; at = text.find(said))
    text.erase(at, said.size());
  const auto read = episodes::read_episodes(text, "e.jsonl");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->episodes[0].instructions, episodes::Instructions::ids);
}

TEST(EpisodeFile, InWordsEachGoalHasAText) {
  episodes::EpisodeFile file = small_file();
  file.episodes[1].instructions = episodes::Instructions::words;
  const Error error = error_of(episodes::write_episodes(file));
  EXPECT_EQ(error.code, "episode.bad_value");
  EXPECT_EQ(error.where, "e.jsonl:3/goals");
  file.episodes[1].goals[0].text = "the tea";
  EXPECT_EQ(error_of(episodes::write_episodes(file)).code, "none");
}

TEST(EpisodeFile, AnotherStoreIsAnError) {
  episodes::EpisodeFile file = small_file();
  file.episodes[0].scene_hash = "cc";
  EXPECT_EQ(error_of(episodes::write_episodes(file)).code, "episode.other_store");
  EXPECT_EQ(episodes::check_store(small_file().episodes[0], "aa", "cc").error().code,
            "episode.other_store");
  EXPECT_TRUE(
      episodes::check_store(small_file().episodes[0], "aa", episodes::plan_hash(plan::Plan{}))
          .ok());
}

// Every fault that a hand or another program may put in: with its line and its field.
TEST(EpisodeFile, FaultsAreNamed) {
  struct Fault {
    const char *code, *where;
    void (*make)(episodes::EpisodeFile&);
  };
  const Fault faults[] = {
      {"episode.duplicate_id",
       "e.jsonl:3/id",
       [](episodes::EpisodeFile& f) { f.episodes[1].id = f.episodes[0].id; }},
      {"episode.bad_value",
       "e.jsonl:3/items/0/rotation_wxyz",
       [](episodes::EpisodeFile& f) {
         f.episodes[1].items[0].rotation_wxyz = {0, 0, 0, 0};
       }},
      {"episode.bad_value",
       "e.jsonl:2/items/0/rotation_wxyz",
       [](episodes::EpisodeFile& f) {
         f.episodes[0].items[0].rotation_wxyz = {1, 1, 0, 0};
       }},
      {"episode.bad_value",
       "e.jsonl:2/cameras",
       [](episodes::EpisodeFile& f) { f.episodes[0].cameras = {"wrst"}; }},
      {"episode.impossible",
       "e.jsonl:2/goals",
       [](episodes::EpisodeFile& f) { f.episodes[0].goals.clear(); }},
      {"json.out_of_range",
       "e.jsonl:2:/goals/0/count",
       [](episodes::EpisodeFile& f) { f.episodes[0].goals[0].count = 0; }},
      {"episode.bad_value",
       "e.jsonl:2/goals",
       [](episodes::EpisodeFile& f) {
         f.episodes[0].items.push_back(f.episodes[0].items[0]);
         f.episodes[0].goals.push_back(f.episodes[0].goals[0]);
       }},
      {"episode.bad_value",
       "e.jsonl:2/items",
       [](episodes::EpisodeFile& f) { f.episodes[0].track = episodes::Track::aisle; }},
      {"episode.bad_value",
       "e.jsonl:2/start",
       [](episodes::EpisodeFile& f) { f.episodes[0].start.x_m = 1; }},
      {"episode.bad_value",
       "e.jsonl:2/categories",
       [](episodes::EpisodeFile& f) {
         f.episodes[0].categories = {{"tea", "beverages", 1, 2}};
       }},
      {"catalog.unknown_sku",
       "e.jsonl:2/goals",
       [](episodes::EpisodeFile& f) { f.episodes[0].goals[0].sku = "coffee"; }},
      {"catalog.duplicate_sku",
       "e.jsonl:1/products",
       [](episodes::EpisodeFile& f) { f.header.products.push_back(f.header.products[0]); }},
      {"episode.other_store",
       "e.jsonl:1/stores/0",
       [](episodes::EpisodeFile& f) { f.header.stores[0].plan.name = "another"; }},
  };
  for (const Fault& fault : faults) {
    episodes::EpisodeFile file = small_file();
    fault.make(file);
    const Error error = error_of(episodes::write_episodes(file));
    EXPECT_EQ(error.code, fault.code) << to_string(error);
    EXPECT_EQ(error.where, fault.where) << to_string(error);
  }
}

TEST(EpisodeFile, RobotsAndToolsAreThoseOfTheTrack) {
  const std::filesystem::path data = std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data";
  episodes::EpisodeFile file = small_file();
  EXPECT_TRUE(episodes::check_robots(file, "e.jsonl", data).ok());
  file.episodes[1].track = episodes::Track::aisle;
  file.episodes[1].robot = "realman-rm75";
  file.episodes[1].tools = "suction";
  EXPECT_TRUE(episodes::check_robots(file, "e.jsonl", data).ok());
  file.episodes[1].tools = "suktion";
  const Error tools = episodes::check_robots(file, "e.jsonl", data).error();
  EXPECT_EQ(tools.where, "e.jsonl:3/tools");
  EXPECT_NE(tools.message.find("did you mean \"suction\""), std::string::npos) << tools.message;
  file.episodes[1].robot = "panda";
  EXPECT_EQ(episodes::check_robots(file, "e.jsonl", data).error().where, "e.jsonl:3/robot");
}

// What a result is worth depends on all of this.
TEST(EpisodeFile, TheHashOfAnEpisodeSeesWhatItDependsOn) {
  const episodes::EpisodeFile file = small_file();
  const auto hash = [](const episodes::EpisodeFile& f) {
    return episodes::episode_hash(f.header, f.episodes[0]);
  };
  episodes::EpisodeFile other = file;
  other.header.products[0].mass_kg += 0.1;
  EXPECT_NE(hash(other), hash(file));
  other = file;
  other.episodes[0].items[0].position_m[0] += 1e-9;
  EXPECT_NE(hash(other), hash(file));
  other = file;
  other.header.products.push_back(file.header.products[0]);
  other.header.products.back().sku = "coffee";
  EXPECT_EQ(hash(other), hash(file)) << "nothing of the episode";
}

TEST(EpisodeFile, AnotherTrackIsAnError) {
  EXPECT_TRUE(episodes::track_named("checkout").ok());
  const auto track = episodes::track_named("chekout");
  ASSERT_FALSE(track.ok());
  EXPECT_EQ(track.error().code, "episode.unknown_track");
  std::string text = episodes::write_episodes(small_file());
  text.replace(text.rfind("\"checkout\""), 10, "\"ski-jump\"");
  EXPECT_EQ(error_of(text).code, "json.unknown_name");
}

}  // namespace
}  // namespace marketgen
