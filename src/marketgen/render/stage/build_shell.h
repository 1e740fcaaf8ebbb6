// The room itself: floor, walls with their openings, ceiling, skirting, columns, doors and windows.
#pragma once
#include <vector>

#include "render/stage/draft.h"
#include "render/stage/room.h"

namespace marketgen::render::raytrace {

class ShellBuilder {
 public:
  ShellBuilder(Draft& draft, const Room& room);
  void build(Draft& draft) const;

 private:
  enum Finish : std::uint16_t {
    floor,
    wall,
    ceiling,
    skirting,
    frame,
    pane,
    steel_door,
    trim,
    finishes
  };
  void add_floor(Mesh& mesh) const;
  void add_ceiling(Mesh& mesh) const;
  void add_wall(Mesh& mesh, const WallEdge& edge) const;
  void add_skirting(Mesh& mesh, const WallEdge& edge) const;
  void add_reveal(Mesh& mesh, const WallEdge& edge, const WallOpening& opening) const;
  void add_glazing(Mesh& mesh, const WallEdge& edge, const WallOpening& opening) const;
  void add_steel_door(Mesh& mesh, const WallEdge& edge, const WallOpening& opening) const;
  void add_columns(Mesh& mesh, const plan::Shell& shell) const;

  const Room& room_;
  std::vector<std::uint16_t> materials_;  // by Finish
  float floor_extent_ = 1, wall_extent_ = 1, ceiling_extent_ = 1;
};

}  // namespace marketgen::render::raytrace
