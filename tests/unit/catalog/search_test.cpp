// Search: what a shopper types finds what he means, in the order that asset_database.h promises.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "catalog/asset_database.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

using Skus = std::vector<std::string>;

catalog::Product row(std::string sku, std::string name, std::string subcategory = "other") {
  catalog::Product p;
  p.sku = std::move(sku);
  p.name = std::move(name);
  p.subcategory = std::move(subcategory);
  p.category = "dairy";
  return p;
}

// A few rows beside goods that match nothing, for BM25 gives no weight to a word that most rows
// have.
catalog::Catalog catalog_of(std::vector<catalog::Product> products) {
  catalog::Catalog catalog;
  catalog.products = std::move(products);
  for (const char* name : {"Zebra", "Zinc", "Zodiac", "Zombie", "Zone", "Zoo", "Zulu", "Zither"})
    catalog.products.push_back(row("z-" + std::string(name), name));
  catalog.search_lexicon.skip = {"something", "to", "a"};
  catalog.search_lexicon.without = {"without"};
  catalog.search_lexicon.intents = {{{"clean"}, {"cleaner"}},
                                    {{"windows", "clean windows"}, {"glass cleaner"}},
                                    {{"wash dishes"}, {"dish soap"}},
                                    {{"sugar free"}, {"unsweetened"}},
                                    {{"红酒"}, {"red wine"}}};
  return catalog;
}

std::vector<catalog::AssetHit> hits(const catalog::Catalog& catalog, std::string text) {
  const auto database = catalog::AssetDatabase::build(catalog);
  EXPECT_TRUE(database.ok()) << to_string(database.error());
  catalog::AssetQuery query;
  query.text = std::move(text);
  const auto found = database->find(query);
  EXPECT_TRUE(found.ok()) << to_string(found.error());
  return found.value();
}

Skus skus(const catalog::Catalog& catalog, std::string text) {
  Skus found;
  for (const catalog::AssetHit& hit : hits(catalog, std::move(text)))
    found.push_back(catalog.products[hit.row].sku);
  return found;
}

TEST(Search, ScoreIsBm25OfTheContract) {
  catalog::Catalog catalog;
  for (const char* name : {"Milk", "Tea", "Rice", "Soap"})
    catalog.products.push_back(row(name, name));
  const auto found = hits(catalog, "milk");
  ASSERT_EQ(found.size(), 1U);
  // One row of four has the word, all rows are equally long, the name weighs 5:
  // ln((4 - 1 + 0.5) / (1 + 0.5)) * 5 * (1.2 + 1) / (5 + 1.2), half as much again for the name.
  EXPECT_NEAR(found[0].score, std::log(3.5 / 1.5) * 5 * 2.2 / 6.2 * 1.5, 1e-9);
}

TEST(Search, NameBeforeKeywordBeforeDescription) {
  catalog::Catalog catalog = catalog_of({row("a-text", "Butter"),
                                         row("b-keyword", "Drink"),
                                         row("c-name", "Milk Rolls"),
                                         row("d-exact", "Milk"),
                                         row("e-beginning", "Milkshake")});
  catalog.products[0].description = "Made of milk.";
  catalog.products[1].keywords = {"milk"};
  EXPECT_EQ(skus(catalog, "milk"),
            (Skus{"d-exact", "c-name", "b-keyword", "a-text", "e-beginning"}));
}

TEST(Search, MoreMatchedWordsWin) {
  const catalog::Catalog catalog =
      catalog_of({row("milk", "Milk"), row("oat", "Oat Drink"), row("oat-milk", "Oat Milk")});
  EXPECT_EQ(skus(catalog, "oat milk").front(), "oat-milk");
}

TEST(Search, PluralsEndingsCaseAccentsAndPunctuationDoNotMatter) {
  const catalog::Catalog catalog = catalog_of({row("apple", "Apple"),
                                               row("chips", "Chips"),
                                               row("creme", "Crème fraîche"),
                                               row("frozen", "Frozen Berries")});
  EXPECT_EQ(skus(catalog, "APPLES!"), Skus{"apple"});
  EXPECT_EQ(skus(catalog, "chip"), Skus{"chips"});
  EXPECT_EQ(skus(catalog, "creme fraiche"), Skus{"creme"});
  EXPECT_EQ(skus(catalog, "berry"), Skus{"frozen"});
}

TEST(Search, IntentsSayWhatTheCatalogueCallsIt) {
  catalog::Catalog catalog = catalog_of({row("all-purpose", "All-purpose cleaner"),
                                         row("dish-soap", "Dish soap"),
                                         row("glass", "Glass cleaner"),
                                         row("tumbler", "Drinking glass"),
                                         row("soap", "Soap bar")});
  const Skus found = skus(catalog, "something to clean windows");
  ASSERT_GE(found.size(), 2U);
  EXPECT_EQ(found[0], "glass");
  EXPECT_EQ(found[1], "all-purpose");
  EXPECT_EQ(skus(catalog, "washing the dishes").size(), 1U);  // "the" is no word to skip here
  EXPECT_EQ(skus(catalog, "wash a dish"), Skus{"dish-soap"});
}

TEST(Search, WithoutLeavesOutWhatHasIt) {
  catalog::Catalog catalog = catalog_of({row("lactose-free", "Lactose-free Milk"),
                                         row("milk", "Milk"),
                                         row("nuts", "Nut Chocolate"),
                                         row("plain", "Chocolate"),
                                         row("sugar", "Sugar Soda"),
                                         row("tea", "Unsweetened Iced Soda")});
  EXPECT_EQ(skus(catalog, "milk without lactose"), (Skus{"lactose-free", "milk"}));
  EXPECT_EQ(skus(catalog, "chocolate without nuts"), Skus{"plain"});
  EXPECT_EQ(skus(catalog, "soda without sugar"), Skus{"tea"});
}

TEST(Search, ChineseNames) {
  catalog::Catalog catalog = catalog_of({row("cola", "Cola"),
                                         row("milk", "Milk"),
                                         row("red", "Red Wine"),
                                         row("white", "White Wine")});
  catalog.products[0].name_zh = "可乐";
  catalog.products[1].name_zh = "低脂鲜牛奶";
  catalog.products[2].name_zh = "干红葡萄酒";
  catalog.products[3].name_zh = "白葡萄酒";
  EXPECT_EQ(skus(catalog, "红酒"), Skus{"red"});               // both characters, apart
  EXPECT_EQ(skus(catalog, "葡萄酒"), (Skus{"white", "red"}));  // the shorter name first
  EXPECT_EQ(skus(catalog, "牛奶，"), Skus{"milk"});
  EXPECT_EQ(skus(catalog, "低脂牛奶"), Skus{"milk"});
  EXPECT_EQ(skus(catalog, "可乐 cola"), Skus{"cola"});
  catalog.products[2].name_zh = "";
  EXPECT_EQ(skus(catalog, "红酒"), Skus{"red"});  // by what it means
}

TEST(Search, EqualsStandByKindAndId) {
  catalog::Catalog catalog = catalog_of({row("b", "Shelf"), row("a", "Shelf")});
  catalog.fixture_kinds.resize(1);
  catalog.fixture_kinds[0].kind = "0-shelf";
  catalog.fixture_kinds[0].name = "Other";
  const auto found = hits(catalog, "shelf");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(catalog.products[found[0].row].sku, "a");
  EXPECT_EQ(catalog.products[found[1].row].sku, "b");
  EXPECT_EQ(found[0].score, found[1].score);
}

TEST(Search, NothingAndNonsenseFindNothing) {
  const catalog::Catalog catalog = catalog_of({row("milk", "Milk")});
  for (const char* text : {"mi", " ,;- ", "submarine", "something to", "without", "\xE2\x80\x94"})
    EXPECT_TRUE(hits(catalog, text).empty()) << text;
  EXPECT_FALSE(hits(catalog, "mil").empty());
  EXPECT_EQ(hits(catalog, "").size(), catalog.products.size());  // no text: everything
}

TEST(Search, QuestionsAreNeverQuerySyntax) {
  const catalog::Catalog catalog = catalog_of({row("milk", "Milk"), row("tea", "Tea")});
  for (const char* text : {"\"milk",
                           "milk\"",
                           "milk OR",
                           "NEAR(milk tea, 2)",
                           "milk*",
                           "name:milk",
                           "{name brand}: milk",
                           "milk AND",
                           "-milk",
                           "^milk",
                           "milk + ",
                           "(milk",
                           "milk'); DROP TABLE assets;--",
                           "%milk_"})
    EXPECT_EQ(skus(catalog, text).front(), "milk") << text;
}

TEST(Search, AnyBytesAreAnsweredOrRefused) {  // no error of SQLite's own, for any text
  const auto database = catalog::AssetDatabase::build(catalog_of({row("milk", "Milk")}));
  ASSERT_TRUE(database.ok());
  std::mt19937 random(7);
  constexpr std::string_view alphabet = "\"'*():^{}+-,.AN NOT OR NEAR milk\xE7\x89\x9B\xC3\xA9";
  for (int trial = 0; trial < 400; ++trial) {
    catalog::AssetQuery query;
    for (std::size_t i = 0, length = random() % 40; i < length; ++i)
      query.text += alphabet[random() % alphabet.size()];
    const auto found = database->find(query);
    EXPECT_TRUE(found.ok() || found.error().code == "input.not_utf8") << query.text;
  }
  catalog::AssetQuery query;
  query.text = std::string("milk\0tea", 8);
  EXPECT_EQ(database->find(query)->size(), 1U);
  query.text.assign(100'000, 'm');
  EXPECT_TRUE(database->find(query).ok());
}

// ---- The committed rows. ----

const catalog::AssetDatabase& committed_database() {
  static const auto database = catalog::AssetDatabase::build(committed_catalog());
  return database.value();
}

std::vector<catalog::AssetHit> committed_hits(const std::string& text) {
  catalog::AssetQuery query;
  query.text = text;
  return committed_database().find(query).value();
}

const catalog::Product& first(const std::string& text) {
  const auto found = committed_hits(text);
  if (found.empty() || found[0].kind != catalog::AssetKind::goods)
    fatal(("no goods for " + text).c_str());
  return committed_catalog().products[found[0].row];
}

TEST(Search, CommittedRows) {
  EXPECT_NE(first("something to clean windows").name.find("leaner"), std::string::npos);
  EXPECT_EQ(first("milk").subcategory, "milk");
  EXPECT_EQ(first("shampoo").subcategory, "shampoo");
  EXPECT_EQ(first("bananas").category, "produce");
  EXPECT_EQ(first("frozen pizza").category, "frozen");
  EXPECT_EQ(first("红酒").name, "Red Wine");
  EXPECT_EQ(first("something to brush my teeth").subcategory, "oral care");
  for (const char* word :
       {"water", "bread", "apple", "tomato", "pasta", "coffee", "chocolate", "soap"}) {
    EXPECT_FALSE(committed_hits(word).empty()) << word;
  }
}

TEST(Search, FacilitiesAndMaterialsToo) {
  catalog::AssetQuery query;
  query.text = "island freezer";
  query.kinds = {catalog::AssetKind::facility};
  const auto facilities = committed_database().find(query);
  ASSERT_FALSE(facilities->empty());
  EXPECT_EQ(committed_catalog().fixture_kinds[facilities->at(0).row].kind, "island_freezer");
  query.text = "terrazzo";
  query.kinds = {catalog::AssetKind::material};
  const auto materials = committed_database().find(query);
  ASSERT_FALSE(materials->empty());
  EXPECT_EQ(committed_catalog().materials[materials->at(0).row].id.rfind("terrazzo", 0), 0U);
}

}  // namespace
}  // namespace marketgen
