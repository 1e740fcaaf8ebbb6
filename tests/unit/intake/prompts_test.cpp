// What the planner understands: prompts, each with every requirement and every unparsed word
// written by hand.
#include "intake/understanding.h"
#include "intake_fixture.h"

namespace marketgen {
namespace {

struct PromptCase {
  const char* prompt;
  std::vector<std::string> wishes;    // any order
  std::vector<std::string> unparsed;  // in the prompt's order
};

void PrintTo(const PromptCase& row, std::ostream* out) {
  *out << row.prompt;
}

const std::vector<PromptCase> cases = {
    // ---- Sizes and areas ----
    {"24 x 15 m supermarket", {"size 24000x15000", "profile supermarket-eu"}, {}},
    {"a 24 by 15 metres shop", {"size 24000x15000"}, {}},
    {"24x15m", {"size 24000x15000"}, {}},
    {"24m × 15m store", {"size 24000x15000"}, {}},
    {"an 80 x 50 ft market", {"size 24384x15240", "profile supermarket-eu"}, {}},
    {"12 m wide and 9 m deep shop", {"size 12000x9000"}, {}},
    {"4,000 sq ft grocery store", {"area 371.61216", "profile supermarket-eu"}, {}},
    {"a store of 300 m2", {"area 300"}, {}},
    {"a store of 300 m²", {"area 300"}, {}},
    {"300 square metres, six aisles", {"area 300", "aisle_count 6"}, {}},
    {"a shop of at least 250 sqm", {"area >=250"}, {}},
    {"a shop with a bakery of 20 m2", {"zone_present bakery", "area bakery 20"}, {}},
    {"a bakery of 20 m2", {"zone_present bakery", "area 20"}, {}},
    {"a kiosk of 30 m2 selling snacks", {"area 30", "profile kiosk", "zone_present snacks"}, {}},
    {"shop with a 3.2 m ceiling", {"height ceiling 3200"}, {}},
    {"ceiling height of 4 m", {"height ceiling 4000"}, {}},
    // ---- Counts ----
    {"five checkouts", {"fixture_count checkout_lane 5"}, {}},
    {"at least three checkouts", {"fixture_count checkout_lane >=3"}, {}},
    {"no more than 4 lanes", {"fixture_count checkout_lane <=4"}, {}},
    {"more than two checkouts", {"fixture_count checkout_lane >=3"}, {}},
    {"three or more tills", {"fixture_count checkout_lane >=3"}, {}},
    {"two self-checkouts and one checkout",
     {"fixture_count self_checkout 2", "fixture_count checkout_lane 1"},
     {}},
    {"a dozen checkouts", {"fixture_count checkout_lane 12"}, {}},
    {"exactly seven aisles", {"aisle_count 7"}, {}},
    {"two promotion areas", {"zone_count promo 2"}, {}},
    {"two entrances", {"opening entrance 2"}, {}},
    {"six pallet displays", {"fixture_count pallet 6"}, {}},
    // ---- Levels, heights, widths ----
    {"5-tier shelves", {"levels 5"}, {}},
    {"shelves with 5 levels", {"levels 5"}, {}},
    {"5-tier gondolas in snacks",
     {"levels snacks 5", "fixture_count gondola >=1", "zone_present snacks"},
     {}},
    {"snacks with 6 levels", {"levels snacks 6", "zone_present snacks"}, {}},
    {"at most four levels", {"levels <=4"}, {}},
    {"1.8 m wide aisles", {"aisle_width 1800"}, {}},
    {"aisles at least 2 m wide", {"aisle_width >=2000"}, {}},
    {"1.6 m high shelves", {"height fixture 1600"}, {}},
    {"no endcaps", {"endcaps <=0"}, {}},
    // ---- Zones, products, negation ----
    {"bakery, dairy and frozen food",
     {"zone_present bakery", "zone_present dairy", "zone_present frozen"},
     {}},
    {"a shop with no alcohol", {"zone_absent alcohol"}, {}},
    {"without a bakery or a cafe", {"zone_absent bakery", "zone_absent cafe"}, {}},
    {"no bakery, cafe or deli", {"zone_absent bakery", "zone_absent cafe", "zone_absent deli"}, {}},
    {"no alcohol, bakery near the entrance",
     {"zone_absent alcohol", "zone_present bakery", "relation near bakery entrance"},
     {}},
    {"we don't sell alcohol", {"zone_absent alcohol"}, {}},
    {"lots of yoghurt", {"product_present yoghurt"}, {}},
    {"no energy drinks", {"product_absent energy drinks"}, {}},
    {"lots of cold drinks", {"zone_present chilled"}, {}},
    {"a large produce section", {"zone_present produce"}, {}},
    {"bakery but no cafe", {"zone_present bakery", "zone_absent cafe"}, {}},
    {"a shop with chest freezers", {"fixture_count chest_freezer >=1"}, {}},
    // ---- Places ----
    {"dairy along the back wall", {"zone_present dairy", "relation along dairy north"}, {}},
    {"bakery left of the entrance",
     {"zone_present bakery", "relation left_of bakery entrance"},
     {}},
    {"the deli is between the bakery and the dairy",
     {"zone_present deli",
      "zone_present bakery",
      "zone_present dairy",
      "relation between deli bakery dairy"},
     {}},
    {"wine next to cheese",
     {"product_present wine", "product_present cheese", "relation near alcohol dairy"},
     {}},
    {"keep household away from produce",
     {"zone_present household", "relation far household produce"},
     {}},
    {"meat opposite the bakery",
     {"zone_present meat_fish", "zone_present bakery", "relation facing meat_fish bakery"},
     {}},
    {"frozen behind the snacks",
     {"zone_present frozen", "zone_present snacks", "relation behind frozen snacks"},
     {}},
    {"alcohol in the north-east corner",
     {"zone_present alcohol", "relation at alcohol north", "relation at alcohol east"},
     {}},
    {"produce in the middle", {"zone_present produce", "relation at produce center"}, {}},
    {"frozen food at the back and snacks at the front",
     {"zone_present frozen",
      "relation at frozen north",
      "zone_present snacks",
      "relation at snacks south"},
     {}},
    {"Along the back wall put dairy and meat.",
     {"zone_present dairy",
      "relation along dairy north",
      "zone_present meat_fish",
      "relation along meat_fish north"},
     {}},
    {"bakery, dairy and frozen zones along the north wall",
     {"zone_present bakery",
      "relation along bakery north",
      "zone_present dairy",
      "relation along dairy north",
      "zone_present frozen",
      "relation along frozen north"},
     {}},
    {"don't put frozen near the entrance", {"relation far frozen entrance"}, {}},
    {"bakery not next to the meat",
     {"zone_present bakery", "relation not_adjacent bakery meat_fish"},
     {}},
    {"the entrance on the east wall", {"opening entrance east"}, {}},
    {"dairy left of the checkouts",
     {"zone_present dairy", "zone_present checkout", "relation left_of dairy checkout"},
     {}},
    // ---- Look, style, stock, name ----
    {"industrial style", {"style industrial"}, {}},
    {"a Scandinavian discount store", {"style scandinavian", "profile discounter"}, {}},
    {"organic market with an oak floor", {"profile organic-eu", "material floor wood-oak"}, {}},
    {"red brick walls and a black ceiling",
     {"material wall brick-red", "material ceiling ceiling-black"},
     {}},
    {"white shelves", {"color fixture #f5f5f2"}, {}},
    {"green accents", {"color accent #2e7d32"}, {}},
    {"warm light", {"light light_kelvin 3000"}, {}},
    {"well stocked shelves", {"stock fill >=0.93"}, {}},
    {"half empty shelves", {"stock fill <=0.55"}, {}},
    {"a shop called Riverside Fresh with a bakery", {"zone_present bakery"}, {}},
    {"\"Bakery Street\", a convenience store", {"profile convenience-us"}, {}},
    // ---- Strength, slips of the pen, what is not understood ----
    {"ideally with a cafe, and five checkouts",
     {"?zone_present cafe", "fixture_count checkout_lane 5"},
     {}},
    {"a bakery near the entrance if possible",
     {"?zone_present bakery", "?relation near bakery entrance"},
     {}},
    {"it must have a deli", {"zone_present deli"}, {}},
    {"a bakry and a supermaket", {"zone_present bakery", "profile supermarket-eu"}, {}},
    {"ＢＡＫＥＲＹ", {"zone_present bakery"}, {}},
    {"a bakery with a trampoline", {"zone_present bakery"}, {"trampoline"}},
    {"xyzzy plugh", {}, {"xyzzy", "plugh"}},
    {"春眠不觉晓", {}, {"春眠不觉晓"}},
    {"five", {}, {"five"}},
};

class Prompts : public testing::TestWithParam<PromptCase> {};

TEST_P(Prompts, AreUnderstood) {
  const PromptCase& expected = GetParam();
  const intake::Understanding found =
      intake::understand(expected.prompt, shipped_language(), committed_catalog());
  std::vector<std::string> wishes = expected.wishes;
  std::ranges::sort(wishes);
  EXPECT_EQ(sorted_lines(found.requirements), wishes) << expected.prompt;
  std::vector<std::string> unparsed;
  for (const intake::UnparsedWord& word : found.unparsed)
    unparsed.push_back(word.text);
  EXPECT_EQ(unparsed, expected.unparsed) << expected.prompt;
}

INSTANTIATE_TEST_SUITE_P(Table, Prompts, testing::ValuesIn(cases));

TEST(Prompts, SpansPointAtTheWords) {
  const std::string prompt = "A 24 x 15 m shop, café bakery left of the entrance, 五 trampolines";
  const intake::Understanding found =
      intake::understand(prompt, shipped_language(), committed_catalog());
  ASSERT_FALSE(found.requirements.empty());
  for (const plan::Requirement& wish : found.requirements) {
    const auto first = static_cast<std::size_t>(wish.span[0]);
    const auto length = static_cast<std::size_t>(wish.span[1]) - first;
    EXPECT_EQ(prompt.substr(first, length), wish.text);
  }
  ASSERT_EQ(found.unparsed.size(), 2U);
  const intake::UnparsedWord& last = found.unparsed.back();
  EXPECT_EQ(prompt.substr(static_cast<std::size_t>(last.span[0])), "trampolines");
}

TEST(Prompts, NameIsTakenOut) {
  const intake::Understanding found = intake::understand(
      "a market named Green Bakery & Sons by the river", shipped_language(), committed_catalog());
  ASSERT_TRUE(found.name.has_value());
  EXPECT_EQ(found.name->text, "Green Bakery & Sons");
}

struct ContradictionCase {
  const char* prompt;
  const char* kept;
  const char* dropped;
};

TEST(Prompts, ContradictionsAreSettledAndReported) {
  const std::vector<ContradictionCase> contradictions = {
      {"no bakery. A bakery near the entrance.", "bakery", "no bakery"},
      {"five checkouts, and then six checkouts", "six checkouts", "five checkouts"},
      {"oak floor, terrazzo floor", "terrazzo floor", "oak floor"},
      {"dairy near the entrance. Dairy away from the entrance.",
       "Dairy away from the entrance",
       "dairy near the entrance"},
      {"a supermarket, it must have a deli, ideally no deli", "deli", "no deli"},
  };
  for (const ContradictionCase& expected : contradictions) {
    const intake::Understanding found =
        intake::understand(expected.prompt, shipped_language(), committed_catalog());
    ASSERT_FALSE(found.conflicts.empty()) << expected.prompt;
    EXPECT_EQ(found.conflicts[0].kept, expected.kept) << expected.prompt;
    EXPECT_EQ(found.conflicts[0].dropped, expected.dropped) << expected.prompt;
  }
}

// The words of a wish may be few: its clause says which of the many places in a long prompt is
// meant.
TEST(Prompts, ContradictionsQuoteTheClausesOfBoth) {
  const intake::Understanding found = intake::understand(
      "The ceiling is at 4.50 m throughout, I think. Later: the ceiling comes down to 3.80 m in "
      "all "
      "of it.",
      shipped_language(),
      committed_catalog());
  ASSERT_EQ(found.conflicts.size(), 1U);
  const std::string& why = found.conflicts[0].why;
  EXPECT_NE(why.find("\"The ceiling is at 4.50 m throughout\""), std::string::npos) << why;
  EXPECT_NE(why.find("the ceiling comes down to 3.80 m in all of it\""), std::string::npos) << why;
}

TEST(Prompts, NumbersThatCanBothHoldAreNoConflict) {
  const intake::Understanding found =
      intake::understand("at least three checkouts and at most five checkouts",
                         shipped_language(),
                         committed_catalog());
  EXPECT_TRUE(found.conflicts.empty());
  EXPECT_EQ(found.requirements.size(), 2U);
}

}  // namespace
}  // namespace marketgen
