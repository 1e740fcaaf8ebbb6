// What is said of some zones and not of others, what is corrected, and what pronouns stand for.
#include "intake/understanding.h"
#include "intake_fixture.h"

namespace marketgen {
namespace {

struct ConstructionCase {
  const char* prompt;
  std::vector<std::string> wishes;  // any order
};

void PrintTo(const ConstructionCase& row, std::ostream* out) {
  *out << row.prompt;
}

const std::vector<ConstructionCase> constructions = {
    // ---- Limits of single zones ----
    {"Canned goods: shelf pitch 9 inches, six boards high.",
     {"zone_present canned", "shelf_pitch canned 228.6", "levels canned 6"}},
    {"Household gets four levels.", {"zone_present household", "levels household 4"}},
    {"In snacks we want six levels.", {"zone_present snacks", "levels snacks 6"}},
    {"Shelves spaced 35 cm apart", {"shelf_pitch 350"}},
    {"30 cm between the shelves", {"shelf_pitch 300"}},
    {"14 in. pitch", {"shelf_pitch 355.6"}},
    {"five levels everywhere but in the snacks aisle, where three will do",
     {"levels but snacks 5", "levels snacks 3", "zone_present snacks"}},
    {"shelf levels stay at five except for canned, which gets a sixth",
     {"levels but canned 5", "levels canned 6", "zone_present canned"}},
    {"snacks and household get five and four levels respectively",
     {"levels snacks 5", "levels household 4", "zone_present snacks", "zone_present household"}},
    {"Produce and dairy take up 120 and 80 m2 respectively.",
     {"area produce 120", "area dairy 80", "zone_present produce", "zone_present dairy"}},
    {"Snacks get six levels. Household exactly as the snacks.",
     {"levels snacks 6", "levels household 6", "zone_present snacks", "zone_present household"}},
    {"shelves 1.8 m high except in snacks, where they are 1.4 m",
     {"height fixture but snacks 1800", "height fixture snacks 1400", "zone_present snacks"}},
    {"The shop has 300 m2. Snacks and drinks get 30 m2 each.",
     {"area 300",
      "area snacks 30",
      "area beverages 30",
      "zone_present snacks",
      "zone_present beverages"}},
    {"nothing higher than 1.6 m", {"height fixture <=1600"}},
    {"ceiling nine foot six", {"height ceiling 2895.6"}},
    {"gondolas come down from 2.0 to 1.6 metres", {"height gondola 1600"}},
    {"the ceiling comes down to 3.8 m", {"height ceiling 3800"}},
    {"the ceiling is lowered to 3.8 m over the whole room", {"height ceiling 3800"}},
    {"three tills or more", {"fixture_count checkout_lane >=3"}},
    // ---- Floors by comparison ----
    {"Twice as much floor for produce as for dairy, with dairy at 45 m2.",
     {"area dairy 45", "area produce 90", "zone_present dairy", "zone_present produce"}},
    {"The dairy has 40 m2. Produce gets three times the floor of dairy.",
     {"area dairy 40", "area produce 120", "zone_present dairy", "zone_present produce"}},
    // ---- Runs shared among zones ----
    {"Nine double-sided gondola runs. Four of them hold dry goods, three snacks, and the last two "
     "household goods.",
     {"run_count gondola dry_goods 9",
      "run_count gondola dry_goods dry_goods 4",
      "run_count gondola snacks snacks 3",
      "run_count gondola household household 2",
      "zone_present dry_goods",
      "zone_present snacks",
      "zone_present household"}},
    {"two double-sided gondola runs of household goods and three of dry goods",
     {"run_count gondola household household 2",
      "run_count gondola dry_goods dry_goods 3",
      "zone_present dry_goods",
      "zone_present household"}},
    // ---- Stock ----
    {"snacks untidy", {"zone_present snacks", "stock jitter snacks >=0.8"}},
    {"the bakery is nearly empty", {"zone_present bakery", "stock fill bakery <=0.15"}},
    {"half the snacks are sold out", {"zone_present snacks", "stock out_of_stock snacks 0.5"}},
    {"a quarter of the bread is left", {"zone_present bakery", "stock fill bakery 0.25"}},
    {"10 % of the products are missing", {"stock out_of_stock 0.1"}},
    {"everything except the bakery should be full",
     {"stock fill but bakery >=1", "zone_present bakery"}},
    {"nothing misplaced", {"stock misplaced <=0"}},
    {"5 % of the price tags are missing", {"stock tags_missing 0.05"}},
    {"10 % wrong price labels", {"stock tags_wrong_price 0.1"}},
    {"some outdated price tags", {"stock tags_wrong_price >=0.05"}},
    {"3 % of the price tags in the wrong place", {"stock tags_wrong_product 0.03"}},
    {"some double price tickets", {"stock tags_doubled >=0.05"}},
    {"no missing price tags", {"stock tags_missing <=0"}},
    {"a few things on the wrong shelf", {"stock misplaced >=0.02"}},
    {"The bakery is nearly empty. Everything else full.",
     {"zone_present bakery", "stock fill bakery <=0.15", "stock fill but bakery >=1"}},
    {"everything full apart from the bakery, which is nearly empty",
     {"zone_present bakery", "stock fill but bakery >=1", "stock fill bakery <=0.15"}},
    // ---- Corrections ----
    {"The entrance in the south wall. I mean the east wall.", {"opening entrance east"}},
    {"dairy on the left, no, on the right", {"zone_present dairy", "relation at dairy east"}},
    {"three checkouts, no, make that five", {"fixture_count checkout_lane 5"}},
    // ---- Pronouns and places ----
    {"Windows in the west wall. The cafe along that same wall.",
     {"opening window west", "zone_present cafe", "relation along cafe west"}},
    {"the deli facing the wine section, which is left of the bakery",
     {"zone_present deli",
      "zone_present alcohol",
      "zone_present bakery",
      "relation facing deli alcohol",
      "relation left_of alcohol bakery"}},
    {"produce at the front, with the bakery on its right",
     {"zone_present produce",
      "zone_present bakery",
      "relation at produce south",
      "relation right_of bakery produce"}},
    {"dairy and bakery opposite each other",
     {"zone_present dairy", "zone_present bakery", "relation facing dairy bakery"}},
    {"produce is the first thing you see",
     {"zone_present produce", "relation near produce entrance"}},
    {"snacks a long way from the entrance",
     {"zone_present snacks", "relation far snacks entrance"}},
    {"Left wall: dairy. Back wall: meat.",
     {"zone_present dairy",
      "zone_present meat_fish",
      "relation along dairy west",
      "relation along meat_fish north"}},
    {"bakery on the left and near the entrance",
     {"zone_present bakery", "relation at bakery west", "relation near bakery entrance"}},
    // ---- Openings ----
    {"two entrances, one west and one east",
     {"opening entrance 2", "opening entrance west 1", "opening entrance east 1"}},
    {"the entrance at the left end of the south wall", {"opening entrance south east"}},
    {"The entrance is in the south wall, at its left end.", {"opening entrance south east"}},
    {"no windows", {"opening window <=0"}},
    // ---- Present and absent ----
    {"Take the bins out.", {"fixture_count bin <=0"}},
    {"snacks; bins are not allowed", {"zone_present snacks", "fixture_count bin <=0"}},
    {"don't leave out the eggs", {"product_present eggs"}},
    {"No gates by the entrance.", {"fixture_count gate <=0"}},
    {"No frozen food near the entrance.", {"relation far frozen entrance"}},
    {"no gondolas in the offers area", {"fixture_count gondola <=0", "zone_present promo"}},
    {"Everything except alcohol and frozen food.", {"zone_absent alcohol", "zone_absent frozen"}},
    {"nothing alcoholic, nothing fancy", {"zone_absent alcohol"}},
    {"Swap the multidecks in dairy for glass-door coolers, six of them.",
     {"fixture_count multideck <=0", "fixture_count glass_door_cooler 6", "zone_present dairy"}},
    {"Self-checkouts only, five of them.",
     {"fixture_count self_checkout 5", "zone_absent checkout"}},
    // ---- Numbers of another place, or another number ----
    {"Forty pallets in the drinks section and fifteen in dry goods.",
     {"fixture_count pallet 40",
      "fixture_count pallet 15",
      "zone_present beverages",
      "zone_present dry_goods"}},
    {"Two serve-over counters in the deli become three.",
     {"fixture_count serve_over 3", "zone_present deli"}},
    {"Two emergency exits on the west wall.", {"opening emergency 2", "opening emergency west 2"}},
    {"Everywhere five shelves, but in household only three.",
     {"levels 5", "levels household 3", "zone_present household"}},
    {"Eight aisles, each at least 2 m wide.", {"aisle_count 8", "aisle_width >=2000"}},
    {"Produce: 20 tables", {"fixture_count produce_table 20", "zone_present produce"}},
    // ---- Shares ----
    {"filling 70 %, but dry goods only 40 %",
     {"stock fill 0.7", "stock fill dry_goods 0.4", "zone_present dry_goods"}},
    {"Half the dairy is empty, the bakery is sold out.",
     {"stock fill dairy 0.5",
      "stock out_of_stock bakery >=1",
      "zone_present dairy",
      "zone_present bakery"}},
    {"A few tins are on the wrong shelves.",
     {"stock misplaced canned >=0.02", "zone_present canned"}},
    // ---- Marks ----
    {"ceiling 14'", {"height ceiling 4267.2"}},
    {"gondolas 4'6\" tall", {"height gondola 1371.6"}},
    {"gondolas, no higher than 1.4 metres", {"height gondola <=1400"}},
    {"1. Zones\n1.1 Dairy on the left.\n1.2 Bakery\n2. Tills\n2.1 Five lanes",
     {"zone_present dairy",
      "relation at dairy west",
      "zone_present bakery",
      "zone_present checkout",
      "fixture_count checkout_lane 5"}},
    {"| Dept | m2 | Fixture | Where |\n|---|---|---|---|\n| Dairy | 55 | multidecks | back wall |\n"
     "| Bread | 40 | | |",
     {"area dairy 55",
      "area bakery 40",
      "fixture_count multideck >=1",
      "zone_present dairy",
      "zone_present bakery",
      "relation along dairy north"}},
    // ---- What was spoken of ----
    {"One entrance. It is in the west wall, at its left end.",
     {"opening entrance 1", "opening entrance west south"}},
    {"The wine department has 50 m2 and mustn't be near the entrance; the shop has 400 m2.",
     {"area alcohol 50", "area 400", "zone_present alcohol", "relation far alcohol entrance"}},
    {"Drinks by the door, snacks at the back, toiletries in between the two.",
     {"zone_present beverages",
      "zone_present snacks",
      "zone_present personal_care",
      "relation near beverages entrance",
      "relation at snacks north",
      "relation between personal_care beverages snacks"}},
};

class Constructions : public testing::TestWithParam<ConstructionCase> {};

TEST_P(Constructions, AreUnderstood) {
  const intake::Understanding found =
      intake::understand(GetParam().prompt, shipped_language(), committed_catalog());
  std::vector<std::string> wishes = GetParam().wishes;
  std::ranges::sort(wishes);
  EXPECT_EQ(sorted_lines(found.requirements), wishes);
  EXPECT_TRUE(found.conflicts.empty());
}

INSTANTIATE_TEST_SUITE_P(Table, Constructions, testing::ValuesIn(constructions));

}  // namespace
}  // namespace marketgen
