// Tools as grasps see them: pads, fingers and bodies are those of the rows.
#include "robots/grasp_tool.h"

#include <gtest/gtest.h>

#include "support/committed_robot.h"

namespace marketgen {
namespace {

TEST(GraspTools, TheRowsThatAreTools) {
  const auto ids = robots::grasp_tool_ids(committed_rows);
  ASSERT_TRUE(ids.ok());
  EXPECT_EQ(
      *ids,
      (std::vector<std::string>{
          "panda-hand", "panda-long-hand", "panda-suction", "parallel-gripper", "suction-cup"}));
}

// The hand's figures, and its pads of 17.5 x 17.7 mm round the tool centre point.
TEST(GraspTools, PandaHandHasThePadsOfItsRow) {
  const auto hand = robots::load_grasp_tool(committed_rows, "panda-hand");
  ASSERT_TRUE(hand.ok()) << to_string(hand.error());
  EXPECT_EQ(hand->opening_m, 0.08);
  EXPECT_EQ(hand->force_n, 70);
  EXPECT_NEAR(hand->pad_x_m, 0.00875, 1e-12);
  EXPECT_NEAR(hand->pad_z_m, 0.00885, 1e-12);
  EXPECT_NEAR(hand->pad_center.z, 0.0584 + 0.0447 - 0.1034, 1e-12);
  EXPECT_NEAR(hand->pad_center.x, 0, 1e-12);
}

TEST(GraspTools, OpenPadsStandAsFarApartAsAsked) {
  for (const char* id : {"panda-hand", "parallel-gripper"}) {
    const auto tool = robots::load_grasp_tool(committed_rows, id);
    ASSERT_TRUE(tool.ok());
    const std::vector<robots::ToolSolid> solids = robots::opened(*tool, 0.05);
    ASSERT_EQ(solids.size(), tool->left.size() + tool->right.size());
    const robots::ToolSolid &left = solids[0], &right = solids[tool->left.size()];
    EXPECT_NEAR(left.tool_from_solid.position.y - left.half_size.y, 0.025, 1e-12) << id;
    EXPECT_NEAR(right.tool_from_solid.position.y + right.half_size.y, -0.025, 1e-12) << id;
    for (const robots::ToolSolid& solid : solids)  // nothing reaches into the opening
      EXPECT_GE(std::abs(solid.tool_from_solid.position.y) - solid.half_size.y, 0.025 - 1e-12);
  }
}

TEST(GraspTools, AMisspeltToolIsTheNearest) {
  const auto tool = robots::load_grasp_tool(committed_rows, "panda-hnad");
  ASSERT_FALSE(tool.ok());
  EXPECT_EQ(tool.error().code, "robot.unknown");
  EXPECT_NE(tool.error().message.find("did you mean \"panda-hand\""), std::string::npos);
}

}  // namespace
}  // namespace marketgen
