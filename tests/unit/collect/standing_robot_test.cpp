// Where robots may stand: rooms with a box or a column, whose free places are plain to see.
#include "collect/standing_robot.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

// 6 x 6 m with a table of 1 x 1 x 0.9 m round (3, 3).
scene::Scene room_with_a_table() {
  scene::Scene scene;
  scene.layout.shell.width_mm = scene.layout.shell.depth_mm = 6000;
  scene.layout.shell.ceiling_mm = 3000;
  scene::ScenePart part;
  part.position_m = {0, 0, 0.45F};
  part.half_size_m = {0.5F, 0.5F, 0.45F};
  scene::SceneFixture table;
  table.part_count = 1;
  table.position_m = {3, 3, 0};
  scene.parts.push_back(part);
  scene.fixtures.push_back(table);
  layout::Fixture row;
  row.id = "till/run-1/module-1";
  scene.layout.fixtures.push_back(row);
  return scene;
}

Result<void> stand(const std::vector<std::string>& texts, const scene::Scene& scene) {
  std::vector<robots::PlacedRobot> robots;
  for (const std::string& text : texts) {
    MARKETGEN_TRY(const robots::RobotSpec spec, robots::parse_robot_spec(text, text));
    MARKETGEN_TRY(
        robots::PlacedRobot robot,
        robots::place_robot(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data", spec, text));
    robots.push_back(std::move(robot));
  }
  return collect::check_standing(scene, robots);
}

void expect_fault(const Result<void>& stood, const char* code, const char* says) {
  ASSERT_FALSE(stood.ok());
  EXPECT_EQ(stood.error().code, code) << to_string(stood.error());
  EXPECT_NE(stood.error().message.find(says), std::string::npos) << to_string(stood.error());
}

TEST(StandingRobots, FreeFloorAndTableTopsCarryThem) {
  const scene::Scene scene = room_with_a_table();
  for (const char* text :
       {"realman-rm65@1.5,1.5,30", "panda-on-stand@1.5,1.5", "panda@3,3,z=0.9", "panda@1.5,4.5"}) {
    const auto stood = stand({text}, scene);
    EXPECT_TRUE(stood.ok()) << (stood.ok() ? "" : to_string(stood.error()));
  }
}

TEST(StandingRobots, AFixtureInTheWayIsNamedWithAPlaceThatIsClear) {
  const scene::Scene scene = room_with_a_table();
  const auto stood = stand({"realman-rm65@3.2,2.6"}, scene);
  expect_fault(stood, "robot.blocked", "till/run-1/module-1; it is clear at ");
  const std::string& message = stood.error().message;
  const std::string place = message.substr(message.find("clear at ") + 9);
  EXPECT_TRUE(stand({"realman-rm65@" + place}, scene).ok()) << place;
}

TEST(StandingRobots, TheFloorEndsAtTheWalls) {
  const scene::Scene scene = room_with_a_table();
  expect_fault(stand({"panda@-1,3"}, scene), "robot.outside_store", "is not in the store");
  expect_fault(stand({"panda@7,3"}, scene), "robot.outside_store", "is not in the store");
  expect_fault(stand({"panda@1,1,z=-0.5"}, scene), "robot.outside_store", "is not in the store");
  // Its base is inside; the hand, half a metre ahead, is not.
  expect_fault(stand({"panda@5.75,3"}, scene), "robot.outside_store", "outside the walls");
  EXPECT_TRUE(stand({"panda@5.75,3,90"}, scene).ok());
}

TEST(StandingRobots, NothingHangsInTheAir) {
  const scene::Scene scene = room_with_a_table();
  expect_fault(stand({"panda@3,3,z=1.4"}, scene), "robot.no_support", "write z=0.900");
  expect_fault(stand({"panda@1,1,z=0.9"}, scene), "robot.no_support", "write z=0.000");
}

TEST(StandingRobots, ColumnsAndOtherRobotsAreInTheWay) {
  scene::Scene scene = room_with_a_table();
  scene.layout.shell.columns.push_back({1500, 1500, 400});
  expect_fault(stand({"panda@1.5,1.5"}, scene), "robot.blocked", "a column");
  expect_fault(stand({"realman-rm65@1.5,4.5", "panda@1.5,4.5"}, scene),
               "robot.blocked",
               "the robot realman-rm65");
  EXPECT_TRUE(stand({"realman-rm65@1.5,4.8", "realman-rm65@4.5,4.8,180"}, scene).ok());
}

}  // namespace
}  // namespace marketgen
