// A user's own products stand on a shelf for certain wherever one sells and holds them; of every
// other the store says why not.
#include "scene/own_goods.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "scene/assortment.h"
#include "scene_of.h"

namespace marketgen {
namespace {

catalog::Product own_product(const std::string& sku,
                             const std::string& category,
                             const std::string& subcategory,
                             std::array<int, 3> size_mm = {66, 66, 115}) {
  catalog::Product product;
  product.sku = "own-" + sku;
  product.name = sku;
  product.category = category;
  product.subcategory = subcategory;
  product.archetype = "box";
  product.size_mm = size_mm;
  product.mass_kg = 0.3;
  return product;
}

// The committed rows and these.
catalog::Catalog with_own(const std::vector<catalog::Product>& own) {
  catalog::Catalog catalog = committed_catalog();
  for (const catalog::Product& product : own) {
    catalog.products.push_back(product);
    catalog.own.push_back(product.sku);
  }
  std::ranges::sort(catalog.products, {}, &catalog::Product::sku);
  std::ranges::sort(catalog.own);
  return catalog;
}

struct Stocked {
  scene::Scene scene;
  std::vector<scene::Unstocked> unstocked;
  std::set<std::string> skus;  // that stand
};

Stocked stock(const HandLaidShop& shop, const catalog::Catalog& catalog, std::uint64_t seed = 1) {
  auto built = scene::build_scene(shop.layout, shop.plan, catalog, Seed(seed));
  if (!built.ok()) fatal(to_string(built.error()).c_str());
  Stocked stocked{std::move(built).value(), {}, {}};
  stocked.unstocked = scene::unstocked_products(stocked.scene, shop.plan, catalog);
  for (const scene::SceneProduct& item : stocked.scene.products)
    stocked.skus.insert(stocked.scene.catalog[item.sku].sku);
  return stocked;
}

std::string why(const Stocked& stocked) {
  return stocked.unstocked.size() == 1 ? stocked.unstocked[0].why : "";
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Three modules have room for some of the 200 or so soft drinks, so that chance alone leaves most
// out.
TEST(OwnGoods, StandSomewhereWhateverTheSeed) {
  const HandLaidShop shop = shop_of({"beverages", "snacks", "canned"});
  const catalog::Catalog catalog =
      with_own({own_product("aa-cola", "beverages", "soft drinks"),
                own_product("zz-cola", "beverages", "soft drinks"),
                own_product("crisps", "snacks", "crisps", {150, 60, 220}),
                own_product("beans", "canned", "beans", {75, 75, 110})});
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Stocked stocked = stock(shop, catalog, seed);
    EXPECT_TRUE(stocked.unstocked.empty()) << seed << ": " << why(stocked);
    for (const std::string& sku : catalog.own)
      EXPECT_TRUE(stocked.skus.contains(sku)) << sku << " at seed " << seed;
  }
}

// One product of each word; the best named: "ginger ale" is no ginger biscuit.
TEST(MustStock, StandsInItsZoneWhateverTheSeed) {
  HandLaidShop shop = shop_of({"beverages", "snacks"});
  const std::vector<std::string> words = {"Ginger Ale", "Tonic Water", "grapefruit juice"};
  shop.plan.zones[0].stock.must_stock = words;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Stocked stocked = stock(shop, committed_catalog(), seed);
    for (const std::string& word : words) {
      const std::vector<std::uint32_t> rows =
          scene::best_named(shop.plan.zones[0], word, committed_catalog());
      ASSERT_FALSE(rows.empty()) << word;
      EXPECT_TRUE(std::ranges::any_of(rows,
                                      [&](std::uint32_t row) {
                                        return stocked.skus.contains(
                                            committed_catalog().products[row].sku);
                                      }))
          << word << " at seed " << seed;
    }
  }
}

TEST(MustStock, TheNameItselfIsNamedBest) {
  plan::Zone dairy;
  dairy.type = "dairy";
  for (const std::uint32_t row : scene::best_named(dairy, "butter", committed_catalog()))
    EXPECT_TRUE(committed_catalog().products[row].name.ends_with("Butter"));
  EXPECT_FALSE(scene::best_named(dairy, "butter", committed_catalog()).empty());
  EXPECT_TRUE(scene::best_named(dairy, "motor oil", committed_catalog()).empty());
}

TEST(OwnGoods, AreNeverOutOfStock) {
  HandLaidShop shop = shop_of({"beverages"});
  shop.plan.zones[0].stock.out_of_stock = 1;
  const catalog::Catalog catalog = with_own({own_product("cola", "beverages", "soft drinks")});
  const Stocked stocked = stock(shop, catalog);
  EXPECT_EQ(stocked.skus, std::set<std::string>{"own-cola"});
}

TEST(OwnGoods, AHundredOfThemFillTheShelvesAndTheRestIsNamed) {
  const HandLaidShop shop = shop_of({"snacks"});
  std::vector<catalog::Product> own;
  for (int i = 0; i < 100; ++i)
    own.push_back(own_product("bag-" + std::to_string(i), "snacks", "crisps", {150, 60, 220}));
  const Stocked stocked = stock(shop, with_own(own));
  // Two sides of five shelves or more hold seven or eight bags each. What else stands there is
  // narrower than what they leave free.
  const auto bags = static_cast<std::size_t>(std::ranges::count_if(
      stocked.skus, [](const std::string& sku) { return sku.starts_with("own-"); }));
  EXPECT_EQ(bags, own.size() - stocked.unstocked.size());
  EXPECT_GE(bags, 60U);
  EXPECT_LT(bags, own.size());
  EXPECT_LE(stocked.skus.size(), bags + 10);
  for (const scene::Unstocked& left : stocked.unstocked)
    EXPECT_TRUE(says(left.why, "full of other products of your own")) << left.why;
}

TEST(OwnGoods, LeaveEverythingAsItWasWhereThereAreNone) {
  const HandLaidShop shop = shop_of({"beverages", "snacks"});
  catalog::Catalog nothing_own = committed_catalog();
  EXPECT_EQ(scene::scene_hash(stock(shop, nothing_own).scene), scene::scene_hash(scene_of(shop)));
  // One that nobody sells moves nothing either.
  const catalog::Catalog catalog = with_own({own_product("tea", "dry_goods", "tea")});
  EXPECT_EQ(scene::scene_hash(stock(shop, catalog).scene), scene::scene_hash(scene_of(shop)));
}

TEST(OwnGoods, OfThoseThatDoNotFitItIsSaidWhy) {
  const HandLaidShop shop = shop_of({"beverages", "snacks"});
  const auto why_not = [&](const catalog::Product& product) {
    return why(stock(shop, with_own({product})));
  };
  EXPECT_TRUE(says(why_not(own_product("tea", "dry_goods", "tea")),
                   "no zone of this store sells tea of dry_goods; zones of type dry_goods do"));
  EXPECT_TRUE(says(why_not(own_product("odd", "snacks", "crisps", {66, 66, 900})),
                   "it is 900 mm tall; no shelf that sells it takes more than "));
  EXPECT_TRUE(says(why_not(own_product("odd", "snacks", "crisps", {66, 900, 66})), "900 mm deep"));
  EXPECT_TRUE(
      says(why_not(own_product("odd", "snacks", "crisps", {1400, 66, 66})), "1400 mm wide"));
  catalog::Product frozen = own_product("ice", "snacks", "crisps");
  frozen.storage = catalog::Storage::frozen;
  EXPECT_TRUE(says(why_not(frozen), "it is kept frozen, but the fixtures of zone \"snacks\""));
  const std::string odd = why_not(own_product("odd", "beverages", "potions"));
  EXPECT_TRUE(says(odd, "no type of zone sells ambient potions of beverages; subcategories are:"));
  EXPECT_TRUE(says(odd, "soft drinks")) << odd;
}

TEST(OwnGoods, WhatTheZoneLeavesOutIsLeftOut) {
  HandLaidShop shop = shop_of({"beverages"});
  shop.plan.zones[0].stock.exclude = {"cola"};
  const Stocked stocked = stock(shop, with_own({own_product("cola", "beverages", "soft drinks")}));
  EXPECT_FALSE(stocked.skus.contains("own-cola"));
  EXPECT_EQ(why(stocked), "zone \"beverages\" leaves out cola");
}

}  // namespace
}  // namespace marketgen
