// Which items of a store are drawn as goals: those that can be reached and taken, by grasps that
// the study numbers.
#include <gtest/gtest.h>

#include <algorithm>

#include "assets/product_model.h"
#include "episodes/aisle/grasp_book.h"
#include "episodes/aisle/studied_grasps.h"
#include "support/can_aisle.h"
#include "support/committed_robot.h"

namespace marketgen {
namespace {

const catalog::Product& can_row() {
  static const std::shared_ptr<const episodes::AisleStore> store = can_aisle();
  return *std::ranges::find(store->scene.catalog, "can-cola", &catalog::Product::sku);
}

robots::GraspTool aisle_gripper() {
  return robots::load_grasp_tool(committed_rows, "parallel-gripper").value();
}

TEST(AisleStore, APackUnderAnotherIsNoFrontItem) {
  const std::shared_ptr<const episodes::AisleStore> flat = can_aisle();
  ASSERT_EQ(flat->front_items("can-cola").size(), 4U);
  episodes::AisleStore stacked = *flat;
  scene::Scene& scene = stacked.scene;
  scene::Facing& facing = scene.facings[scene.products[1].facing];
  facing.stack = 2, facing.first_product = 0;
  facing.product_count = static_cast<std::uint32_t>(scene.products.size());
  for (scene::SceneProduct& product : scene.products)
    product.facing = scene.products[1].facing;
  scene.products[2].position_m = scene.products[1].position_m;
  scene.products[2].position_m[2] += static_cast<float>(can_row().height_m());
  EXPECT_TRUE(stacked.carries_another(1));
  EXPECT_FALSE(stacked.carries_another(2));
  const auto front = stacked.front_items("can-cola");
  EXPECT_EQ(std::ranges::count(front, 1U), 0);
  EXPECT_EQ(std::ranges::count(front, 2U), 1);
}

TEST(StudiedGrasps, NumbersChooseInTheirOrder) {
  const auto& frictions = committed_catalog().frictions;
  const auto all = episodes::studied_grasps(can_row(), aisle_gripper(), frictions, {});
  ASSERT_TRUE(all.ok()) << to_string(all.error());
  ASSERT_GE(all->size(), 2U);
  const auto two = episodes::studied_grasps(can_row(), aisle_gripper(), frictions, {1, 0});
  ASSERT_EQ(two->size(), 2U);
  EXPECT_EQ((*two)[0].grasp.product_from_tool.position.z,
            (*all)[1].grasp.product_from_tool.position.z);
  const auto none = episodes::studied_grasps(can_row(), aisle_gripper(), frictions, {99});
  EXPECT_EQ(none.error().code, "motion.no_grasp");
}

grasping::GraspRate rate_of_can(std::vector<grasping::GraspEnd> ends) {
  grasping::GraspRate rate;
  rate.sku = can_row().sku, rate.tool = "parallel-gripper";
  rate.setting = grasping::GraspSetting::stocked;
  for (const grasping::GraspEnd end : ends)
    rate.tries.emplace_back().end = end;
  return rate;
}

episodes::StudiedProduct studied_can(const grasping::GraspRate& known) {
  episodes::GraspBook book(aisle_gripper(), committed_catalog().frictions, {known});
  const auto studied = book.study(can_row());
  EXPECT_TRUE(book.studied().empty()) << "what is known is not tried again";
  return studied.value();
}

TEST(GraspBook, TwoOfThreeTriesHold) {
  using enum grasping::GraspEnd;
  EXPECT_EQ(studied_can(rate_of_can({held, missed, held})).grasps, (std::vector<int>{0, 2}));
  EXPECT_EQ(studied_can(rate_of_can({held, missed, missed})).why_not, "unreliable");
  EXPECT_EQ(studied_can(rate_of_can({toppled, missed})).why_not, "toppled");
  grasping::GraspRate wide = rate_of_can({});
  wide.excluded = grasping::GraspExclusion::too_wide;
  EXPECT_EQ(studied_can(wide).why_not, "too_wide");
}

// A full bottle hangs from its neck and turns between the pads when the hand looks down.
TEST(GraspBook, WhatSwingsIsNotTried) {
  const catalog::Product* syrup = committed_catalog().product("beverages-fruit-syrup-lime-0-7l");
  ASSERT_NE(syrup, nullptr);
  episodes::GraspBook book(aisle_gripper(), committed_catalog().frictions);
  const auto studied = book.study(*syrup);
  ASSERT_TRUE(studied.ok()) << to_string(studied.error());
  EXPECT_TRUE(studied->grasps.empty());
  EXPECT_EQ(studied->why_not, "swings");
  EXPECT_TRUE(book.studied().empty());
  const auto grasps =
      episodes::studied_grasps(*syrup, aisle_gripper(), committed_catalog().frictions, {});
  catalog::Product light = *syrup;
  light.mass_kg /= 10;
  const auto lighter =
      episodes::studied_grasps(light, aisle_gripper(), committed_catalog().frictions, {});
  EXPECT_NEAR(grasps->front().swing_n, 10 * lighter->front().swing_n, 1);
}

// The study's bag bulges, and some of its grasps lean with it; a store's bag is a box.
// Of flat packs whose own face leans: what a study keeps seals on the upright solid that stands in
// a store.
TEST(GraspBook, ACupMustSealOnThePackAsAStoreHasIt) {
  const robots::GraspTool cup = robots::load_grasp_tool(committed_rows, "suction-cup").value();
  const auto ahead = [](const motion::GraspCandidate& grasp) {
    return rotate(grasp.grasp.product_from_tool.rotation, {0, 0, 1}).y;
  };
  episodes::GraspBook book(cup, committed_catalog().frictions);
  const catalog::Product* noodles =
      committed_catalog().product("dry-goods-instant-noodles-shrimp-noodoki-75-g");
  ASSERT_NE(noodles, nullptr);
  int packs = 0, kept = 0;
  for (const catalog::Product& pack : committed_catalog().products) {
    if (pack.archetype != noodles->archetype) continue;
    const auto leaning = episodes::studied_grasps(pack, cup, committed_catalog().frictions, {});
    if (!leaning.ok()) {
      EXPECT_EQ(leaning.error().code, "motion.no_grasp");
      continue;
    }
    if (!std::ranges::any_of(
            *leaning, [](double y) { return y < 0.99; }, ahead))
      continue;
    for (const int number : book.study(pack).value().grasps) {
      ++kept;
      EXPECT_GT(ahead((*leaning)[static_cast<std::size_t>(number)]), 0.997) << pack.sku;
    }
    if (++packs == 30 || kept > 0) break;
  }
  EXPECT_GT(kept, 0) << "of " << packs << " packs";
}

TEST(GraspBook, ANewStudyStopsWhenItIsDecided) {
  episodes::GraspBook book(aisle_gripper(), committed_catalog().frictions);
  const auto studied = book.study(can_row());
  ASSERT_TRUE(studied.ok()) << to_string(studied.error());
  ASSERT_EQ(book.studied().size(), 1U);
  const grasping::GraspRate rate = book.studied().front();
  const int held = rate.held(), lost = static_cast<int>(rate.tries.size()) - held;
  EXPECT_NE(held == 2, lost == 2) << held << " held, " << lost << " lost";
}

}  // namespace
}  // namespace marketgen
