// The reader knows the catalogue's words, amounts and synonyms, and says when it understands
// nothing.
#include "perception/goal_reader.h"

#include <gtest/gtest.h>

#include "perception/said_amounts.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

catalog::Product product(const std::string& sku,
                         const std::string& name,
                         const std::string& variant,
                         const std::string& net) {
  catalog::Product row;
  row.sku = sku;
  row.name = name;
  row.variant = variant;
  row.brand = "Kurano";
  row.category = "beverages";
  row.subcategory = "soft drinks";
  row.archetype = "can";
  row.net = net;
  return row;
}

std::vector<std::string> read(const std::vector<catalog::Product>& rows, const std::string& text) {
  const perception::CatalogueReader reader(rows, committed_catalog().search_lexicon);
  return reader.read(text).value();
}

TEST(SaidAmounts, AreReadInManyForms) {
  const auto total = [](const std::string& text) {
    const auto said = perception::said_words(text, {"bag"});
    return said.amounts.size() == 1 ? said.amounts[0].total() : -1;
  };
  EXPECT_EQ(total("the milk, one litre"), 1000);
  EXPECT_EQ(total("half a litre of milk"), 500);
  EXPECT_EQ(total("milk, 1.5 l"), 1500);
  EXPECT_EQ(total("the 500g bread"), 500);
  EXPECT_EQ(total("a kilo of rice"), 1000);
  EXPECT_EQ(total("cola, 6 x 330 ml"), 1980);
  EXPECT_EQ(total("cola, six times half a litre"), 3000);
  EXPECT_EQ(total("tea, twenty bags"), 20);
  EXPECT_EQ(total("two bags of tea"), -1);  // how many are wanted
  const auto said = perception::said_words("the 1.5% fat milk by Weidora", {});
  EXPECT_EQ(said.words, (std::vector<std::string>{"the", "1.5", "fat", "milk", "by", "weidora"}));
}

TEST(CatalogueReader, ReadsNamesVariantsAmountsAndSynonyms) {
  const std::vector<catalog::Product> rows{product("cola", "Cola", "Original", "330 ml"),
                                           product("cola-zero", "Cola", "Zero Sugar", "330 ml"),
                                           product("cola-litre", "Cola", "Original", "1 l"),
                                           product("crisps", "Potato Crisps", "Paprika", "175 g")};
  EXPECT_EQ(read(rows, "two cans of original cola, 330 millilitres"),
            std::vector<std::string>{"cola"});
  EXPECT_EQ(read(rows, "the sugar-free cola").front(), "cola-zero");
  EXPECT_EQ(read(rows, "the cola without sugar").front(), "cola-zero");
  EXPECT_EQ(read(rows, "the original cola, one litre"), std::vector<std::string>{"cola-litre"});
  EXPECT_EQ(read(rows, "potato chips"), std::vector<std::string>{"crisps"});
  // As much is said of both: by SKU.
  EXPECT_EQ(read(rows, "the original cola"), (std::vector<std::string>{"cola", "cola-litre"}));
}

// What shoppers say for what labels call otherwise, in the whole catalogue.
TEST(CatalogueReader, ReadsEverydayWords) {
  const auto first = [](const std::string& text) {
    return read(committed_catalog().products, text).front();
  };
  EXPECT_EQ(first("the ice tea in the variety peach"), "beverages-iced-tea-peach-0-5l");
  EXPECT_EQ(first("the cherry coke"), "beverages-cola-cherry-330ml");
  EXPECT_EQ(first("the garbanzo beans"), first("the chickpeas"));
  EXPECT_EQ(first("the bottled water"), first("the mineral water"));
}

TEST(CatalogueReader, ACanIsAShapeThoughTheWordSaysNothingElsewhere) {
  catalog::Product bottle = product("a-cola", "Cola", "Original", "330 ml");
  bottle.archetype = "pet_bottle";
  const std::vector<catalog::Product> rows{bottle, product("cola", "Cola", "Original", "330 ml")};
  EXPECT_EQ(read(rows, "two cans of cola"), std::vector<std::string>{"cola"});
}

// All that are called bottles are bottles, not only the one whose row has the word.
TEST(CatalogueReader, KnowsWhatShapesAreCalled) {
  catalog::Product flask = product("shampoo-mild", "Shampoo", "Mild", "250 ml");
  catalog::Product large = product("shampoo-repair", "Shampoo", "Repair", "500 ml");
  flask.archetype = large.archetype = "flask";
  large.description = "Shampoo in a large bottle.";
  catalog::Product box = product("shampoo-solid", "Shampoo", "Solid", "75 g");
  box.archetype = "box";
  EXPECT_EQ(read({flask, large, box}, "the bottle of shampoo"),
            (std::vector<std::string>{"shampoo-mild", "shampoo-repair"}));
}

TEST(CatalogueReader, SaysWhenNoWordIsKnown) {
  const perception::CatalogueReader reader({product("cola", "Cola", "Original", "330 ml")},
                                           committed_catalog().search_lexicon);
  const auto result = reader.read("the zyxwv");
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, "perception.not_understood");
}

TEST(SaidAmounts, ANumberAtTheBeginningIsAnAmountWhenAMeasureFollows) {
  const auto pasta = perception::said_words("500 g of pasta", {});
  ASSERT_EQ(pasta.amounts.size(), 1U);
  EXPECT_EQ(pasta.amounts[0].amount, 500);
  EXPECT_FALSE(pasta.count.has_value());
  const auto milk = perception::said_words("two cartons of milk", {});
  EXPECT_TRUE(milk.amounts.empty());
  EXPECT_EQ(milk.count, 2.0);
}

}  // namespace
}  // namespace marketgen
