#include "export/glb_room.h"

#include "export/room_mesh.h"

namespace marketgen::exporters {

Result<void> add_room(const scene::Scene& scene,
                      io::GlbDocument& document,
                      GlbMaterials& materials) {
  const plan::Look& look = scene.layout.look;
  const RoomMesh room = room_mesh(scene.layout.shell, look, [&](const std::string& material) {
    return materials.extent_m(material);
  });
  std::vector<int> indices;
  for (std::uint16_t i = 0; i < room_surfaces; ++i) {
    const auto surface = static_cast<RoomSurface>(i);
    const std::string material = room_material(surface, look);
    if (material.empty())
      indices.push_back(materials.add(plain_room_surface(surface)));
    else {
      MARKETGEN_TRY(const int tiled, materials.add_tiled(material));
      indices.push_back(tiled);
    }
  }
  document.add_node({{"name", "room"}, {"mesh", document.add_mesh("room", room.mesh, indices)}},
                    -1);
  return {};
}

}  // namespace marketgen::exporters
