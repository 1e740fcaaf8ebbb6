// NAV and reach on rooms whose free floor is known.
#include "audit/traffic.h"

#include "audit/egress.h"

#include <gtest/gtest.h>

#include "audit/metrics.h"
#include "audited_shop.h"

namespace marketgen {
namespace {

// A room of 10 x 4 m with nothing in it.
scene::Scene empty_room() {
  scene::Scene scene;
  scene.layout.shell.width_mm = 10000;
  scene.layout.shell.depth_mm = 4000;
  scene.layout.shell.openings = {
      {"entrance", plan::OpeningKind::entrance, plan::Wall::south, 0.2, 1500}};
  return scene;
}

// A fixture from the south-west to the north-east corner.
void block(scene::Scene& scene, RectMm r) {
  layout::Fixture f;
  f.id = f.run = "wall-" + std::to_string(scene.layout.fixtures.size());
  f.x_mm = (r.x0 + r.x1) / 2, f.y_mm = (r.y0 + r.y1) / 2;
  f.width_mm = r.width(), f.depth_mm = r.depth();
  scene.layout.fixtures.push_back(f);
}

TEST(Traffic, AnEmptyRoomHangsTogether) {
  EXPECT_EQ(audit::measure_traffic(empty_room()).largest_share, 1);
}

TEST(Traffic, AWallOfFixturesSplitsTheRoom) {  // x = 5.9-6.1 m: 0.42-5.48 m are left on one
                                               // side, 6.52-9.58 m on the other
  scene::Scene scene = empty_room();
  block(scene, {5900, 0, 6100, 4000});
  EXPECT_NEAR(audit::measure_traffic(scene).largest_share, 5.06 / (5.06 + 3.06), 0.01);
}

TEST(Traffic, ADoorJoinsTheHalvesOnlyWhenTheRobotFits) {  // it is 0.84 m wide
  for (const auto& [gap_mm, together] : {std::pair(1100, true), std::pair(700, false)}) {
    scene::Scene scene = empty_room();
    block(scene, {5900, 0, 6100, 1500});
    block(scene, {5900, 1500 + gap_mm, 6100, 4000});
    EXPECT_EQ(audit::measure_traffic(scene).largest_share == 1, together) << gap_mm;
  }
}

TEST(Traffic, NoFloorAtAll) {
  scene::Scene scene = empty_room();
  block(scene, {0, 0, 10000, 4000});
  EXPECT_EQ(audit::measure_traffic(scene).largest_share, 0);
}

TEST(Traffic, ColumnsAndOutlinesCount) {
  scene::Scene scene = empty_room();
  scene.layout.shell.columns = {{6000, 1000, 1900}, {6000, 3000, 1900}};
  EXPECT_LT(audit::measure_traffic(scene).largest_share, 0.7);
  scene = empty_room();
  scene.layout.shell.outline_mm = PolygonMm{{0, 0},
                                            {4000, 0},
                                            {4000, 1800},
                                            {6000, 1800},
                                            {6000, 0},
                                            {10000, 0},
                                            {10000, 4000},
                                            {6000, 4000},
                                            {6000, 2200},
                                            {4000, 2200},
                                            {4000, 4000},
                                            {0, 4000}};  // two halls and a passage of 0.4 m
  EXPECT_NEAR(audit::measure_traffic(scene).largest_share, 0.5, 0.01);
}

TEST(Traffic, ShelvesBehindAWallAreOutOfReach) {
  const scene::Scene open = AuditedShop().scene;
  EXPECT_EQ(audit::measure_traffic(open).reachable_shelves, 1);
  EXPECT_TRUE(audit::measure_traffic(open).unreachable.empty());
  AuditedShop shop;
  layout::Fixture wall;
  wall.id = wall.run = "wall";
  wall.x_mm = 11500, wall.y_mm = 5000, wall.width_mm = 200,
  wall.depth_mm = 10000;  // cuts off dairy and checkout
  shop.scene.layout.fixtures.push_back(wall);
  const audit::Traffic traffic = audit::measure_traffic(shop.scene);
  EXPECT_EQ(traffic.unreachable.size(), 4U);
  EXPECT_NEAR(traffic.reachable_shelves, 1 - 4.0 / 20, 1e-9);
  EXPECT_NEAR(traffic.reachable_bays, 1 - 1.0 / 5, 1e-9) << "the dairy's is one of five";
}

TEST(Egress, GoesRoundWhatStandsThere) {
  AuditedShop shop;
  shop.scene.layout.fixtures.clear();
  const audit::Egress open = audit::measure_egress(shop.scene.layout);
  // 20 x 10 m, doors at 4 and 16 m: from the middle of the back wall 6 m along and 10 m across.
  EXPECT_NEAR(open.longest_m, 9.5 + 0.41 * 6, 0.6);
  layout::Fixture wall;
  wall.id = wall.run = "wall";
  wall.x_mm = 10000, wall.y_mm = 5000, wall.width_mm = 20000, wall.depth_mm = 200;
  shop.scene.layout.fixtures = {wall};
  EXPECT_LT(audit::measure_egress(shop.scene.layout).longest_m, 8) << "nobody is behind the wall";
  wall.x_mm = 8500, wall.width_mm = 17000;
  shop.scene.layout.fixtures = {wall};
  EXPECT_GT(audit::measure_egress(shop.scene.layout).longest_m, 18) << "round its end";
}

TEST(Metrics, FillOfKnownShelves) {  // 20 shelves of 1 m with 0.8 m each, two of them sold out
  const scene::Scene scene = AuditedShop().scene;
  ASSERT_EQ(scene.shelves.size(), 20U);
  EXPECT_NEAR(audit::shelf_fill(scene), 18 * 0.8 / 20, 1e-5);
  EXPECT_EQ(audit::shelf_fill(empty_room()), 0);
}

TEST(Metrics, SellingAreaLeavesTheTillsOut) {
  EXPECT_NEAR(audit::selling_area_m2(AuditedShop().scene), 200 - 10, 1e-9);
}

TEST(Metrics, AislesBetweenShelves) {
  AuditedShop shop;
  EXPECT_EQ(audit::shopping_aisles(shop.scene), 1);
  shop.scene.layout.aisles.push_back({"cross",
                                      layout::AisleKind::cross,
                                      {{3000, 5250}, {5500, 5250}, {5500, 7050}, {3000, 7050}},
                                      1800});
  shop.scene.layout.aisles.push_back({"front",
                                      layout::AisleKind::main,
                                      {{0, 3000}, {20000, 3000}, {20000, 4000}, {0, 4000}},
                                      1000});  // shelves on neither side
  EXPECT_EQ(audit::shopping_aisles(shop.scene), 1);
}

}  // namespace
}  // namespace marketgen
