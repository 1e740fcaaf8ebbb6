// Bulk settling: what is poured lies still inside, does not overlap, is the same every time, and
// what does not fit is counted.
#include "physics/settle/bulk_settle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/parallel.h"
#include "physics/goods/product_bodies.h"
#include "physics/goods/spec_geoms.h"
#include "physics/settle/bulk_model.h"
#include "physics/settle/penetration.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

const catalog::Product& first_shape(const std::string& archetype) {
  for (const catalog::Product& product : committed_catalog().products)
    if (product.archetype == archetype) return product;
  fatal(archetype.c_str());
}

physics::SharedGoodsBody body_of(const catalog::Product& product) {
  return physics::goods_body(product, physics::GoodsUse::bulk).value();
}

std::vector<physics::SharedGoodsBody> items_of(const std::vector<std::string>& shapes) {
  std::vector<physics::SharedGoodsBody> items;
  for (const std::string& shape : shapes)
    items.push_back(body_of(first_shape(shape)));
  return items;
}

physics::SettledBulk settled(const std::vector<physics::SharedGoodsBody>& items, int seed = 1) {
  auto result =
      physics::settle_bulk(physics::checkout_basket, items, Seed(static_cast<std::uint64_t>(seed)));
  if (!result.ok()) fatal(to_string(result.error()).c_str());
  return std::move(result).value();
}

std::vector<physics::SharedGoodsBody> mixed_items() {
  return items_of({"can", "box", "gable_carton", "pouch", "apple", "can", "banana_bunch"});
}

// The items as they lie, with the basket, in a model of its own.
struct Laid {
  physics::MujocoModel model{nullptr, mj_deleteModel};
  physics::MujocoData data{nullptr, mj_deleteData};
};
Laid laid(const std::vector<physics::SharedGoodsBody>& items, const physics::SettledBulk& bulk) {
  const physics::MujocoSpec spec(mj_makeSpec(), mj_deleteSpec);
  physics::set_contact_options(*spec, 0);
  spec->option.enableflags &= ~mjENBL_SLEEP;
  spec->compiler.balanceinertia = 1;
  physics::add_container(mjs_findBody(spec.get(), "world"), physics::checkout_basket);
  physics::ProductBodies bodies(*spec);
  for (std::size_t i = 0; i < items.size(); ++i)
    bodies.add("item" + std::to_string(i), *items[i], bulk.items[i].container_from_product);
  Laid made;
  made.model = std::move(physics::compile(*spec, "test")).value();
  made.data = std::move(physics::make_data(*made.model, "test")).value();
  mj_forward(made.model.get(), made.data.get());
  return made;
}

// Between geoms of different bodies, the basket's among them.
double deepest_in_bulk(const Laid& l) {
  double deepest = 0;
  for (int a = 0; a < l.model->ngeom; ++a) {
    for (int b = a + 1; b < l.model->ngeom; ++b) {
      if (l.model->geom_bodyid[a] == l.model->geom_bodyid[b]) continue;
      deepest =
          std::max(deepest, -mj_geomDistance(l.model.get(), l.data.get(), a, b, 0.001, nullptr));
    }
  }
  return deepest;
}

TEST(BulkSettling, PacksLieStillInsideAndApart) {
  for (const int seed : {1, 2, 3}) {
    SCOPED_TRACE(seed);
    const std::vector<physics::SharedGoodsBody> items = mixed_items();
    const physics::SettledBulk bulk = settled(items, seed);
    EXPECT_TRUE(bulk.rests);
    EXPECT_EQ(bulk.spilled, 0);
    ASSERT_EQ(bulk.items.size(), items.size());
    const Laid l = laid(items, bulk);
    EXPECT_LT(deepest_in_bulk(l), physics::penetration_limit_m);
    for (std::size_t i = 0; i < items.size(); ++i) {
      const mjtNum* middle = l.data->xipos + 3 * (i + 1);
      EXPECT_TRUE(bulk.items[i].inside);
      EXPECT_LT(std::abs(middle[0]), physics::checkout_basket.top_x_m / 2);
      EXPECT_LT(std::abs(middle[1]), physics::checkout_basket.top_y_m / 2);
      EXPECT_GT(middle[2], 0);
    }
    // Let go where they were said to lie, they stay.
    for (int step = 0; step < 250; ++step)
      mj_step(l.model.get(), l.data.get());
    for (std::size_t i = 0; i < items.size(); ++i) {
      const mjtNum* q = l.data->qpos + l.model->jnt_qposadr[i];
      const Vec3 moved = Vec3{q[0], q[1], q[2]} - bulk.items[i].container_from_product.position;
      EXPECT_LT(length(moved), 0.005) << items[i]->product.sku;
    }
  }
}

TEST(BulkSettling, TheSameTwiceAndOnAnyNumberOfThreads) {
  const std::vector<physics::SharedGoodsBody> items = mixed_items();
  std::vector<std::vector<physics::SettledBulk>> runs;
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    runs.push_back(parallel_map(2, [&](std::size_t) { return settled(items, 5); }));
  }
  for (const std::vector<physics::SettledBulk>& run : runs) {
    for (const physics::SettledBulk& bulk : run) {
      EXPECT_EQ(bulk.simulated_s, runs[0][0].simulated_s);
      for (std::size_t i = 0; i < items.size(); ++i) {
        EXPECT_EQ(bulk.items[i].container_from_product.position,
                  runs[0][0].items[i].container_from_product.position);
        EXPECT_EQ(bulk.items[i].container_from_product.rotation,
                  runs[0][0].items[i].container_from_product.rotation);
      }
    }
  }
  EXPECT_NE(settled(items, 6).items[0].container_from_product.position,
            runs[0][0].items[0].container_from_product.position);
}

TEST(BulkSettling, AHeavyAndALightOneBothRest) {
  catalog::Product heavy = first_shape("can"), light = first_shape("box");
  heavy.mass_kg = 4, light.mass_kg = 0.02;
  light.size_mm = {280, 120, 70};  // whatever box the catalogue begins with
  const std::vector<physics::SharedGoodsBody> items{body_of(light), body_of(heavy), body_of(light)};
  const physics::SettledBulk bulk = settled(items);
  EXPECT_TRUE(bulk.rests);
  EXPECT_EQ(bulk.spilled, 0);
  EXPECT_LT(deepest_in_bulk(laid(items, bulk)), physics::penetration_limit_m);
}

TEST(BulkSettling, WhatDoesNotFitSpillsAndIsCounted) {
  const catalog::Product& box = first_shape("box");
  const std::vector<physics::SharedGoodsBody> many(30, body_of(box));
  const physics::SettledBulk full = settled(many);
  const auto inside = std::ranges::count(full.items, true, &physics::SettledItem::inside);
  EXPECT_EQ(full.spilled + inside, 30);
  EXPECT_GT(full.spilled, 0);
  EXPECT_GT(inside, 3);
}

TEST(BulkSettling, WhetherAPackFits) {
  catalog::Product pack = first_shape("box");
  pack.size_mm = {385, 255, 150};
  EXPECT_TRUE(physics::fits_in(physics::checkout_basket, pack));
  pack.size_mm = {150, 255, 385};  // some way round
  EXPECT_TRUE(physics::fits_in(physics::checkout_basket, pack));
  pack.size_mm = {385, 255, 155};
  EXPECT_FALSE(physics::fits_in(physics::checkout_basket, pack));
  pack.size_mm = {395, 50, 50};
  EXPECT_FALSE(physics::fits_in(physics::checkout_basket, pack));
}

// Inner faces where the measures say: at the floor, at the rim.
TEST(BulkSettling, TheWallsStandWhereTheMeasuresSay) {
  const std::vector<physics::ContainerBox> boxes = physics::boxes_of(physics::checkout_basket);
  ASSERT_EQ(boxes.size(), 8U);  // four walls, four ledges
  const auto free = [&](Vec3 at) {
    return std::ranges::none_of(boxes, [&](const physics::ContainerBox& box) {
      const Vec3 p = inverse(box.container_from_box) * at;
      return std::abs(p.x) < box.half_size.x && std::abs(p.y) < box.half_size.y &&
             std::abs(p.z) < box.half_size.z;
    });
  };
  for (const double side : {1.0, -1.0}) {
    EXPECT_TRUE(free({side * 0.148, 0, 0.149}));
    EXPECT_FALSE(free({side * 0.152, 0, 0.149}));
    EXPECT_TRUE(free({0, side * 0.213, 0.149}));
    EXPECT_FALSE(free({0, side * 0.217, 0.149}));
    EXPECT_TRUE(free({side * 0.131, 0, 0.0125}));
    EXPECT_FALSE(free({side * 0.134, 0, 0.0125}));
    EXPECT_TRUE(free({side * 0.111, 0, 0.002}));
    EXPECT_FALSE(free({side * 0.113, 0, 0.002}));
  }
}

TEST(BulkSettling, BadInputIsAnError) {
  const std::vector<physics::SharedGoodsBody> one = items_of({"can"});
  const auto code = [&](const physics::OpenContainer& container,
                        const std::vector<physics::SharedGoodsBody>& items) {
    const auto result = physics::settle_bulk(container, items, Seed(1));
    return result.ok() ? std::string() : result.error().code;
  };
  physics::OpenContainer broken = physics::checkout_basket;
  broken.height_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code(broken, one), "physics.bad_command");
  broken.height_m = std::numeric_limits<double>::infinity();
  EXPECT_EQ(code(broken, one), "physics.bad_command");
  broken = physics::checkout_basket;
  broken.taper_m = 0.14;  // the ledges meet
  EXPECT_EQ(code(broken, one), "physics.bad_command");
  EXPECT_EQ(code(physics::checkout_basket,
                 std::vector<physics::SharedGoodsBody>(physics::max_bulk_items + 1, one[0])),
            "physics.bad_command");

  auto weightless = std::make_shared<physics::GoodsBody>(*one[0]), flat = weightless;
  weightless->product.mass_kg = 0;
  EXPECT_EQ(code(physics::checkout_basket, {weightless}), "catalog.bad_row");
  flat = std::make_shared<physics::GoodsBody>(*one[0]);
  flat->product.size_mm[1] = 0;
  EXPECT_EQ(code(physics::checkout_basket, {flat}), "catalog.bad_row");

  const auto none = physics::settle_bulk(physics::checkout_basket, {}, Seed(1));
  ASSERT_TRUE(none.ok());
  EXPECT_TRUE(none->rests);
  EXPECT_TRUE(none->items.empty());
}

}  // namespace
}  // namespace marketgen
