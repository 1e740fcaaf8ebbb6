// Rectangles of a BSP tree: known answers.
#include "plan/bsp.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

plan::Node inner(const char* id, plan::Axis split, const char* first, const char* second) {
  plan::Node node;
  node.id = id;
  node.split = split;
  node.children = {first, second};
  return node;
}

plan::Node leaf(const char* id, const char* zone) {
  plan::Node node;
  node.id = id;
  node.zone = zone;
  return node;
}

plan::Zone zone(const char* id) {
  plan::Zone made;
  made.id = id;
  made.type = "snacks";
  return made;
}

// 10 x 8 m: a 3 m strip in the south, a 2 m aisle, then two halves side by side with no aisle.
plan::Plan three_zones() {
  plan::Plan plan;
  plan.shell.width_mm = 10000;
  plan.shell.depth_mm = 8000;
  plan.nodes = {leaf("back-west", "b"),
                inner("root", plan::Axis::y, "front", "back"),
                leaf("front", "a"),
                inner("back", plan::Axis::x, "back-west", "back-east"),
                leaf("back-east", "c")};
  plan.nodes[1].ratio = 0.5;
  plan.nodes[1].gap_mm = 2000;
  plan.zones = {zone("a"), zone("b"), zone("c")};
  return plan;
}

TEST(Bsp, RootIsNobodysChild) {
  EXPECT_EQ(plan::root_of(three_zones()), 1U);
}

TEST(Bsp, RatioAppliesToWhatTheGapLeaves) {
  const std::vector<RectMm> rects = plan::zone_rectangles(three_zones());
  EXPECT_EQ(rects[0], (RectMm{0, 0, 10000, 3000}));
  EXPECT_EQ(rects[1], (RectMm{0, 5000, 5000, 8000}));  // absent ratio and gap: halves, no aisle
  EXPECT_EQ(rects[2], (RectMm{5000, 5000, 10000, 8000}));
}

TEST(Bsp, ParentsComeBeforeChildrenWithTheirDepth) {
  const plan::Plan plan = three_zones();
  std::vector<std::string> order;
  for (const plan::NodeRect& placed : plan::node_rectangles(plan)) {
    order.push_back(plan.nodes[placed.node].id + std::to_string(placed.depth));
  }
  EXPECT_EQ(order,
            (std::vector<std::string>{"root0", "front1", "back1", "back-west2", "back-east2"}));
}

TEST(Bsp, NothingIsLostToRounding) {  // 0.333 of 7,001 mm is no whole number
  plan::Node cut = inner("cut", plan::Axis::x, "a", "b");
  cut.ratio = 0.333;
  cut.gap_mm = 1000;
  const auto [west, east] = plan::split_rect({0, 0, 8001, 500}, cut);
  EXPECT_EQ(west.x1, 2331);
  EXPECT_EQ(east.x0, 3331);
  EXPECT_EQ(east.x1, 8001);
}

TEST(Bsp, GapWiderThanTheFloorLeavesEmptyParts) {
  plan::Node cut = inner("cut", plan::Axis::y, "a", "b");
  cut.gap_mm = 5000;
  const auto [south, north] = plan::split_rect({0, 0, 1000, 3000}, cut);
  EXPECT_TRUE(south.empty());
  EXPECT_TRUE(north.empty());
}

}  // namespace
}  // namespace marketgen
