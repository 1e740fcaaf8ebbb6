// A GLB from anywhere: either a model that is safe to use, or an error.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/model_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace marketgen;
  const auto model = io::parse_glb({reinterpret_cast<const char*>(data), size}, "fuzz");
  if (!model.ok()) return 0;
  const Mesh& mesh = model->mesh;
  if (mesh.triangles.empty() || mesh.normals.size() != mesh.positions.size() ||
      mesh.uvs.size() != mesh.positions.size() || mesh.surfaces.size() != mesh.triangles.size())
    std::abort();
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle)
      if (vertex >= mesh.positions.size()) std::abort();
  }
  for (const std::uint16_t surface : mesh.surfaces)
    if (surface >= model->materials.size()) std::abort();
  for (const io::ModelMaterial& material : model->materials)
    if (material.picture >= static_cast<int>(model->pictures.size())) std::abort();
  for (const Vec3f& p : mesh.positions)
    if (!std::isfinite(p.x + p.y + p.z)) std::abort();
  return 0;
}
