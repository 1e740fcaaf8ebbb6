// The room as boxes: walls with their door and window openings, lintels, panes, doors and columns.
//
// Store frame, metres. Walls stand outside the floor's outline, so their inner faces lie on it;
// their measures are those of the pictures (plan/shell_measures.h).
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/pose.h"
#include "plan/plan.h"

namespace marketgen::physics {

enum class ShellPieceKind { wall, pane, door, column };
constexpr std::array<std::string_view, 4> names_of(ShellPieceKind) {
  return {"wall", "pane", "door", "column"};
}

struct ShellPiece {
  std::string id;  // "wall-0/piece-1", "door/dock", "pane/window-1", "column-2"
  ShellPieceKind kind = ShellPieceKind::wall;
  Pose pose;  // of the box's centre
  Vec3 half_size;
};

// Entrances and exits stand open; service and emergency doors are shut; windows have a pane.
std::vector<ShellPiece> shell_pieces(const plan::Shell& shell);

}  // namespace marketgen::physics
