// A shopping plan of a store's scene and of words, offline and where a model costs too much.
#include "environments/store_shopping.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "environments/store_assortment.h"
#include "io/json.h"
#include "support/committed_catalog.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

// One item of every committed row.
const scene::Scene& full_store() {
  static const scene::Scene store = [] {
    scene::Scene made;
    made.catalog = committed_catalog().products;
    for (std::uint32_t i = 0; i < made.catalog.size(); ++i) {
      scene::SceneProduct item;
      item.sku = i;
      made.products.push_back(item);
    }
    return made;
  }();
  return store;
}

Result<shopping::ShoppingPlan> bought(const std::string& words,
                                      const std::vector<std::string>& sold_out = {},
                                      const environments::ShoppingOptions& options = {}) {
  return environments::shop(
      words, environments::assortment_of(full_store(), sold_out), committed_catalog(), options);
}

TEST(StoreShopping, TakesAnotherProductForOneThatIsSoldOut) {
  const auto plan = bought("milk");
  ASSERT_TRUE(plan.ok()) << to_string(plan.error());
  ASSERT_EQ(plan->lines.size(), 1U);
  EXPECT_EQ(io::write_json(*plan), io::write_json(*bought("milk")));
  const auto other = bought("milk", {plan->lines[0].sku});
  ASSERT_TRUE(other.ok()) << to_string(other.error());
  ASSERT_EQ(other->lines.size(), 1U);
  EXPECT_NE(other->lines[0].sku, plan->lines[0].sku);
}

TEST(StoreShopping, WhatNoItemStandsOfIsSoldOut) {
  const auto plan = bought("milk");
  ASSERT_TRUE(plan.ok()) << to_string(plan.error());
  const std::string sku = plan->lines.at(0).sku;
  scene::Scene store = full_store();
  std::erase_if(store.products, [&](const scene::SceneProduct& item) {
    return store.catalog[item.sku].sku == sku;
  });
  const auto assortment = environments::assortment_of(store);
  EXPECT_EQ(assortment.sold_out, std::vector{sku});
  const auto other = environments::shop("milk", assortment, committed_catalog());
  ASSERT_TRUE(other.ok()) << to_string(other.error());
  EXPECT_EQ(io::write_json(*other), io::write_json(*bought("milk", {sku})));
}

TEST(StoreShopping, AModelWithoutTokensLeavesTheOfflinePlan) {
  environments::ShoppingOptions options{"http:m", {}};
  options.access.url = "http://127.0.0.1:9/v1";  // nobody is asked
  options.access.limits.max_tokens = 0;
  const auto plan = bought("breakfast for two under 14 €", {}, options);
  ASSERT_TRUE(plan.ok()) << to_string(plan.error());
  ASSERT_TRUE(plan->shopper.has_value());
  EXPECT_EQ(plan->shopper->kept, "offline");
  EXPECT_NE(plan->shopper->why.find("planners.over_budget"), std::string::npos)
      << plan->shopper->why;
  auto offline = *bought("breakfast for two under 14 €");
  offline.shopper = plan->shopper;
  EXPECT_EQ(io::write_json(*plan), io::write_json(offline));
}

TEST(StoreShopping, NothingIsRecordedOfWordsThatAreNotUnderstood) {
  const ScratchFolder scratch;
  environments::ShoppingOptions options{"http:m", {}};
  options.access.url = "http://127.0.0.1:9/v1";
  options.access.record = scratch.path() / "talk";
  const auto plan = bought("two flurbs", {}, options);
  ASSERT_FALSE(plan.ok());
  EXPECT_EQ(plan.error().code, "shopping.not_understood");
  EXPECT_FALSE(std::filesystem::exists(options.access.record));
}

TEST(StoreShopping, RefusesWhatItCannotDo) {
  EXPECT_EQ(bought("").error().code, "shopping.not_understood");
  EXPECT_EQ(bought("milk", {"dairy-unicorn-milk"}).error().code, "catalog.unknown_sku");
  EXPECT_EQ(bought("milk", {}, {"opnai:m", {}}).error().code, "usage.bad_flag");
}

}  // namespace
}  // namespace marketgen
