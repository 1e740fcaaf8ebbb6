// Goods that were moved, without a copy of their scene.
#include "collect/goods_now.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

TEST(GoodsNow, OnlyWhatWasMovedStandsElsewhere) {
  scene::Scene scene;
  scene.products.resize(2);
  scene.products[0].position_m = {1, 2, 0.5F};
  scene.products[1].position_m = {3, 2, 0.5F};
  collect::GoodsNow goods(scene);
  EXPECT_EQ(goods.pose(0).position.x, 1);
  goods.move(0, {{0.1, 0, 0.2}, {}});
  // As a scene says it: in single precision.
  EXPECT_EQ(goods.pose(0).position.x, static_cast<double>(0.1F));
  EXPECT_EQ(goods.pose(1).position.x, 3);
  EXPECT_EQ(scene.products[0].position_m[0], 1);
}

}  // namespace
}  // namespace marketgen
