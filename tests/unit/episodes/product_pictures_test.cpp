// What the catalogue shows an agent of a product is the product's alone.
#include "episodes/product_pictures.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

#include "support/committed_catalog.h"

namespace marketgen {
namespace {

const catalog::Product& of_shape(const char* archetype) {
  for (const catalog::Product& product : committed_catalog().products)
    if (product.archetype == archetype) return product;
  fatal("the catalogue has no such shape");
}

TEST(ProductPictures, AreTheSameWhateverOthersThereAre) {
  const catalog::Product& can = of_shape("can");
  const catalog::Product& box = of_shape("box");
  const std::array alone{&can};
  const std::array both{&box, &can};
  const auto by_itself = episodes::product_pictures(alone);
  const auto beside = episodes::product_pictures(both);
  ASSERT_TRUE(by_itself.ok() && beside.ok());
  ASSERT_EQ(by_itself->front().size(), 6U);
  for (std::size_t side = 0; side < 6; ++side) {
    const agent::ProductPicture &a = by_itself->front()[side], &b = beside->back()[side];
    EXPECT_EQ(a.color.pixels, b.color.pixels) << side;
    EXPECT_EQ(a.depth_m, b.depth_m) << side;
  }
}

TEST(SlowProductPictures, OfEachShapeAreTheSameInAnyCompany) {
  std::vector<const catalog::Product*> some;
  std::set<std::string> shapes;
  for (const catalog::Product& product : committed_catalog().products)
    if (shapes.insert(product.archetype).second) some.push_back(&product);
  std::vector<const catalog::Product*> backwards(some.rbegin(), some.rend());
  const auto one = episodes::product_pictures(some);
  const auto other = episodes::product_pictures(backwards);
  ASSERT_TRUE(one.ok() && other.ok());
  for (std::size_t i = 0; i < some.size(); ++i)
    for (std::size_t side = 0; side < 6; ++side) {
      const agent::ProductPicture& a = (*one)[i][side];
      const agent::ProductPicture& b = (*other)[some.size() - 1 - i][side];
      EXPECT_EQ(a.color.pixels, b.color.pixels) << some[i]->sku << " " << side;
      EXPECT_EQ(a.depth_m, b.depth_m) << some[i]->sku << " " << side;
    }
}

TEST(ProductPictures, ShowAllOfItFromEverySide) {
  const catalog::Product& can = of_shape("can");
  const std::array alone{&can};
  const auto pictures = episodes::product_pictures(alone);
  ASSERT_TRUE(pictures.ok()) << to_string(pictures.error());
  for (const agent::ProductPicture& picture : pictures->front()) {
    double shown = 0, bright = 0;
    for (std::size_t i = 0; i < picture.depth_m.size(); ++i) {
      if (!(picture.depth_m[i] > 0)) continue;
      ++shown;
      bright += picture.color.pixels[3 * i + 1];
    }
    EXPECT_GT(shown / static_cast<double>(picture.depth_m.size()), 0.6);
    EXPECT_GT(bright / shown, 15);  // the room's light falls on it
  }
}

}  // namespace
}  // namespace marketgen
