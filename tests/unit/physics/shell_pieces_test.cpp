#include "physics/world/shell_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/hand_made_scene.h"

namespace marketgen {
namespace {

// True when the point lies inside a piece (of that kind).
bool covered(const std::vector<physics::ShellPiece>& pieces,
             Vec3 point,
             physics::ShellPieceKind kind = physics::ShellPieceKind::wall) {
  return std::ranges::any_of(pieces, [&](const physics::ShellPiece& piece) {
    const Vec3 local = inverse(piece.pose) * point;
    return piece.kind == kind && std::abs(local.x) < piece.half_size.x &&
           std::abs(local.y) < piece.half_size.y && std::abs(local.z) < piece.half_size.z;
  });
}

double volume(const physics::ShellPiece& piece) {
  return 8 * piece.half_size.x * piece.half_size.y * piece.half_size.z;
}

TEST(ShellPieces, LeaveTheEntranceOpenUnderALintel) {
  const auto pieces = physics::shell_pieces(HandMadeScene().scene.layout.shell);
  EXPECT_FALSE(covered(pieces, {1.5, -0.1, 1.0}));  // the middle of the entrance
  EXPECT_TRUE(covered(pieces, {1.5, -0.1, 2.7}));
  EXPECT_TRUE(covered(pieces, {0.7, -0.1, 1.0}));  // beside it: 0.75 m is its west jamb
  EXPECT_FALSE(covered(pieces, {0.8, -0.1, 1.0}));
}

TEST(ShellPieces, WindowsHaveSillAndPaneAndServiceDoorsAreShut) {
  const auto pieces = physics::shell_pieces(HandMadeScene().scene.layout.shell);
  EXPECT_TRUE(covered(pieces, {4.5, -0.1, 0.5}));
  EXPECT_FALSE(covered(pieces, {4.5, -0.1, 1.5}));
  EXPECT_TRUE(covered(pieces, {4.5, -0.1, 1.5}, physics::ShellPieceKind::pane));
  EXPECT_TRUE(covered(pieces, {0.9, 4.1, 1.5}, physics::ShellPieceKind::door));
  EXPECT_TRUE(covered(pieces, {0.9, 4.1, 2.2}));  // above a service door
}

TEST(ShellPieces, WallsCloseAtTheCornersWithoutOverlap) {
  plan::Shell shell = HandMadeScene().scene.layout.shell;
  shell.openings.clear();
  shell.columns.clear();
  const auto pieces = physics::shell_pieces(shell);
  for (const double x : {-0.1, 6.1}) {
    for (const double y : {-0.1, 4.1})
      EXPECT_TRUE(covered(pieces, {x, y, 1.0}));
  }
  double total = 0;
  for (const physics::ShellPiece& piece : pieces)
    total += volume(piece);
  EXPECT_NEAR(
      total, (6.4 * 4.4 - 6.0 * 4.0) * 3.0, 1e-9);  // the frame between inner and outer faces
}

TEST(ShellPieces, StandOutsideAnLShapedFloor) {
  plan::Shell shell;
  shell.width_mm = 8000, shell.depth_mm = 8000, shell.ceiling_mm = 3000;
  shell.outline_mm =
      PolygonMm{{0, 0}, {8000, 0}, {8000, 4000}, {4000, 4000}, {4000, 8000}, {0, 8000}};
  const auto pieces = physics::shell_pieces(shell);
  EXPECT_TRUE(covered(pieces, {6.0, 4.1, 1.0}));
  EXPECT_TRUE(covered(pieces, {4.1, 6.0, 1.0}));
  EXPECT_FALSE(covered(pieces, {3.9, 3.9, 1.0}));
  EXPECT_FALSE(covered(pieces, {3.9, 6.0, 1.0}));
}

}  // namespace
}  // namespace marketgen
