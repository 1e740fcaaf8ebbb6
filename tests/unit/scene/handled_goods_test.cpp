// How shoppers leave what they do not take: on shelves made by hand, and in whole shops by the
// hour.
#include "scene/handled_goods.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "geometry/pose.h"
#include "hand_made_stock.h"
#include "scene_of.h"

namespace marketgen {
namespace {

// Of a tin, a box of cereals (which falls), and a thin bar that leans.
const catalog::Catalog& goods() {
  static const catalog::Catalog catalog =
      catalog_of({stock_row("beans", "can", {75, 75, 110}, 0.4, 2),
                  stock_row("cereals", "box", {120, 70, 200}, 0.5),
                  stock_row("bars", "box", {60, 25, 160}, 0.1)});
  return catalog;
}

struct Shelf {
  scene::PlannedShelf planned;
  scene::ShelfRoom room = shelf_room();
  std::vector<scene::FilledBlock> blocks;
  scene::SoldOfShelf sold;
};

// Some facings of each, of which `taken` packs are gone.
Shelf shopped(int taken, std::uint64_t seed) {
  Shelf shelf;
  shelf.planned = {{0, 4}, {1, 3}, {2, 4}};
  plan::StockSpec stock;
  stock.out_of_stock = 0;
  shelf.blocks = scene::fill_shelf(shelf.planned, shelf.room, stock, goods(), Stream(seed));
  for (scene::FilledBlock& block : shelf.blocks)
    shelf.sold.push_back(take_sold(block, {0, taken}, false, false, Stream(seed)));
  return shelf;
}

void handle(Shelf& shelf, double jitter, std::uint64_t seed) {
  handle_goods(shelf.blocks,
               shelf.sold,
               shelf.planned,
               shelf.room,
               jitter,
               goods(),
               Seed(seed).child("handled"),
               Seed(seed).child("strange"));
}

std::vector<scene::ShelfItem> items_on(const Shelf& shelf) {
  std::vector<scene::ShelfItem> items;
  for (const scene::FilledBlock& block : shelf.blocks)
    items.insert(items.end(), block.items.begin(), block.items.end());
  return items;
}

bool is_out_of_line(const scene::ShelfItem& item) {
  return (item.flags & scene::product_out_of_line) != 0;
}

bool stands_upright(const scene::ShelfItem& item) {
  return item.rotation.x == 0 && item.rotation.y == 0;
}

int number_out_of_line(int taken, double jitter) {
  int number = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Shelf shelf = shopped(taken, seed);
    handle(shelf, jitter, seed);
    number += static_cast<int>(std::ranges::count_if(items_on(shelf), is_out_of_line));
  }
  return number;
}

TEST(HandledGoods, AreTouchedByWhatWasTakenAndHowTidyTheZoneIs) {
  EXPECT_EQ(number_out_of_line(0, 1), 0);
  EXPECT_EQ(number_out_of_line(12, 0), 0);
  EXPECT_GT(number_out_of_line(4, 0.2), 0);
  EXPECT_GT(number_out_of_line(12, 0.2), number_out_of_line(4, 0.2));
  EXPECT_GT(number_out_of_line(12, 0.8), number_out_of_line(12, 0.2));
}

// Only foremost packs move, all others stand to the last bit as they were.
TEST(HandledGoods, MoveInFrontAlone) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Shelf shelf = shopped(10, seed);
    const std::vector<scene::ShelfItem> before = items_on(shelf);
    handle(shelf, 1, seed);
    const std::vector<scene::ShelfItem> after = items_on(shelf);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_EQ(before[i].position.x, after[i].position.x);
      if ((before[i].flags & scene::product_front_row) != 0) continue;
      EXPECT_EQ(before[i].position, after[i].position);
      EXPECT_EQ(before[i].rotation, after[i].rotation);
    }
  }
}

// Corners of a pack in the shelf's frame.
std::vector<Vec3> corners_of(const scene::ShelfItem& item) {
  const catalog::Product& product = goods().products[item.product];
  std::vector<Vec3> corners;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      for (const double z : {0.0, 1.0})
        corners.push_back(Pose{item.position, item.rotation} * Vec3{x * product.width_m(),
                                                                    y * product.depth_m(),
                                                                    z * product.height_m()});
  return corners;
}

TEST(HandledGoods, StayOnTheirBoardAndRest) {
  int lying = 0, leaning = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    Shelf shelf = shopped(14, seed);
    handle(shelf, 1, seed);
    for (const scene::ShelfItem& item : items_on(shelf)) {
      double lowest = 1;
      for (const Vec3& corner : corners_of(item)) {
        lowest = std::min(lowest, corner.z);
        const double beyond = item.product == 0 ? 0.016 : 0.001;  // the box of a turned tin
        EXPECT_GE(corner.y, -beyond);
        EXPECT_LE(corner.y, shelf.room.depth_m + beyond);
        EXPECT_LE(std::abs(corner.x), shelf.room.width_m / 2 + beyond);
        EXPECT_LE(corner.z, shelf.room.clearance_m);
      }
      EXPECT_GE(lowest, -1e-9);
      if (stands_upright(item)) continue;
      EXPECT_NEAR(lowest, 0, 1e-9);
      const double over = 1 - 2 * item.rotation.x * item.rotation.x;  // cosine
      (over < 0.1 ? lying : leaning) += 1;
      EXPECT_TRUE(over < 0.1 || goods().products[item.product].sku == "bars");
    }
  }
  EXPECT_GT(lying, 5);
  EXPECT_GT(leaning, 5);
}

TEST(HandledGoods, AreTheSameOfTheSameSeed) {
  Shelf one = shopped(9, 3), other = shopped(9, 3);
  handle(one, 0.7, 5);
  handle(other, 0.7, 5);
  const auto a = items_on(one), b = items_on(other);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].position, b[i].position);
    EXPECT_EQ(a[i].rotation, b[i].rotation);
  }
}

// ---- Whole shops ----

HandLaidShop untidy_shop_at(const char* time, double jitter) {
  HandLaidShop shop = shop_of(selling_types());
  shop.plan.time = time;
  for (plan::Zone& zone : shop.plan.zones)
    zone.stock.jitter = jitter;
  return shop;
}

std::size_t touched(const scene::Scene& scene) {
  return static_cast<std::size_t>(
      std::ranges::count_if(scene.products, [](const scene::SceneProduct& item) {
        return (item.flags & scene::product_out_of_line) != 0;
      }));
}

std::size_t strange(const scene::Scene& scene) {
  return static_cast<std::size_t>(
      std::ranges::count_if(scene.products, [](const scene::SceneProduct& item) {
        return (item.flags & scene::product_misplaced) != 0;
      }));
}

TEST(DisorderByTheHour, GrowsUntilStaffComeAgain) {
  std::size_t before = 0;
  for (const char* time : {"Sat 08:30", "Sat 10:00", "Sat 12:00", "Sat 13:30"}) {
    const std::size_t now = touched(scene_of(untidy_shop_at(time, 0.2)));
    EXPECT_GT(now, before) << time;
    before = now;
  }
  EXPECT_EQ(touched(scene_of(untidy_shop_at("Sat 06:00", 0.2))), 0U);
  EXPECT_LT(touched(scene_of(untidy_shop_at("Sat 14:05", 0.2))),
            before);  // half was faced up again
  EXPECT_GT(touched(scene_of(untidy_shop_at("Sat 13:30", 0.8))), before);
}

TEST(DisorderByTheHour, IsNoneWithoutATimeOrWhereAllIsFacedUp) {
  HandLaidShop shop = shop_of(selling_types());
  EXPECT_EQ(touched(scene_of(shop)), 0U);
  EXPECT_EQ(touched(scene_of(untidy_shop_at("Sat 18:00", 0))), 0U);
  EXPECT_EQ(strange(scene_of(untidy_shop_at("Sat 18:00", 0))), 0U);
  EXPECT_GT(strange(scene_of(untidy_shop_at("Sat 18:00", 1))), 0U);
}

// Just faced up: whatever is sold is missing at the back, every column begins at the edge.
TEST(DisorderByTheHour, FacedUpShelvesAreFullInFront) {
  const scene::Scene full = scene_of(untidy_shop_at("Mon 06:00", 0)),
                     evening = scene_of(untidy_shop_at("Sat 18:00", 0));
  ASSERT_LT(evening.products.size(), full.products.size());
  std::set<std::array<float, 3>> in_front;
  for (const scene::SceneProduct& item : full.products)
    if ((item.flags & scene::product_front_row) != 0) in_front.insert(item.position_m);
  for (const scene::SceneProduct& item : evening.products) {
    const scene::Facing& facing = evening.facings[item.facing];
    const std::string& sku = evening.catalog[facing.sku].sku;
    if (scene::lies_in_a_heap(*committed_catalog().product(sku))) continue;
    const bool foremost = (item.flags & scene::product_front_row) != 0;
    EXPECT_TRUE(!foremost || in_front.contains(item.position_m)) << sku;
  }
}

}  // namespace
}  // namespace marketgen
