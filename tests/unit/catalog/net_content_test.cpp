// Amounts of packs, colours of labels, and what is easily taken for what.
#include "catalog/net_content.h"

#include <gtest/gtest.h>

#include "catalog/label_color.h"
#include "catalog/look_alike.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

TEST(NetContent, ReadsWhatRowsPrint) {
  const auto litre = catalog::net_content("1 l"), six = catalog::net_content("6 x 1.5 l"),
             bags = catalog::net_content("20 bags");
  ASSERT_TRUE(litre && six && bags);
  EXPECT_EQ(litre->total(), 1000);
  EXPECT_EQ(litre->unit, catalog::NetUnit::millilitre);
  EXPECT_EQ(six->packs, 6);
  EXPECT_EQ(six->total(), 9000);
  EXPECT_EQ(bags->unit, catalog::NetUnit::piece);
  EXPECT_EQ(bags->counted, "bag");
  EXPECT_FALSE(catalog::net_content("each"));
  EXPECT_FALSE(catalog::net_content("x l"));
  EXPECT_TRUE(catalog::net_content("0.5 l")->is_as_much_as(*catalog::net_content("500 ml")));
  EXPECT_FALSE(catalog::net_content("500 g")->is_as_much_as(*catalog::net_content("500 ml")));
  EXPECT_FALSE(catalog::net_content("4 rolls")->is_as_much_as(*catalog::net_content("4 bags")));
}

// The printed amount is that of the unit price, wherever both are of mass or volume.
TEST(NetContent, AgreesWithTheUnitPrice) {
  for (const catalog::Product& row : committed_catalog().products) {
    const auto net = catalog::net_content(row.net);
    if (!net || net->unit == catalog::NetUnit::piece || row.unit_of_measure == "piece") continue;
    EXPECT_NEAR(net->total() / 1000, row.unit_amount, 0.011 * row.unit_amount) << row.sku;
  }
}

TEST(LabelColor, NamesWhatIsClearAlone) {
  EXPECT_EQ(catalog::label_color_term("#1565c0"), "blue");
  EXPECT_EQ(catalog::label_color_term("#c1121f"), "red");
  EXPECT_EQ(catalog::label_color_term("#ffffff"), "white");
  EXPECT_EQ(catalog::label_color_term("#2e7d32"), "green");
  EXPECT_EQ(catalog::label_color_term("#1a1a1a"), "black");
  EXPECT_FALSE(catalog::label_color_term("#00838f"));  // between green and blue
  EXPECT_FALSE(catalog::label_color_term("blue"));
}

TEST(LookAlike, IsOfTheFamilyOrOfTheSameShapeAndGroup) {
  catalog::Product a, b;
  a.sku = "a", b.sku = "b";
  a.subcategory = b.subcategory = "milk";
  a.archetype = b.archetype = "box";
  a.size_mm = {70, 70, 200};
  b.size_mm = {72, 70, 190};
  EXPECT_TRUE(catalog::are_look_alikes(a, b));
  EXPECT_FALSE(catalog::are_look_alikes(a, a));
  b.size_mm = {90, 70, 190};
  EXPECT_FALSE(catalog::are_look_alikes(a, b));
  a.family = b.family = "kurano-cola";
  EXPECT_TRUE(catalog::are_look_alikes(a, b));
}

}  // namespace
}  // namespace marketgen
