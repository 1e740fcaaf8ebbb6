// How large the shop becomes, and its zones, by what a sentence says about floor.
#include "intake/understanding.h"
#include "intake_fixture.h"

namespace marketgen {
namespace {

constexpr double usual = -1;  // nothing is said about the shop's floor

struct FloorCase {
  const char* prompt;
  double shop_m2;
  const char* zone = "";  // the zone type whose floor was asked for
  double zone_m2 = 0;
};

void PrintTo(const FloorCase& row, std::ostream* out) {
  *out << row.prompt;
}

const std::vector<FloorCase> floor_cases = {
    // ---- The shop's, wherever it stands in the sentence ----
    {"a kiosk of 40 m2 with snacks and cold drinks", 40},
    {"40 m2 kiosk with snacks and cold drinks", 40},
    {"a 40 m² kiosk with snacks and cold drinks", 40},
    {"a kiosk with snacks and cold drinks, 40 square metres", 40},
    {"a kiosk with snacks and cold drinks of 40 m2", 40},
    {"a kiosk with snacks and cold drinks (40 m2)", 40},
    {"a kiosk (40 m2) with snacks and cold drinks", 40},
    {"kiosk, 40 m2, snacks and cold drinks", 40},
    {"snacks and cold drinks on 40 m2", 40},
    {"40 m2: a kiosk with snacks", 40},
    {"A kiosk. 40 m2. Snacks and cold drinks.", 40},
    {"a kiosk with 40 m² of sales floor and a lot of snacks", 40},
    {"a kiosk of 30 m2 selling snacks", 30},
    {"a kiosk of 30 m2 offering drinks and sandwiches", 30},
    {"a shop of 55 m2 including a bakery", 55},
    {"a supermarket of about 300 m² with dairy along the back wall", 300},
    {"a supermarket of roughly 300 square metres featuring produce", 300},
    {"a 300 square metre supermarket with a bakery by the entrance", 300},
    {"a 300-square-metre supermarket with five checkouts", 300},
    {"three hundred square metres, a bakery and a deli", 300},
    {"two hundred and fifty square metres of shop", 250},
    {"a corner shop of sixty square metres", 60},
    {"a hundred and twenty square metre shop with drinks", 120},
    {"a shop of at least 250 sqm with produce", 250},
    {"a supermarket with a floor area of 420 m2 and wine", 420},
    {"a 420 m2 hall with produce and bakery", 420},
    {"a supermarket on 600 m2 with eight aisles", 600},
    {"a 4,000 sq ft grocery store with dairy", 371.6},
    {"a 4000 square foot convenience store with snacks", 371.6},
    {"1,200 m2 hypermarket with a cafe", 1200},
    {"a hypermarket of 1 200 m² with a cafe", 1200},
    {"a shop of 200 to 300 m2 with dairy", 250},
    {"a 200-300 m2 shop with dairy", 250},
    {"a shop between 200 and 300 m2", 250},
    {"a 90 m2 small organic shop with bread", 90},
    {"a large 500 m2 supermarket", 500},
    {"a 130 m2 Asian grocery with rice and noodles", 130},
    {"a 20 m2 kiosk", 20},
    {"a test shop of 16 m2", 16},
    // ---- Width by depth ----
    {"24 x 15 m supermarket with a bakery", 360},
    {"12 by 9 m", 108},
    {"a shop of 12 by 9 m with snacks", 108},
    {"a shop with snacks and dairy, 12 x 9 metres", 108},
    {"twelve by nine metres, with a bakery", 108},
    {"a kiosk, 8m x 6m, drinks", 48},
    {"80 x 50 ft market with a salad bar", 371.6},
    {"12 m wide and 9 m deep, with a bakery", 108},
    {"a supermarket 30 m long and 12 m wide", 360},
    {"a 10 m wide shop of 150 m2", 150},
    {"an 18 x 12 m shop with a 20 m2 bakery", 216, "bakery", 20},
    // ---- A shop that goes by the name of its goods ----
    {"a drugstore of 200 m2", 200},
    {"a 60 m2 wine shop", 60},
    {"a 60 m2 wine and spirits shop", 60},
    {"a 50 m² bakery with a coffee corner", 50},
    {"a bakery of 50 m2", 50},
    {"a butcher's shop of 45 m2", 45},
    {"a pharmacy of 100 m2 with cosmetics", 100},
    {"a 70 m2 greengrocer", 70},
    {"a 400 m2 drinks market with beer and water", 400},
    // ---- A zone's ----
    {"a supermarket with a 20 m2 bakery", usual, "bakery", 20},
    {"a supermarket with a bakery of 20 m2", usual, "bakery", 20},
    {"supermarket with bakery of 20 m2", usual, "bakery", 20},
    {"a supermarket with a bakery (20 m2)", usual, "bakery", 20},
    {"a supermarket with a large 30 m2 bakery", usual, "bakery", 30},
    {"a supermarket with a bakery section of about 20 m2", usual, "bakery", 20},
    {"a supermarket with a 5 x 4 m bakery", usual, "bakery", 20},
    {"a 400 m2 supermarket with a 25 m2 deli", 400, "deli", 25},
    {"a 25 m2 deli in a 400 m2 supermarket", 400, "deli", 25},
    {"a shop of 300 m2, with a bakery of 20 m2 near the entrance", 300, "bakery", 20},
    {"a shop of 300 m2. Bakery: 20 m2.", 300, "bakery", 20},
    {"24 x 15 m, produce, dairy of 30 m2 and snacks", 360, "dairy", 30},
    {"a 360 m2 supermarket with 20 m2 of wine", 360, "alcohol", 20},
    {"a 300 m2 shop with a 15 m2 beer section", 300, "alcohol", 15},
};

class FloorSizes : public testing::TestWithParam<FloorCase> {};

TEST_P(FloorSizes, AreThoseThatWereSaid) {
  const FloorCase& expected = GetParam();
  const auto planner = intake::offline_planner();
  ASSERT_TRUE(planner.ok());
  intake::Brief brief;
  brief.prompt = expected.prompt;
  const auto made = intake::plan_from_brief(brief, committed_catalog(), **planner, Seed(1));
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  const plan::Shell& shell = made->plan.shell;
  const double built_m2 = 1e-6 * shell.width_mm * shell.depth_mm;
  std::vector<std::string> zones_with_floor;
  for (const plan::Requirement& wish : made->requirements) {
    if (wish.kind != plan::RequirementKind::area || wish.subject.empty()) continue;
    zones_with_floor.push_back(wish.subject);
    EXPECT_NEAR(wish.value, expected.zone_m2, 0.01);
  }
  const std::vector<std::string> wanted_zones(*expected.zone != '\0' ? 1 : 0, expected.zone);
  EXPECT_EQ(zones_with_floor, wanted_zones);
  if (expected.shop_m2 != usual) {
    EXPECT_NEAR(built_m2, expected.shop_m2, 0.05 * expected.shop_m2);
  } else {
    EXPECT_NEAR(built_m2, 360, 1);  // a supermarket's
  }
}

INSTANTIATE_TEST_SUITE_P(Table, FloorSizes, testing::ValuesIn(floor_cases));

TEST(FloorSizes, OneSideThatWasSaidIsKept) {
  const auto planner = intake::offline_planner();
  intake::Brief brief;
  brief.prompt = "a 10 m wide supermarket with dairy";
  const auto made = intake::plan_from_brief(brief, committed_catalog(), **planner, Seed(1));
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->plan.shell.width_mm, 10000);
}

// ---- Nothing, or nothing of any use, was said ----

TEST(Nonsense, IsSaidToBe) {
  for (const char* prompt :
       {"asdf qwerty", "lorem ipsum", "春眠不觉晓", "🛒🛒", "please", "!!", "42"}) {
    const intake::Understanding found =
        intake::understand(prompt, shipped_language(), committed_catalog());
    EXPECT_FALSE(found.understood) << prompt;
  }
  for (const char* prompt :
       {"a shop", "dairy", "🛒 kiosk", "well stocked", "a shop called Asdf"}) {
    const intake::Understanding found =
        intake::understand(prompt, shipped_language(), committed_catalog());
    EXPECT_TRUE(found.understood) << prompt;
  }
}

TEST(Nonsense, ListsPicturesAsWell) {
  const intake::Understanding found =
      intake::understand("🛒 bakery", shipped_language(), committed_catalog());
  ASSERT_EQ(found.unparsed.size(), 1U);
  EXPECT_EQ(found.unparsed[0].text, "🛒");
}

}  // namespace
}  // namespace marketgen
