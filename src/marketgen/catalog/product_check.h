// The rules of one product row, for those who write rows and for those who read them.
#pragma once
#include "base/result.h"
#include "catalog/catalog.h"
#include "catalog/product.h"

namespace marketgen::catalog {

// What check_catalog demands of a row apart from the others: a known category, codes, a plausible
// density, colours. Error: catalog.bad_row.
Result<void> check_product(const Product& product, const Catalog& catalog);

}  // namespace marketgen::catalog
