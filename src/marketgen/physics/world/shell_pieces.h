// The room as boxes: walls with their door and window openings, lintels, panes, doors and columns.
//
// Store frame, metres. Walls stand outside the floor's outline, so their inner faces lie on it.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/pose.h"
#include "plan/plan.h"

namespace marketgen {

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

constexpr double wall_thickness_m = 0.2;
// Clear heights, as in the pictures of the store: automatic sliding doors of shops 2.2-2.5 m.
constexpr double door_height_m = 2.3, service_door_height_m = 2.1;
constexpr double window_sill_m = 0.9, window_top_m = 2.5;
constexpr double least_lintel_m = 0.25;  // openings end this far below the ceiling
constexpr double door_leaf_m = 0.05;     // also of a pane with its frame

// Entrances and exits stand open; service and emergency doors are shut; windows have a pane.
std::vector<ShellPiece> shell_pieces(const Shell& shell);

}  // namespace marketgen
