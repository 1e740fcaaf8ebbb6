// Rows of settled heaps: there and back, and damaged ones.
#include <gtest/gtest.h>

#include "catalog/heap.h"

namespace marketgen {
namespace {

catalog::HeapRow small_row() {
  return catalog::heap_row("apple",
                           {75, 75, 70},
                           {160, 80},
                           {{{{0.04, 0.04, 0}, {1, 0, 0, 0}}, {}},
                            {{{0.12, 0.04, 0}, {0.6, 0, 0.8, 0}}, {}},
                            {{{0.08, 0.04, 0.05}, {0, 1, 0, 0}}, {0, 1}}});
}

TEST(HeapRow, PiecesComeBackToATenthOfAMillimetre) {
  const std::vector<catalog::HeapPiece> pieces = catalog::pieces_of(small_row());
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_NEAR(pieces[1].pose.position.x, 0.12, 5e-5);
  EXPECT_NEAR(pieces[1].pose.rotation.w, 0.6, 1e-4);
  EXPECT_NEAR(pieces[1].pose.rotation.y, 0.8, 1e-4);
  EXPECT_TRUE(pieces[1].lies_on.empty());
  EXPECT_EQ(pieces[2].lies_on, (std::vector<std::uint32_t>{0, 1}));
}

TEST(HeapRow, NumbersThatDoNotFitTogetherGiveNoPieces) {
  catalog::HeapRow row = small_row();
  row.poses.pop_back();
  EXPECT_TRUE(catalog::pieces_of(row).empty());
  row = small_row();
  row.supports.pop_back();
  EXPECT_TRUE(catalog::pieces_of(row).empty());
  row = small_row();
  row.supports.back() = 2;  // on itself
  EXPECT_TRUE(catalog::pieces_of(row).empty());
  row = small_row();
  row.supports.push_back(0);  // of a fourth piece
  EXPECT_TRUE(catalog::pieces_of(row).empty());
}

}  // namespace
}  // namespace marketgen
