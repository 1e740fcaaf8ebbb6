// Where a block stands in its bay, and what stands in it.
#include "scene/planogram_rows.h"

#include <gtest/gtest.h>

#include "support/hand_made_scene.h"

namespace marketgen {
namespace {

// The hand-made shelf with one can at its left end, on the upper board.
scene::Scene one_can() {
  HandMadeScene made;
  made.add(1, {2.45F, HandMadeScene::shelf_y_m - 0.1F, HandMadeScene::upper_board_m});
  made.scene.facings[0].x_m = 0.02F, made.scene.facings[0].width_m = 0.14F;
  made.scene.facings[0].facings = 2, made.scene.facings[0].rows_deep = 3;
  return made.scene;
}

TEST(PlanogramRows, MeasureFromTheLeftFrontOfTheBay) {
  const std::vector<scene::PlanogramRow> rows = scene::planogram_rows(one_can());
  ASSERT_EQ(rows.size(), 1U);
  const scene::PlanogramRow& row = rows[0];
  // The bay is 1.25 m wide and 0.5 m deep, the shelf 1.24 m and its edge 0.22 m before the middle.
  EXPECT_EQ(row.bay_width_mm, 1250);
  EXPECT_EQ(row.bay_x_mm, 5 + 20);
  EXPECT_EQ(row.bay_y_mm, 250 - 220);
  EXPECT_EQ(row.bay_z_mm, 550);
  EXPECT_EQ(row.shelf_height_mm, 550);
  EXPECT_EQ(row.bay, 1);
}

TEST(PlanogramRows, AreTheSameWhereverTheFixtureStands) {
  scene::Scene turned = one_can();  // faces west
  turned.layout.fixtures[0].yaw_deg = 270, turned.fixtures[0].quarter_turns = 3;
  turned.layout.fixtures[0].x_mm = 1000, turned.fixtures[0].position_m[0] = 1;
  const scene::PlanogramRow row = scene::planogram_rows(turned).at(0);
  EXPECT_EQ(row.bay_x_mm, 25);
  EXPECT_EQ(row.bay_y_mm, 30);
  EXPECT_EQ(row.bay_z_mm, 550);
}

TEST(PlanogramRows, TheBackOfAModuleIsABayOfItsOwn) {
  scene::Scene scene = one_can();
  scene.shelves[1].side = 1, scene.shelves[1].rotation_wxyz = {0, 0, 0, 1};  // faces north
  scene.shelves[1].position_m = {0, 0.22F, HandMadeScene::upper_board_m};
  const scene::PlanogramRow row = scene::planogram_rows(scene).at(0);
  EXPECT_EQ(row.side, 1);
  EXPECT_EQ(row.bay_x_mm, 25);
  EXPECT_EQ(row.bay_y_mm, 30);
}

TEST(PlanogramRows, CountWhatStandsAndWhatHasRoom) {
  scene::Scene scene = one_can();
  scene::PlanogramRow row = scene::planogram_rows(scene).at(0);
  EXPECT_EQ(row.units, 1);
  EXPECT_EQ(row.capacity, 6);
  EXPECT_EQ(row.misplaced, 0);
  EXPECT_EQ(row.orientation, scene::PackFace::front);
  scene.products[0].sku = 0;  // a box in the can's place, its side to the front
  scene.products[0].rotation_wxyz = {0.70710678F, 0, 0, 0.70710678F};
  row = scene::planogram_rows(scene).at(0);
  EXPECT_EQ(row.misplaced, 1);
  EXPECT_EQ(row.orientation, scene::PackFace::side);
  scene.shelves[1].use = assets::ShelfUse::heap;
  EXPECT_EQ(scene::planogram_rows(scene).at(0).orientation, scene::PackFace::loose);
}

}  // namespace
}  // namespace marketgen
