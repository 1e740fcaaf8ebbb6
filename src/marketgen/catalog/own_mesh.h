// Meshes of products that are no archetype: a user's GLB or OBJ file beside his catalogue.
//
// A catalogue names a file in its own folder. When it is loaded the file is read, brought into the
// product's frame and size and kept under $MARKETGEN_CACHE/meshes by its content; from then on
// Product::mesh is "<sha256>.glb", so that scenes depend on what the mesh is and not on where it
// lay. A store folder holds copies of the meshes that it uses.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
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

// The kept mesh of a product of archetype mesh, in glTF's frame. Errors: model.bad_file for a name
// that is none; input.not_found when the cache no longer has it; model.*.
Result<io::OutsideModel> kept_mesh(const Product& product);

// Copies the meshes of `products` from the cache to `folder`/meshes, and those that the cache lacks
// back from there. Without meshes neither does anything.
Result<void> save_meshes(const std::vector<Product>& products, const std::filesystem::path& folder);
Result<void> restore_meshes(const std::vector<Product>& products,
                            const std::filesystem::path& folder);

}  // namespace marketgen::catalog
