#include "layout/relations.h"

#include <gtest/gtest.h>

#include "sample_shop.h"

namespace marketgen {
namespace {

// 20 x 10 m, entrance in the middle of the south wall; four zones in a row along the north wall,
// one by the door.
Layout shop() {
  Layout layout;
  layout.shell.width_mm = 20000;
  layout.shell.depth_mm = 10000;
  layout.shell.outline_mm = PolygonMm{{0, 0}, {20000, 0}, {20000, 10000}, {0, 10000}};
  layout.shell.openings = {sample::door("entrance", OpeningKind::entrance, Wall::south, 0.5)};
  layout.zones = {sample::layout_zone("bakery", "bakery", {0, 7000, 5000, 10000}),
                  sample::layout_zone("dairy", "dairy", {7000, 7000, 12000, 10000}),
                  sample::layout_zone("deli", "deli", {14000, 7000, 20000, 10000}),
                  sample::layout_zone("fruit", "produce", {6000, 0, 9000, 4000})};
  return layout;
}

bool holds(RelationKind kind, std::string a, std::string b, std::optional<std::string> c = {}) {
  return check_relation(shop(), {kind, std::move(a), std::move(b), std::move(c), Strength::must})
      .holds;
}

TEST(Relations, NearAndFarAreMeasuredBetweenEdgesAndMiddles) {
  EXPECT_TRUE(holds(RelationKind::near, "produce", "entrance"));
  EXPECT_FALSE(holds(RelationKind::near, "deli", "entrance"));
  EXPECT_TRUE(holds(RelationKind::far, "bakery", "deli"));
  EXPECT_FALSE(holds(RelationKind::far, "bakery", "dairy"));
}

TEST(Relations, AlongAWallMeansAtIt) {
  EXPECT_TRUE(holds(RelationKind::along, "dairy", "north"));
  EXPECT_FALSE(holds(RelationKind::along, "fruit", "north"));
}

TEST(Relations, LeftIsSeenComingIn) {
  EXPECT_TRUE(holds(RelationKind::left_of, "bakery", "entrance"));
  EXPECT_TRUE(holds(RelationKind::right_of, "deli", "dairy"));
  EXPECT_FALSE(holds(RelationKind::left_of, "deli", "dairy"));
  Layout turned = shop();  // coming in from the north, left is east
  turned.shell.openings[0].wall = Wall::north;
  EXPECT_TRUE(
      check_relation(turned, {RelationKind::left_of, "deli", "dairy", {}, Strength::must}).holds);
}

TEST(Relations, BetweenAndBehind) {
  EXPECT_TRUE(holds(RelationKind::between, "dairy", "bakery", "deli"));
  EXPECT_FALSE(holds(RelationKind::between, "bakery", "dairy", "deli"));
  EXPECT_TRUE(holds(RelationKind::behind, "dairy", "produce"));
}

TEST(Relations, NotAdjacentNeedsAnAisleBetween) {
  EXPECT_TRUE(holds(RelationKind::not_adjacent, "bakery", "dairy"));
  Layout close = shop();
  close.zones[1].polygon_mm = polygon_of({5500, 7000, 12000, 10000});
  EXPECT_FALSE(
      check_relation(close, {RelationKind::not_adjacent, "bakery", "dairy", {}, Strength::must})
          .holds);
}

TEST(Relations, MessagesSayWhatWasMeasured) {
  const RelationResult result =
      check_relation(shop(), {RelationKind::near, "deli", "entrance", {}, Strength::must});
  EXPECT_EQ(result.message, "deli should be near entrance; measured 7.6 m, at most 4.5 m holds");
}

TEST(Relations, UnknownNamesAreLeftToValidation) {
  EXPECT_TRUE(holds(RelationKind::near, "nowhere", "entrance"));
}

}  // namespace
}  // namespace marketgen
