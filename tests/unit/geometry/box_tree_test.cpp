// The tree against every pair, and what it costs in a crowd.
#include "geometry/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "base/parallel.h"
#include "base/seed.h"

namespace marketgen {
namespace {

Bounds3 box_at(Vec3f low, Vec3f size) {
  return {low, low + size};
}

std::vector<std::uint32_t> near(const BoxTree& tree, const Bounds3& box, float overlap_m) {
  std::vector<std::uint32_t> rows;
  tree.each_near(box, overlap_m, [&](std::uint32_t row) { rows.push_back(row); });
  std::ranges::sort(rows);
  return rows;
}

TEST(BoxTree, FindsWhatABruteForceFinds) {
  Stream draw(7);
  std::vector<Bounds3> boxes;
  for (int i = 0; i < 500; ++i) {
    const auto side = [&] { return static_cast<float>(draw.uniform(0.001, i % 7 == 0 ? 3 : 0.1)); };
    const auto place = [&] { return 0.125F * static_cast<float>(draw.integer(0, 40)); };
    boxes.push_back(box_at({place(), place(), place() / 4}, {side(), side(), side()}));
  }
  const BoxTree tree(boxes);
  std::size_t found = 0;
  for (const float overlap : {-0.125F, -0.005F, 0.0F, 0.01F}) {
    for (const Bounds3& box : boxes) {
      std::vector<std::uint32_t> expected;
      for (std::uint32_t k = 0; k < boxes.size(); ++k) {
        if (overlap_of(boxes[k], box) >= overlap) expected.push_back(k);
      }
      EXPECT_EQ(near(tree, box, overlap), expected);
      found += expected.size();
    }
  }
  EXPECT_GT(found, 4000U);
}

// Large trees are made by several threads: they find what one finds, in the same order.
TEST(BoxTree, IsTheSameTreeOfAnyNumberOfThreads) {
  Stream draw(11);
  std::vector<Bounds3> boxes;
  for (int i = 0; i < 30'000; ++i) {
    const auto place = [&] { return static_cast<float>(draw.uniform(0, 10)); };
    boxes.push_back(box_at({place(), place(), place()}, {0.2F, 0.3F, 0.1F}));
  }
  const BoxTree tree(boxes);
  const auto order = [&](const BoxTree& of, const Bounds3& box) {
    std::vector<std::uint32_t> rows;
    of.each_near(box, 0, [&](std::uint32_t row) { rows.push_back(row); });
    return rows;
  };
  const ThreadLimit limit(1);
  const BoxTree alone(boxes);
  for (std::size_t i = 0; i < boxes.size(); i += 500) {
    EXPECT_EQ(order(tree, boxes[i]), order(alone, boxes[i]));
    std::size_t expected = 0;
    for (const Bounds3& box : boxes)
      expected += overlap_of(box, boxes[i]) >= 0 ? 1U : 0U;
    EXPECT_EQ(order(tree, boxes[i]).size(), expected);
  }
}

TEST(BoxTree, HasNoNeighboursWhereThereIsNothing) {
  EXPECT_TRUE(near(BoxTree({}), box_at({0, 0, 0}, {1, 1, 1}), -1).empty());
  const std::vector<Bounds3> one{box_at({0, 0, 0}, {1, 1, 1})};
  EXPECT_TRUE(near(BoxTree(one), box_at({3, 0, 0}, {1, 1, 1}), -1.5F).empty());
  EXPECT_EQ(near(BoxTree(one), box_at({3, 0, 0}, {1, 1, 1}), -2.5F).size(), 1U);
}

// A sweep along one axis compares each of these with all of a slice: seconds become hours.
TEST(BoxTree, AMillionSmallBoxesInARoom) {
  std::vector<Bounds3> boxes;
  for (int x = 0; x < 100; ++x) {
    for (int y = 0; y < 100; ++y) {
      for (int z = 0; z < 100; ++z)
        boxes.push_back(box_at({0.01F * static_cast<float>(x),
                                0.01F * static_cast<float>(y),
                                0.01F * static_cast<float>(z)},
                               {0.009F, 0.009F, 0.009F}));
    }
  }
  const auto start = std::chrono::steady_clock::now();
  const BoxTree tree(boxes);
  std::size_t pairs = 0;
  for (std::uint32_t i = 0; i < boxes.size(); i += 10)
    tree.each_near(boxes[i], -0.002F, [&](std::uint32_t k) { pairs += k != i ? 1 : 0; });
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(40));
  EXPECT_GT(pairs, 2'000'000U);
}

// Boxes that all lie in one place still halve: the tree is made, and a box elsewhere is told apart
// at once.
TEST(BoxTree, ACrowdOnOneSpot) {
  const std::vector<Bounds3> boxes(100'000, box_at({1, 1, 1}, {0.1F, 0.1F, 0.1F}));
  const BoxTree tree(boxes);
  EXPECT_EQ(near(tree, boxes[0], 0).size(), boxes.size());
  EXPECT_TRUE(near(tree, box_at({2, 2, 2}, {0.1F, 0.1F, 0.1F}), 0).empty());
}

}  // namespace
}  // namespace marketgen
