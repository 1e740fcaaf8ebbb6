// COL and OOB against known answers; the sweep against every pair.
#include "audit/collisions.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "audit/audit.h"
#include "audit/item_bounds.h"
#include "base/seed.h"
#include "scene/placements.h"
#include "support/hand_laid_shop.h"
#include "support/hand_made_scene.h"

namespace marketgen {
namespace {

constexpr std::uint32_t cereal = 0, can = 1,
                        apple = 2;  // boxes of 190 x 60 x 280, cans of 66 x 115 mm, apples
constexpr float board = HandMadeScene::lower_board_m, upper = HandMadeScene::upper_board_m;
constexpr float y = HandMadeScene::shelf_y_m - 0.1F;

audit::CollisionCount counted(const scene::Scene& scene) {
  const auto bounds = audit::item_bounds(scene);
  EXPECT_TRUE(bounds.ok());
  const auto count = audit::count_collisions(scene, *bounds);
  EXPECT_TRUE(count.ok()) << (count.ok() ? "" : to_string(count.error()));
  return count.ok() ? *count : audit::CollisionCount{99, 99, std::nullopt};
}

std::vector<std::uint32_t> outside(const scene::Scene& scene) {
  return audit::items_out_of_place(scene, *audit::item_bounds(scene));
}

std::array<float, 4> yaw(double degrees) {
  const double half = degrees * 3.14159265358979 / 360;
  return {static_cast<float>(std::cos(half)), 0, 0, static_cast<float>(std::sin(half))};
}

TEST(Collisions, TwoBoxesTwoMillimetresIntoOneAnother) {
  HandMadeScene made;
  made.add(cereal, {3.0F, y, upper});
  made.add(cereal, {3.188F, y, upper});
  EXPECT_EQ(counted(made.scene).colliding_pairs, 1U);
  EXPECT_EQ(counted(made.scene).near_pairs, 1U);
}

TEST(Collisions, TheDeepestPairIsNamedWithItsDepth) {
  HandMadeScene made;
  made.add(cereal, {3.0F, y, upper});
  made.add(cereal, {3.188F, y, upper});
  made.add(cereal, {3.373F, y, upper});
  const auto count = counted(made.scene);
  ASSERT_TRUE(count.deepest);
  EXPECT_EQ(count.deepest->items, physics::ProductPair(1, 2));
  EXPECT_NEAR(count.deepest->depth_m, 0.005, 1e-4);
}

TEST(Collisions, HalfAMillimetreIsAllowed) {
  HandMadeScene made;
  made.add(cereal, {3.0F, y, upper});
  made.add(cereal, {3.1895F, y, upper});
  EXPECT_EQ(counted(made.scene).colliding_pairs, 0U);
}

TEST(Collisions, AStackTouchesAndDoesNotCollide) {
  HandMadeScene made;
  for (int i = 0; i < 3; ++i)
    made.add(can, {3.0F, y, board + 0.115F * static_cast<float>(i)});
  EXPECT_EQ(counted(made.scene).colliding_pairs, 0U);
  EXPECT_EQ(counted(made.scene).near_pairs, 2U);
}

TEST(Collisions, CansHalfAMillimetreApart) {
  HandMadeScene made;
  for (int i = 0; i < 4; ++i)
    made.add(can, {2.8F + 0.0665F * static_cast<float>(i), y, board});
  EXPECT_EQ(counted(made.scene).colliding_pairs, 0U);
  EXPECT_EQ(counted(made.scene).near_pairs, 3U);
}

TEST(Collisions, ACanInTheFlankOfABox) {
  HandMadeScene made;
  made.add(cereal, {3.0F, y, board});
  made.add(can, {3.0F + 0.095F + 0.033F - 0.003F, y, board});
  EXPECT_EQ(counted(made.scene).colliding_pairs, 1U);
}

TEST(
    Collisions,
    ACanAtTheCornerOfABox) {  // their boxes overlap by 5 mm, but the can is round: 6.6 mm stay free
  HandMadeScene made;
  made.add(cereal, {3.0F, y, board});
  made.add(can, {3.0F + 0.095F + 0.028F, y + 0.03F + 0.028F, board});
  EXPECT_EQ(counted(made.scene).colliding_pairs, 0U);
  EXPECT_EQ(counted(made.scene).near_pairs, 1U);
}

TEST(Collisions, ATurnedCanTakesNoMoreRoom) {
  HandMadeScene made;
  made.add(can, {3.0F, y, board}, yaw(45));
  made.add(can, {3.0665F, y, board}, yaw(10));
  EXPECT_EQ(counted(made.scene).colliding_pairs, 0U);
}

TEST(Collisions, ATurnedBoxDoes) {
  HandMadeScene made;
  made.add(cereal, {3.0F, y, upper}, yaw(20));
  made.add(cereal, {3.0F, y + 0.065F, upper});
  EXPECT_EQ(counted(made.scene).colliding_pairs, 1U);
}

TEST(Collisions, NobodyIsNearNobody) {
  HandMadeScene made;
  EXPECT_EQ(counted(made.scene).near_pairs, 0U);
  made.add(can, {3.0F, y, board});
  EXPECT_EQ(counted(made.scene).near_pairs, 0U);
  made.add(can, {3.0F, y, upper});
  EXPECT_EQ(counted(made.scene).near_pairs, 0U);
}

TEST(Collisions, TheSweepFindsEveryPair) {  // against all pairs, on places that lie on the borders
                                            // of the sweep's strips too
  Stream draw(4);
  HandMadeScene made;
  for (int i = 0; i < 300; ++i) {
    const float x = static_cast<float>(draw.uniform(0.2, 5.8));
    const float north = i % 2 == 0 ? static_cast<float>(draw.uniform(0.2, 3.8))
                                   : 0.25F * static_cast<float>(draw.integer(1, 15));
    made.add(static_cast<std::uint32_t>(draw.integer(0, 2)),
             {x, north, static_cast<float>(draw.uniform(0, 0.3))},
             yaw(draw.uniform(-180, 180)));
  }
  const auto bounds = audit::item_bounds(made.scene);
  ASSERT_TRUE(bounds.ok());
  std::uint64_t near = 0;
  for (std::size_t a = 0; a < bounds->size(); ++a) {
    for (std::size_t b = a + 1; b < bounds->size(); ++b) {
      const Bounds3 &p = (*bounds)[a], &q = (*bounds)[b];
      const auto apart = [](float low_p, float high_p, float low_q, float high_q) {
        return std::max(low_p, low_q) - std::min(high_p, high_q);
      };
      const float gap = std::max({apart(p.low.x, p.high.x, q.low.x, q.high.x),
                                  apart(p.low.y, p.high.y, q.low.y, q.high.y),
                                  apart(p.low.z, p.high.z, q.low.z, q.high.z)});
      near += gap <= 0.005F ? 1 : 0;
    }
  }
  EXPECT_GT(near, 50U);
  EXPECT_EQ(counted(made.scene).near_pairs, near);
}

// A model of MuJoCo that holds them all takes minutes to make, and grows with the square.
TEST(Collisions, ThirtyThousandPairsInOneAnother) {
  HandMadeScene made;
  for (int i = 0; i < 30'000; ++i) {
    const float x = 0.5F * static_cast<float>(i % 300), north = 0.5F * static_cast<float>(i / 300);
    made.add(cereal, {x, north, 0});
    made.add(cereal, {x + 0.1F, north, 0});
  }
  const auto start = std::chrono::steady_clock::now();
  const audit::CollisionCount count = counted(made.scene);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(40));
  EXPECT_EQ(count.near_pairs, 30'000U);
  EXPECT_EQ(count.colliding_pairs, 30'000U);
}

// Goods of 9 mm, as a shop of them has them: each is near to those around it only, however many
// stand in the same strip of the store.
TEST(Collisions, ATonOfSmallGoods) {
  HandMadeScene made;
  made.scene.catalog.at(can).size_mm = {9, 9, 9};
  for (int i = 0; i < 200'000; ++i) {
    made.scene.products.push_back({can,
                                   scene::no_facing,
                                   {0.01F * static_cast<float>(i % 100),
                                    0.01F * static_cast<float>(i / 100 % 50),
                                    0.01F * static_cast<float>(i / 5000)},
                                   {1, 0, 0, 0},
                                   0});
  }
  const auto start = std::chrono::steady_clock::now();
  const audit::CollisionCount count = counted(made.scene);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(40));
  EXPECT_EQ(count.colliding_pairs, 0U);
  EXPECT_GT(count.near_pairs, 2'000'000U);
}

// ---- Items out of place. ----

TEST(OutOfPlace, KnownPlaces) {  // the shelf is 1.24 m wide, 0.44 m deep, its front edge at y
                                 // = 3.48; 0.36 m are free above the lower board
  struct Case {
    const char* name;
    std::uint32_t sku;
    std::array<float, 3> position;
    bool out;
  };
  const Case cases[] = {
      {"in the middle", can, {3, y, board}, false},
      {"at the left end", can, {3 - 0.62F + 0.033F, y, board}, false},
      {"2 mm over the left end", can, {3 - 0.62F + 0.031F, y, board}, true},
      {"2 mm over the right end", can, {3 + 0.62F - 0.031F, y, board}, true},
      {"at the front edge", can, {3, 3.48F + 0.033F, board}, false},
      {"2 mm over the front edge", can, {3, 3.48F + 0.031F, board}, true},
      {"2 mm into the back panel", can, {3, 3.92F - 0.031F, board}, true},
      {"2 mm into the board", can, {3, y, board - 0.002F}, true},
      {"under the next board", cereal, {3, y, board + 0.079F}, false},
      {"2 mm into the next board", cereal, {3, y, board + 0.082F}, true},
  };
  for (const Case& c : cases) {
    HandMadeScene made;
    made.add(c.sku, c.position);
    EXPECT_EQ(outside(made.scene).size(), c.out ? 1U : 0U) << c.name;
  }
}

TEST(OutOfPlace, PinnedItemsNeedOnlyTheRoom) {
  HandMadeScene made;
  made.scene.products.push_back({can, scene::no_facing, {1, 1, 0}, {1, 0, 0, 0}, 0});
  EXPECT_TRUE(outside(made.scene).empty());
  made.scene.products.push_back(
      {can, scene::no_facing, {0.03F, 1, 0}, {1, 0, 0, 0}, 0});  // in the west wall
  made.scene.products.push_back(
      {can, scene::no_facing, {1, 1, -0.01F}, {1, 0, 0, 0}, 0});  // in the floor
  made.scene.products.push_back(
      {can, scene::no_facing, {1, 1, 2.9F}, {1, 0, 0, 0}, 0});  // in the ceiling
  made.scene.products.push_back(
      {can, scene::no_facing, {1, 4.2F, 0}, {1, 0, 0, 0}, 0});  // in the street
  EXPECT_EQ(outside(made.scene), (std::vector<std::uint32_t>{1, 2, 3, 4}));
}

TEST(OutOfPlace, TheRoomIsItsOutline) {  // an L: the north-east quarter is not part of it
  HandMadeScene made;
  made.scene.layout.shell.outline_mm =
      PolygonMm{{0, 0}, {6000, 0}, {6000, 2000}, {3000, 2000}, {3000, 4000}, {0, 4000}};
  made.scene.products.push_back({can, scene::no_facing, {1, 3, 0}, {1, 0, 0, 0}, 0});
  made.scene.products.push_back({can, scene::no_facing, {5, 1, 0}, {1, 0, 0, 0}, 0});
  EXPECT_TRUE(outside(made.scene).empty());
  made.scene.products.push_back({can, scene::no_facing, {5, 3, 0}, {1, 0, 0, 0}, 0});
  made.scene.products.push_back({can, scene::no_facing, {3.01F, 3, 0}, {1, 0, 0, 0}, 0});
  EXPECT_EQ(outside(made.scene), (std::vector<std::uint32_t>{2, 3}));
}

// ---- Whole shelves of every kind, as untidy as they get: MuJoCo is the judge. ----

TEST(Collisions, GeneratedShelvesHaveNone) {
  HandLaidShop shop = shop_of(selling_types());
  for (plan::Zone& zone : shop.plan.zones) {
    zone.stock.jitter = 1;
    zone.stock.misplaced = 0.2;
    zone.stock.fill = 1;
  }
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const auto scene = scene::build_scene(shop.layout, shop.plan, committed_catalog(), Seed(seed));
    ASSERT_TRUE(scene.ok()) << to_string(scene.error());
    const audit::CollisionCount count = counted(*scene);
    EXPECT_EQ(count.colliding_pairs, 0U);
    EXPECT_GT(count.near_pairs, 1000U);
    const auto out = outside(*scene);
    EXPECT_TRUE(out.empty()) << out.size() << " items, first "
                             << scene::product_id(*scene, out.front()) << " "
                             << scene->catalog[scene->products[out.front()].sku].sku;
  }
}

}  // namespace
}  // namespace marketgen
