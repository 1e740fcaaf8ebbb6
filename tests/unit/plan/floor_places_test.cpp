// What the names of places stand for on a floor that is known.
#include "plan/floor_places.h"

#include <gtest/gtest.h>

#include "named_shop.h"

namespace marketgen {
namespace {

using Places = std::vector<plan::NamedPlace>;

TEST(FloorPlaces, WallsAreStripsAndTheMiddleIsAThird) {
  const NamedShop shop;
  EXPECT_EQ(plan::places_named(shop.floor(), "north"),
            (Places{{plan::PlaceKind::wall, {0, 8500, 20000, 10000}}}));
  EXPECT_EQ(plan::places_named(shop.floor(), "south"),
            (Places{{plan::PlaceKind::wall, {0, 0, 20000, 1500}}}));
  EXPECT_EQ(plan::places_named(shop.floor(), "west"),
            (Places{{plan::PlaceKind::wall, {0, 0, 1500, 10000}}}));
  EXPECT_EQ(plan::places_named(shop.floor(), "east"),
            (Places{{plan::PlaceKind::wall, {18500, 0, 20000, 10000}}}));
  EXPECT_EQ(plan::places_named(shop.floor(), "center"),
            (Places{{plan::PlaceKind::middle, {6666, 3333, 13333, 6666}}}));
}

TEST(FloorPlaces, DoorsAreTheFloorInsideThemByKindOrId) {
  const NamedShop shop;
  EXPECT_EQ(plan::places_named(shop.floor(), "entrance"),
            (Places{{plan::PlaceKind::opening, {3500, 0, 4500, 1000}}}));
  EXPECT_EQ(plan::places_named(shop.floor(), "exit"), plan::places_named(shop.floor(), "way-out"));
  EXPECT_EQ(plan::places_named(shop.floor(), "exit").size(), 1U);
}

TEST(FloorPlaces, ZonesGoByIdAndType) {
  NamedShop shop;
  shop.zones.push_back({"bakery-2", "bakery", {17000, 4000, 20000, 7000}});
  EXPECT_EQ(plan::places_named(shop.floor(), "bakery").size(), 2U);
  EXPECT_EQ(plan::places_named(shop.floor(), "bakery-2").size(), 1U);
}

TEST(FloorPlaces, SelfCheckoutsAreCheckouts) {
  NamedShop shop;
  shop.zones.push_back({"self", "self_checkout", {10000, 0, 13000, 2000}});
  EXPECT_EQ(plan::places_named(shop.floor(), "checkout").size(), 2U);
  EXPECT_EQ(plan::places_named(shop.floor(), "self_checkout").size(), 1U);
}

TEST(FloorPlaces, WhatIsNotThereOrHasNoFloorIsNoPlace) {
  NamedShop shop;
  shop.zones.push_back({"wine", "alcohol", {}});
  EXPECT_TRUE(plan::places_named(shop.floor(), "moon").empty());
  EXPECT_TRUE(plan::places_named(shop.floor(), "wine").empty());
  EXPECT_TRUE(plan::places_named(shop.floor(), "window").empty());
}

TEST(FloorPlaces, PointsInsideLieOnTheInnerSideOfEveryWall) {
  const RectMm floor{0, 0, 20000, 10000};
  const auto at = [&](plan::Wall wall) {
    return plan::point_inside(floor, {"door", plan::OpeningKind::exit, wall, 0.25, 1000}, 300);
  };
  EXPECT_EQ(at(plan::Wall::south), (PointMm{5000, 300}));
  EXPECT_EQ(at(plan::Wall::north), (PointMm{5000, 9700}));
  EXPECT_EQ(at(plan::Wall::west), (PointMm{300, 2500}));
  EXPECT_EQ(at(plan::Wall::east), (PointMm{19700, 2500}));
}

}  // namespace
}  // namespace marketgen
