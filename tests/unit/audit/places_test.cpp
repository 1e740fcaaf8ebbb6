// Relations among the places of a hand-made shop: a table of what is true and what is not.
#include "audit/places.h"

#include <gtest/gtest.h>

#include "audited_shop.h"

namespace marketgen {
namespace {

struct PlaceCase {
  const char *a, *relation, *b, *c;
  bool holds;
};

void expect_all(const Scene& scene, const std::vector<PlaceCase>& cases) {
  for (const PlaceCase& k : cases) {
    const auto relation = value_named<RelationKind>(k.relation);
    ASSERT_TRUE(relation) << k.relation;
    EXPECT_EQ(check_relation(scene, *relation, k.a, k.b, k.c).holds, k.holds)
        << k.a << " " << k.relation << " " << k.b << " " << k.c;
  }
}

TEST(Relations, KnownTruths) {  // the diagonal is 22.4 m: near up to 4.5 m, far from 7.8 m
  expect_all(AuditedShop().scene,
             {
                 {"produce", "near", "bakery", "", true},  // 1 m
                 {"produce", "near", "entrance", "", true},
                 {"bakery", "near", "frozen", "", true},    // 1.4 m
                 {"produce", "near", "dairy", "", false},   // 9.7 m
                 {"dairy", "near", "checkout", "", false},  // 6.5 m: neither near nor far
                 {"dairy", "far", "checkout", "", false},
                 {"produce", "far", "dairy", "", true},
                 {"produce", "far", "bakery", "", false},
                 {"dairy", "far", "entrance", "", true},
                 {"dairy", "along", "north", "", true},
                 {"dairy", "at", "north", "", true},
                 {"produce", "along", "west", "", true},
                 {"produce", "along", "south", "", true},
                 {"bakery", "along", "north", "", false},
                 {"frozen", "at", "center", "", true},
                 {"frozen", "along", "south", "", false},
                 {"produce", "left_of", "bakery", "", true},  // who comes in walks north: west is
                                                              // on the left
                 {"bakery", "left_of", "produce", "", false},
                 {"checkout", "right_of", "produce", "", true},
                 {"produce", "right_of", "checkout", "", false},
                 {"dairy", "behind", "bakery", "", true},
                 {"bakery", "behind", "dairy", "", false},
                 {"produce", "facing", "bakery", "", true},
                 {"produce", "facing", "dairy", "", false},
                 {"bakery", "between", "produce", "checkout", true},
                 {"produce", "between", "bakery", "checkout", false},
                 {"frozen", "between", "produce", "dairy", true},
                 {"snacks", "not_adjacent", "bakery", "", false},  // they share a side
                 {"produce", "not_adjacent", "dairy", "", true},
                 {"produce", "not_adjacent", "bakery", "", true},  // 1 m
             });
}

TEST(Relations, WhatIsNotThereRelatesToNothing) {
  for (const std::string_view relation : names_of(RelationKind{})) {
    const RelationKind kind = *value_named<RelationKind>(relation);
    EXPECT_FALSE(check_relation(AuditedShop().scene, kind, "deli", "produce", "bakery").holds)
        << relation;
    EXPECT_FALSE(check_relation(AuditedShop().scene, kind, "produce", "deli", "bakery").holds)
        << relation;
  }
}

TEST(Relations,
     LeftTurnsWithTheEntrance) {  // who comes in from the west walks east: north is on the left
  AuditedShop shop;
  shop.scene.layout.shell.openings[0].wall = Wall::west;
  expect_all(shop.scene,
             {{"dairy", "left_of", "bakery", "", true},
              {"bakery", "right_of", "dairy", "", true},
              {"checkout", "behind", "produce", "", true}});
}

TEST(Relations, OneOfTwoIsEnoughToBeNearNotToBeFar) {  // a second bakery far from the first
  AuditedShop shop;
  shop.scene.layout.zones.push_back(
      {"bakery-2", "bakery", "bakery", polygon_of({17000, 4000, 20000, 7000}), 9});
  expect_all(shop.scene,
             {{"bakery", "near", "produce", "", true},
              {"bakery", "far", "produce", "", false},
              {"bakery-2", "far", "produce", "", true},
              {"bakery", "along", "east", "", true}});
}

TEST(Places, Names) {
  const Scene scene = AuditedShop().scene;
  EXPECT_EQ(places_named(scene, "north"), (std::vector<RectMm>{{0, 8500, 20000, 10000}}));
  EXPECT_EQ(places_named(scene, "west"), (std::vector<RectMm>{{0, 0, 1500, 10000}}));
  EXPECT_EQ(places_named(scene, "entrance"), (std::vector<RectMm>{{3500, 0, 4500, 1000}}));
  EXPECT_EQ(places_named(scene, "dairy"), (std::vector<RectMm>{{12000, 8500, 20000, 10000}}));
  EXPECT_EQ(places_named(scene, "center").size(), 1U);
  EXPECT_TRUE(places_named(scene, "moon").empty());
  AuditedShop tills;
  tills.scene.layout.zones.push_back(
      {"self", "self_checkout", "Self checkout", polygon_of({10000, 0, 13000, 2000}), 6});
  EXPECT_EQ(places_named(tills.scene, "checkout").size(), 2U);
}

}  // namespace
}  // namespace marketgen
