// The room as one mesh: floor, ceiling, walls with their openings, shut doors and panes.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "assets/product_model.h"
#include "geometry/mesh.h"
#include "plan/plan.h"

namespace marketgen::exporters {

// Surfaces of the room's mesh, in this order.
enum RoomSurface : std::uint16_t {
  room_floor,
  room_wall,
  room_ceiling,
  room_door,
  room_pane,
  room_surfaces
};
constexpr std::array<std::string_view, room_surfaces> room_surface_names{
    "floor", "wall", "ceiling", "door", "window"};

struct RoomMesh {
  Mesh mesh;
  std::vector<std::uint32_t> pieces;  // first vertex of each: floor, ceiling, boxes
};

// In the store frame. `extent_m` says of a material how many metres one repeat covers: UVs count
// repeats.
RoomMesh room_mesh(const plan::Shell& shell,
                   const plan::Look& look,
                   const std::function<double(const std::string&)>& extent_m);

// The material of floor, walls or ceiling; empty for a surface that is plain.
std::string room_material(RoomSurface surface, const plan::Look& look);
// What doors and panes look like.
assets::Surface plain_room_surface(RoomSurface surface);

}  // namespace marketgen::exporters
