// The one measure of every relation: what holds on a floor that is known, and by how much.
#include "plan/relation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "named_shop.h"

namespace marketgen {
namespace {

using enum plan::RelationKind;

std::optional<plan::RelationMeasure> measured(const NamedShop& shop,
                                              const plan::RelationTerms& relation) {
  return plan::measure_relation(shop.floor(), relation);
}

struct SlackCase {
  plan::RelationTerms relation;
  double slack_m;
};

void expect_slack(const NamedShop& shop, const std::vector<SlackCase>& cases) {
  for (const auto& [relation, slack_m] : cases) {
    const auto measure = measured(shop, relation);
    ASSERT_TRUE(measure) << relation.a << " " << name_of(relation.kind) << " " << relation.b;
    EXPECT_NEAR(measure->slack_m(), slack_m, 1e-3)
        << plan::words_of(shop.floor(), relation, measure) << ", " << relation.c;
    EXPECT_EQ(measure->holds(), slack_m >= 0);
  }
}

constexpr double diagonal = 22.36068;

TEST(Relations, KnownSlack) {
  expect_slack(
      NamedShop(),
      {
          {{near, "produce", "bakery"}, 0.2 * diagonal - 1},
          {{near, "produce", "entrance"}, 0.2 * diagonal},
          {{near, "produce", "dairy"}, 0.2 * diagonal - std::hypot(8, 5.5)},
          {{near, "dairy", "checkout"}, 0.2 * diagonal - 6.5},  // neither near
          {{far, "dairy", "checkout"}, 6.5 - 0.35 * diagonal},  // nor far
          {{far, "produce", "dairy"}, std::hypot(8, 5.5) - 0.35 * diagonal},
          {{far, "produce", "bakery"}, 1 - 0.35 * diagonal},
          {{along, "dairy", "north"}, 1.5},  // its whole depth; of 8 m, 4 would do
          {{at, "dairy", "north"}, 1.5},
          {{along, "produce", "west"}, 1.5},
          {{along, "bakery", "north"}, -5.5},
          {{along, "frozen", "south"}, -2.5},
          {{at, "frozen", "center"}, 1},      // both metres of its length; one would do
          {{at, "dairy", "center"}, -2.667},  // 1.333 m of its 8 m, and 1.834 m beyond
          {{at, "bakery", "produce"}, 0.5},   // 1 m away
          {{at, "canned", "entrance"}, -1.5},
          {{left_of, "produce", "bakery"}, 4.4},  // who comes in walks north: west is on the left
          {{left_of, "bakery", "produce"}, -4.6},
          {{right_of, "checkout", "produce"}, 14.4},
          {{right_of, "produce", "checkout"}, -14.6},
          {{behind, "dairy", "bakery"}, 7.65},
          {{behind, "bakery", "dairy"}, -7.85},
          {{behind, "snacks", "bakery"}, -0.1},  // in one line
          {{facing, "produce", "bakery"}, 2.9},  // along 3 m
          {{facing, "bakery", "canned"}, 2.9},
          {{facing, "produce", "checkout"}, -4},  // 10 m away
          {{facing, "produce", "dairy"}, -5.6},   // apart along x by 8 m, along y by 5.5 m
          {{not_adjacent, "snacks", "bakery"}, -1},
          {{not_adjacent, "produce", "bakery"}, 0},
          {{not_adjacent, "produce", "dairy"}, std::hypot(8, 5.5) - 1},
      });
}

TEST(Relations, BetweenIsOnTheWayFromOneToTheOther) {
  const NamedShop shop;
  EXPECT_TRUE(measured(shop, {between, "bakery", "produce", "checkout"})->holds());
  EXPECT_TRUE(measured(shop, {between, "frozen", "produce", "dairy"})->holds());
  EXPECT_FALSE(measured(shop, {between, "produce", "bakery", "checkout"})->holds());
  // Half-way along the way, but far beside it.
  EXPECT_FALSE(measured(shop, {between, "dairy", "bakery", "checkout"})->holds());
  // Nothing lies between a thing and itself.
  EXPECT_FALSE(measured(shop, {between, "frozen", "dairy", "dairy"})->holds());
}

TEST(Relations, NearIsThreeMetresInASmallShop) {
  NamedShop shop;
  const plan::NamedFloor small{{0, 0, 6000, 6000},
                               shop.openings,
                               {{"a", "a", {0, 0, 1000, 1000}}, {"b", "b", {4000, 0, 5000, 1000}}}};
  EXPECT_NEAR(plan::measure_relation(small, {near, "a", "b"})->slack_m(), 0, 1e-9);
}

TEST(Relations, LeftTurnsWithTheEntrance) {
  NamedShop shop;
  shop.openings[0].wall = plan::Wall::west;  // who comes in walks east: north is on the left
  EXPECT_TRUE(measured(shop, {left_of, "dairy", "bakery"})->holds());
  EXPECT_TRUE(measured(shop, {right_of, "bakery", "dairy"})->holds());
  EXPECT_TRUE(measured(shop, {behind, "checkout", "produce"})->holds());
  shop.openings[0].wall = plan::Wall::north;
  EXPECT_TRUE(measured(shop, {left_of, "checkout", "produce"})->holds());
}

TEST(Relations, AShopWithoutAnEntranceIsSeenFromItsExit) {
  NamedShop shop;
  shop.openings = {{"out", plan::OpeningKind::exit, plan::Wall::north, 0.5, 2000}};
  EXPECT_TRUE(measured(shop, {behind, "bakery", "dairy"})->holds());
}

TEST(Relations, OneOfTwoIsEnoughToBeNearNotToBeFar) {
  NamedShop shop;
  shop.zones.push_back({"bakery-2", "bakery", {17000, 4000, 20000, 7000}});
  EXPECT_TRUE(measured(shop, {near, "bakery", "produce"})->holds());
  EXPECT_FALSE(measured(shop, {far, "bakery", "produce"})->holds());
  EXPECT_TRUE(measured(shop, {far, "bakery-2", "produce"})->holds());
  EXPECT_TRUE(measured(shop, {along, "bakery", "east"})->holds());
  EXPECT_EQ(measured(shop, {along, "bakery", "east"})->at_mm, (PointMm{18500, 5500}));
}

TEST(Relations, WhatIsNotThereCannotBeJudged) {
  const NamedShop shop;
  for (std::size_t i = 0; i < plan::names_of(plan::RelationKind{}).size(); ++i) {
    const auto kind = static_cast<plan::RelationKind>(i);
    for (const plan::RelationTerms& relation :
         {plan::RelationTerms{kind, "deli", "produce", "bakery"},
          plan::RelationTerms{kind, "produce", "deli", "bakery"}}) {
      EXPECT_FALSE(measured(shop, relation)) << name_of(kind);
      EXPECT_EQ(plan::missing_place(shop.floor(), relation), "deli");
    }
  }
  const plan::RelationTerms third{between, "produce", "bakery", "deli"};
  EXPECT_FALSE(measured(shop, third));
  EXPECT_EQ(plan::missing_place(shop.floor(), third), "deli");
  EXPECT_EQ(plan::missing_place(shop.floor(), {near, "produce", "bakery", ""}), "");
  // A zone has no place relative to itself.
  EXPECT_FALSE(measured(shop, {near, "bakery", "bakery"}));
}

TEST(Relations, WordsSayWhatWasMeasuredOrWhyNot) {
  const NamedShop shop;
  const auto words = [&](const plan::RelationTerms& relation) {
    return plan::words_of(shop.floor(), relation, measured(shop, relation));
  };
  EXPECT_EQ(words({near, "dairy", "checkout"}),
            "dairy near checkout: gap 6.5 m, at most 4.5 m holds");
  EXPECT_EQ(words({not_adjacent, "snacks", "bakery"}),
            "snacks not adjacent bakery: gap 0.0 m, at least 1.0 m holds");
  EXPECT_EQ(words({near, "dairy", "deli"}),
            "dairy near deli cannot be judged: the store has no deli");
  EXPECT_EQ(words({near, "dairy", "dairy"}),
            "dairy near dairy cannot be judged: both names stand for the same place");
}

TEST(Relations, TermsAreThoseOfPlansAndOfWishes) {
  const plan::Relation relation{between, "bakery", "produce", "checkout", plan::Strength::must};
  EXPECT_EQ(plan::terms_of(relation).c, "checkout");
  plan::Requirement wish;
  wish.relation = near;
  wish.subject = "dairy";
  wish.object = "entrance";
  wish.second_object = "not of near";
  EXPECT_EQ(plan::terms_of(wish).a, "dairy");
  EXPECT_EQ(plan::terms_of(wish).b, "entrance");
  EXPECT_EQ(plan::terms_of(wish).c, "");
}

}  // namespace
}  // namespace marketgen
