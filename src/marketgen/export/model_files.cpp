#include "export/model_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "export/goods_sheets.h"
#include "export/licences.h"
#include "export/material_pictures.h"
#include "export/obj_text.h"
#include "export/room_mesh.h"
#include "export/xml_text.h"

namespace marketgen::exporters {
namespace {

std::string obj_with_look(const std::string& stem, const Mesh& mesh) {
  return fmt::format("mtllib {0}.mtl\nusemtl look\n", stem) + obj_text(mesh);
}

// `picture` is a file beside it, or empty.
std::string mtl_text(const assets::Surface& surface, const std::string& picture) {
  const Vec3f& c = surface.color;
  std::string text = fmt::format("newmtl look\nKd {} {} {}\nKs 0.05 0.05 0.05\nNs 20\nd {}\n",
                                 srgb_from_linear(c.x),
                                 srgb_from_linear(c.y),
                                 srgb_from_linear(c.z),
                                 surface.kind == assets::SurfaceKind::glass ? glass_alpha : 1.0F);
  if (!picture.empty()) text += fmt::format("map_Kd {}\n", picture);
  return text;
}

// The triangles of one surface, with the corners that they need.
Mesh surface_mesh(const Mesh& mesh, std::uint16_t surface) {
  Mesh part;
  std::map<std::uint32_t, std::uint32_t> known;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.surfaces[t] != surface) continue;
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t v = mesh.triangles[t][c];
      const auto [entry, is_new] = known.try_emplace(v, 0);
      if (is_new) entry->second = part.add_vertex(mesh.positions[v], mesh.normals[v], mesh.uvs[v]);
      corners[c] = entry->second;
    }
    part.add_triangle(corners[0], corners[1], corners[2], 0);
  }
  return part;
}

// Below a picture.
assets::Surface white_surface() {
  return {.color = {1, 1, 1}};
}

}  // namespace

std::string goods_mesh_file(const std::string& sku) {
  return sku + "/pack.obj";
}

void ModelFiles::add(const std::string& name, std::string bytes) {
  if (std::ranges::find(files_, name, &BesideFile::name) == files_.end())
    files_.push_back({name, std::move(bytes)});
}

Result<ModelFiles> ModelFiles::make(const scene::Scene& scene) {
  ModelFiles files;
  MARKETGEN_TRY(const auto sheets, goods_sheets(scene));
  for (std::size_t row = 0; row < sheets.size(); ++row) {
    if (!sheets[row]) continue;
    const std::string& sku = scene.catalog[row].sku;
    files.files_.push_back(
        {goods_mesh_file(sku), "mtllib pack.mtl\nusemtl look\n" + sheets[row]->obj});
    files.files_.push_back({sku + "/pack.mtl", mtl_text(white_surface(), "pack.png")});
    files.files_.push_back({sku + "/pack.png", sheets[row]->png});
  }
  MARKETGEN_CHECK(files.add_room(scene));
  files.files_.push_back(licences_file(scene));
  return files;
}

Result<void> ModelFiles::add_room(const scene::Scene& scene) {
  const exporters::RoomMesh room =
      room_mesh(scene.layout.shell, scene.layout.look, [&](const std::string& material) {
        return material_repeat_m(scene, material);
      });
  for (std::uint16_t i = 0; i < room_surfaces; ++i) {
    const Mesh mesh = surface_mesh(room.mesh, i);
    if (i == room_ceiling || mesh.triangles.empty()) continue;
    const auto surface = static_cast<RoomSurface>(i);
    const std::string name(room_surface_names[i]), id = room_material(surface, scene.layout.look);
    const catalog::MaterialRow* row = id.empty() ? nullptr : scene_material(scene, id);
    assets::Surface look = id.empty() ? plain_room_surface(surface) : plain_plaster();
    std::string picture;
    if (row != nullptr) {
      MARKETGEN_TRY(MaterialPictures made, material_pictures(*row));
      look = white_surface();
      picture = name + ".png";
      files_.push_back({"room/" + picture, std::move(made.color)});
    }
    room_.push_back({name, "room/" + name + ".obj"});
    files_.push_back({room_.back().file, obj_with_look(name, mesh)});
    files_.push_back({"room/" + name + ".mtl", mtl_text(look, picture)});
  }
  return {};
}

}  // namespace marketgen::exporters
