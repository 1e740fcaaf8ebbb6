#include "layout/side.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

constexpr RectMm room{0, 0, 10, 6};

TEST(Side, StripsLieInsideAndBeyondTheirSide) {
  EXPECT_EQ(strip_inside(room, Side::north, 2), (RectMm{0, 4, 10, 6}));
  EXPECT_EQ(strip_inside(room, Side::east, 3, 1), (RectMm{6, 0, 9, 6}));
  EXPECT_EQ(strip_beyond(room, Side::west, 2), (RectMm{-2, 0, 0, 6}));
  EXPECT_EQ(strip_beyond(room, Side::south, 2), (RectMm{0, -2, 10, 0}));
}

TEST(Side,
     LeftIsSeenFromTheFront) {  // a front that faces south is looked at northward: left is west
  EXPECT_EQ(left_of(Side::south), Side::west);
  EXPECT_EQ(left_of(Side::east), Side::south);
  EXPECT_EQ(left_of(Side::north), Side::east);
  EXPECT_EQ(left_of(Side::west), Side::north);
}

TEST(Side, YawNamesTheSideAFrontFaces) {
  EXPECT_EQ(facing_of(0), Side::south);
  EXPECT_EQ(facing_of(90), Side::east);
  EXPECT_EQ(yaw_facing(Side::west), 270);
}

TEST(Spans, WithoutTakesOverlappingPiecesOut) {
  EXPECT_EQ(without({0, 10}, {{6, 8}, {2, 3}, {7, 9}}),
            (std::vector<Span>{{0, 2}, {3, 6}, {9, 10}}));
  EXPECT_EQ(without({0, 10}, {{-5, 4}}, 7), (std::vector<Span>{}));
  EXPECT_EQ(without({0, 10}, {}), (std::vector<Span>{{0, 10}}));
}

}  // namespace
}  // namespace marketgen
