#include "export/room_mesh.h"

#include "physics/world/shell_pieces.h"
#include "render/stage/room.h"

namespace marketgen::exporters {
namespace {

void add_horizontal(Mesh& mesh,
                    const PolygonMm& outline,
                    float z,
                    bool faces_up,
                    RoomSurface surface,
                    double extent_m) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const PointMm& p : outline) {
    const Vec3f at{static_cast<float>(p[0]) * 1e-3F, static_cast<float>(p[1]) * 1e-3F, z};
    const auto scale = static_cast<float>(1 / extent_m);
    mesh.add_vertex(at, {0, 0, faces_up ? 1.0F : -1.0F}, {at.x * scale, -at.y * scale});
  }
  for (const auto& [a, b, c] : render::raytrace::triangulated(outline)) {
    mesh.add_triangle(first + a, first + (faces_up ? b : c), first + (faces_up ? c : b), surface);
  }
}

RoomSurface surface_of(physics::ShellPieceKind kind) {
  if (kind == physics::ShellPieceKind::door) return room_door;
  return kind == physics::ShellPieceKind::pane ? room_pane : room_wall;
}

void add_piece(Mesh& mesh, const physics::ShellPiece& piece, double wall_extent_m) {
  const std::size_t first = mesh.positions.size();
  const Vec3f half = to_float(piece.half_size);
  add_box(mesh, -half, half, 0, surface_of(piece.kind), static_cast<float>(1 / wall_extent_m));
  place(mesh, piece.pose, first);
}

}  // namespace

RoomMesh room_mesh(const plan::Shell& shell,
                   const plan::Look& look,
                   const std::function<double(const std::string&)>& extent_m) {
  const PolygonMm outline =
      shell.outline_mm.value_or(polygon_of(RectMm{0, 0, shell.width_mm, shell.depth_mm}));
  RoomMesh room;
  const auto begin_piece = [&]() -> Mesh& {
    room.pieces.push_back(static_cast<std::uint32_t>(room.mesh.positions.size()));
    return room.mesh;
  };
  add_horizontal(begin_piece(), outline, 0, true, room_floor, extent_m(look.floor));
  add_horizontal(begin_piece(),
                 outline,
                 static_cast<float>(shell.ceiling_mm) * 1e-3F,
                 false,
                 room_ceiling,
                 extent_m(look.ceiling));
  for (const physics::ShellPiece& piece : physics::shell_pieces(shell))
    add_piece(begin_piece(), piece, extent_m(look.wall));
  return room;
}

std::string room_material(RoomSurface surface, const plan::Look& look) {
  if (surface == room_floor) return look.floor;
  if (surface == room_wall) return look.wall;
  return surface == room_ceiling ? look.ceiling : "";
}

assets::Surface plain_room_surface(RoomSurface surface) {
  if (surface == room_pane)
    return {.color = {0.8F, 0.9F, 0.9F},
            .roughness = 0.05F,
            .kind = assets::SurfaceKind::glass,
            .texture = ""};
  return {.color = {0.3F, 0.32F, 0.34F}, .roughness = 0.4F, .metallic = 0.2F, .texture = ""};
}

}  // namespace marketgen::exporters
