// Product rows of a user's own file, to stand beside ours.
//
// JSON: an array of rows (market-product-1), or one market-asset/1 document as `assets import`
// writes it. CSV: the first line names fields of the row, "label.primary" for a field within the
// label, "faces.front" and "contents.color" likewise; size_mm is written "66x66x115" and keywords
// "cola; soft drink".
#pragma once
#include <filesystem>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"
#include "catalog/product.h"
#include "catalog/rows.h"

namespace marketgen::catalog {

// By the file's ending, .json or .csv. Meshes and pictures that rows name are kept
// (catalog/own_mesh.h, catalog/own_faces.h). A row
// that does not name its contact material, or its friction, has none: fill_in() gives it one.
// Errors: json.*, csv.*, input.*, model.*, image.*, catalog.bad_row.
Result<std::vector<Product>> read_user_products(const std::filesystem::path& file);

// The contact material that packs of the row's shape among `rows` usually have, and the friction of
// that material, where the row says neither.
void fill_in(Product& own,
             const std::vector<Product>& rows,
             const std::vector<FrictionRow>& frictions);

// The catalogue with rows of a user's beside its own, as load_catalog() has them, by another hash.
// They were checked when they were read; a SKU that the catalogue has is passed over.
Catalog with_own_products(Catalog catalog, const std::vector<Product>& own);

}  // namespace marketgen::catalog
