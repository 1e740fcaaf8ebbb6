// Search: what a shopper types finds what he means.
#include <gtest/gtest.h>

#include "catalog/search.h"

namespace marketgen {
namespace {

Product row(std::string sku, std::string name, std::string subcategory = "other") {
  Product p;
  p.sku = std::move(sku);
  p.name = std::move(name);
  p.subcategory = std::move(subcategory);
  p.category = "dairy";
  return p;
}

std::vector<std::string> skus(const Catalog& catalog, std::string_view text) {
  std::vector<std::string> found;
  for (const SearchHit& hit : search_products(catalog, text))
    found.push_back(catalog.products[hit.product].sku);
  return found;
}

using Skus = std::vector<std::string>;

TEST(Search, ScoresAreThoseOfTheContract) {  // name 4, keyword 3, subcategory 2, description 1,
                                             // half for a beginning
  Catalog catalog;
  catalog.products = {row("a", "Milk"),
                      row("b", "Drink"),
                      row("c", "Cream", "milk"),
                      row("d", "Milkshake"),
                      row("e", "Butter")};
  catalog.products[1].keywords = {"milk"};
  catalog.products[4].description = "Made of milk.";
  const auto hits = search_products(catalog, "milk");
  ASSERT_EQ(hits.size(), 5U);
  EXPECT_EQ(skus(catalog, "milk"),
            (Skus{"a", "b", "c", "d", "e"}));  // 4, 3, 2, 2 (half of 4), 1; ties by SKU
  EXPECT_DOUBLE_EQ(hits[0].score, 4);
  EXPECT_DOUBLE_EQ(hits[1].score, 3);
  EXPECT_DOUBLE_EQ(hits[2].score, 2);
  EXPECT_DOUBLE_EQ(hits[3].score, 2);
  EXPECT_DOUBLE_EQ(hits[4].score, 1);
}

TEST(Search, MoreMatchedWordsWin) {
  Catalog catalog;
  catalog.products = {row("oat", "Oat Drink"), row("oat-milk", "Oat Milk"), row("milk", "Milk")};
  const auto hits = search_products(catalog, "oat milk");
  EXPECT_EQ(skus(catalog, "oat milk").front(), "oat-milk");
  EXPECT_DOUBLE_EQ(hits[0].score, 8);  // two names, all words
  EXPECT_DOUBLE_EQ(hits[1].score, 2);  // one name, half of the words
}

TEST(Search, PluralsCaseAndPunctuationDoNotMatter) {
  Catalog catalog;
  catalog.products = {row("apple", "Apple"), row("chips", "Chips")};
  EXPECT_EQ(skus(catalog, "APPLES!"), Skus{"apple"});
  EXPECT_EQ(skus(catalog, "chip"), Skus{"chips"});
}

TEST(Search, ShortBeginningsAndNothingFindNothing) {
  Catalog catalog;
  catalog.products = {row("milk", "Milk")};
  EXPECT_TRUE(search_products(catalog, "mi").empty());
  EXPECT_TRUE(search_products(catalog, "").empty());
  EXPECT_TRUE(search_products(catalog, " ,;- ").empty());
  EXPECT_TRUE(search_products(catalog, "submarine").empty());
  EXPECT_FALSE(search_products(catalog, "mil").empty());
}

TEST(Search, CommittedRows) {
  const auto loaded = load_catalog(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data");
  ASSERT_TRUE(loaded.ok());
  const Catalog& catalog = *loaded;
  const auto first = [&](std::string_view text) -> const Product& {
    return catalog.products[search_products(catalog, text).at(0).product];
  };
  EXPECT_EQ(first("milk").subcategory, "milk");
  EXPECT_EQ(first("shampoo").subcategory, "shampoo");
  EXPECT_EQ(first("bananas").category, "produce");
  EXPECT_EQ(first("frozen pizza").category, "frozen");
  EXPECT_EQ(skus(catalog, "milk"), skus(catalog, "milk"));
  for (const char* word :
       {"water", "bread", "apple", "tomato", "pasta", "coffee", "chocolate", "soap"}) {
    EXPECT_FALSE(search_products(catalog, word).empty()) << word;
  }
}

}  // namespace
}  // namespace marketgen
