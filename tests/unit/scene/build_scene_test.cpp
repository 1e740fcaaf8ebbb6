// build_scene on a room laid out by hand: stock, prices, misplaced and pinned items.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/parallel.h"
#include "scene/placements.h"
#include "scene/scene.h"
#include "scene/scene_file.h"
#include "scene_of.h"
#include "support/hand_laid_shop.h"

namespace marketgen {
namespace {

TEST(BuildScene, TablesReferToOneAnotherAndNothingOverlapsInThem) {
  const scene::Scene scene = scene_of(shop_of(selling_types()));
  EXPECT_TRUE(scene::check_indices(scene, "scene").ok());
  std::uint32_t next = 0;
  for (std::uint32_t f = 0; f < scene.facings.size(); ++f) {
    const scene::Facing& facing = scene.facings[f];
    EXPECT_EQ(facing.first_product, next);
    next += facing.product_count;
    for (std::uint32_t i = facing.first_product; i < next; ++i) {
      EXPECT_EQ(scene.products[i].facing, f);
      EXPECT_EQ(scene.products[i].sku, facing.sku);
    }
  }
  EXPECT_EQ(next, scene.products.size());
}

TEST(BuildScene, EverySellingZoneIsStocked) {
  const scene::Scene scene = scene_of(shop_of(selling_types()));
  std::map<std::string, int> items;
  for (const scene::SceneProduct& item : scene.products) {
    const std::uint32_t fixture = scene.shelves[scene.facings[item.facing].shelf].fixture;
    ++items[scene.layout.fixtures[fixture].zone];
  }
  for (const std::string& type : selling_types())
    EXPECT_GT(items[type], 20) << type;
}

TEST(BuildScene, ChilledAndFrozenGoodsStandOnlyWhereItIsColdEnough) {
  for (const char* kind :
       {"gondola", "multideck", "island_freezer"}) {  // the wrong fixtures for most of these zones
    const scene::Scene scene =
        scene_of(shop_of({"dairy", "chilled", "frozen", "beverages", "canned"}, kind));
    const catalog::Storage keeps = committed_catalog().fixture_kind(kind)->temperature;
    for (const scene::SceneProduct& item : scene.products) {
      const catalog::Storage needs = scene.catalog[item.sku].storage;
      EXPECT_TRUE(needs == keeps ||
                  (keeps == catalog::Storage::chilled && needs == catalog::Storage::ambient))
          << kind << ": " << scene.catalog[item.sku].sku;
    }
  }
}

TEST(BuildScene, OnePriceLabelAFacingBlockInItsMiddle) {
  const scene::Scene scene = scene_of(shop_of(selling_types()));
  std::map<std::uint32_t, int> labels;
  for (const scene::PriceLabel& label : scene.price_labels) {
    ++labels[label.facing];
    const scene::Facing& block = scene.facings[label.facing];
    EXPECT_EQ(label.shelf, block.shelf);
    EXPECT_EQ(label.sku, block.sku);
    EXPECT_NEAR(label.x_m, block.x_m + block.width_m / 2, 1e-5);
    EXPECT_LE(label.width_m, block.width_m);
    EXPECT_EQ(label.price_cents,
              static_cast<std::uint32_t>(std::lround(scene.catalog[label.sku].price * 100)));
  }
  int blocks_with_a_rail = 0;
  for (std::uint32_t f = 0; f < scene.facings.size(); ++f) {
    const bool rail = scene.shelves[scene.facings[f].shelf].price_rail != 0;
    EXPECT_EQ(labels[f], rail ? 1 : 0);
    blocks_with_a_rail += rail ? 1 : 0;
  }
  EXPECT_GT(blocks_with_a_rail, 50);
}

TEST(BuildScene, BlocksOfAShelfFollowOneAnother) {
  const scene::Scene scene = scene_of(shop_of(selling_types()));
  std::map<std::uint32_t, const scene::Facing*> last;
  for (const scene::Facing& facing : scene.facings) {
    const scene::Facing*& before = last[facing.shelf];
    EXPECT_EQ(facing.position, before == nullptr ? 0 : before->position + 1);
    const float free_from = before == nullptr ? 0 : before->x_m + before->width_m;
    EXPECT_GE(facing.x_m, free_from - 1e-5F);
    EXPECT_LE(facing.x_m + facing.width_m, scene.shelves[facing.shelf].width_m + 1e-5F);
    before = &facing;
  }
}

TEST(BuildScene, IdsAreUniqueAndReadable) {
  const scene::Scene scene = scene_of(shop_of({"canned", "beverages"}));
  std::set<std::string> ids;
  for (std::uint32_t i = 0; i < scene.products.size(); ++i)
    ids.insert(scene::product_id(scene, i));
  EXPECT_EQ(ids.size(), scene.products.size());
  EXPECT_TRUE(ids.contains("canned/run-1/module-1/level-0/facing-0/item-0"));
}

TEST(BuildScene, CatalogueSliceIsSortedAndUsed) {
  const scene::Scene scene = scene_of(shop_of({"canned"}));
  std::vector<int> used(scene.catalog.size(), 0);
  for (const scene::Facing& facing : scene.facings)
    used[facing.sku] = 1;
  EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0);
  for (std::size_t i = 1; i < scene.catalog.size(); ++i)
    EXPECT_LT(scene.catalog[i - 1].sku, scene.catalog[i].sku);
}

TEST(BuildScene, SameForEveryThreadCountAndDifferentForEverySeed) {
  const HandLaidShop shop = shop_of(selling_types());
  std::set<std::string> bytes;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    bytes.insert(scene::encode_scene(scene_of(shop, 5)));
  }
  EXPECT_EQ(bytes.size(), 1U);
  EXPECT_NE(scene::scene_hash(scene_of(shop, 5)), scene::scene_hash(scene_of(shop, 6)));
}

TEST(BuildScene, AChangeInOneZoneMovesNothingInAnother) {
  HandLaidShop shop = shop_of({"canned", "snacks"});
  const auto items_of = [](const scene::Scene& scene, const std::string& zone) {
    std::map<std::string, std::array<float, 3>> items;
    for (std::uint32_t i = 0; i < scene.products.size(); ++i) {
      const std::string id = scene::product_id(scene, i);
      if (id.starts_with(zone))
        items[id + " " + scene.catalog[scene.products[i].sku].sku] = scene.products[i].position_m;
    }
    return items;
  };
  shop.plan.zones[1].stock.misplaced = 0.2;
  const auto before = items_of(scene_of(shop), "snacks");
  shop.plan.zones[0].stock.facings = {1, 1};
  shop.plan.zones[0].stock.exclude = {"beans"};
  EXPECT_EQ(items_of(scene_of(shop), "snacks"), before);
}

TEST(BuildScene, UnknownFixtureKindIsAnError) {
  HandLaidShop shop = shop_of({"canned"});
  shop.layout.fixtures[0].kind = "catapult";
  const auto built = scene::build_scene(shop.layout, shop.plan, committed_catalog(), Seed(1));
  ASSERT_FALSE(built.ok());
  EXPECT_EQ(built.error().code, "catalog.unknown_kind");
}

// ---- Misplaced items. ----

// Those that others stand on stay, so that more of the others are strangers.
TEST(Misplaced, ShareOfAllItemsInFront) {
  HandLaidShop shop = shop_of({"canned", "snacks", "household", "dry_goods", "personal_care"});
  int seen = 0, wrong = 0;
  for (plan::Zone& zone : shop.plan.zones)
    zone.stock.misplaced = 0.2;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const scene::Scene scene = scene_of(shop, seed);
    for (const scene::SceneProduct& item : scene.products) {
      seen += (item.flags & scene::product_front_row) != 0 ? 1 : 0;
      wrong += (item.flags & scene::product_misplaced) != 0 ? 1 : 0;
      EXPECT_EQ((item.flags & scene::product_misplaced) != 0,
                item.sku != scene.facings[item.facing].sku);
    }
  }
  ASSERT_GT(seen, 1000);
  EXPECT_NEAR(static_cast<double>(wrong) / seen,
              0.2,
              0.04);  // the smallest packs find no smaller stranger
}

TEST(Misplaced, StrangersComeFromElsewhereAndFit) {
  HandLaidShop shop = shop_of({"canned", "dairy"});
  for (plan::Zone& zone : shop.plan.zones)
    zone.stock.misplaced = 0.3;
  const scene::Scene scene = scene_of(shop);
  int wrong = 0;
  for (const scene::SceneProduct& item : scene.products) {
    if ((item.flags & scene::product_misplaced) == 0) continue;
    const catalog::Product& stranger = scene.catalog[item.sku];
    const catalog::Product& owner = scene.catalog[scene.facings[item.facing].sku];
    EXPECT_NE(stranger.subcategory, owner.subcategory);
    EXPECT_EQ(stranger.storage, owner.storage);
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_LE(stranger.size_mm[axis], owner.size_mm[axis]);
    ++wrong;
  }
  EXPECT_GT(wrong, 5);
}

TEST(Misplaced, StrangersStandStraight) {  // a can may stand turned by 14 degrees; a box of its
                                           // width has no room for that
  HandLaidShop shop = shop_of({"canned"});
  shop.plan.zones[0].stock.misplaced = 0.5;
  shop.plan.zones[0].stock.jitter = 1;
  const scene::Scene scene = scene_of(shop);
  for (const scene::SceneProduct& item : scene.products) {
    if ((item.flags & scene::product_misplaced) == 0) continue;
    const Quaternion shelf =
        scene::world_from_shelf(scene, scene.facings[item.facing].shelf).rotation;
    EXPECT_NEAR(item.rotation_wxyz[0], shelf.w, 1e-6);
    EXPECT_NEAR(item.rotation_wxyz[3], shelf.z, 1e-6);
  }
}

// ---- Placements. ----

TEST(Placements, StandExactlyWhereThePlanSays) {
  HandLaidShop shop = shop_of({"canned"});
  const std::string sku = committed_catalog().products.front().sku;
  shop.plan.placements = {{sku, {30.0, 2.0, 0.0}, 90}};
  const scene::Scene scene = scene_of(shop);
  const scene::SceneProduct& item = scene.products.back();
  EXPECT_EQ(scene.catalog[item.sku].sku, sku);
  EXPECT_EQ(item.facing, scene::no_facing);
  EXPECT_EQ(item.position_m, (std::array<float, 3>{30, 2, 0}));
  EXPECT_NEAR(item.rotation_wxyz[0], std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(item.rotation_wxyz[3], std::sqrt(0.5), 1e-6);
  EXPECT_EQ(scene::product_id(scene, static_cast<std::uint32_t>(scene.products.size() - 1)),
            "placement-0");
}

TEST(Placements, ClearTheirPlaceWithWhatStandsOnIt) {
  HandLaidShop shop = shop_of({"canned"});
  shop.plan.zones[0].stock.out_of_stock = 0;
  const scene::Scene before = scene_of(shop);
  const auto stacked = std::find_if(before.facings.begin(),
                                    before.facings.end(),
                                    [](const scene::Facing& f) { return f.stack >= 2; });
  ASSERT_NE(stacked, before.facings.end());
  const scene::SceneProduct& lower =
      before.products[stacked->first_product];  // the lowest of the first stack
  const auto& at = lower.position_m;
  shop.plan.placements = {{before.catalog[lower.sku].sku, {at[0], at[1], at[2]}, 0}};
  const scene::Scene after = scene_of(shop);
  const std::size_t gone = before.products.size() + 1 - after.products.size();
  EXPECT_EQ(gone, stacked->stack);
  for (std::size_t i = 0; i + 1 < after.products.size(); ++i) {
    if (after.facings[after.products[i].facing].shelf != stacked->shelf) continue;
    const auto& p = after.products[i].position_m;
    EXPECT_FALSE(std::abs(p[0] - at[0]) < 0.01F && std::abs(p[1] - at[1]) < 0.01F)
        << scene::product_id(after, static_cast<std::uint32_t>(i));
  }
}

TEST(Placements, WhatOnlyTouchesStays) {
  HandLaidShop shop = shop_of({"canned"});
  shop.plan.zones[0].stock.out_of_stock = 0;
  shop.plan.zones[0].stock.jitter = 0;
  const scene::Scene before = scene_of(shop);
  const auto roomy = std::ranges::find_if(before.facings, [&](const scene::Facing& f) {
    const double height = before.catalog[f.sku].height_m();
    return f.product_count > 0 &&
           (f.stack + 1) * height < double(before.shelves[f.shelf].clearance_m);
  });
  ASSERT_NE(roomy, before.facings.end());
  const scene::Facing& block = *roomy;
  const scene::SceneProduct& top = before.products[block.first_product + block.stack - 1U];
  const catalog::Product& product = before.catalog[top.sku];
  const double above = static_cast<double>(top.position_m[2]) + product.height_m();
  shop.plan.placements = {{product.sku, {top.position_m[0], top.position_m[1], above}, 0}};
  EXPECT_EQ(scene_of(shop).products.size(), before.products.size() + 1);
}

TEST(Placements, UnknownSkuNamesItsPlaceAndTheNearest) {
  HandLaidShop shop = shop_of({"canned"});
  const std::string sku = committed_catalog().products.front().sku;
  shop.plan.placements = {{sku, {1, 1, 0}, 0}, {sku + "x", {1, 1, 0}, 0}};
  const auto built = scene::build_scene(shop.layout, shop.plan, committed_catalog(), Seed(1));
  ASSERT_FALSE(built.ok());
  EXPECT_EQ(built.error().code, "catalog.unknown_sku");
  EXPECT_NE(built.error().where.find("/placements/1/sku"), std::string::npos);
  EXPECT_NE(built.error().message.find(sku), std::string::npos);
}

// ---- Budgets. ----

// Goods of 5 mm, twelve on one another: what a shop of twenty shelves has room for would not go
// into the memory of the machine. It is refused before the first of them is laid.
TEST(Budgets, AShopOfGrainsIsRefused) {
  catalog::Catalog grains = committed_catalog();
  for (catalog::Product& product : grains.products) {
    product.size_mm = {5, 5, 5};
    product.stack_max = 12;
  }
  HandLaidShop shop = shop_of({"canned"});
  const layout::Fixture first = shop.layout.fixtures.front();
  for (int number = 2; number <= 40; ++number) {
    shop.layout.fixtures.push_back(
        module_of(*grains.fixture_kind(first.kind), "canned", 2000, number));
    shop.layout.fixtures.back().y_mm = 1000 * number;
  }
  const auto built = scene::build_scene(shop.layout, shop.plan, grains, Seed(1));
  ASSERT_FALSE(built.ok());
  EXPECT_EQ(built.error().code, "scene.too_large");
  EXPECT_NE(built.error().message.find("8,000,000"), std::string::npos) << built.error().message;
}

TEST(Budgets, PlacementsAreCountedFromTheFirst) {
  HandLaidShop shop = shop_of({"canned"});
  const catalog::Product& product = committed_catalog().products.front();
  for (int i = 0; i < 2000; ++i)
    shop.plan.placements.push_back({product.sku, {10 + 0.5 * (i % 60), 1 + 0.2 * (i / 60), 0}, 0});
  const scene::Scene scene = scene_of(shop);
  const auto first = static_cast<std::uint32_t>(scene.products.size() - 2000);
  EXPECT_EQ(scene::product_id(scene, first), "placement-0");
  EXPECT_EQ(scene::product_id(scene, first + 1999), "placement-1999");
  EXPECT_NE(scene::product_id(scene, first - 1).find("/facing-"), std::string::npos);
}

}  // namespace
}  // namespace marketgen
