#include "physics/settle/settle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/mujoco_guard.h"
#include "unit/physics/shelf_places.h"

namespace marketgen {
namespace {

physics::SettleOptions whole_room() {
  physics::SettleOptions options;
  options.region_m = {0, 0, 6, 4};
  options.settle_s = 0.5, options.watch_s = 1;
  return options;
}

physics::SettleReport settled(const scene::Scene& scene,
                              const physics::SettleOptions& options = whole_room()) {
  const Result<physics::SettleReport> report = physics::settle(scene, options);
  EXPECT_TRUE(report.ok()) << (report.ok() ? "" : to_string(report.error()));
  return report.ok() ? *report : physics::SettleReport{};
}

TEST(Settle, ACanOnAShelfStaysWithinAMillimetre) {
  HandMadeScene made;
  made.add(can, {3, on_shelf_y, lower});
  const physics::SettleReport report = settled(made.scene);
  EXPECT_EQ(report.products, 1);
  EXPECT_LT(report.worst_drift_m, 0.001);
  EXPECT_EQ(report.share_below_5_cm, 1);
}

TEST(Settle, AnItemInTheAirFallsByItsHeightAboveTheShelf) {
  HandMadeScene made;
  made.add(can, {3, on_shelf_y, lower + 0.2F});
  const physics::SettleReport report = settled(made.scene);
  EXPECT_NEAR(report.worst_drift_m, 0.2, 0.01);
  EXPECT_EQ(report.share_below_5_cm, 0);
}

TEST(Settle, ALeaningBoxFallsOver) {  // 30 degrees about Y: its centre is beyond its lower edge
  HandMadeScene made;
  const float half = 0.5F * 30.0F * 3.14159265F / 180.0F;
  made.add(cereal, {3, on_shelf_y, upper + 0.05F}, {std::cos(half), 0, std::sin(half), 0});
  const physics::SettleReport report = settled(made.scene);
  EXPECT_GT(report.worst_drift_m, 0.05);
  EXPECT_EQ(report.worst_product, "dry/run-1/module-1/level-1/facing-0/item-0");
}

TEST(Settle, ABoxOverTheEdgeFallsOffTheShelf) {
  HandMadeScene made;
  made.add(cereal, {3, HandMadeScene::shelf_y_m - 0.26F, upper});
  EXPECT_GT(settled(made.scene).worst_drift_m, 0.3);
}

TEST(Settle, AStackOfCansStands) {  // of a row that may be stacked
  HandMadeScene made;
  made.scene.catalog[can].stack_max = 3;
  for (int level = 0; level < 3; ++level)
    made.add(can, {3, on_shelf_y, lower + 0.115F * static_cast<float>(level)});
  EXPECT_LT(settled(made.scene).worst_drift_m, 0.001);
}

TEST(Settle, AnAppleDoesNotRollAway) {
  HandMadeScene made;
  made.add(apple, {3, on_shelf_y, lower});
  EXPECT_LT(settled(made.scene).worst_drift_m, 0.002);
}

TEST(Settle, HangingGoodsHoldOnToTheirHook) {  // nothing is below them
  HandMadeScene made;
  made.scene.shelves[1].use = assets::ShelfUse::hang;
  made.add(cereal, {3, on_shelf_y - 0.6F, 1.2F});
  EXPECT_LT(settled(made.scene).worst_drift_m, 0.001);
}

TEST(Settle, TakesTheNearestToTheMiddleAndLeavesTheOthersStanding) {
  HandMadeScene made;
  made.add(can, {3, on_shelf_y, lower + 0.115F});  // stands on the next one, which is not let go
  made.add(can, {3.0001F, on_shelf_y, lower});
  made.add(can, {2.6F, on_shelf_y, lower});
  physics::SettleOptions options = whole_room();
  options.region_m = {2, 3, 4, 4};
  options.max_products = 1;
  const physics::SettleReport report = settled(made.scene, options);
  EXPECT_EQ(report.products, 1);
  EXPECT_LT(report.worst_drift_m, 0.001);
}

TEST(Settle, NothingInTheRegionIsNoFailure) {
  const physics::SettleReport report = settled(HandMadeScene().scene);
  EXPECT_EQ(report.products, 0);
  EXPECT_EQ(report.share_below_5_cm, 1);
}

TEST(Settle, IsTheSameEveryTime) {
  HandMadeScene made;
  made.stock();
  const physics::SettleReport first = settled(made.scene), second = settled(made.scene);
  EXPECT_EQ(first.worst_drift_m, second.worst_drift_m);
  EXPECT_EQ(first.median_drift_m, second.median_drift_m);
}

TEST(Settle, AMalformedPartIsAnErrorAndNotTheEnd) {
  HandMadeScene made;
  made.add(can, {3, on_shelf_y, lower});
  made.scene.parts[1].half_size_m = {-1, 0, 0};
  const Result<physics::SettleReport> report = physics::settle(made.scene, whole_room());
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, "physics.failed");
  EXPECT_NE(report.error().message.find("size"), std::string::npos) << report.error().message;
}

TEST(Guard, TurnsAMujocoErrorIntoAValue) {
  const Result<void> broken = physics::guarded("here", [] { mju_error("no such joint %d", 7); });
  ASSERT_FALSE(broken.ok());
  EXPECT_EQ(broken.error().code, "physics.failed");
  EXPECT_EQ(broken.error().where, "here");
  EXPECT_NE(broken.error().message.find("no such joint 7"), std::string::npos)
      << broken.error().message;
  EXPECT_TRUE(physics::guarded("here", [] {}).ok());
}

TEST(Region, CoversTheAisleAndTheShelvesBesideIt) {
  HandMadeScene made;
  made.stock();
  const auto region = physics::region_around_aisle(made.scene, 5);
  const std::array<double, 4> expected{0.5 - 0.6, 1.5 - 0.6, 5.5 + 0.6, 3.3 + 0.6};
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(region[i], expected[i], 1e-9);
  EXPECT_EQ(physics::region_around_aisle(made.scene, 1000)[0], 0)
      << "too few products: the whole store";
}

TEST(Physics, NamesItsEngine) {
  EXPECT_EQ(physics::physics_version(), "4.0.1");
}

}  // namespace
}  // namespace marketgen
