// Rows that travel with episodes may be older than Product::contents.
#pragma once
#include <vector>

#include "catalog/catalog.h"

namespace marketgen::catalog {

// Gives rows without contents those of the catalogue's row of the same SKU: they are seen, and no
// more.
void complete_contents(std::vector<Product>& rows, const Catalog& catalog);

}  // namespace marketgen::catalog
