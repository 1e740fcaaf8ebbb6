// Floors cut into strips, and the binary trees made of them.
#include "intake/slices.h"

#include <gtest/gtest.h>

#include "plan/bsp.h"

namespace marketgen {
namespace {

const std::vector<std::string> ids = {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j"};

// Columns of 2 m with aisles of 1 m, from west to east.
intake::Slice columns(int count) {
  intake::Slice slice = intake::cut_slice(plan::Axis::x);
  for (int i = 0; i < count; ++i)
    slice.add(intake::zone_slice(i), 2000, 1000);
  return slice;
}

std::vector<RectMm> rects_of_tree(const intake::Slice& slice,
                                  int width_mm,
                                  int depth_mm,
                                  int zones) {
  plan::Plan plan;
  plan.shell.width_mm = width_mm;
  plan.shell.depth_mm = depth_mm;
  plan.nodes = intake::nodes_of(slice, ids);
  for (int i = 0; i < zones; ++i) {
    plan::Zone& zone = plan.zones.emplace_back();
    zone.id = ids[static_cast<std::size_t>(i)];
  }
  return plan::zone_rectangles(plan);
}

TEST(Slices, RectanglesFollowOneAnother) {
  const std::vector<RectMm> rects = intake::zone_rects(columns(3), {0, 0, 8000, 5000}, 3);
  EXPECT_EQ(rects[0], (RectMm{0, 0, 2000, 5000}));
  EXPECT_EQ(rects[1], (RectMm{3000, 0, 5000, 5000}));
  EXPECT_EQ(rects[2], (RectMm{6000, 0, 8000, 5000}));
}

TEST(Slices, EightColumnsNeedThreeCuts) {
  EXPECT_EQ(intake::tree_depth(columns(8)), 3);
}

TEST(Slices, TreeGivesTheSameRectangles) {
  const intake::Slice slice = columns(7);
  const std::vector<RectMm> direct = intake::zone_rects(slice, {0, 0, 20000, 5000}, 7);
  const std::vector<RectMm> tree = rects_of_tree(slice, 20000, 5000, 7);
  for (std::size_t i = 0; i < direct.size(); ++i) {
    EXPECT_NEAR(direct[i].x0, tree[i].x0, 2) << i;
    EXPECT_NEAR(direct[i].x1, tree[i].x1, 2) << i;
  }
}

// 1 m beside 30 m would be a ratio of 0.03; grouped with its neighbour it is one of 0.25.
TEST(Slices, NarrowPartsAreGroupedSoThatRatiosAreAllowed) {
  intake::Slice slice = intake::cut_slice(plan::Axis::x);
  slice.add(intake::zone_slice(0), 1000, 0);
  slice.add(intake::zone_slice(1), 3000, 1000);
  slice.add(intake::zone_slice(2), 27000, 1000);
  for (const plan::Node& node : intake::nodes_of(slice, ids)) {
    if (!node.ratio) continue;
    EXPECT_GE(*node.ratio, 0.08);
    EXPECT_LE(*node.ratio, 0.92);
  }
  EXPECT_EQ(intake::tree_depth(slice), 2);
}

TEST(Slices, WhatNoRatioCanSayIsTooDeep) {
  intake::Slice slice = intake::cut_slice(plan::Axis::y);
  slice.add(intake::zone_slice(0), 1000, 0);
  slice.add(intake::zone_slice(1), 50000, 0);
  EXPECT_GT(intake::tree_depth(slice), plan::max_bsp_depth);
}

TEST(Slices, PartsOfTheSameCutAreTakenInPieceByPiece) {
  intake::Slice slice = intake::cut_slice(plan::Axis::x);
  slice.add(intake::zone_slice(3), 1000, 0);
  slice.add(columns(3), 8000, 500);
  EXPECT_EQ(slice.parts.size(), 4U);
  EXPECT_EQ(slice.gaps_mm, (std::vector<int>{500, 1000, 1000}));
}

}  // namespace
}  // namespace marketgen
