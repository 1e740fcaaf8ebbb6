// GTIN-13 against published examples.
#include <gtest/gtest.h>

#include <string>

#include "catalog/gtin.h"

namespace marketgen {
namespace {

// The example of the GS1 General Specifications' check-digit chapter, and numbers printed on real
// packs and books.
constexpr const char* published[] = {"6291041500213",
                                     "4006381333931",
                                     "5901234123457",
                                     "9780306406157",
                                     "9783161484100",
                                     "8711253001202"};

TEST(Gtin, AcceptsPublishedNumbers) {
  for (const char* number : published)
    EXPECT_TRUE(catalog::is_ean13(number)) << number;
}

TEST(Gtin, EverySlippedDigitIsSeen) {  // weights 1 and 3 are coprime to 10: one wrong digit always
                                       // changes the sum
  for (const char* number : published) {
    for (std::size_t i = 0; i < 13; ++i) {
      for (char digit = '0'; digit <= '9'; ++digit) {
        std::string wrong = number;
        if (wrong[i] == digit) continue;
        wrong[i] = digit;
        EXPECT_FALSE(catalog::is_ean13(wrong)) << number << " as " << wrong;
      }
    }
  }
}

TEST(Gtin, OnlyThirteenDigits) {
  for (const char* text : {"",
                           "629104150021",
                           "62910415002130",
                           "629104150021X",
                           " 629104150021",
                           "629104150021\xC2\xB3"}) {
    EXPECT_FALSE(catalog::is_ean13(text)) << text;
  }
}

TEST(Gtin, RestrictedCirculationIsGs1sList) {  // 020-029, 040-049, 200-299; neighbours belong to
                                               // GS1 US and to reserved ranges
  for (const char* prefix : {"020", "029", "040", "049", "200", "299"}) {
    EXPECT_TRUE(catalog::is_restricted_circulation(std::string(prefix) + "0000000000")) << prefix;
  }
  for (const char* prefix :
       {"000", "019", "030", "039", "050", "139", "199", "300", "400", "978"}) {
    EXPECT_FALSE(catalog::is_restricted_circulation(std::string(prefix) + "0000000000")) << prefix;
  }
  EXPECT_FALSE(catalog::is_restricted_circulation(""));
  EXPECT_FALSE(catalog::is_restricted_circulation("20"));
}

}  // namespace
}  // namespace marketgen
