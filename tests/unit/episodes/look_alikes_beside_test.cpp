#include "episodes/aisle/look_alikes_beside.h"

#include <gtest/gtest.h>

#include "catalog/look_alike.h"
#include "support/committed_catalog.h"

namespace marketgen::episodes {
namespace {

// One facing of each row, at these places along a board.
scene::Scene board_of(const std::vector<catalog::Product>& rows, const std::vector<float>& at_x_m) {
  scene::Scene scene;
  scene.catalog = rows;
  for (std::uint32_t i = 0; i < rows.size(); ++i) {
    scene::Facing facing;
    facing.sku = facing.first_product = i;
    facing.product_count = 1;
    scene.facings.push_back(facing);
    scene::SceneProduct product;
    product.sku = product.facing = i;
    product.position_m = {at_x_m[i], 0, 1};
    scene.products.push_back(product);
  }
  return scene;
}

// Two that are alike, and one that is like neither.
std::vector<catalog::Product> two_alike_and_another() {
  const std::vector<catalog::Product>& all = committed_catalog().products;
  for (const catalog::Product& first : all)
    for (const catalog::Product& second : all) {
      if (!catalog::are_look_alikes(first, second)) continue;
      for (const catalog::Product& third : all)
        if (third.category != first.category && !catalog::are_look_alikes(first, third) &&
            !catalog::are_look_alikes(second, third))
          return {first, second, third};
    }
  return {};
}

TEST(LookAlikesBeside, StandWithinAMetre) {
  const std::vector<catalog::Product> rows = two_alike_and_another();
  ASSERT_EQ(rows.size(), 3U);
  const std::set<std::string> both{rows[0].sku, rows[1].sku};
  EXPECT_EQ(skus_with_look_alikes_beside(board_of(rows, {0, 0.9F, 0.1F})), both);
  EXPECT_TRUE(skus_with_look_alikes_beside(board_of(rows, {0, 1.2F, 0.1F})).empty());
}

TEST(LookAlikesBeside, WhatIsSoldOutStandsNowhere) {
  const std::vector<catalog::Product> rows = two_alike_and_another();
  scene::Scene scene = board_of(rows, {0, 0.5F, 1});
  scene.facings[1].product_count = 0;
  EXPECT_TRUE(skus_with_look_alikes_beside(scene).empty());
}

}  // namespace
}  // namespace marketgen::episodes
