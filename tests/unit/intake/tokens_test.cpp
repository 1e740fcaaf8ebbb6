// Words, numbers and their bytes.
#include "intake/tokens.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

std::vector<std::string> texts(std::string_view prompt) {
  std::vector<std::string> found;
  for (const intake::Token& token : intake::tokenize(prompt))
    found.push_back(token.text);
  return found;
}

using Texts = std::vector<std::string>;

TEST(Tokens, DigitsAndLettersPart) {
  EXPECT_EQ(texts("24x15m"), (Texts{"24", "x", "15", "m"}));
  EXPECT_EQ(texts("5-tier"), (Texts{"5", "tier"}));
  EXPECT_EQ(texts("self-checkout"), (Texts{"self", "checkout"}));
}

TEST(Tokens, SquareMetresStayTogether) {
  EXPECT_EQ(texts("300 m2, 300 m²"), (Texts{"300", "m2", ",", "300", "m2"}));
}

TEST(Tokens, NumbersAreReadAsPeopleWriteThem) {
  EXPECT_EQ(intake::tokenize("4,000")[0].number, 4000);
  EXPECT_EQ(intake::tokenize("1,234,567")[0].number, 1234567);
  EXPECT_EQ(intake::tokenize("1.8")[0].number, 1.8);
  EXPECT_EQ(intake::tokenize("1,8")[0].number, 1.8);
  EXPECT_EQ(intake::tokenize("１２")[0].number, 12);  // full width
  EXPECT_EQ(intake::tokenize("15.").size(), 2U);      // a full stop, not a decimal point
}

TEST(Tokens, AreFoldedWithoutLosingTheirBytes) {
  const std::string prompt = "Café ＢＡＫＥＲＹ don’t";
  const std::vector<intake::Token> tokens = intake::tokenize(prompt);
  ASSERT_EQ(tokens.size(), 3U);
  EXPECT_EQ(tokens[0].text, "café");
  EXPECT_EQ(tokens[1].text, "bakery");
  EXPECT_EQ(tokens[2].text, "don't");
  for (const intake::Token& token : tokens) {
    EXPECT_GT(token.span[1], token.span[0]);
    EXPECT_LE(token.span[1], static_cast<int>(prompt.size()));
  }
  EXPECT_EQ(prompt.substr(0, static_cast<std::size_t>(tokens[0].span[1])), "Café");
}

TEST(Tokens, SentencesEndAtStopsAndBullets) {
  const auto ends = [](std::string_view prompt) {
    int count = 0;
    for (const intake::Token& token : intake::tokenize(prompt))
      count += token.kind == intake::TokenKind::sentence_end ? 1 : 0;
    return count;
  };
  EXPECT_EQ(ends("a shop. A bakery!"), 2);
  EXPECT_EQ(ends("4,000 sq. ft"), 0);
  EXPECT_EQ(ends("a shop\n- bakery\n- dairy"), 2);
  EXPECT_EQ(ends("a shop with\na bakery"), 0);  // wrapped, not ended
}

}  // namespace
}  // namespace marketgen
