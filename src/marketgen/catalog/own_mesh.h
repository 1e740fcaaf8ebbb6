// Meshes of products that are no archetype: a user's GLB or OBJ file beside his catalogue.
//
// A catalogue names a file in its own folder. When it is loaded the file is read, brought into the
// product's frame and size and kept by its content (catalog/kept_file.h); from then on
// Product::mesh is "<sha256>.glb".
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"
#include "catalog/kept_file.h"
#include "catalog/product.h"
#include "io/model_file.h"

namespace marketgen::catalog {

constexpr std::string_view mesh_archetype = "mesh";

// A unit that a file may have been made in.
enum class LengthUnit { m, cm, mm, inch };
constexpr std::array<std::string_view, 4> names_of(LengthUnit) {
  return {"m", "cm", "mm", "inch"};
}
double metres_in(LengthUnit unit);

// Every position times `factor`.
void scale_model(io::OutsideModel& model, double factor);

// Moves the model so that it stands in the middle of its footprint on y = 0, and stretches it to
// the size (width x, depth z, height y in glTF's frame) exactly. It may be 3 % or 0.6 mm off in
// each direction; error model.bad_scale otherwise, which says the unit or the turn that would fit.
Result<void> fit_model(io::OutsideModel& model,
                       const std::array<int, 3>& size_mm,
                       const std::string& where);

// The content name of the mesh in `file`, fitted to the product and kept. Errors: model.*, input.*,
// io.*.
Result<std::string> keep_mesh(const std::filesystem::path& file, const Product& product);

// The mesh that a product of archetype mesh names.
KeptName mesh_name(const Product& product);

// The kept mesh of a product of archetype mesh, in glTF's frame. Errors: those of kept_bytes(),
// model.*.
Result<io::OutsideModel> kept_mesh(const Product& product);

}  // namespace marketgen::catalog
