// Price tags that are missing, wrong or doubled, and what the scene keeps of the truth.
#include "scene/price_tags.h"
#include "catalog/country.h"

#include <gtest/gtest.h>

#include <map>

#include "scene_of.h"

namespace marketgen {
namespace {

using scene::PriceLabel;

scene::Scene shop_with(const plan::PriceTagSpec& faults, std::uint64_t seed = 1) {
  HandLaidShop shop = shop_of({"canned", "snacks", "household", "dry_goods", "personal_care"});
  for (plan::Zone& zone : shop.plan.zones)
    zone.stock.price_tags = faults;
  return scene_of(shop, seed);
}

scene::Scene tidy_shop(std::uint64_t seed = 1) {
  return scene_of(shop_of({"canned", "snacks", "household", "dry_goods", "personal_care"}), seed);
}

double share_of(const scene::Scene& scene, scene::TagFault fault) {
  const auto faulty = std::ranges::count_if(scene.price_labels, [&](const PriceLabel& label) {
    return scene::fault_of(scene, label) == fault;
  });
  return static_cast<double>(faulty) / static_cast<double>(scene.price_labels.size());
}

TEST(PriceTags, HaveNoFaultUnlessThePlanAsksForOne) {
  const scene::Scene scene = tidy_shop();
  ASSERT_GT(scene.price_labels.size(), 150U);
  EXPECT_EQ(share_of(scene, scene::TagFault::none), 1);
  EXPECT_EQ(scene::scene_hash(shop_with({})), scene::scene_hash(scene));
}

// A country changes what tags say, and nothing of what stands where.
TEST(PriceTags, ACountryChangesPricesAndNothingElse) {
  HandLaidShop shop = shop_of({"canned", "snacks", "household", "dry_goods", "personal_care"});
  const scene::Scene euro = scene_of(shop);
  shop.plan.country = "jp";
  for (plan::Zone& zone : shop.plan.zones)
    zone.stock.price_tags = plan::PriceTagSpec{.wrong_price = 0.25};
  const scene::Scene yen = scene_of(shop);
  ASSERT_EQ(yen.products.size(), euro.products.size());
  for (std::size_t i = 0; i < yen.products.size(); ++i) {
    EXPECT_EQ(yen.products[i].position_m, euro.products[i].position_m);
    EXPECT_EQ(yen.catalog[yen.products[i].sku].sku, euro.catalog[euro.products[i].sku].sku);
  }
  const catalog::Country& japan = *catalog::find_country("jp");
  for (std::size_t sku = 0; sku < yen.catalog.size(); ++sku) {
    EXPECT_EQ(yen.catalog[sku].country, "jp");
    EXPECT_EQ(yen.catalog[sku].price, catalog::localized(euro.catalog[sku], japan).price);
  }
  EXPECT_NEAR(share_of(yen, scene::TagFault::wrong_price), 0.25, 0.05);
  for (const PriceLabel& label : yen.price_labels)
    EXPECT_EQ(label.price_cents % 100, 0U);  // whole yen, on wrong tags too
}

TEST(PriceTags, AShareIsMissingAndTheOthersStayAsTheyWere) {
  const scene::Scene tidy = tidy_shop(), faulty = shop_with({.missing = 0.2});
  const double kept = static_cast<double>(faulty.price_labels.size()) /
                      static_cast<double>(tidy.price_labels.size());
  EXPECT_NEAR(kept, 0.8, 0.05);
  std::map<std::uint32_t, PriceLabel> before;
  for (const PriceLabel& label : tidy.price_labels)
    before[label.facing] = label;
  for (const PriceLabel& label : faulty.price_labels) {
    EXPECT_EQ(label.price_cents, before.at(label.facing).price_cents);
    EXPECT_EQ(label.x_m, before.at(label.facing).x_m);
    EXPECT_EQ(label.promotion, before.at(label.facing).promotion);
  }
  EXPECT_EQ(faulty.products.size(), tidy.products.size());
}

TEST(PriceTags, WrongPricesArePrintedAndThoseOfTheProductsStay) {
  const scene::Scene scene = shop_with({.wrong_price = 0.25});
  EXPECT_NEAR(share_of(scene, scene::TagFault::wrong_price), 0.25, 0.05);
  EXPECT_EQ(share_of(scene, scene::TagFault::wrong_product), 0);
  for (const PriceLabel& label : scene.price_labels) {
    const catalog::Product said = scene::product_on_tag(scene, label);
    EXPECT_EQ(scene::price_cents(said), label.price_cents);
    EXPECT_EQ(said.sku, scene.catalog[label.sku].sku);
    const double ratio = said.price / scene.catalog[label.sku].price;
    EXPECT_GT(ratio, 0.7);
    EXPECT_LT(ratio, 1.4);
  }
}

TEST(PriceTags, OfAnotherProductAreThoseOfOneOnTheShelf) {
  const scene::Scene scene = shop_with({.wrong_product = 0.3});
  std::size_t wrong = 0;
  for (const PriceLabel& label : scene.price_labels) {
    if (scene::fault_of(scene, label) != scene::TagFault::wrong_product) continue;
    ++wrong;
    EXPECT_TRUE(std::ranges::any_of(scene.facings, [&](const scene::Facing& facing) {
      return facing.shelf == label.shelf && facing.sku == label.sku;
    }));
    EXPECT_EQ(label.price_cents, scene::price_cents(scene.catalog[label.sku]));
  }
  EXPECT_GT(wrong, scene.price_labels.size() / 6);  // shelves with one product have no other
}

TEST(PriceTags, DoubledOnesHangSideBySideBeforeTheirBlock) {
  const scene::Scene scene = shop_with({.doubled = 0.5});
  std::map<std::uint32_t, std::vector<PriceLabel>> tags;
  for (const PriceLabel& label : scene.price_labels)
    tags[label.facing].push_back(label);
  std::size_t doubled = 0;
  for (const auto& [row, of_block] : tags) {
    if (of_block.size() < 2) continue;
    ++doubled;
    ASSERT_EQ(of_block.size(), 2U);
    const scene::Facing& facing = scene.facings[row];
    const PriceLabel &now = of_block[0], &old = of_block[1];
    EXPECT_GE(now.x_m - now.width_m / 2, facing.x_m - 1e-5);
    EXPECT_GE(old.x_m - old.width_m / 2, now.x_m + now.width_m / 2);
    EXPECT_LE(old.x_m + old.width_m / 2, facing.x_m + facing.width_m + 1e-5);
    EXPECT_EQ(scene::fault_of(scene, now), scene::TagFault::none);
    EXPECT_EQ(scene::fault_of(scene, old), scene::TagFault::wrong_price);
  }
  EXPECT_GT(doubled, 20U);
}

TEST(PriceTags, FaultsOfOneZoneMoveNothingInAnother) {
  HandLaidShop shop = shop_of({"canned", "snacks"});
  shop.plan.zones[1].stock.price_tags = plan::PriceTagSpec{.missing = 0.3};
  const scene::Scene one = scene_of(shop);
  shop.plan.zones[0].stock.price_tags = plan::PriceTagSpec{.wrong_price = 1};
  const scene::Scene both = scene_of(shop);
  const auto tags_of = [](const scene::Scene& scene, const std::string& zone) {
    std::map<std::uint32_t, std::uint32_t> cents;
    for (const PriceLabel& label : scene.price_labels)
      if (scene.layout.fixtures[scene.shelves[label.shelf].fixture].zone == zone)
        cents[label.facing] = label.price_cents;
    return cents;
  };
  const std::string snacks = shop.plan.zones[1].id, canned = shop.plan.zones[0].id;
  EXPECT_EQ(tags_of(one, snacks), tags_of(both, snacks));
  EXPECT_NE(tags_of(one, canned), tags_of(both, canned));
  EXPECT_EQ(share_of(both, scene::TagFault::wrong_product), 0);
}

}  // namespace
}  // namespace marketgen
