// Words for goals fit exactly one product on offer, and say what tells it from look-alikes.
#include "episodes/referring_expression.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "assets/product_model.h"
#include "catalog/container_nouns.h"
#include "episodes/goal_words.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

using episodes::Attribute;

catalog::Product milk(const std::string& sku, const std::string& variant, const std::string& net) {
  catalog::Product row;
  row.sku = sku;
  row.name = "Fresh Milk";
  row.variant = variant;
  row.brand = "Weidora";
  row.category = "dairy";
  row.subcategory = "milk";
  row.archetype = "gable_carton";
  row.net = net;
  row.label.primary = "#1565c0";
  return row;
}

bool says(const episodes::ReferringExpression& told, Attribute attribute) {
  return std::ranges::count(told.says, attribute, &episodes::ToldAttribute::attribute) > 0;
}

TEST(ReferringExpression, SaysTheOnlyThingInWhichALookAlikeDiffers) {
  const episodes::Offer sizes({milk("a", "1.5% Fat", "1 l"), milk("b", "1.5% Fat", "500 ml")});
  const episodes::Offer variants({milk("a", "1.5% Fat", "1 l"), milk("b", "3.5% Fat", "1 l")});
  catalog::Product other = milk("b", "1.5% Fat", "1 l");
  other.brand = "Alvenna";
  const episodes::Offer brands({milk("a", "1.5% Fat", "1 l"), other});
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    EXPECT_TRUE(says(*episodes::refer_to(sizes, 0, 1, Seed(seed)), Attribute::size));
    EXPECT_TRUE(says(*episodes::refer_to(variants, 0, 1, Seed(seed)), Attribute::variant));
    EXPECT_TRUE(says(*episodes::refer_to(brands, 0, 1, Seed(seed)), Attribute::brand));
  }
}

TEST(ReferringExpression, OfTwinsNothingIsSaid) {
  const episodes::Offer twins({milk("a", "1.5% Fat", "1 l"), milk("b", "1.5% Fat", "1000 ml")});
  EXPECT_FALSE(episodes::refer_to(twins, 0, 1, Seed(1)));
}

TEST(ReferringExpression, ComesInManyWords) {
  const episodes::Offer offer({milk("a", "1.5% Fat", "1 l"), milk("b", "3.5% Fat", "500 ml")});
  std::set<std::string> texts;
  for (std::uint64_t seed = 0; seed < 60; ++seed)
    texts.insert(episodes::refer_to(offer, 0, 1, Seed(seed))->text);
  EXPECT_GT(texts.size(), 20U);
  EXPECT_EQ(episodes::refer_to(offer, 0, 1, Seed(7))->text,
            episodes::refer_to(offer, 0, 1, Seed(7))->text);
  EXPECT_TRUE(episodes::refer_to(offer, 0, 2, Seed(7))->text.starts_with("two "));
}

// The evaluator by itself: amounts, sayings, containers, colours.
TEST(Offer, FitsWhatAHearerMayMean) {
  const episodes::Offer offer({milk("a", "1.5% Fat", "1 l")});
  EXPECT_TRUE(offer.fits(0, {Attribute::size, "1000 ml"}));
  EXPECT_FALSE(offer.fits(0, {Attribute::size, "1 kg"}));
  EXPECT_TRUE(offer.fits(0, {Attribute::variant, "low-fat"}));
  EXPECT_FALSE(offer.fits(0, {Attribute::variant, "full-fat"}));
  EXPECT_TRUE(offer.fits(0, {Attribute::name, "milk"}));
  EXPECT_FALSE(offer.fits(0, {Attribute::name, "cola"}));
  EXPECT_TRUE(offer.fits(0, {Attribute::container, "carton"}));
  EXPECT_FALSE(offer.fits(0, {Attribute::container, "bottle"}));
  EXPECT_TRUE(offer.fits(0, {Attribute::color, "blue"}));
  EXPECT_FALSE(offer.fits(0, {Attribute::color, "red"}));
}

// Every product of the catalogue, among all others: exactly that one fits, or nothing is said.
TEST(SlowReferringExpression, FitsOneProductOfTheWholeCatalogue) {
  const episodes::Offer offer(committed_catalog().products);
  std::size_t untold = 0;
  for (std::size_t number = 0; number < offer.size(); number += 3) {
    const auto told = episodes::refer_to(offer, number, 1, Seed(number));
    if (!told) {
      ++untold;
      continue;
    }
    EXPECT_EQ(offer.fitting(told->says), std::vector<std::size_t>{number}) << told->text;
    EXPECT_EQ(told->text.find(offer.row(number).sku), std::string::npos);
  }
  EXPECT_LT(untold, offer.size() / 3 / 20);  // a twentieth
}

// What the lists of sayings speak of is there.
TEST(SaidOtherwise, IsOfTheCatalogue) {
  std::set<std::string> archetypes;
  for (const catalog::Product& row : committed_catalog().products)
    archetypes.insert(row.archetype);
  std::size_t called = 0;
  for (const std::string& archetype : archetypes)
    called += catalog::container_nouns(archetype).empty() ? 0U : 1U;
  EXPECT_GT(called, 40U);
  std::size_t said = 0;
  for (const catalog::Product& row : committed_catalog().products)
    said += episodes::said_otherwise(Attribute::name, row.name).empty() ? 0U : 1U;
  EXPECT_GT(said, 150U);
}

TEST(GoalWords, TellEachGoalOrNone) {
  episodes::EpisodeSpec spec;
  spec.goals = {{"a", 2}, {"b", 1}};
  const episodes::Offer offer({milk("a", "1.5% Fat", "1 l"), milk("b", "3.5% Fat", "500 ml")});
  ASSERT_TRUE(tell_goals(offer, episodes::InstructionVerb::unload, Seed(1), spec));
  EXPECT_FALSE(spec.goals[0].text);  // by SKU
  EXPECT_NE(spec.instruction.find("2 of Weidora Fresh Milk 1.5% Fat (1 l)"), std::string::npos);
  spec.instructions = episodes::Instructions::words;
  ASSERT_TRUE(tell_goals(offer, episodes::InstructionVerb::unload, Seed(1), spec));
  for (const episodes::EpisodeGoal& goal : spec.goals)
    EXPECT_NE(spec.instruction.find(*goal.text), std::string::npos);
}

}  // namespace
}  // namespace marketgen
