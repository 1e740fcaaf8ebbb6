// Doors of fixtures as a robot that opens them knows them.
#include "collect/scene_doors.h"

#include <gtest/gtest.h>

#include "collect/scene_obstacles.h"
#include "scene/fixture_stage.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

scene::Scene staged(const char* kind) {
  return scene::stage_fixture(*committed_catalog().fixture_kind(kind), committed_catalog()).value();
}

// Its front looks south: the doors are hinged on their west ends and open towards the south.
TEST(SceneDoors, EveryDoorOfACoolerHangsOnItsLeftAndHasABar) {
  const scene::Scene scene = staged("cooler-three-door");
  ASSERT_EQ(scene.joints.size(), 3U);
  for (std::uint32_t joint = 0; joint < scene.joints.size(); ++joint) {
    const auto door = collect::hinged_door(scene, joint);
    ASSERT_TRUE(door);
    EXPECT_EQ(door->along, (Vec3{1, 0, 0}));
    EXPECT_NEAR(door->out.y, -1, 1e-9);
    EXPECT_NEAR(door->length_m, 0.7, 0.01);
    EXPECT_NEAR(door->face_m - door->back_m, 0.04, 1e-6);
    EXPECT_NEAR(door->bar.out_m - door->face_m, 0.02, 1e-6);
    EXPECT_GT(door->bar.along_m, 0.65);
    EXPECT_GT(door->bar.high_m - door->bar.low_m, 0.5);
    EXPECT_NEAR(door->hold_rad, 1.4835, 1e-3);
    EXPECT_EQ(door->leaf.cylinders.size(), 1U);
  }
}

TEST(SceneDoors, ALeafTurnsAboutItsHingeTowardsWhoOpensIt) {
  const auto door = collect::hinged_door(staged("cooler-one-door"), 0).value();
  const Vec3 edge = door.point_at(door.open_rad, door.length_m, 0, 1);
  EXPECT_GT(dot(edge - door.hinge, door.out), 0.6);
  EXPECT_LT(dot(edge - door.hinge, door.along), 0);
  EXPECT_EQ(edge.z, 1);
}

TEST(SceneDoors, DrawersAndDoorsWithoutABarAreNone) {
  const scene::Scene drawers = staged("drawer-unit");
  for (std::uint32_t joint = 0; joint < drawers.joints.size(); ++joint)
    EXPECT_FALSE(collect::hinged_door(drawers, joint));
}

// An arm planner meets the leaf where it is, and not where the scene has it.
TEST(SceneDoors, ObstaclesAreWhereTheDoorIsNow) {
  const scene::Scene scene = staged("cooler-one-door");
  const auto door = collect::hinged_door(scene, 0).value();
  collect::GoodsNow store(scene);
  const Vec3 before = door.point_at(0, 0, 0.4, 1);  // where the leaf stands when it is open
  const auto meets = [&](const motion::Obstacles& obstacles) {
    const auto world = motion::CollisionWorld::make(obstacles).value();
    const auto block = motion::packed(std::vector<motion::PlainSphere>{{before, 0.06}});
    return world.hits(block, to_float(before), 0.06F);
  };
  EXPECT_FALSE(meets(collect::fixture_obstacles(store, before, 0.5)));
  store.set_joints({1.5});
  EXPECT_TRUE(meets(collect::fixture_obstacles(store, before, 0.5)));
  EXPECT_FALSE(meets(collect::fixture_obstacles(store, before, 0.5, 0)));
}

}  // namespace
}  // namespace marketgen
