// Fixtures, runs and equipment that a prompt counts: what is understood, and what the plan makes of
// it.
#include <cmath>

#include "intake/understanding.h"
#include "intake_fixture.h"
#include "plan/bsp.h"

namespace marketgen {
namespace {

using Kind = plan::RequirementKind;

intake::Understanding understood(const std::string& prompt) {
  return intake::understand(prompt, shipped_language(), committed_catalog());
}

plan::Plan counted_plan(const std::string& prompt) {
  intake::Brief brief;
  brief.prompt = prompt;
  auto made = intake::plan_from_brief(brief, committed_catalog(), shipped_planner(), Seed(1));
  if (!made.ok()) fatal(to_string(made.error()).c_str());
  return std::move(made->plan);
}

const plan::Zone& counted_zone(const plan::Plan& plan, const std::string& type) {
  const auto zone = std::ranges::find(plan.zones, type, &plan::Zone::type);
  if (zone == plan.zones.end()) fatal(("no zone " + type).c_str());
  return *zone;
}

// How many of the kind the plan has in the zone; -1 when it does not say.
int count_in(const plan::Zone& zone, const std::string& kind) {
  if (zone.fixture.kind == kind) return zone.fixture.count.value_or(-1);
  for (const plan::FixtureSpec& also : zone.also.value_or(std::vector<plan::FixtureSpec>{}))
    if (also.kind == kind) return also.count.value_or(-1);
  return 0;
}

// ---- What is understood ----

struct RunCase {
  const char* prompt;
  const char* kind;
  const char* zone;  // in which they are counted; "" is the store
  int runs, sides;
  int fixtures;  // 0: not said
};

TEST(FixtureCounts, RunsAreRead) {
  const std::vector<RunCase> cases{
      {"twelve double-sided runs of gondolas for dry goods", "gondola", "dry_goods", 12, 2, 0},
      {"18 parallel single-sided gondola runs", "gondola", "", 18, 1, 0},
      {"two rows of six chest freezers", "chest_freezer", "", 2, 0, 12},
      {"a row of ten glass-door freezers", "glass_door_freezer", "", 1, 0, 10},
      {"drinks in four double-sided gondola runs", "gondola", "beverages", 4, 2, 0},
      {"three double-sided gondola runs of household goods", "gondola", "household", 3, 2, 0},
      {"eight double-sided runs", "gondola", "", 8, 2, 0},
  };
  for (const RunCase& expected : cases) {
    const intake::Understanding found = understood(expected.prompt);
    const plan::Requirement* runs = found.find(Kind::run_count);
    ASSERT_NE(runs, nullptr) << expected.prompt;
    EXPECT_EQ(runs->subject, expected.kind) << expected.prompt;
    EXPECT_EQ(runs->second_object, expected.zone) << expected.prompt;
    EXPECT_EQ(runs->value, expected.runs) << expected.prompt;
    EXPECT_EQ(runs->second_value, expected.sides) << expected.prompt;
    const plan::Requirement* count = found.find(Kind::fixture_count);
    EXPECT_EQ(count != nullptr, expected.fixtures > 0) << expected.prompt;
    if (count != nullptr) {
      EXPECT_EQ(count->value, expected.fixtures) << expected.prompt;
    }
    EXPECT_TRUE(found.unparsed.empty() || found.unparsed.front().text == "parallel")
        << expected.prompt;
  }
}

struct ScopeCase {
  const char* prompt;
  const char* kind;
  const char* zone;
  int count;
};

TEST(FixtureCounts, FixturesAreCountedWhereTheyStand) {
  const std::vector<ScopeCase> cases{
      {"a bakery with two display tables and three bins", "produce_table", "bakery", 2},
      {"a bakery with two display tables and three bins", "bin", "bakery", 3},
      {"three tables and a fridge in the bakery", "produce_table", "bakery", 3},
      {"at least two serve-over counters in the deli", "serve_over", "deli", 2},
      {"eight pallets of water", "pallet", "beverages", 8},
      {"five blocks of six island freezers", "island_freezer", "", 30},
      {"beer in eight glass door coolers", "glass_door_cooler", "alcohol", 8},
      {"trolleys by the exit", "trolley_bay", "exit", 1},
  };
  for (const ScopeCase& expected : cases) {
    const intake::Understanding found = understood(expected.prompt);
    const plan::Requirement* count = found.find(Kind::fixture_count, expected.kind);
    ASSERT_NE(count, nullptr) << expected.prompt;
    EXPECT_EQ(count->second_object, expected.zone) << expected.prompt;
    EXPECT_EQ(count->value, expected.count) << expected.prompt;
  }
}

TEST(FixtureCounts, OfTwoZonesDoNotContradictEachOther) {
  const intake::Understanding found =
      understood("four serve-over counters for meat. Two serve-over counters for cheese.");
  EXPECT_TRUE(found.conflicts.empty());
}

// ---- What the plan makes of it ----

TEST(FixtureCounts, BecomeGroupsOfTheirZone) {
  const plan::Plan plan = counted_plan(
      "24 x 15 m supermarket, a bakery with two display tables, a bread wall and three bins");
  const plan::Zone& bakery = counted_zone(plan, "bakery");
  EXPECT_EQ(bakery.fixture.kind, "bakery_rack");
  EXPECT_EQ(count_in(bakery, "produce_table"), 2);
  EXPECT_EQ(count_in(bakery, "bin"), 3);
}

TEST(FixtureCounts, OfOtherGoodsStandBesideTheZonesOwn) {
  const plan::Plan plan = counted_plan("supermarket of 400 m2 with eight pallets of water");
  const plan::Zone& drinks = counted_zone(plan, "beverages");
  EXPECT_EQ(drinks.fixture.kind, "gondola");
  EXPECT_EQ(count_in(drinks, "pallet"), 8);
}

TEST(FixtureCounts, RunsHaveTheirNumberAndSides) {
  const plan::Plan plan = counted_plan("two rows of six chest freezers");
  const plan::FixtureSpec& frozen = counted_zone(plan, "frozen").fixture;
  EXPECT_EQ(frozen.kind, "chest_freezer");
  EXPECT_EQ(frozen.count, 12);
  EXPECT_EQ(frozen.runs, 2);
  const plan::FixtureSpec& single =
      counted_zone(counted_plan("dry goods in four single-sided gondola runs"), "dry_goods")
          .fixture;
  EXPECT_EQ(single.runs, 4);
  EXPECT_EQ(single.double_sided, false);
}

TEST(FixtureCounts, RunsOfTheStoreAreSharedAmongItsZones) {
  int runs = 0;
  for (const plan::Zone& zone :
       counted_plan("36 x 24 m supermarket with 14 double-sided runs").zones)
    runs += zone.fixture.runs.value_or(0);
  EXPECT_EQ(runs, 14);
}

TEST(FixtureCounts, ModulesOfTheStoreAreSharedAmongItsZones) {
  const plan::Plan plan = counted_plan("22 x 16 m supermarket with 10 gondolas and 4 multidecks");
  for (const auto& [kind, number] : {std::pair{"gondola", 10}, std::pair{"multideck", 4}}) {
    int count = 0;
    for (const plan::Zone& zone : plan.zones) {
      if (zone.fixture.kind != kind) continue;
      ASSERT_TRUE(zone.fixture.count.has_value()) << zone.id;
      count += *zone.fixture.count;
    }
    EXPECT_EQ(count, number) << kind;
  }
}

TEST(FixtureCounts, AKindThatOneZoneIsNotToHaveStandsInOthers) {
  const plan::Plan plan =
      counted_plan("400 m2 supermarket with household goods, no gondolas in household");
  EXPECT_NE(counted_zone(plan, "household").fixture.kind, "gondola");
  EXPECT_TRUE(std::ranges::any_of(
      plan.zones, [](const plan::Zone& zone) { return zone.fixture.kind == "gondola"; }));
}

TEST(FixtureCounts, EquipmentIsThePlans) {
  const plan::Plan plan =
      counted_plan("supermarket, no gates, two stacks of baskets, trolleys by the exit");
  ASSERT_TRUE(plan.equipment.has_value());
  const auto of = [&](std::string_view kind) {
    return std::ranges::find(*plan.equipment, kind, &plan::EquipmentSpec::kind);
  };
  ASSERT_NE(of("gate"), plan.equipment->end());
  EXPECT_EQ(of("gate")->count, 0);
  ASSERT_NE(of("trolley_bay"), plan.equipment->end());
  EXPECT_EQ(of("trolley_bay")->at, "exit");
  EXPECT_FALSE(counted_plan("supermarket").equipment.has_value());
}

TEST(FixtureCounts, AShopWithoutTillsHasADesk) {
  for (const char* prompt : {"kiosk of 20 m2 with drinks and snacks, no tills",
                             "drugstore with a customer service desk instead of tills"}) {
    const plan::Plan plan = counted_plan(prompt);
    for (const plan::Zone& zone : plan.zones)
      EXPECT_TRUE(zone.type != "checkout" && zone.type != "self_checkout") << prompt;
    EXPECT_EQ(counted_zone(plan, "customer_service").fixture.kind, "kiosk") << prompt;
    ASSERT_TRUE(plan.equipment.has_value()) << prompt;
    EXPECT_EQ(plan.equipment->front().kind, "checkout_lane") << prompt;
    EXPECT_EQ(plan.equipment->front().count, 0) << prompt;
  }
}

TEST(FixtureCounts, FloorsAreMeasuredForThem) {
  const auto area = [](const plan::Plan& plan, const std::string& type) {
    const std::vector<RectMm> rects = plan::zone_rectangles(plan);
    double m2 = 0;
    for (std::size_t i = 0; i < rects.size(); ++i)
      m2 += plan.zones[i].type == type ? rects[i].area_m2() : 0;
    return m2;
  };
  const plan::Plan few = counted_plan("supermarket with six chest freezers");
  const plan::Plan many = counted_plan("supermarket with forty chest freezers");
  EXPECT_GT(area(many, "frozen"), 2 * area(few, "frozen"));
  EXPECT_GT(many.shell.width_mm * 1.0 * many.shell.depth_mm,
            few.shell.width_mm * 1.0 * few.shell.depth_mm);
  const plan::Plan said = counted_plan("20 x 15 m supermarket with forty chest freezers");
  EXPECT_EQ(said.shell.width_mm, 20000);  // what was said holds
}

}  // namespace
}  // namespace marketgen
