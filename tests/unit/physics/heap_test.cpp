// Heaps: the committed rows lie still when they are cut and let go, and settling makes such rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "physics/settle/heap.h"
#include "physics/settle/penetration.h"
#include "physics/settle/settle.h"
#include "scene/heap_fill.h"
#include "scene/placements.h"
#include "scene/shelf_fill.h"
#include "support/hand_laid_shop.h"

namespace marketgen {
namespace {

constexpr scene::ShelfRoom room{0.55, 0.60, 0.45, assets::ShelfUse::stand};
constexpr scene::ShelfRoom small_room{0.36, 0.36, 0.45, assets::ShelfUse::stand};
constexpr double corner_m = 4;  // of the room, in the middle of a bare floor

scene::Scene heap_on_the_floor(const catalog::Product& product,
                               const std::vector<scene::HeapItem>& items) {
  scene::Scene scene;
  scene.layout.shell.width_mm = scene.layout.shell.depth_mm = 9000;
  scene.layout.shell.ceiling_mm = 3000;
  scene.catalog.push_back(product);
  for (const scene::HeapItem& item : items) {
    const Vec3 p = item.pose.position;
    const Quaternion& q = item.pose.rotation;
    scene::SceneProduct one;
    one.facing = scene::no_facing;
    one.position_m = {static_cast<float>(corner_m + p.x),
                      static_cast<float>(corner_m + p.y),
                      static_cast<float>(p.z)};
    one.rotation_wxyz = {static_cast<float>(q.w),
                         static_cast<float>(q.x),
                         static_cast<float>(q.y),
                         static_cast<float>(q.z)};
    scene.products.push_back(one);
  }
  return scene;
}

// Of the whole heap, uncut.
double deepest_overlap(const catalog::Product& product, const catalog::HeapRow& row) {
  std::vector<scene::HeapItem> items;
  for (const catalog::HeapPiece& piece : catalog::pieces_of(row))
    items.push_back({piece.pose, piece.lies_on.empty()});
  const scene::Scene scene = heap_on_the_floor(product, items);
  const double reach = 2 * length(Vec3{product.width_m(), product.depth_m(), product.height_m()});
  std::vector<physics::ProductPair> pairs;
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    for (std::uint32_t j = i + 1; j < items.size(); ++j) {
      if (length(items[i].pose.position - items[j].pose.position) < reach) pairs.emplace_back(i, j);
    }
  }
  const std::vector<double> depths = physics::penetration_depths(scene, pairs).value();
  return depths.empty() ? 0 : *std::ranges::max_element(depths);
}

TEST(Heaps, EveryRoundLooseProductHasOne) {
  int products = 0;
  for (const catalog::Product& product : committed_catalog().products) {
    if (!scene::lies_as_balls(product)) continue;
    ++products;
    ASSERT_NE(committed_catalog().heap(product), nullptr)
        << product.sku << ": run marketgen assets heaps -o data/heaps.json";
    EXPECT_GE(catalog::pieces_of(*committed_catalog().heap(product)).size(), 5U) << product.sku;
  }
  EXPECT_GE(products, 50);
}

TEST(Heaps, EveryPieceLiesWhollyInTheFootprintOfItsRow) {
  for (const catalog::Product& product : committed_catalog().products) {
    const catalog::HeapRow* row =
        scene::lies_as_balls(product) ? committed_catalog().heap(product) : nullptr;
    if (row == nullptr) continue;
    SCOPED_TRACE(product.sku);
    const assets::CollisionPrimitive primitive = assets::collision_of(product).value();
    ASSERT_EQ(primitive.shape, assets::CollisionShape::ellipsoid);
    const Vec3f h = primitive.half_size;
    for (const catalog::HeapPiece& piece : catalog::pieces_of(*row)) {
      const Vec3 middle = piece.pose * Vec3{0, 0, primitive.center.z};
      const Vec3 reach = ellipsoid_half_extents(piece.pose.rotation, {h.x, h.y, h.z});
      EXPECT_GE(std::min(middle.x - reach.x, middle.y - reach.y), 0);
      EXPECT_LE(middle.x + reach.x, 1e-3 * row->width_mm);
      EXPECT_LE(middle.y + reach.y, 1e-3 * row->depth_mm);
    }
  }
}

TEST(Heaps, CutToARoomTheyStayInItAndLieOnOneAnother) {
  Stream draw(3);
  for (const catalog::Product& product : committed_catalog().products) {
    const catalog::HeapRow* row =
        scene::lies_as_balls(product) ? committed_catalog().heap(product) : nullptr;
    if (row == nullptr || product.width_m() > 0.12) continue;
    SCOPED_TRACE(product.sku);
    const std::vector<scene::HeapItem> items = scene::laid_heap(*row, product, room, 0, draw);
    const auto on_board =
        std::ranges::count_if(items, [](const scene::HeapItem& item) { return item.on_board; });
    EXPECT_GE(on_board, 4);
    EXPECT_GT(std::ssize(items), on_board);
    for (const scene::HeapItem& item : items) {
      EXPECT_GE(item.pose.position.x, -0.1);
      EXPECT_LE(item.pose.position.x, room.width_m + 0.1);
      EXPECT_LE(item.pose.position.z, room.clearance_m);
    }
  }
}

TEST(Heaps, LetGoTheyLieStill) {
  Stream draw(4);
  std::set<std::string> seen;
  double still = 0, all = 0;
  for (const catalog::Product& product : committed_catalog().products) {
    const catalog::HeapRow* row =
        scene::lies_as_balls(product) ? committed_catalog().heap(product) : nullptr;
    if (row == nullptr || !seen.insert(product.archetype).second) continue;
    SCOPED_TRACE(product.sku);
    const scene::Scene scene =
        heap_on_the_floor(product, scene::laid_heap(*row, product, small_room, 0.1, draw));
    if (scene.products.size() < 2) continue;  // larger than the room
    physics::SettleOptions options;
    options.region_m = {0, 0, 9, 9};
    options.watch_s = 1;
    const physics::SettleReport report = physics::settle(scene, options).value();
    EXPECT_EQ(report.products, std::min<int>(200, static_cast<int>(scene.products.size())));
    EXPECT_LT(report.median_drift_m, 0.01);
    still += report.share_below_5_cm * report.products;
    all += report.products;
  }
  EXPECT_GE(seen.size(), 10U);
  EXPECT_GE(all, 200);
  EXPECT_GE(still, 0.95 * all) << all;
}

TEST(Heaps, SettlingMakesTheSameHeapEveryTimeAndPiecesDoNotOverlap) {
  const catalog::Product* melon = nullptr;  // few pieces: quick
  for (const catalog::Product& product : committed_catalog().products) {
    if (scene::lies_as_balls(product) && (melon == nullptr || product.width_m() > melon->width_m()))
      melon = &product;
  }
  ASSERT_NE(melon, nullptr);
  const catalog::HeapRow row = physics::settle_heap(*melon).value();
  EXPECT_EQ(row.poses, physics::settle_heap(*melon)->poses);
  EXPECT_EQ(row.poses, committed_catalog().heap(*melon)->poses);
  EXPECT_EQ(row.supports, committed_catalog().heap(*melon)->supports);
  ASSERT_GE(catalog::pieces_of(row).size(), 4U);
  EXPECT_LT(deepest_overlap(*melon, row), physics::penetration_limit_m);
}

TEST(Heaps, NoTwoPiecesOfACommittedRowAreFurtherInsideOneAnotherThanTheRuleAllows) {
  for (const catalog::Product& product : committed_catalog().products) {
    const catalog::HeapRow* row =
        scene::lies_as_balls(product) ? committed_catalog().heap(product) : nullptr;
    if (row == nullptr) continue;
    EXPECT_LT(deepest_overlap(product, *row), 0.8 * physics::penetration_limit_m) << product.sku;
  }
}

TEST(Heaps, AProductWithoutAShapeIsAnError) {
  catalog::Product product;
  product.archetype = "no_such_shape";
  EXPECT_FALSE(physics::settle_heap(product).ok());
}

}  // namespace
}  // namespace marketgen
