// Grasps from the front of what stands on a shelf, and what may be taken for what there.
#include "perception/shelf_grasps.h"

#include <gtest/gtest.h>

#include "perception/rivals.h"
#include "skills/hand_room.h"
#include "support/committed_robot.h"

namespace marketgen {
namespace {

// A can that stands on the origin, known as rows are.
agent::KnownProduct can_of(float radius_m) {
  constexpr float half_height_m = 0.05F;
  agent::KnownProduct can;
  can.product.sku = "test-can";
  can.product.mass_kg = 0.1;
  can.body.center_of_mass = {0, 0, half_height_m};
  can.body.pieces.push_back({.shape = assets::PieceShape::cylinder,
                             .center = {0, 0, half_height_m},
                             .half_size = {radius_m, radius_m, half_height_m}});
  return can;
}

double widest_opening(float radius_m) {
  const robots::GraspTool gripper =
      robots::load_grasp_tool(committed_rows, "parallel-gripper").value();
  const agent::KnownProduct can = can_of(radius_m);
  const auto grasps = perception::FrontGrasps(gripper).grasps({can, {}, {}});
  if (!grasps.ok()) fatal(to_string(grasps.error()).c_str());
  double widest = 0;
  for (const perception::SeenGrasp& grasp : *grasps)
    widest = std::max(widest, grasp.opening_m);
  return widest;
}

// The gripper opens by 90 mm.
TEST(FrontGrasps, FingersHaveRoomWhereTheToolOpensWideEnough) {
  EXPECT_NEAR(widest_opening(0.030F), 0.070, 0.002);
  EXPECT_GT(widest_opening(0.042F), 0.086) << "84 mm: closer, as it is stocked";
  EXPECT_EQ(widest_opening(0.045F), 0);
}

// A board 25 mm over the can and the whole shelf deep: hands come level, not from above.
TEST(FrontGrasps, KeepOffTheBoardOverThePack) {
  const robots::GraspTool gripper =
      robots::load_grasp_tool(committed_rows, "parallel-gripper").value();
  const agent::KnownProduct can = can_of(0.030F);
  const motion::GraspObstacle board{Pose{{0, 0.2, 0.135}, {}}, {0.5, 0.25, 0.01}};
  assets::ContactPiece box;
  box.half_size = to_float(board.half_size);
  const motion::GraspSurface surface({box});
  const auto deepest = [&](const std::vector<motion::GraspObstacle>& walls) {
    const auto grasps = perception::FrontGrasps(gripper).grasps({can, {}, {}, {}, walls});
    EXPECT_TRUE(grasps.ok());
    EXPECT_FALSE(grasps->empty());
    double deep = 0;
    for (const perception::SeenGrasp& grasp : *grasps)
      deep = std::max(deep,
                      skills::hand_overlap(skills::open_hand(gripper, grasp.opening_m),
                                           grasp.base_from_tip,
                                           skills::PlacedBody{&surface, board.world_from_box}));
    return deep;
  };
  EXPECT_GT(deepest({}), 0.005) << "nothing is tried by this test";
  EXPECT_EQ(deepest({board}), 0);
}

catalog::Product row(const char* sku, const char* category, std::array<int, 3> size_mm) {
  catalog::Product product;
  product.sku = sku;
  product.category = category;
  product.size_mm = size_mm;
  return product;
}

std::vector<std::string> skus(const std::vector<const catalog::Product*>& rows) {
  std::vector<std::string> all;
  for (const catalog::Product* each : rows)
    all.push_back(each->sku);
  return all;
}

TEST(Rivals, AreOfItsCategoryAfarAndOfAnyKindCloseBy) {
  const std::vector<catalog::Product> rows{row("tea", "drinks", {60, 50, 120}),
                                           row("other-tea", "drinks", {62, 50, 118}),
                                           row("jug", "drinks", {110, 90, 200}),
                                           row("soap", "care", {60, 48, 125}),
                                           row("stamp", "care", {20, 20, 20}),
                                           row("fridge", "drinks", {600, 600, 1800})};
  EXPECT_EQ(skus(perception::rivals_of(rows[0], rows)), std::vector<std::string>{"other-tea"});
  EXPECT_EQ(skus(perception::rivals_of_any_kind(rows[0], rows)),
            (std::vector<std::string>{"other-tea", "soap", "jug"}));
}

}  // namespace
}  // namespace marketgen
