// What leaves the simulation for a policy from outside has nothing of the episode's truth.
#include "environments/told_task.h"

#include <gtest/gtest.h>

#include "environments/episode_ground.h"
#include "environments/run_episode.h"
#include "io/json.h"

namespace marketgen {
namespace {

// Every text and number of it is one that is found again wherever it stands.
episodes::EpisodeSpec episode() {
  episodes::EpisodeSpec spec;
  spec.id = "SECRET/id";
  spec.track = episodes::Track::aisle;
  spec.store = "SECRET/store";
  spec.scene_hash = "SECRET/scene";
  spec.plan_hash = "SECRET/plan";
  spec.robot = "realman-rm75";
  spec.tools = "suction";
  spec.station = "checkout";
  spec.lane = "SECRET/lane";
  spec.seed = 4711001;
  spec.instruction = "Fetch the tea.";
  spec.instructions = episodes::Instructions::words;
  spec.items = {{"SECRET/item", {0.4711, 0.4711, 0.4711}, {0.4711, 0, 0, 0.4711}}};
  spec.goals = {{"SECRET-tea-250-g", 2, "two boxes of tea"}};
  spec.start = {4711.5, 4711.5, 47.11};
  spec.categories = {{"SECRET-tea-250-g", "beverages", 1.5, 2.5}};
  spec.cameras = {"head_camera"};
  spec.limit_s = 900;
  episodes::WitnessPick pick;
  pick.sku = "SECRET-tea-250-g";
  pick.product = "SECRET/product";
  pick.arm = "SECRET/arm";
  pick.strategy = "SECRET/strategy";
  pick.grasps = {4711};
  pick.base = {4711.5, 4711.5, 47.11};
  spec.certificate = {{"SECRET/proved"}, {pick}};
  return spec;
}

TEST(ToldTask, HasNothingOfPosesWitnessSeedsOrIds) {
  const std::string told = io::write_json(environments::told_task(episode()));
  ASSERT_NE(io::write_json(episode()).find("SECRET"), std::string::npos);
  EXPECT_EQ(told.find("SECRET"), std::string::npos) << told;
  EXPECT_EQ(told.find("4711"), std::string::npos) << told;
  EXPECT_EQ(told.find("47.11"), std::string::npos) << told;
}

TEST(ToldTask, HasWhatTheAgentIsToDoAndWhatItKnowsBeforehand) {
  const environments::ToldTask told =
      io::read_json<environments::ToldTask>(io::write_json(environments::told_task(episode())),
                                            "task")
          .value();
  EXPECT_EQ(told.track, episodes::Track::aisle);
  EXPECT_EQ(told.instruction, "Fetch the tea.");
  EXPECT_EQ(told.robot, "realman-rm75");
  EXPECT_EQ(told.tools, "suction");
  EXPECT_EQ(told.cameras, std::vector<std::string>{"head_camera"});
  EXPECT_EQ(told.limit_s, 900);
  ASSERT_EQ(told.goals.size(), 1U);
  EXPECT_EQ(told.goals[0].text, "two boxes of tea");
  EXPECT_FALSE(told.goals[0].sku);
  EXPECT_EQ(told.goals[0].count, 2);
  ASSERT_EQ(told.categories.size(), 1U);
  EXPECT_EQ(told.categories[0].goal, 0);
  EXPECT_FALSE(told.categories[0].sku);
  EXPECT_EQ(told.categories[0].x_m, 1.5);
}

// What policies in the program are told, too.
TEST(ToldTask, InWordsNoPolicyIsToldASku) {
  const agent::Task task = environments::task_of(episode());
  ASSERT_EQ(task.goals.size(), 1U);
  EXPECT_EQ(task.goals[0].sku, "");
  EXPECT_EQ(task.goals[0].text, "two boxes of tea");
  EXPECT_EQ(task.goals[0].count, 2);
  EXPECT_EQ(task.instruction.find("SECRET"), std::string::npos);
}

// The whole of it, of every episode that comes with the program.
TEST(ToldTask, HasNoSkuOfAGoalInThePool) {
  for (const episodes::Track track : {episodes::Track::checkout, episodes::Track::aisle}) {
    const auto ground = environments::EpisodeGround::of_pool(track);
    ASSERT_TRUE(ground.ok()) << to_string(ground.error());
    for (const episodes::EpisodeSpec& spec : (*ground)->episodes()) {
      EXPECT_EQ(spec.instructions, episodes::Instructions::words) << spec.id;
      const std::string told = io::write_json(environments::told_task(spec));
      for (const episodes::EpisodeGoal& goal : spec.goals) {
        EXPECT_EQ(told.find(goal.sku), std::string::npos) << told;
        EXPECT_NE(told.find(*goal.text), std::string::npos) << told;
      }
    }
  }
}

TEST(ToldTask, BySkuItIsAsBefore) {
  episodes::EpisodeSpec spec = episode();
  spec.instructions = episodes::Instructions::ids;
  const environments::ToldTask told = environments::told_task(spec);
  EXPECT_EQ(told.goals[0].sku, "SECRET-tea-250-g");
  EXPECT_FALSE(told.goals[0].text);
  EXPECT_EQ(told.categories[0].sku, "SECRET-tea-250-g");
  EXPECT_EQ(environments::task_of(spec).goals[0].sku, "SECRET-tea-250-g");
}

}  // namespace
}  // namespace marketgen
