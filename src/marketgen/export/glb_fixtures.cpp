#include <map>

#include "export/glb_room.h"
#include "export/part_mesh.h"

namespace marketgen::exporters {
namespace {

// The parts as bytes, without the rows of their fixture and joint: equal modules have equal bytes.
std::string content_of(const scene::Scene& scene, const scene::SceneFixture& fixture) {
  std::string bytes;
  for (std::uint32_t i = 0; i < fixture.part_count; ++i) {
    scene::ScenePart part = scene.parts[fixture.first_part + i];
    part.fixture = 0;
    part.joint = -1;
    bytes.append(reinterpret_cast<const char*>(&part), sizeof part);
  }
  return bytes;
}

// Merges the parts of one module into one mesh with as few materials as it has looks.
class ModuleMesh {
 public:
  ModuleMesh(const scene::Scene& scene, GlbMaterials& materials)
      : scene_(scene), materials_(materials) {}

  Result<void> add(const scene::ScenePart& part) {
    const catalog::MaterialRow* row =
        part.material < 0 ? nullptr : &scene_.materials[static_cast<std::size_t>(part.material)];
    const assets::Surface look = part_surface(part);
    int material = -1;
    if (row == nullptr)
      material = materials_.add(look);
    else {
      MARKETGEN_TRY(material, materials_.add_tiled(row->id));
    }
    add_part(mesh,
             part,
             scene::fixture_from_part(part),
             surface_of(material),
             row == nullptr ? 1.0 : materials_.extent_m(row->id));
    return {};
  }

  Mesh mesh;
  std::vector<int> surfaces;  // materials by the mesh's surface numbers

 private:
  std::uint16_t surface_of(int material) {
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      if (surfaces[i] == material) return static_cast<std::uint16_t>(i);
    }
    surfaces.push_back(material);
    return static_cast<std::uint16_t>(surfaces.size() - 1);
  }

  const scene::Scene& scene_;
  GlbMaterials& materials_;
};

io::GltfJson node_of(const scene::Scene& scene, std::uint32_t fixture, int mesh) {
  const scene::SceneFixture& row = scene.fixtures[fixture];
  const layout::Fixture& placed = scene.layout.fixtures[fixture];
  io::GltfJson node{
      {"name", placed.id}, {"mesh", mesh}, {"translation", io::json_array(row.position_m)}};
  node["rotation"] = io::json_array(io::gltf_rotation(yaw_from_quarter_turns(row.quarter_turns)));
  node["extras"] = {{"fixture", placed.id}, {"kind", placed.kind}, {"zone", placed.zone}};
  return node;
}

}  // namespace

Result<void> add_fixtures(const scene::Scene& scene,
                          io::GlbDocument& document,
                          GlbMaterials& materials) {
  const int group = document.add_node({{"name", "fixtures"}}, -1);
  std::map<std::string, int> mesh_of_content;
  for (std::uint32_t f = 0; f < scene.fixtures.size(); ++f) {
    const scene::SceneFixture& row = scene.fixtures[f];
    if (row.part_count == 0) continue;
    const auto [entry, is_new] = mesh_of_content.try_emplace(content_of(scene, row), 0);
    if (is_new) {
      ModuleMesh built(scene, materials);
      for (std::uint32_t i = row.first_part; i < row.first_part + row.part_count; ++i)
        MARKETGEN_CHECK(built.add(scene.parts[i]));
      entry->second = document.add_mesh(scene.layout.fixtures[f].kind, built.mesh, built.surfaces);
    }
    document.add_node(node_of(scene, f, entry->second), group);
  }
  return {};
}

}  // namespace marketgen::exporters
