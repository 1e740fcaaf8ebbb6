#include "layout/side.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

constexpr RectMm room{0, 0, 10, 6};

TEST(Side, StripsLieInsideAndBeyondTheirSide) {
  EXPECT_EQ(layout::strip_inside(room, layout::Side::north, 2), (RectMm{0, 4, 10, 6}));
  EXPECT_EQ(layout::strip_inside(room, layout::Side::east, 3, 1), (RectMm{6, 0, 9, 6}));
  EXPECT_EQ(layout::strip_beyond(room, layout::Side::west, 2), (RectMm{-2, 0, 0, 6}));
  EXPECT_EQ(layout::strip_beyond(room, layout::Side::south, 2), (RectMm{0, -2, 10, 0}));
}

TEST(Side,
     LeftIsSeenFromTheFront) {  // a front that faces south is looked at northward: left is west
  EXPECT_EQ(layout::left_of(layout::Side::south), layout::Side::west);
  EXPECT_EQ(layout::left_of(layout::Side::east), layout::Side::south);
  EXPECT_EQ(layout::left_of(layout::Side::north), layout::Side::east);
  EXPECT_EQ(layout::left_of(layout::Side::west), layout::Side::north);
}

TEST(Side, YawNamesTheSideAFrontFaces) {
  EXPECT_EQ(layout::facing_of(0), layout::Side::south);
  EXPECT_EQ(layout::facing_of(90), layout::Side::east);
  EXPECT_EQ(layout::yaw_facing(layout::Side::west), 270);
}

TEST(Spans, WithoutTakesOverlappingPiecesOut) {
  EXPECT_EQ(layout::without({0, 10}, {{6, 8}, {2, 3}, {7, 9}}),
            (std::vector<layout::Span>{{0, 2}, {3, 6}, {9, 10}}));
  EXPECT_EQ(layout::without({0, 10}, {{-5, 4}}, 7), (std::vector<layout::Span>{}));
  EXPECT_EQ(layout::without({0, 10}, {}), (std::vector<layout::Span>{{0, 10}}));
}

}  // namespace
}  // namespace marketgen
