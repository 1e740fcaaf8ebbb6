// Plans made of prompts: valid, repeatable, different for every seed, and with the relations that
// were asked for.
//
// Relations are judged here by formulas of this file's own, on the rectangles of the finished plan.
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "intake_fixture.h"
#include "io/json.h"
#include "plan/bsp.h"
#include "plan/egress.h"

namespace marketgen {
namespace {

Result<intake::Planned> planned(const std::string& prompt, std::uint64_t seed = 1) {
  intake::Brief brief;
  brief.prompt = prompt;
  return intake::plan_from_brief(brief, committed_catalog(), shipped_planner(), Seed(seed));
}

plan::Plan plan_of(const std::string& prompt, std::uint64_t seed = 1) {
  auto made = planned(prompt, seed);
  if (!made.ok()) fatal(to_string(made.error()).c_str());
  return std::move(made->plan);
}

TEST(Plans, PricesAreOfTheCountryThatIsAskedFor) {
  EXPECT_EQ(plan_of("an American supermarket with a bakery").country, "us");
  EXPECT_EQ(plan_of("a Chinese supermarket with a fish counter").country, "cn");
  EXPECT_EQ(plan_of("\u4fbf\u5229\u5e97\uff0c\u7167\u7f8e\u56fd\u90a3\u79cd\u6765").country, "us");
  for (const char* nowhere : {"a supermarket with a bakery", "a convenience store", "us"})
    EXPECT_FALSE(plan_of(nowhere).country) << nowhere;
  intake::Brief brief;
  brief.prompt = "an American supermarket", brief.country = "ca";
  const auto made = intake::plan_from_brief(brief, committed_catalog(), shipped_planner(), Seed(1));
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->plan.country, "ca");
}

// ---- An independent look at rectangles ----

RectMm rect_of_type(const plan::Plan& plan, const std::string& type) {
  const std::vector<RectMm> rects = plan::zone_rectangles(plan);
  for (std::size_t i = 0; i < plan.zones.size(); ++i) {
    if (plan.zones[i].type == type) return rects[i];
  }
  return {};
}

struct Point {
  double x, y;
};
Point middle(const RectMm& r) {
  return {(r.x0 + r.x1) / 2.0, (r.y0 + r.y1) / 2.0};
}

Point door(const plan::Plan& plan, plan::OpeningKind kind) {
  const double w = plan.shell.width_mm, d = plan.shell.depth_mm;
  for (const plan::Opening& opening : plan.shell.openings) {
    if (opening.kind != kind) continue;
    switch (opening.wall) {
      case plan::Wall::south:
        return {opening.center * w, 0};
      case plan::Wall::north:
        return {opening.center * w, d};
      case plan::Wall::west:
        return {0, opening.center * d};
      case plan::Wall::east:
        return {w, opening.center * d};
    }
  }
  return {-1, -1};
}

double diagonal(const plan::Plan& plan) {
  return std::hypot(plan.shell.width_mm, plan.shell.depth_mm);
}

double gap(const RectMm& a, const RectMm& b) {
  const double dx = std::max({0, a.x0 - b.x1, b.x0 - a.x1}),
               dy = std::max({0, a.y0 - b.y1, b.y0 - a.y1});
  return std::hypot(dx, dy);
}
double gap(const RectMm& a, Point p) {
  const double dx = std::max({0.0, a.x0 - p.x, p.x - a.x1}),
               dy = std::max({0.0, a.y0 - p.y, p.y - a.y1});
  return std::hypot(dx, dy);
}

struct RelationCase {
  const char* name;
  const char* prompt;
  bool (*holds)(const plan::Plan&);
};

void PrintTo(const RelationCase& row, std::ostream* out) {
  *out << row.prompt;
}

bool near(const plan::Plan& plan, double distance) {
  return distance <= std::max(3000.0, 0.2 * diagonal(plan));
}

const std::vector<RelationCase> relation_cases = {
    {"bakery_left_of_entrance",
     "a 24 x 15 m supermarket with a bakery left of the entrance",
     [](const plan::Plan& p) {
       return middle(rect_of_type(p, "bakery")).x < door(p, plan::OpeningKind::entrance).x;
     }},
    {"bakery_right_of_entrance",
     "a 24 x 15 m supermarket with a bakery right of the entrance",
     [](const plan::Plan& p) {
       return middle(rect_of_type(p, "bakery")).x > door(p, plan::OpeningKind::entrance).x;
     }},
    {"dairy_along_back_wall",
     "a 24 x 15 m supermarket with dairy along the back wall",
     [](const plan::Plan& p) { return rect_of_type(p, "dairy").y1 == p.shell.depth_mm; }},
    {"frozen_along_east_wall",
     "a 24 x 15 m supermarket with frozen food along the east wall",
     [](const plan::Plan& p) { return rect_of_type(p, "frozen").x1 == p.shell.width_mm; }},
    {"produce_in_the_middle",
     "a 40 x 25 m supermarket with produce in the middle",
     [](const plan::Plan& p) {
       const Point m = middle(rect_of_type(p, "produce"));
       return std::abs(m.x - p.shell.width_mm / 2.0) < p.shell.width_mm / 4.0 &&
              std::abs(m.y - p.shell.depth_mm / 2.0) < p.shell.depth_mm / 4.0;
     }},
    {"wine_next_to_cheese",
     "a 40 x 25 m organic market with wine next to cheese",
     [](const plan::Plan& p) {
       return near(p, gap(rect_of_type(p, "alcohol"), rect_of_type(p, "dairy")));
     }},
    {"produce_near_entrance",
     "a supermarket with produce near the entrance",
     [](const plan::Plan& p) {
       return near(p, gap(rect_of_type(p, "produce"), door(p, plan::OpeningKind::entrance)));
     }},
    {"frozen_far_from_entrance",
     "a 30 x 20 m supermarket with frozen food far from the entrance",
     [](const plan::Plan& p) {
       return gap(rect_of_type(p, "frozen"), door(p, plan::OpeningKind::entrance)) >
              0.35 * diagonal(p);
     }},
    {"household_away_from_produce",
     "a 30 x 20 m supermarket, keep household away from produce",
     [](const plan::Plan& p) {
       return gap(rect_of_type(p, "household"), rect_of_type(p, "produce")) > 0.35 * diagonal(p);
     }},
    {"deli_between_bakery_and_dairy",
     "a 30 x 20 m supermarket with a deli between bakery and dairy",
     [](const plan::Plan& p) {
       const Point a = middle(rect_of_type(p, "deli")), b = middle(rect_of_type(p, "bakery")),
                   c = middle(rect_of_type(p, "dairy"));
       return (a.x - b.x) * (c.x - b.x) + (a.y - b.y) * (c.y - b.y) > 0 &&
              (a.x - c.x) * (b.x - c.x) + (a.y - c.y) * (b.y - c.y) > 0;
     }},
    {"alcohol_in_north_east_corner",
     "a 24 x 15 m supermarket with alcohol in the north-east corner",
     [](const plan::Plan& p) {
       const RectMm r = rect_of_type(p, "alcohol");
       return r.x1 > p.shell.width_mm - 1500 && r.y1 > p.shell.depth_mm - 1500;
     }},
    {"snacks_at_the_front",
     "a 24 x 15 m supermarket with snacks at the front",
     [](const plan::Plan& p) { return rect_of_type(p, "snacks").y0 < 1500; }},
    {"meat_behind_dry_goods",
     "a 24 x 15 m supermarket with meat behind the groceries",
     [](const plan::Plan& p) {
       return middle(rect_of_type(p, "meat_fish")).y > middle(rect_of_type(p, "dry_goods")).y;
     }},
    {"meat_not_next_to_bakery",
     "a 24 x 15 m supermarket, meat not next to the bakery",
     [](const plan::Plan& p) {
       return gap(rect_of_type(p, "meat_fish"), rect_of_type(p, "bakery")) > 500;
     }},
    {"promo_near_checkouts",
     "a 24 x 15 m supermarket with special offers near the checkouts",
     [](const plan::Plan& p) {
       return near(p, gap(rect_of_type(p, "promo"), rect_of_type(p, "checkout")));
     }},
    {"frozen_near_checkouts",
     "a 24 x 15 m supermarket with frozen food near the tills",
     [](const plan::Plan& p) {
       return near(p, gap(rect_of_type(p, "frozen"), rect_of_type(p, "checkout")));
     }},
    {"dairy_left_of_meat",
     "a 24 x 15 m supermarket with dairy left of the meat",
     [](const plan::Plan& p) {
       return middle(rect_of_type(p, "dairy")).x < middle(rect_of_type(p, "meat_fish")).x;
     }},
    {"entrance_in_east_wall",
     "a 24 x 15 m supermarket with the entrance on the east wall",
     [](const plan::Plan& p) {
       return door(p, plan::OpeningKind::entrance).x == p.shell.width_mm;
     }},
    {"left_seen_from_a_north_door",
     "a 24 x 15 m supermarket, entrance on the north wall, bakery left of the entrance",
     [](const plan::Plan& p) {  // who comes in from the north has the east on the left
       return door(p, plan::OpeningKind::entrance).y == p.shell.depth_mm &&
              middle(rect_of_type(p, "bakery")).x > door(p, plan::OpeningKind::entrance).x;
     }},
    {"back_wall_of_a_west_door",
     "a 24 x 15 m supermarket, entrance on the west wall, dairy along the back wall",
     [](const plan::Plan& p) { return rect_of_type(p, "dairy").x1 == p.shell.width_mm; }},
    {"two_walls_at_once",
     "a 30 x 20 m supermarket with bakery along the west wall and dairy along the east wall",
     [](const plan::Plan& p) {
       return rect_of_type(p, "bakery").x0 == 0 && rect_of_type(p, "dairy").x1 == p.shell.width_mm;
     }},
    {"entrance_left_of_exit",
     "a 24 x 15 m supermarket with the entrance left of the exit",
     [](const plan::Plan& p) {
       return door(p, plan::OpeningKind::entrance).x < door(p, plan::OpeningKind::exit).x;
     }},
    {"entrance_at_the_right",
     "a 24 x 15 m supermarket with the entrance on the right",
     [](const plan::Plan& p) {
       return door(p, plan::OpeningKind::entrance).x > 0.5 * p.shell.width_mm;
     }},
};

class PlannedRelations : public testing::TestWithParam<RelationCase> {};

TEST_P(PlannedRelations, HoldForEverySeed) {
  for (const std::uint64_t seed : {1U, 2U}) {
    EXPECT_TRUE(GetParam().holds(plan_of(GetParam().prompt, seed)))
        << GetParam().prompt << ", seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Table,
                         PlannedRelations,
                         testing::ValuesIn(relation_cases),
                         [](const auto& row) { return std::string(row.param.name); });

// ---- What else the words decide ----

const plan::Zone* zone_of(const plan::Plan& plan, const std::string& type) {
  for (const plan::Zone& zone : plan.zones) {
    if (zone.type == type) return &zone;
  }
  return nullptr;
}

TEST(Plans, SizeProfileAndLookFollowTheWords) {
  const plan::Plan plan = plan_of(
      "large Scandinavian organic market, 40 x 25 m, dark oak floor, 6-tier shelves, 4 m ceiling");
  EXPECT_EQ(plan.shell.width_mm, 40000);
  EXPECT_EQ(plan.shell.depth_mm, 25000);
  EXPECT_EQ(plan.shell.ceiling_mm, 4000);
  EXPECT_EQ(plan.profile, "organic-eu");
  EXPECT_EQ(plan.look.floor, "wood-dark");
  EXPECT_EQ(plan.look.wall, "plaster-white");
  EXPECT_EQ(zone_of(plan, "dry_goods")->fixture.levels, 6);
}

TEST(Plans, RefusedZonesAndTheirGoodsStayOut) {
  const plan::Plan plan = plan_of("a 24 x 15 m supermarket with special offers and no alcohol");
  EXPECT_EQ(zone_of(plan, "alcohol"), nullptr);
  const std::vector<std::string>& excluded = zone_of(plan, "promo")->stock.exclude;
  for (const char* goods : {"beer", "wine", "spirits"}) {
    EXPECT_NE(std::ranges::find(excluded, goods), excluded.end()) << goods;
  }
}

TEST(Plans, GoodsAskedForAreOnTheirZonesList) {
  const plan::Plan plan = plan_of("a 24 x 15 m supermarket with oat milk and doughnuts");
  ASSERT_TRUE(zone_of(plan, "dairy")->stock.must_stock.has_value());
  EXPECT_EQ(*zone_of(plan, "dairy")->stock.must_stock, std::vector<std::string>{"Oat Drink"});
  EXPECT_EQ(*zone_of(plan, "bakery")->stock.must_stock, std::vector<std::string>{"Doughnuts"});
  EXPECT_FALSE(zone_of(plan, "snacks")->stock.must_stock.has_value());
}

TEST(Plans, LanesAreCountedAsAsked) {
  EXPECT_EQ(
      zone_of(plan_of("a 24 x 15 m supermarket with five checkouts"), "checkout")->fixture.count,
      5);
}

// A hall too narrow for them: four runs, three behind one another, are still two abreast.
TEST(Plans, CountedRunsOfANarrowHallStandBehindOneAnother) {
  const plan::Plan plan =
      plan_of("A shop 16 m wide and 30 m deep with four double-sided gondola runs of dry goods");
  EXPECT_EQ(zone_of(plan, "dry_goods")->fixture.runs, 4);
}

TEST(Plans, PillarsStandInAGridOfTheRoom) {
  const plan::Plan plan = plan_of("a shop 18 m wide and 18 m deep with nine pillars");
  ASSERT_EQ(plan.shell.columns.size(), 9U);
  EXPECT_EQ(plan.shell.columns.front().x_mm, 3000);
  EXPECT_EQ(plan.shell.columns.front().y_mm, 3000);
  EXPECT_EQ(plan.shell.columns.back().x_mm, 15000);
  EXPECT_TRUE(plan_of("a shop 18 m wide and 18 m deep").shell.columns.empty());
}

TEST(Plans, AskedFloorIsGiven) {
  const plan::Plan plan = plan_of("a 24 x 15 m supermarket with a bakery of 25 m2");
  EXPECT_NEAR(rect_of_type(plan, "bakery").area_m2(), 25, 4);
}

TEST(Plans, EveryWishHasItsProvenance) {
  const plan::Plan plan =
      plan_of("a 24 x 15 m supermarket called Fresh Corner with 5-tier shelves");
  EXPECT_EQ(plan.name, "Fresh Corner");
  const auto said = [&](const std::string& path) {
    return std::ranges::any_of(plan.provenance, [&](const plan::Provenance& entry) {
      return entry.path == path && entry.source == plan::Source::text && entry.span.has_value();
    });
  };
  EXPECT_TRUE(said("/name"));
  EXPECT_TRUE(said("/shell/width_mm"));
  EXPECT_TRUE(said("/profile"));
}

TEST(Plans, FlagsBeatTheText) {
  intake::Brief brief;
  brief.prompt = "a 24 x 15 m industrial supermarket";
  brief.size_mm = {{20000, 12000}};
  brief.profile = "discounter";
  brief.style = "premium";
  const auto planner = intake::offline_planner();
  const auto made = intake::plan_from_brief(brief, committed_catalog(), **planner, Seed(1));
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->plan.shell.width_mm, 20000);
  EXPECT_EQ(made->plan.profile, "discounter");
  EXPECT_EQ(made->plan.look.wall, "wood-panel");
  EXPECT_EQ(made->conflicts.size(), 3U);
  for (const intake::Conflict& conflict : made->conflicts)
    EXPECT_TRUE(conflict.kept.starts_with("--"));
}

TEST(Plans, AHallHasTheWaysOutThatItNeedsUnlessSomebodySaysHowMany) {
  const auto emergency_exits = [](const plan::Plan& plan) {
    return std::ranges::count(
        plan.shell.openings, plan::OpeningKind::emergency, &plan::Opening::kind);
  };
  EXPECT_EQ(emergency_exits(plan_of("a 24 x 15 m supermarket")), 0);
  for (const char* prompt : {"a 60 x 50 m hypermarket",
                             "a 100 x 80 m hypermarket with the entrance in the east wall",
                             "a 125 x 80 m cash and carry"}) {
    const plan::Plan plan = plan_of(prompt);
    const plan::WaysOut ways = plan::ways_out(plan.shell);
    EXPECT_GT(emergency_exits(plan), 0) << prompt;
    EXPECT_GE(ways.doors, ways.needed_doors()) << prompt;
    EXPECT_GE(ways.width_mm, ways.needed_width_mm()) << prompt;
  }
  EXPECT_EQ(emergency_exits(plan_of("a 100 x 80 m hypermarket with one emergency exit")), 1);
  EXPECT_EQ(emergency_exits(plan_of("a 100 x 80 m hypermarket without emergency exits")), 0);
}

TEST(Plans, RefusedFixturesGiveWayToOthersThatKeepTheSame) {
  const plan::Plan plan = plan_of("a 24 x 15 m supermarket with frozen food, no island freezers");
  EXPECT_EQ(zone_of(plan, "frozen")->fixture.kind, "glass_door_freezer");
  const plan::Plan asked = plan_of("a 24 x 15 m supermarket with chest freezers");
  ASSERT_NE(zone_of(asked, "frozen"), nullptr);
  EXPECT_EQ(zone_of(asked, "frozen")->fixture.kind, "chest_freezer");
}

TEST(Plans, WordsThatSayNothingStillGiveAStore) {
  const auto made = planned("lorem ipsum dolor");
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  EXPECT_EQ(made->unparsed.size(), 3U);
  EXPECT_GE(made->plan.zones.size(), 8U);
}

TEST(Plans, ExtremeFloorsAreStillPlans) {
  for (const char* prompt : {"a 4 x 4 m kiosk with bakery, dairy, produce and wine",
                             "60 x 4 m shop",
                             "4 x 60 m shop",
                             "a 24 x 15 m supermarket with 300 self-checkouts",
                             "a 4 x 60 m shop with two entrances and an emergency exit",
                             "a 200 x 200 m hypermarket",
                             "a 5 x 5 m shop with five checkouts",
                             "150 x 12 m supermarket"}) {
    const auto made = planned(prompt);
    ASSERT_TRUE(made.ok()) << prompt << ": " << to_string(made.error());
  }
}

TEST(Plans, SameBriefAndSeedGiveTheSamePlan) {
  const std::string prompt = "a supermarket with a bakery near the entrance and six aisles";
  const std::string first = io::write_json(plan_of(prompt, 7));
  EXPECT_EQ(io::write_json(plan_of(prompt, 7)), first);
  const ThreadLimit one_thread(1);
  EXPECT_EQ(io::write_json(plan_of(prompt, 7)), first);
}

// Share of the floor on which two plans have different zone types.
double difference(const plan::Plan& a, const plan::Plan& b) {
  const std::vector<RectMm> rects_a = plan::zone_rectangles(a), rects_b = plan::zone_rectangles(b);
  const auto type_at = [](const plan::Plan& plan, const std::vector<RectMm>& rects, PointMm p) {
    for (std::size_t i = 0; i < rects.size(); ++i) {
      if (rects[i].contains(p)) return plan.zones[i].type;
    }
    return std::string();
  };
  int differ = 0, points = 0;
  for (int x = 250; x < a.shell.width_mm; x += 500) {
    for (int y = 250; y < a.shell.depth_mm; y += 500) {
      const std::string first = type_at(a, rects_a, {x, y}), second = type_at(b, rects_b, {x, y});
      if (first.empty() && second.empty()) continue;
      ++points;
      differ += first != second ? 1 : 0;
    }
  }
  return static_cast<double>(differ) / points;
}

TEST(Plans, SeedsGiveDifferentStores) {
  std::vector<plan::Plan> plans;
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    plans.push_back(plan_of("a 24 x 15 m supermarket", seed));
  double sum = 0;
  int pairs = 0;
  for (std::size_t a = 0; a < plans.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b, ++pairs)
      sum += difference(plans[a], plans[b]);
  }
  EXPECT_GT(sum / pairs, 0.4);
}

// ---- Any words ----

// Sentences nobody would write: words of every kind the planner knows, and some it does not.
std::string random_prompt(Stream& draw) {
  static constexpr const char* words[] = {
      "bakery",   "dairy",    "wine",      "no",     "two",    "300",       "next to",
      "the",      "left of",  "aisles",    "tall",   "frozen", "checkouts", "entrance",
      "and",      ",",        "along the", "wall",   "north",  "without",   "self-checkouts",
      "12 m",     "4 x 60 m", "-5",        "banana", "€",      "5-tier",    "café",
      "far from", "small",    "huge"};
  std::string prompt = "shop";
  const int length = draw.integer(3, 18);
  for (int i = 0; i < length; ++i) {
    const int at = draw.integer(0, static_cast<int>(std::size(words)) - 1);
    prompt += std::string(" ") + words[static_cast<std::size_t>(at)];
  }
  return prompt;
}

TEST(Plans, OfRandomWordsAreValidAndRepeatable) {
  for (std::uint64_t i = 0; i < 60; ++i) {
    Stream draw = Seed(i).child("random_prompt").stream();
    const std::string prompt = random_prompt(draw);
    const auto first = planned(prompt, i);
    ASSERT_TRUE(first.ok()) << prompt << ": " << to_string(first.error());
    EXPECT_EQ(io::write_json(first->plan), io::write_json(planned(prompt, i)->plan)) << prompt;
  }
}

// ---- Work ----

// Two thousand words, every clause of them about a place.
std::string salad(std::uint64_t seed) {
  static constexpr const char* zones[] = {"bakery",
                                          "dairy",
                                          "produce",
                                          "frozen",
                                          "meat",
                                          "deli",
                                          "snacks",
                                          "drinks",
                                          "wine",
                                          "household",
                                          "canned food"};
  static constexpr const char* relations[] = {
      "next to", "left of", "behind", "far from", "opposite", "in front of", "right of"};
  Stream draw = Seed(seed).child("salad").stream();
  const auto one_of = [&](const auto& list) {
    const int last = static_cast<int>(std::size(list)) - 1;
    return std::string(list[static_cast<std::size_t>(draw.integer(0, last))]);
  };
  std::string prompt = "a 24 x 15 m shop";
  for (int clause = 0; clause < 500; ++clause)
    prompt += ", " + one_of(zones) + " " + one_of(relations) + " the " + one_of(zones);
  return prompt;
}

// Floors that the search judged: the work of planning, whatever machine does it.
int floors_judged(const intake::Planned& planned) {
  int judged = 0;
  for (const std::string& line : planned.trace)
    if (line.starts_with("judged ")) judged += std::stoi(line.substr(7));
  return judged;
}

TEST(Plans, OfTwoThousandWordsTakeBoundedWork) {
  constexpr int one_search = 8 * 221, max_searches = 12;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const auto made = planned(salad(seed), seed);
    ASSERT_TRUE(made.ok()) << to_string(made.error());
    EXPECT_LE(floors_judged(*made), max_searches * one_search);
    EXPECT_LE(made->plan.relations.size(), 40U);
    const auto surplus = std::ranges::find(made->conflicts, "relations", &intake::Conflict::what);
    ASSERT_NE(surplus, made->conflicts.end());
    EXPECT_NE(surplus->why.find("at most 40"), std::string::npos);
  }
}

TEST(Plans, NumbersBeyondTheirLimitsAreGivenUpAndSaid) {
  struct LimitCase {
    const char *prompt, *dropped, *kept;
  };
  for (const LimitCase& row : {LimitCase{"a shop with 10000 exits", "10000 exits", "6"},
                               LimitCase{"a shop with 500 windows", "500 windows", "12"},
                               LimitCase{"a shop with 50 bakeries", "50 bakeries", "12"},
                               LimitCase{"a shop with 4000 aisles", "4000 aisles", "60"},
                               LimitCase{"a shop with 900 checkouts", "900 checkouts", "200"},
                               LimitCase{"0.3 m wide aisles", "0.3 m wide aisles", "600 mm"}}) {
    const auto made = planned(row.prompt);
    ASSERT_TRUE(made.ok()) << row.prompt << ": " << to_string(made.error());
    const auto found = std::ranges::find(made->conflicts, row.dropped, &intake::Conflict::dropped);
    ASSERT_NE(found, made->conflicts.end()) << row.prompt;
    EXPECT_EQ(found->kept, row.kept) << row.prompt;
    EXPECT_LE(made->plan.shell.openings.size(), 40U);
    EXPECT_LE(floors_judged(*made), 12 * 8 * 221) << row.prompt;
  }
}

}  // namespace
}  // namespace marketgen
