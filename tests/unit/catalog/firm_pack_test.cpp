#include "catalog/firm_pack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "support/committed_catalog.h"

namespace marketgen {
namespace {

const catalog::Product& row(std::string_view sku) {
  const auto& products = committed_catalog().products;
  const auto found = std::ranges::find(products, sku, &catalog::Product::sku);
  if (found == products.end()) fatal(std::string(sku).c_str());
  return *found;
}

TEST(FirmPack, WhatFilmIsDrawnRoundKeepsItsShape) {
  for (const char* sku : {"dairy-liver-sausage-fine-200g",
                          "personal-care-soap-block-olive-marsolie-300-g",
                          "household-matches-kerzano-10-boxes",
                          "household-drawstring-bags-35-l-foliwell-22-bags",
                          "bakery-pumpernickel-500g"}) {
    EXPECT_EQ(row(sku).rigidity, catalog::Rigidity::soft) << sku;
    EXPECT_FALSE(catalog::firm_because(row(sku)).empty()) << sku;
    EXPECT_FALSE(catalog::gives_way(row(sku))) << sku;
  }
}

TEST(FirmPack, WhatIsSlicedLooseOrFullOfAirGivesWay) {
  for (const char* sku : {"dairy-bacon-rashers-150g",
                          "dairy-frankfurters-400g",
                          "dairy-smoked-salmon-sliced-200g",
                          "bakery-toast-bread-wheat-500g",
                          "household-sponges-scrub-wischfein-3-pieces",
                          "household-lunch-bags-foliwell-50-bags",
                          "personal-care-nappies-size-4-minoo-38-pieces"})
    EXPECT_TRUE(catalog::gives_way(row(sku))) << sku;
  for (const catalog::Product& product : committed_catalog().products) {
    if (product.archetype != "pouch" && product.archetype != "pillow_bag") continue;
    EXPECT_EQ(catalog::gives_way(product), product.rigidity == catalog::Rigidity::soft)
        << product.sku;
  }
}

// Each line of the table is of some row, and none of a row that is not soft.
TEST(FirmPack, EachReasonHasItsPacks) {
  std::map<std::string_view, std::set<std::string>> shapes;
  for (const catalog::Product& product : committed_catalog().products) {
    const std::string_view because = catalog::firm_because(product);
    if (because.empty()) continue;
    EXPECT_EQ(product.rigidity, catalog::Rigidity::soft) << product.sku;
    shapes[because].insert(product.archetype);
  }
  EXPECT_EQ(shapes.size(), 5U);
  catalog::Product rigid = row("bakery-pumpernickel-500g");
  rigid.rigidity = catalog::Rigidity::rigid;
  EXPECT_EQ(catalog::firm_because(rigid), "");
}

}  // namespace
}  // namespace marketgen
