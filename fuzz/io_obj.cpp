// An OBJ from anywhere, with itself as its material library: either a model or an error.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/model_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace marketgen;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto model =
      io::parse_obj(text, "fuzz", [&](const std::string&) -> Result<std::string> { return text; });
  if (!model.ok()) return 0;
  const Mesh& mesh = model->mesh;
  if (mesh.triangles.empty() || mesh.normals.size() != mesh.positions.size()) std::abort();
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle)
      if (vertex >= mesh.positions.size()) std::abort();
  }
  for (const std::uint16_t surface : mesh.surfaces)
    if (surface >= model->materials.size()) std::abort();
  for (const Vec3f& p : mesh.positions)
    if (!std::isfinite(p.x + p.y + p.z)) std::abort();
  return 0;
}
