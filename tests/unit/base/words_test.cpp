// English words, folded so that one and many are the same.
#include "base/words.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

TEST(Words, SingularByTheEnding) {
  EXPECT_EQ(singular("checkouts"), "checkout");
  EXPECT_EQ(singular("bakeries"), "bakery");
  EXPECT_EQ(singular("dishes"), "dish");
  EXPECT_EQ(singular("glass"), "glass");
  EXPECT_EQ(singular("tomatoes"), "tomato");
  EXPECT_EQ(singular("bus"), "bus");
  EXPECT_EQ(singular("loaves"), "loaf");
  EXPECT_EQ(singular("shoes"), "shoe");
}

// Words in "ie" would otherwise be another word than their plural.
TEST(Words, OneAndManyAreOneWord) {
  for (const auto& [one, many] : {std::pair("cookie", "cookies"),
                                  std::pair("smoothie", "smoothies"),
                                  std::pair("pie", "pies"),
                                  std::pair("berry", "berries"),
                                  std::pair("sandwich", "sandwiches"),
                                  std::pair("mango", "mangoes"),
                                  std::pair("leaf", "leaves"),
                                  std::pair("knife", "knives")}) {
    EXPECT_EQ(singular(one), singular(many));
  }
}

TEST(Words, SpacedWordsStandInOneAnotherWhereTheirWordsDo) {
  EXPECT_EQ(spaced_words("Cherry Tomatoes"), " cherry tomato ");
  EXPECT_EQ(spaced_words("Mac & Cheese, 2"), " mac cheese 2 ");
  EXPECT_EQ(spaced_words("Children's Yoghurt"), " children yoghurt ");
  EXPECT_EQ(spaced_words(" - "), "");
  EXPECT_NE(spaced_words("Cherry Tomatoes").find(spaced_words("tomato")), std::string::npos);
  EXPECT_EQ(spaced_words("Chocolate").find(spaced_words("cola")), std::string::npos);
}

}  // namespace
}  // namespace marketgen
