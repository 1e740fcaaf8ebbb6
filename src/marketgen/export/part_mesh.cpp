#include "export/part_mesh.h"

#include "assets/fixtures/fixture_model.h"

namespace marketgen::exporters {

assets::Surface part_surface(const scene::ScenePart& part) {
  assets::Surface look;
  look.color = {part.color[0], part.color[1], part.color[2]};
  look.roughness = part.roughness;
  look.metallic = part.metallic;
  look.kind = part.kind;
  return look;
}

void add_part(Mesh& mesh,
              const scene::ScenePart& part,
              const Pose& owner_from_part,
              std::uint16_t surface,
              double extent_m) {
  assets::FixturePart shape;
  shape.unit = part.unit;
  shape.shape = part.shape;
  shape.fixture_from_part = owner_from_part;
  shape.half_size = {part.half_size_m[0], part.half_size_m[1], part.half_size_m[2]};
  const std::size_t first = mesh.uvs.size();
  assets::add_part_mesh(mesh, shape, surface);
  const auto scale = static_cast<float>(1 / extent_m);
  for (std::size_t v = first; v < mesh.uvs.size(); ++v)
    mesh.uvs[v] = mesh.uvs[v] * scale;
}

}  // namespace marketgen::exporters
