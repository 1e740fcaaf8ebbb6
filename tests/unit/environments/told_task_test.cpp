// What leaves the simulation for a policy from outside has nothing of the episode's truth.
#include "environments/told_task.h"

#include <gtest/gtest.h>

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
  spec.items = {{"SECRET/item", {0.4711, 0.4711, 0.4711}, {0.4711, 0, 0, 0.4711}}};
  spec.goals = {{"tea", 2}};
  spec.start = {4711.5, 4711.5, 47.11};
  spec.categories = {{"tea", "beverages", 1.5, 2.5}};
  spec.cameras = {"head_camera"};
  spec.limit_s = 900;
  episodes::WitnessPick pick;
  pick.sku = "tea";
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
  EXPECT_EQ(told.goals[0].sku, "tea");
  EXPECT_EQ(told.goals[0].count, 2);
  ASSERT_EQ(told.categories.size(), 1U);
  EXPECT_EQ(told.categories[0].x_m, 1.5);
}

}  // namespace
}  // namespace marketgen
