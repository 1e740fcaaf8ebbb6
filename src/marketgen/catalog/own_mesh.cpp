#include "catalog/own_mesh.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "geometry/mesh.h"
#include "io/model_glb.h"

namespace marketgen::catalog {
namespace fs = std::filesystem;
namespace {

constexpr double fit_tolerance = 0.03;  // scans differ by this much
constexpr double rounding_m = 0.6e-3;   // rows are in whole millimetres

using Sizes = std::array<double, 3>;  // width, depth, height in metres

Sizes sizes_of(const io::OutsideModel& model) {
  const Vec3f size = marketgen::bounds_of(model.mesh).size();  // Y is up
  return {size.x, size.z, size.y};
}

bool fits(const Sizes& sizes, const std::array<int, 3>& size_mm, double factor) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double wanted = size_mm[i] * 1e-3;
    if (std::abs(sizes[i] * factor - wanted) > std::max(fit_tolerance * wanted, rounding_m))
      return false;
  }
  return true;
}

std::string millimetres(const Sizes& sizes) {
  return fmt::format("{:.1f} x {:.1f} x {:.1f} mm", 1e3 * sizes[0], 1e3 * sizes[1], 1e3 * sizes[2]);
}

// Why the sizes differ, as far as that can be told, and what mends it.
std::string remedy(const Sizes& sizes, const std::array<int, 3>& size_mm) {
  for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::cm, LengthUnit::inch}) {
    if (fits(sizes, size_mm, metres_in(unit)))
      return fmt::format(
          "its unit is {}, glTF's is the metre: export it in metres, or run "
          "\"marketgen assets import FILE --unit {}\"",
          name_of(unit),
          name_of(unit));
  }
  Sizes mesh = sizes, row{size_mm[0] * 1e-3, size_mm[1] * 1e-3, size_mm[2] * 1e-3};
  std::sort(mesh.begin(), mesh.end());
  std::sort(row.begin(), row.end());
  bool turned = true;
  for (std::size_t i = 0; i < 3; ++i)
    turned = turned && std::abs(mesh[i] / row[i] - 1) <= fit_tolerance;
  if (turned) return "it lies on another side: turn it so that Y is up and its front faces +Z";
  return "correct size_mm, or export the mesh at its true size in metres";
}

constexpr std::string_view mesh_endings[] = {".glb"};
constexpr KeptKind mesh_kind{"mesh", "meshes", mesh_endings, io::max_model_bytes, "model.bad_file"};

}  // namespace

double metres_in(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::m:
      return 1;
    case LengthUnit::cm:
      return 0.01;
    case LengthUnit::mm:
      return 0.001;
    case LengthUnit::inch:
      return 0.0254;
  }
  return 1;
}

void scale_model(io::OutsideModel& model, double factor) {
  const auto f = static_cast<float>(factor);
  for (Vec3f& p : model.mesh.positions)
    p *= f;
  for (std::vector<Vec3f>& piece : model.pieces) {
    for (Vec3f& p : piece)
      p *= f;
  }
}

Result<void> fit_model(io::OutsideModel& model,
                       const std::array<int, 3>& size_mm,
                       const std::string& where) {
  const Sizes sizes = sizes_of(model);
  if (!fits(sizes, size_mm, 1)) {
    return Error{"model.bad_scale",
                 where,
                 fmt::format("is {}, its row says {} x {} x {} mm; {}",
                             millimetres(sizes),
                             size_mm[0],
                             size_mm[1],
                             size_mm[2],
                             remedy(sizes, size_mm))};
  }
  const Bounds3 bounds = marketgen::bounds_of(model.mesh);
  const Vec3f origin{bounds.center().x, bounds.low.y, bounds.center().z};
  const auto stretch = [&](std::size_t i) {
    return static_cast<float>(size_mm[i] * 1e-3 / sizes[i]);
  };
  const Vec3f factor{stretch(0), stretch(2), stretch(1)};
  for (Vec3f& p : model.mesh.positions)
    p = (p - origin) * factor;
  for (std::vector<Vec3f>& piece : model.pieces) {
    for (Vec3f& p : piece)
      p = (p - origin) * factor;
  }
  return {};
}

Result<std::string> keep_mesh(const fs::path& file, const Product& product) {
  MARKETGEN_TRY(io::OutsideModel model, io::read_model_file(file));
  MARKETGEN_CHECK(fit_model(model, product.size_mm, file.string()));
  io::merge_pictures(model);
  MARKETGEN_TRY(const std::string bytes, io::encode_glb(model, product.sku));
  return keep_bytes(mesh_kind, bytes, mesh_endings[0]);
}

KeptName mesh_name(const Product& product) {
  return {&mesh_kind, product.mesh, product.sku + "/mesh"};
}

Result<io::OutsideModel> kept_mesh(const Product& product) {
  const KeptName name = mesh_name(product);
  MARKETGEN_TRY(const std::string bytes, kept_bytes(name));
  return io::parse_glb(bytes, name.where);
}

}  // namespace marketgen::catalog
