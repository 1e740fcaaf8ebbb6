// What people ask for becomes a store that keeps its hard rules; what cannot be built becomes the
// nearest store that does, and says what was given up. No goods and no pictures: design only.
#include "store/design.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "io/json.h"
#include "layout/makes.h"
#include "support/committed_catalog.h"
#include "support/number_of_cases.h"

namespace marketgen {
namespace {

std::vector<std::string> prompts_of(const std::string& file) {
  std::ifstream in(std::string(MARKETGEN_SOURCE_DIR "/tests/fixtures/prompts/") + file);
  std::vector<std::string> prompts;
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && line[0] != '#') prompts.push_back(line);
  return prompts;
}

Result<store::Designed> designed(const std::string& prompt, std::uint64_t seed) {
  intake::Brief brief;
  brief.prompt = prompt;
  return store::design_store(brief, committed_catalog(), Seed(seed));
}

std::string hard_faults(const layout::Layout& layout) {
  std::string text;
  for (const layout::Violation& v : layout.violations)
    if (v.severity == layout::Severity::hard) text += "\n  " + v.code + ": " + v.message;
  return text;
}

// Whatever is written, its reader takes.
void expect_readable(const plan::Plan& plan, const std::string& prompt) {
  const auto read = plan::read_plan(io::write_json(plan), "plan.json", committed_catalog());
  ASSERT_TRUE(read.ok()) << prompt << ": " << to_string(read.error());
  EXPECT_EQ(io::write_json(*read), io::write_json(plan)) << prompt;
}

void expect_lawful(const std::vector<std::string>& prompts, std::uint64_t seed) {
  for (const std::string& prompt : prompts) {
    const auto store = designed(prompt, seed);
    ASSERT_TRUE(store.ok()) << prompt << ": " << to_string(store.error());
    EXPECT_EQ(hard_faults(store->layout), "") << prompt << ", seed " << seed;
    expect_readable(store->planned.plan, prompt);
    expect_readable(store->repaired.plan, prompt);
  }
}

TEST(Designs, OfSensiblePromptsKeepTheirHardRules) {
  const std::vector<std::string> prompts = prompts_of("sensible.txt");
  ASSERT_GT(prompts.size(), 95U);
  expect_lawful(prompts, 1);
}

TEST(Designs, OfImpossiblePromptsAreTheNearestLawfulStore) {
  const std::vector<std::string> prompts = prompts_of("impossible.txt");
  ASSERT_GT(prompts.size(), 20U);
  expect_lawful(prompts, 1);
}

auto tills_of(const layout::Layout& layout) {
  return std::ranges::count_if(layout.fixtures, [](const layout::Fixture& fixture) {
    const catalog::FixtureKind* kind = committed_catalog().fixture_kind(fixture.kind);
    return kind != nullptr && kind->role == catalog::FixtureRole::checkout;
  });
}

// Shops whose kind has no tills, and those that were asked for without, have none and need none to
// be lawful.
TEST(Designs, HaveNoTillsWhereNoneAreWanted) {
  const std::vector<std::string> without = {"a dark store with frozen food",
                                            "a kiosk with snacks and drinks, no tills",
                                            "snacks and canned food only, no checkouts",
                                            "a hypermarket without checkouts"};
  for (const std::string& prompt : without) {
    const auto store = designed(prompt, 1);
    ASSERT_TRUE(store.ok()) << prompt << ": " << to_string(store.error());
    EXPECT_EQ(hard_faults(store->layout), "") << prompt;
    EXPECT_EQ(tills_of(store->layout), 0) << prompt;
  }
}

TEST(Designs, SayWhatWasGivenUp) {
  const auto store = designed("a 5 x 38 m supermarket with six checkouts", 1);
  ASSERT_TRUE(store.ok());
  EXPECT_GT(tills_of(store->layout), 0);
  const auto& conflicts = store->planned.conflicts;
  const auto given_up = std::ranges::find(conflicts, "six checkouts", &intake::Conflict::dropped);
  ASSERT_NE(given_up, conflicts.end());
  EXPECT_FALSE(given_up->why.empty());
  // The wish itself stays as it was said: the audit finds it unmet.
  const auto wish = std::ranges::find(
      store->planned.requirements, plan::RequirementKind::fixture_count, &plan::Requirement::kind);
  ASSERT_NE(wish, store->planned.requirements.end());
  EXPECT_EQ(wish->value, 6);
}

TEST(Designs, ConcedeNothingThatStands) {
  const auto store = designed("a 24 x 15 m supermarket with three checkouts", 1);
  ASSERT_TRUE(store.ok());
  EXPECT_TRUE(store->planned.conflicts.empty());
  EXPECT_EQ(tills_of(store->layout), 3);
  EXPECT_EQ(std::ranges::count_if(store->layout.fixtures,
                                  [&](const layout::Fixture& fixture) {
                                    return layout::counts_as(
                                        store->layout, fixture, "checkout_lane");
                                  }),
            3);
}

// ---- Any words: plans that their reader takes ----

// Sentences nobody would write, of words of every kind that the planner knows.
std::string random_prompt(std::uint64_t seed) {
  static constexpr const char* words[] = {"bakery",
                                          "dairy",
                                          "wine",
                                          "no",
                                          "two",
                                          "300 m2",
                                          "next to",
                                          "left of",
                                          "aisles",
                                          "0.3 m wide",
                                          "frozen",
                                          "checkouts",
                                          "entrance",
                                          "and",
                                          ",",
                                          "along the north wall",
                                          "without",
                                          "self-checkouts",
                                          "12 m",
                                          "9 x 60 m",
                                          "-5",
                                          "exits",
                                          "windows",
                                          "999999999",
                                          "5-tier",
                                          "café",
                                          "far from",
                                          "small",
                                          "huge",
                                          "rows of",
                                          "levels",
                                          "3 m high shelves",
                                          "20 m high ceiling",
                                          "between",
                                          "a 9000 m2",
                                          "no milk",
                                          "no cola",
                                          "no coffee",
                                          "emergency exit",
                                          "called \"A \u201C\"",
                                          "4",
                                          "service door",
                                          "in the middle",
                                          "green accents"};
  Stream draw = Seed(seed).child("prompt").stream();
  std::string prompt = "shop";
  const int length = draw.integer(3, 30);
  for (int i = 0; i < length; ++i) {
    const int at = draw.integer(0, static_cast<int>(std::size(words)) - 1);
    prompt += std::string(" ") + words[static_cast<std::size_t>(at)];
  }
  return prompt;
}

TEST(Designs, OfAnyWordsAreReadable) {
  const auto planner = intake::offline_planner();
  ASSERT_TRUE(planner.ok());
  const std::uint64_t prompts = number_of_cases("MARKETGEN_PROPERTY_PROMPTS", 150);
  for (std::uint64_t seed = 0; seed < prompts; ++seed) {
    intake::Brief brief;
    brief.prompt = random_prompt(seed);
    const int size = static_cast<int>(seed % 150);
    brief.size_mm = {{12000 + 100 * size, 9000 + 70 * size}};
    const auto planned = intake::plan_from_brief(brief, committed_catalog(), **planner, Seed(seed));
    ASSERT_TRUE(planned.ok()) << brief.prompt << ": " << to_string(planned.error());
    expect_readable(planned->plan, brief.prompt);
  }
}

TEST(Designs, OfFewWordsThatAskForTooMuchAreReadable) {
  for (const char* prompt : {"drugstore, 0.3 m wide aisles",
                             "3 entrances, 4 entrances",
                             "a 30 x 20 m shop with at least 3 entrances and at most 5 entrances",
                             "10000 exits",
                             "999999999999999999999 checkouts",
                             "1000000000000 rows of frozen food",
                             "90 m high shelves and a 200 m ceiling",
                             "a shop with 1000000000000000000000 aisles and 99999999999 levels"}) {
    const auto store = designed(prompt, 1);
    ASSERT_TRUE(store.ok()) << prompt << ": " << to_string(store.error());
    expect_readable(store->repaired.plan, prompt);
  }
}

// ---- Work: steps rather than seconds, which are the same on every machine ----

// Twelve thousand characters of clauses that contradict one another.
std::string salad(const std::string& shop, std::uint64_t seed) {
  static constexpr const char* things[] = {"bakery",
                                           "dairy",
                                           "produce",
                                           "frozen",
                                           "meat",
                                           "deli",
                                           "snacks",
                                           "drinks",
                                           "wine",
                                           "household",
                                           "canned food",
                                           "cosmetics",
                                           "magazines",
                                           "promo",
                                           "cafe",
                                           "storage",
                                           "self-checkouts",
                                           "checkouts",
                                           "customer service"};
  static constexpr const char* clauses[] = {"A next to the B",
                                            "A left of the B",
                                            "A far from the B",
                                            "A between B and the entrance",
                                            "A along the north wall",
                                            "N A zones",
                                            "A of 80 m2",
                                            "N rows of A",
                                            "no A",
                                            "lots of A",
                                            "N entrances",
                                            "N exits",
                                            "N windows",
                                            "N emergency exits",
                                            "N aisles",
                                            "N checkouts",
                                            "2.5 m wide aisles",
                                            "A opposite the B",
                                            "A behind the B"};
  Stream draw = Seed(seed).child("salad").stream();
  const auto one_of = [&](const auto& list) {
    const int last = static_cast<int>(std::size(list)) - 1;
    return std::string(list[static_cast<std::size_t>(draw.integer(0, last))]);
  };
  std::string prompt = shop;
  while (prompt.size() < 12'000) {
    prompt += ", ";
    for (const char c : one_of(clauses))
      prompt += c == 'A' || c == 'B' ? one_of(things)
                : c == 'N'           ? std::to_string(draw.integer(1, 60))
                                     : std::string(1, c);
  }
  return prompt;
}

// Floors that the search judged, each counted with what it holds and what is asked of it.
std::int64_t work_of(const intake::Planned& planned) {
  std::int64_t floors = 0;
  for (const std::string& line : planned.trace)
    if (line.starts_with("judged ")) floors += std::stoll(line.substr(7));
  return floors * (std::ssize(planned.plan.zones) + std::ssize(planned.plan.relations));
}

TEST(SlowDesigns, OfSaladsTakeBoundedWorkAndSayWhatWasGivenUp) {
  // 150,000 for the first plan, half as much for each that follows.
  constexpr std::int64_t max_search_work = 450'000, one_layout = 4'000;
  const auto planner = intake::offline_planner();
  ASSERT_TRUE(planner.ok());
  std::uint64_t seed = 0;
  for (const char* shop : {"a 4 x 4 m kiosk",
                           "a 8 x 5 m shop",
                           "a 5 x 38 m supermarket",
                           "a 24 x 15 m shop",
                           "a 200 x 20 m supermarket",
                           "a 100 x 80 m hypermarket"}) {
    SCOPED_TRACE(shop);
    intake::Brief brief;
    brief.prompt = salad(shop, ++seed);
    std::int64_t searched = 0;
    int plans = 0;
    const store::PlanAgain plan = [&](const intake::Concessions& concessions) {
      auto planned =
          intake::plan_from_brief(brief, committed_catalog(), **planner, Seed(seed), concessions);
      if (planned.ok()) searched += work_of(*planned);
      ++plans;
      return planned;
    };
    auto planned = plan({});
    ASSERT_TRUE(planned.ok()) << to_string(planned.error());
    EXPECT_GT(planned->conflicts.size(), 10U);
    auto repaired = layout::repair_plan(planned->plan, committed_catalog(), Seed(seed));
    ASSERT_TRUE(repaired.ok());
    EXPECT_LT(repaired->work, layout::max_repair_work + one_layout);
    auto layout = store::layout_of(*repaired, committed_catalog(), Seed(seed));
    ASSERT_TRUE(layout.ok());
    const auto made =
        store::concede({std::move(*planned), std::move(*repaired), std::move(*layout)},
                       plan,
                       committed_catalog(),
                       Seed(seed));
    EXPECT_LT(searched, max_search_work);
    EXPECT_LE(plans, 11);
    if (made.ok()) expect_readable(made->repaired.plan, brief.prompt);
  }
}

}  // namespace
}  // namespace marketgen
