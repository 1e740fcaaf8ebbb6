#include <algorithm>
#include <cmath>
#include <numbers>

#include "export/material_pictures.h"
#include "export/room_mesh.h"
#include "export/usd_layers.h"
#include "export/usd_solids.h"
#include "geometry/rectangle.h"
#include "physics/goods/contact_shape.h"
#include "physics/world/shell_pieces.h"

namespace marketgen::exporters {
namespace {

constexpr std::string_view room_path = "/Shop/room";

Result<std::vector<int>> room_looks(const scene::Scene& scene, UsdLooks& looks) {
  std::vector<int> by_surface;
  for (std::uint16_t i = 0; i < room_surfaces; ++i) {
    const auto surface = static_cast<RoomSurface>(i);
    const std::string material = room_material(surface, scene.layout.look);
    if (material.empty())
      by_surface.push_back(looks.add(plain_room_surface(surface)));
    else {
      MARKETGEN_TRY(const int tiled, looks.add_tiled(material));
      by_surface.push_back(tiled);
    }
  }
  return by_surface;
}

void write_look(UsdText& out, const UsdShape& shape, const std::vector<int>& by_surface) {
  out.open("def Xform \"look\"", {"prepend references = " + shape.reference});
  for (const UsdShape::Part& part : shape.parts) {
    const UsdLabels labels{{"class", std::string(room_surface_names[part.surface])}};
    out.open(fmt::format("over \"{}\"", part.name),
             {"prepend apiSchemas = [\"MaterialBindingAPI\"" + usd_label_schemas(labels) + "]"});
    out.line("rel material:binding = <{}/materials/look_{}>", room_path, by_surface[part.surface]);
    write_usd_labels(out, labels);
    out.close();
  }
  out.close();
}

// The floor is endless for what falls on it.
void write_floor(UsdText& out, const plan::Shell& shell, const std::string& material) {
  const float x = static_cast<float>(shell.width_mm) * 1e-3F,
              y = static_cast<float>(shell.depth_mm) * 1e-3F;
  out.open("def Plane \"floor\"",
           {"prepend apiSchemas = [\"PhysicsCollisionAPI\", \"MaterialBindingAPI\"]"});
  out.line("uniform token axis = \"Z\"");
  out.line("float3[] extent = {}", usd_extent({{-x / 2, -y / 2, 0}, {x / 2, y / 2, 0}}));
  out.line("double length = {}", y);
  out.line("rel material:binding:physics = <{}>", material);
  out.line("uniform token purpose = \"guide\"");
  out.line("double width = {}", x);
  write_usd_pose(out, {{x / 2, y / 2, 0}, {}});
  out.close();
}

// Lamps in even rows under the ceiling, so bright that the floor has the look's illuminance.
constexpr double lamp_pitch_x_m = 2.4, lamp_pitch_y_m = 2.8, lamp_length_m = 1.2,
                 lamp_width_m = 0.3, lamp_below_ceiling_m = 0.02;

std::vector<Vec3> lamp_places(const plan::Shell& shell) {
  const PolygonMm outline =
      shell.outline_mm.value_or(polygon_of(RectMm{0, 0, shell.width_mm, shell.depth_mm}));
  const double x = shell.width_mm * 1e-3, y = shell.depth_mm * 1e-3;
  const auto along = std::max(1L, std::lround(x / lamp_pitch_x_m)),
             across = std::max(1L, std::lround(y / lamp_pitch_y_m));
  std::vector<Vec3> places;
  for (long i = 0; i < along; ++i) {
    for (long j = 0; j < across; ++j) {
      const Vec3 at{x * (static_cast<double>(i) + 0.5) / static_cast<double>(along),
                    y * (static_cast<double>(j) + 0.5) / static_cast<double>(across),
                    shell.ceiling_mm * 1e-3 - lamp_below_ceiling_m};
      if (contains(outline, floor_mm(at))) places.push_back(at);
    }
  }
  return places;
}

}  // namespace

Result<std::string> usd_room(UsdParts& parts) {
  const scene::Scene& scene = parts.scene;
  UsdLooks looks(parts.pictures);
  MARKETGEN_TRY(const std::vector<int> by_surface, room_looks(scene, looks));
  std::vector<bool> textured;
  for (const int look : by_surface)
    textured.push_back(looks.textured(look));
  const RoomMesh room =
      room_mesh(scene.layout.shell, scene.layout.look, [&](const std::string& material) {
        return material_repeat_m(scene, material);
      });
  const UsdShape shape = parts.geometry.add("room", usd_meshes(room.mesh, textured, room.pieces));
  const std::string contact = usd_contact_material(room_path);
  UsdText out;
  out.append(usd_head("Shop"));
  out.open("over \"Shop\"");
  out.open("def Xform \"room\"", {"kind = \"component\""});
  write_look(out, shape, by_surface);
  looks.write(out, room_path, physics::still_friction);
  write_floor(out, scene.layout.shell, contact);
  UsdNames names;
  names.of("look"), names.of("materials"), names.of("floor");
  for (const physics::ShellPiece& piece : physics::shell_pieces(scene.layout.shell))
    write_usd_collider(
        out,
        parts.geometry,
        names.of(piece.id),
        assets::ContactShape{assets::CollisionShape::box, piece.pose, piece.half_size},
        UsdContact{contact});
  out.close();
  out.close();
  return out.take();
}

std::string usd_lights(const scene::Scene& scene) {
  const plan::Shell& shell = scene.layout.shell;
  const plan::Look& look = scene.layout.look;
  const std::vector<Vec3> places = lamp_places(shell);
  // A lamp of luminance L gives off pi L for every square metre of it; all of that reaches the
  // floor or walls of about its colour.
  const double floor_m2 = shell.width_mm * 1e-3 * shell.depth_mm * 1e-3;
  const double nits = look.light_lux * floor_m2 /
                      (std::numbers::pi * lamp_length_m * lamp_width_m *
                       static_cast<double>(std::max<std::size_t>(places.size(), 1)));
  UsdText out;
  out.append(usd_head("Shop"));
  out.open("over \"Shop\"");
  out.open("def Xform \"lights\"", {"kind = \"group\""});
  for (std::size_t i = 0; i < places.size(); ++i) {
    out.open(fmt::format("def RectLight \"lamp_{}\"", i));
    out.line(
        "float3[] extent = {}",
        usd_extent(
            {{-static_cast<float>(lamp_length_m / 2), -static_cast<float>(lamp_width_m / 2), 0},
             {static_cast<float>(lamp_length_m / 2), static_cast<float>(lamp_width_m / 2), 0}}));
    out.line("float inputs:colorTemperature = {}", look.light_kelvin);
    out.line("bool inputs:enableColorTemperature = 1");
    out.line("float inputs:height = {}", lamp_width_m);
    out.line("float inputs:intensity = {}", static_cast<float>(nits));
    out.line("float inputs:width = {}", lamp_length_m);
    write_usd_pose(out, {places[i], {}});
    out.close();
  }
  out.close();
  out.close();
  return out.take();
}

}  // namespace marketgen::exporters
