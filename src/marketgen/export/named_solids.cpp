#include "export/named_solids.h"

#include "physics/world/shell_pieces.h"

namespace marketgen::exporters {
namespace {

constexpr double floor_thickness_m = 0.1;

}  // namespace

std::vector<NamedSolid> room_solids(const plan::Shell& shell) {
  const Vec3 half{shell.width_mm * 0.5e-3, shell.depth_mm * 0.5e-3, floor_thickness_m / 2};
  std::vector<NamedSolid> solids{
      {std::string(floor_solid),
       {assets::CollisionShape::box, {{half.x, half.y, -half.z}, {}}, half}}};
  for (const physics::ShellPiece& piece : physics::shell_pieces(shell))
    solids.push_back({piece.id, {assets::CollisionShape::box, piece.pose, piece.half_size}});
  return solids;
}

}  // namespace marketgen::exporters
