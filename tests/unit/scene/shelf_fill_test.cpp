// Filled shelves, measured by brute force in the plane: nothing outside, nothing closer than 1 mm.
#include "scene/shelf_fill.h"

#include "assets/product_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "hand_made_stock.h"
#include "scene/scene.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

constexpr double kept_apart_m = 0.001, rounding_m = 1e-9;

struct Point {
  double x, y;
};

// Footprint of a standing item: a disc, or a turned rectangle.
struct Footprint {
  bool disc = false;
  Point center{};
  double radius = 0;
  std::vector<Point> corners;  // counter-clockwise
};

// Shapes whose outline is a circle from above, whatever their rows say about the rest.
bool stands_on_a_disc(
    const catalog::Product& p) {  // by its mesh: nothing of it lies outside the circle
  if (p.archetype == "round_produce") return true;  // a ball, but for its stalk
  static std::map<std::string, bool> known;
  const auto [entry, is_new] = known.try_emplace(p.sku, p.size_mm[0] == p.size_mm[1]);
  if (!is_new || !entry->second) return entry->second;
  const auto model = assets::make_product_model(p);
  if (!model.ok()) fatal(to_string(model.error()).c_str());
  const float out_of_round_m = p.material == "skin" ? 0.002F : 0.0005F;  // baked and grown
  for (const Vec3f& v : model->mesh.positions) {
    if (std::hypot(v.x, v.y) > static_cast<float>(p.width_m()) / 2 + out_of_round_m)
      entry->second = false;
  }
  return entry->second;
}

Footprint footprint_of(const scene::ShelfItem& item, const catalog::Product& p) {
  Footprint f;
  f.center = {item.position.x, item.position.y};
  if (stands_on_a_disc(p)) {
    f.disc = true;
    f.radius = p.width_m() / 2;
    return f;
  }
  const double yaw = 2 * std::atan2(item.rotation.z, item.rotation.w);
  const double c = std::cos(yaw), s = std::sin(yaw), w = p.width_m() / 2, d = p.depth_m() / 2;
  for (const Point& q : {Point{-w, -d}, Point{w, -d}, Point{w, d}, Point{-w, d}}) {
    f.corners.push_back({f.center.x + c * q.x - s * q.y, f.center.y + s * q.x + c * q.y});
  }
  return f;
}

double distance(Point p, Point a, Point b) {  // to a segment
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double t =
      std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

bool inside(Point p, const std::vector<Point>& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < 0) return false;
  }
  return true;
}

double distance(Point p, const std::vector<Point>& polygon) {
  if (inside(p, polygon)) return 0;
  double least = 1e9;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    least = std::min(least, distance(p, polygon[i], polygon[(i + 1) % polygon.size()]));
  return least;
}

// Rectangles this near to parallel never cross without a corner of one in or nearest to the other.
double distance(const Footprint& a, const Footprint& b) {
  if (a.disc && b.disc)
    return std::hypot(a.center.x - b.center.x, a.center.y - b.center.y) - a.radius - b.radius;
  if (a.disc) return distance(a.center, b.corners) - a.radius;
  if (b.disc) return distance(b.center, a.corners) - b.radius;
  double least = 1e9;
  for (const Point& p : a.corners)
    least = std::min(least, distance(p, b.corners));
  for (const Point& p : b.corners)
    least = std::min(least, distance(p, a.corners));
  return least;
}

struct Filled {
  std::vector<scene::FilledBlock> blocks;
  std::vector<const scene::ShelfItem*> items;
};

Filled filled(const scene::PlannedShelf& plan,
              const scene::ShelfRoom& room,
              const plan::StockSpec& stock,
              const catalog::Catalog& catalog,
              std::uint64_t seed) {
  Filled result{scene::fill_shelf(plan, room, stock, catalog, Stream(seed)), {}};
  for (const scene::FilledBlock& block : result.blocks) {
    for (const scene::ShelfItem& item : block.items)
      result.items.push_back(&item);
  }
  return result;
}

void expect_inside(const Filled& shelf,
                   const scene::ShelfRoom& room,
                   const catalog::Catalog& catalog) {
  for (const scene::ShelfItem* item : shelf.items) {
    const catalog::Product& p = catalog.products[item->product];
    const Footprint f = footprint_of(*item, p);
    std::vector<Point> reach = f.corners;
    if (f.disc)
      reach = {{f.center.x - f.radius, f.center.y - f.radius},
               {f.center.x + f.radius, f.center.y + f.radius}};
    for (const Point& q : reach) {
      EXPECT_LE(std::abs(q.x), room.width_m / 2 + kept_apart_m) << p.sku;
      EXPECT_GE(q.y, -kept_apart_m) << p.sku;
      EXPECT_LE(q.y, room.depth_m + kept_apart_m) << p.sku;
    }
    EXPECT_GE(item->position.z, 0);
    EXPECT_LE(item->position.z + p.height_m(), room.clearance_m + rounding_m) << p.sku;
  }
}

void expect_apart(const Filled& shelf, const catalog::Catalog& catalog) {
  for (std::size_t a = 0; a < shelf.items.size(); ++a) {
    const scene::ShelfItem& one = *shelf.items[a];
    const catalog::Product& p = catalog.products[one.product];
    const Footprint foot = footprint_of(one, p);
    for (std::size_t b = a + 1; b < shelf.items.size(); ++b) {
      const scene::ShelfItem& other = *shelf.items[b];
      const catalog::Product& q = catalog.products[other.product];
      const bool side_by_side = one.position.z < other.position.z + q.height_m() - rounding_m &&
                                other.position.z < one.position.z + p.height_m() - rounding_m;
      if (!side_by_side) continue;
      ASSERT_GE(distance(foot, footprint_of(other, q)), kept_apart_m - rounding_m)
          << p.sku << " and " << q.sku;
    }
  }
}

TEST(FillShelf, CountsOfAKnownShelf) {  // 0.45 m deep: 6 rows of 66 + 3 mm; 0.3 m high: 2 cans of
                                        // 115 mm on one another
  const catalog::Catalog catalog = catalog_of({stock_row("can", "can", {66, 66, 115}, 0.35, 2)});
  plan::StockSpec stock;
  stock.jitter = 0;
  stock.out_of_stock = 0;
  const Filled shelf = filled({{0, 3}}, shelf_room(1.2, 0.45, 0.3), stock, catalog, 1);
  ASSERT_EQ(shelf.blocks.size(), 1U);
  EXPECT_EQ(shelf.blocks[0].rows_deep, 6);
  EXPECT_EQ(shelf.blocks[0].stack, 2);
  EXPECT_LE(shelf.items.size(), 3U * 6 * 2);  // the last rows of a column may be sold
  EXPECT_GE(shelf.items.size(), 3U * 1 * 2);
  EXPECT_EQ(shelf.items.size() % 2, 0U);
  EXPECT_NEAR(shelf.blocks[0].width_m, 3 * 0.070, 1e-12);
  EXPECT_EQ(
      std::count_if(shelf.items.begin(),
                    shelf.items.end(),
                    [](const scene::ShelfItem* i) { return i->flags == scene::product_front_row; }),
      6);
}

TEST(FillShelf, StackedItemsRestOnOneAnother) {
  const catalog::Catalog catalog = catalog_of({stock_row("tin", "food_tin", {75, 75, 80}, 0.3, 4)});
  plan::StockSpec stock;
  stock.out_of_stock = 0;
  const Filled shelf = filled({{0, 2}}, shelf_room(1, 0.4, 0.36), stock, catalog, 3);
  std::set<double> heights;
  for (const scene::ShelfItem* item : shelf.items)
    heights.insert(item->position.z);
  EXPECT_EQ(heights, (std::set<double>{0, 0.08, 0.16, 3 * 0.08}));
}

TEST(FillShelf, DepthFillLeavesTheBackEmpty) {
  const catalog::Catalog catalog = catalog_of({stock_row("box", "box", {100, 97, 200}, 0.4)});
  plan::StockSpec stock;
  stock.out_of_stock = 0;
  for (const auto& [depth_fill, rows] : {std::pair(1.0, 4), std::pair(0.5, 2), std::pair(0.0, 1)}) {
    stock.depth_fill = depth_fill;
    EXPECT_EQ(filled({{0, 1}}, shelf_room(1, 0.4, 0.3), stock, catalog, 1).blocks[0].rows_deep,
              rows)
        << depth_fill;
  }
}

TEST(FillShelf, RandomShelvesOfRealRows) {
  const catalog::Catalog& catalog = committed_catalog();
  std::vector<std::uint32_t> packs;
  for (std::uint32_t i = 0; i < catalog.products.size(); ++i) {
    if (!scene::lies_in_a_heap(catalog.products[i])) packs.push_back(i);
  }
  int items = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Stream draw(seed);
    const scene::Bay bay{
        {shelf_room(draw.uniform(0.6, 1.4), draw.uniform(0.3, 0.6), draw.uniform(0.2, 0.5))},
        false};
    plan::StockSpec stock;
    stock.jitter = seed % 3 == 0 ? 1.0 : draw.uniform();
    stock.fill = 1;
    scene::AssortmentCursor cursor{static_cast<std::size_t>(draw.integer(0, 250))};
    const auto plan = scene::plan_bay(bay, packs, stock, catalog, cursor, Stream(seed + 500));
    const Filled shelf = filled(plan[0], bay.shelves[0], stock, catalog, seed + 900);
    expect_inside(shelf, bay.shelves[0], catalog);
    expect_apart(shelf, catalog);
    items += static_cast<int>(shelf.items.size());
  }
  EXPECT_GT(items, 1500);
}

TEST(FillShelf,
     HeapedBallsDoNotEnterOneAnother) {  // true balls: centres are at least a diameter apart
  const catalog::Catalog catalog =
      catalog_of({stock_row("ball", "round_produce", {80, 80, 80}, 0.2)});
  plan::StockSpec stock;
  stock.out_of_stock = 0;
  const Filled shelf = filled({{0, 6}}, shelf_room(0.6, 0.5, 0.25), stock, catalog, 1);
  EXPECT_EQ(shelf.blocks[0].stack, 3);
  double nearest = 1;
  for (std::size_t a = 0; a < shelf.items.size(); ++a) {
    for (std::size_t b = a + 1; b < shelf.items.size(); ++b) {
      nearest = std::min(nearest, length(shelf.items[a]->position - shelf.items[b]->position));
    }
  }
  EXPECT_GE(nearest, 0.08);
  EXPECT_LT(nearest, 0.082);  // a heap, not a cloud
  expect_inside(shelf, shelf_room(0.6, 0.5, 0.25), catalog);
}

TEST(FillShelf, HeapedCylindersLieInThePocketsBelow) {
  const catalog::Catalog catalog =
      catalog_of({stock_row("cucumber", "elongated_produce", {300, 50, 50}, 0.4)});
  plan::StockSpec stock;
  stock.out_of_stock = 0;
  const Filled shelf = filled({{0, 2}}, shelf_room(0.7, 0.4, 0.2), stock, catalog, 1);
  double nearest = 1;
  for (std::size_t a = 0; a < shelf.items.size(); ++a) {
    for (std::size_t b = a + 1; b < shelf.items.size(); ++b) {
      const Vec3 d = shelf.items[a]->position - shelf.items[b]->position;
      if (std::abs(d.x) < 0.3) nearest = std::min(nearest, std::hypot(d.y, d.z));
    }
  }
  EXPECT_GE(nearest, 0.05);
  EXPECT_LT(nearest, 0.052);
}

TEST(FillShelf, OutOfStockShare) {  // 4,000 blocks at 10 %: within three sigma of 0.0047
  const catalog::Catalog catalog = catalog_of({stock_row("can", "can", {66, 66, 115}, 0.35)});
  plan::StockSpec stock;
  stock.out_of_stock = 0.1;
  int empty = 0, blocks = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    for (const scene::FilledBlock& block : scene::fill_shelf(
             {{0, 2}, {0, 2}, {0, 2}, {0, 2}}, shelf_room(), stock, catalog, Seed(seed).stream())) {
      ++blocks;
      empty += block.items.empty() ? 1 : 0;
    }
  }
  EXPECT_EQ(blocks, 4000);
  EXPECT_NEAR(empty / 4000.0, 0.1, 0.015);
  stock.out_of_stock = 1;
  EXPECT_TRUE(filled({{0, 4}}, shelf_room(), stock, catalog, 1).items.empty());
}

TEST(FillShelf, NoJitterIsRulerStraight) {
  const catalog::Catalog catalog = catalog_of({stock_row("box", "box", {100, 90, 200}, 0.4)});
  plan::StockSpec stock;
  stock.jitter = 0;
  stock.out_of_stock = 0;
  for (const scene::ShelfItem* item : filled({{0, 4}}, shelf_room(), stock, catalog, 9).items) {
    EXPECT_EQ(item->rotation, (Quaternion{1, 0, 0, 0}));
  }
}

TEST(FillShelf, AnEmptyPlanIsAnEmptyShelf) {
  EXPECT_TRUE(scene::fill_shelf({}, shelf_room(), {}, catalog::Catalog{}, Stream(1)).empty());
}

TEST(FillShelf, NoRoundThingThatLiesIsStoodOnAnother) {
  int rolls = 0;
  for (const catalog::Product& product : committed_catalog().products) {
    const Result<assets::CollisionPrimitive> primitive = assets::collision_of(product);
    ASSERT_TRUE(primitive.ok()) << product.sku;
    if (!primitive->lying || scene::lies_in_a_heap(product)) continue;
    ++rolls;
    EXPECT_EQ(product.stack_max, 1) << product.sku;
  }
  EXPECT_GE(rolls, 6);
}

}  // namespace
}  // namespace marketgen
