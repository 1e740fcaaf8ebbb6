#include "catalog/own_files.h"

#include "catalog/own_faces.h"
#include "catalog/own_mesh.h"

namespace marketgen::catalog {
namespace {

std::vector<KeptName> own_files_of(const std::vector<Product>& products) {
  std::vector<KeptName> names;
  for (const Product& product : products) {
    if (product.archetype == mesh_archetype) names.push_back(mesh_name(product));
    for (KeptName& face : face_names(product))
      names.push_back(std::move(face));
  }
  return names;
}

}  // namespace

Result<void> save_own_files(const std::vector<Product>& products,
                            const std::filesystem::path& folder) {
  for (const KeptName& name : own_files_of(products))
    MARKETGEN_CHECK(save_kept(name, folder));
  return {};
}

Result<void> restore_own_files(const std::vector<Product>& products,
                               const std::filesystem::path& folder) {
  for (const KeptName& name : own_files_of(products))
    MARKETGEN_CHECK(restore_kept(name, folder));
  return {};
}

Result<void> save_spare_files(const std::vector<Product>& rows,
                              const std::filesystem::path& folder) {
  for (const KeptName& name : own_files_of(rows)) {
    if (is_kept(name)) MARKETGEN_CHECK(save_kept(name, folder));
  }
  return {};
}

Result<void> restore_spare_files(const std::vector<Product>& rows,
                                 const std::filesystem::path& folder) {
  for (const KeptName& name : own_files_of(rows)) {
    if (is_saved(name, folder)) MARKETGEN_CHECK(restore_kept(name, folder));
  }
  return {};
}

}  // namespace marketgen::catalog
