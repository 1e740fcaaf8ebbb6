// Every kept file (catalog/kept_file.h) that products need: their meshes, the pictures of their
// sides.
#pragma once
#include <filesystem>
#include <vector>

#include "base/result.h"
#include "catalog/product.h"

namespace marketgen::catalog {

// Copies the files of `products` from the cache into a store's folder (meshes/, faces/), and those
// that the cache lacks back from there. Without such products neither does anything. Errors:
// model.bad_file, image.bad_file, input.*, io.*.
Result<void> save_own_files(const std::vector<Product>& products,
                            const std::filesystem::path& folder);
Result<void> restore_own_files(const std::vector<Product>& products,
                               const std::filesystem::path& folder);

// The same for rows that nothing in the store shows yet, but an edit of it may: what is not there
// is passed over.
Result<void> save_spare_files(const std::vector<Product>& rows,
                              const std::filesystem::path& folder);
Result<void> restore_spare_files(const std::vector<Product>& rows,
                                 const std::filesystem::path& folder);

}  // namespace marketgen::catalog
